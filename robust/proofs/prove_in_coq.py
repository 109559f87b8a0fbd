# SPDX-License-Identifier: Apache-2.0
"""Usage: python3 prove_in_coq.py RECORD GAPPA COQC FOLDER [--calculus TESTS] [--jobs N] [NAME...]

Has Coq check every claim that prove.py has Gappa prove, from Gappa's proof; the theories of coq/; the error-free
transformations, as recorded; and each step of the error calculus that the program TESTS carries out (error_bound.h). All must rest on nothing but the axioms of Coq's
library. FOLDER, which is made anew, keeps the theories. NAME: only what begins so. Exit status 1 if anything is not proved; an interruption stops at once.
"""

import argparse
import concurrent.futures
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

import calculus_steps
import claims
import coq
import error_free
import gappa
import prove

# Each with how many theorems it tells the assumptions of.
THEORIES = {"model": 0, "permanent": 0, "parity": 2, "own_frame": 5, "calculus": 1, "error_free": 5}


class Check:
    """Claims that Coq checks in a folder."""

    def __init__(self, gappa_program, coqc, folder):
        self.gappa, self.coqc, self.folder = gappa_program, coqc, folder
        self.running, self.stopped = set(), False

    def of_file(self, file, theorems=1):
        """Faults and assumptions of a file that stands in the folder."""
        if self.stopped:
            return ["it is not checked"], set()
        process = coq.compiled(self.coqc, file)
        self.running.add(process)
        output, _ = process.communicate()
        self.running.discard(process)
        return coq.faults(process.returncode, output, theorems)

    def of_theory(self, name, theorems):
        shutil.copy(coq.FOLDER / f"{name}.v", self.folder)
        return self.of_file(self.folder / f"{name}.v", theorems)

    def of_proof(self, proof):
        """Faults, assumptions and seconds."""
        start = time.monotonic()
        theory = proof.theory(self.gappa)
        if theory is None:
            return ["Gappa does not prove it"], set(), time.monotonic() - start
        file = self.folder / f"{proof.file_name}.v"
        file.write_text(theory)
        return *self.of_file(file, proof.theorems), time.monotonic() - start

    def stop(self):
        self.stopped = True
        for process in list(self.running):
            process.terminate()


class ProofOfClaim:
    """A claim that Gappa proves."""

    def __init__(self, claim):
        self.claim, self.name, self.file_name, self.says = claim, claim.name, claim.file_name, claim.proved
        self.count, self.theorems = 1, 2 if claim.sign else 1

    def theory(self, gappa_program):
        proof = gappa.proof_for_coq(gappa_program, self.claim.says, self.claim.unit)
        return None if proof is None else coq.theory(self.claim.says, proof) + self.claim.sign


class ProofOfTransformation:
    """That an error-free transformation is exact."""

    def __init__(self, transformation):
        self.transformation, self.file_name = transformation, transformation.file_name
        self.name, self.says = transformation.name, f"exact, as compiled for {' and '.join(transformation.targets)}"
        self.count, self.theorems = 1, 1

    def theory(self, _):
        return self.transformation.theory()


class ProofOfSteps:
    """Some of the steps of the error calculus."""

    def __init__(self, number, steps):
        self.name, self.file_name, self.says = f"calculus {number}", f"calculus_{number}", f"{len(steps.steps)} steps"
        self.steps, self.count, self.theorems = steps, len(steps.steps), 1

    def theory(self, _):
        return self.steps.text()


def proofs_of_steps(program, file):
    """Runs tests of the calculus; toy arithmetic proves nothing."""
    environment = {**os.environ, "TOUCHSTONE_CALCULUS_STEPS": str(file)}
    command = [program, "--gtest_filter=-Toy*", "--gtest_brief=1"]
    subprocess.run(command, env=environment, check=True, stdout=subprocess.DEVNULL)
    theories = calculus_steps.theories(file.read_text().splitlines())
    return [ProofOfSteps(number, steps) for number, steps in enumerate(theories, 1)]


class Progress:
    """A line a claim; on a terminal, how many are left, on the line below."""

    def __init__(self, count):
        self.count, self.done, self.on_terminal = count, 0, sys.stdout.isatty()

    def tell(self, line):
        self.done += 1
        print(f"\r\x1b[K{line}" if self.on_terminal else line, flush=True)
        if self.on_terminal and self.done < self.count:
            print(f"{self.done} of {self.count}", end="", flush=True)


def check_all(check, proofs, jobs):
    """The faults of all proofs, those that have none, and what they assume."""
    progress, faults, assumed, right = Progress(len(proofs)), [], set(), []
    pool = concurrent.futures.ThreadPoolExecutor(jobs)
    try:
        checking = {pool.submit(check.of_proof, proof): proof for proof in proofs}
        for future in concurrent.futures.as_completed(checking):
            proof, (found, names, seconds) = checking[future], future.result()
            faults += [f"{proof.name}: {fault}" for fault in found]
            assumed |= names
            if not found:
                right.append(proof)
            progress.tell(f"{proof.name}: {proof.says}, {'NOT checked' if found else 'checked'} in {seconds:.1f} s")
    finally:
        check.stop()
        pool.shutdown(cancel_futures=True)
    return faults, right, assumed


def arguments():
    parser = argparse.ArgumentParser(usage=__doc__.splitlines()[0].removeprefix("Usage: "))
    for name in ("record", "gappa", "coqc"):
        parser.add_argument(name)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--calculus")
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)))
    return parser.parse_intermixed_args()


def tally(proofs, right, kind):
    """How many of a kind are proved, of how many."""
    return " of ".join(str(sum(proof.count for proof in some if isinstance(proof, kind))) for some in (right, proofs))


def main():
    given, start = arguments(), time.monotonic()
    shutil.rmtree(given.folder, ignore_errors=True)
    given.folder.mkdir(parents=True)
    check, faults, assumed, right = Check(given.gappa, given.coqc, given.folder), [], set(), []
    for name, theorems in THEORIES.items():
        found, names = check.of_theory(name, theorems)
        faults += [f"{name}.v: {fault}" for fault in found]
        assumed |= names
    proofs = [ProofOfClaim(claim) for claim in claims.of_records(*prove.read(given.record))]
    proofs += [ProofOfTransformation(each) for each in error_free.transformations(prove.recorded(given.record))]
    if given.calculus:
        proofs += proofs_of_steps(given.calculus, given.folder.resolve() / "steps.txt")
    proofs = [proof for proof in proofs if not given.names or proof.name.startswith(tuple(given.names))]
    if not faults:
        faults, right, names = check_all(check, proofs, given.jobs)
        assumed |= names
    print("Assumed:", *sorted(assumed), sep="\n  ")
    print(*faults, sep="\n")
    print(f"{tally(proofs, right, ProofOfClaim)} claims checked by Coq, {tally(proofs, right, ProofOfTransformation)} error-free"
          f" transformations, {tally(proofs, right, ProofOfSteps)} steps of the error calculus, in {time.monotonic() - start:.0f} s")
    return 1 if faults or not proofs else 0


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        print("\ninterrupted", file=sys.stderr)
        sys.exit(130)
