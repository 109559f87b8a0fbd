# SPDX-License-Identifier: Apache-2.0
"""What Gappa says to a statement [melquiond2007]."""

import re
import subprocess


def run(program, statement, unit, *options):
    digits = 2 * unit.denominator.bit_length() + 64
    # Hints with a denominator say that it must be shown not to be zero; else they are checked to be identities.
    command = [program, "-Wno-null-denominator", f"-Eprecision={digits}", *options]
    return subprocess.run(command, input=statement.for_gappa(), capture_output=True, text=True)


def proves(program, statement, unit):
    """True if Gappa proves the statement, False if it refuses; anything else is an error."""
    if len(statement.goals) > 1:  # together, those that it refuses take long
        return all(proves(program, statement.with_goal(goal), unit) for goal in statement.goals)
    result = run(program, statement, unit)
    complaint = result.stdout + result.stderr
    if result.returncode == 0 and not complaint.strip():
        return True
    if result.returncode == 1 and re.search(r"some (properties|enclosures) were not satisfied", complaint):
        return False
    raise RuntimeError(f"gappa ends with status {result.returncode}: {complaint[-600:]}\n{statement.for_gappa()}")


def proof_for_coq(program, statement, unit):
    """Gappa's proof in Coq's language, in which its hints are assumed. None if Gappa refuses the statement."""
    result = run(program, statement, unit, "-Bcoq")
    return result.stdout if result.returncode == 0 and not result.stderr.strip() else None
