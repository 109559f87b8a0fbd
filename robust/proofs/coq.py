# SPDX-License-Identifier: Apache-2.0
"""Coq's proof of a statement, from Gappa's, and what Coq says to it.

Gappa prints a proof that assumes its hints and spreads the statement over a hundred definitions. Here the hints become
lemmas that Coq proves. The statement comes first, in the words of coq/model.v, and is proved from Gappa's result: so
neither what is claimed nor that it holds depends on Gappa.
"""

import pathlib
import re
import subprocess

LOGICAL_NAME = "Touchstone"  # of the folder coq/
FOLDER = pathlib.Path(__file__).resolve().parent / "coq"
# What Coq's own library assumes: real numbers, extensionality of functions, classical logic.
AXIOMS = ("ClassicalDedekindReals.sig_forall_dec", "ClassicalDedekindReals.sig_not_dec",
          "FunctionalExtensionality.functional_extensionality_dep", "Classical_Prop.classic")


def theory(statement, proof):
    """A file for Coq: the statement, Gappa's proof, and how the one follows from the other."""
    proof = re.sub(r"^Hypothesis (\w+) : (.*)\.$", r"Lemma \1 : \2. Proof. identity. Qed.", proof, flags=re.MULTILINE)
    # Gappa 1.6 defines the terms that 1.4 writes as notations, which tactics see through.
    proof = re.sub(r"^Definition (p\d+|r\d+|_\w+) := (.*?)\.( \(\*.*)?$", r"Notation \1 := (\2).", proof, flags=re.MULTILINE)
    definitions = " ".join(re.findall(r"^Definition (s\d+) ", proof, re.MULTILINE))
    numbers = " ".join(re.findall(r"^Variable _(\w+) ", proof, re.MULTILINE))
    return f"""Require Import Reals {LOGICAL_NAME}.model.

Definition claim : Prop := (
{statement.for_coq()})%R.

{proof}
Theorem proved : claim.
Proof.
{statement.introduced_in_coq()}repeat match goal with |- _ /\\ _ => split end;
apply Rnot_lt_le; intro above; apply Rlt_not_le in above;
apply (l1 {numbers});
cbv beta delta [{definitions}]; hypothesis.
Qed.

Print Assumptions proved.
"""


def compiled(program, file):
    """Starts Coq on a file, the theories of this project within reach. Coq's tactics leave their caches in its folder."""
    return subprocess.Popen([program, "-q", "-Q", ".", LOGICAL_NAME, file.name], cwd=file.parent, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True)


def assumed(output):
    """The names that `Print Assumptions` lists, for each theorem it was asked about."""
    lists = []
    for line in output.splitlines():
        if line in ("Axioms:", "Closed under the global context"):
            lists.append(set())
        elif line and not line[0].isspace():
            if not lists:
                raise ValueError(f"Coq says: {line}")
            lists[-1].add(line.split()[0])
    return lists


def faults(status, output, theorems=1):
    """What is wrong with what Coq says to a file with that many theorems, and the assumptions that are listed."""
    if status != 0:
        return [f"Coq refuses it: {' '.join(output.split())[-300:]}"], set()
    try:
        lists = assumed(output)
    except ValueError as error:
        return [str(error)], set()
    if len(lists) != theorems:
        return [f"Coq tells the assumptions of {len(lists)} theorems, not of {theorems}"], set()
    names = set().union(*lists)
    return [f"it assumes {name}" for name in sorted(names - set(AXIOMS))], names
