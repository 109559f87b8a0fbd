# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts of tests share: a program is run, and the first thing that is not as it should be ends the test, which says so."""
import subprocess


class Failure(SystemExit):
    """Ends the script with status 1 and this sentence on standard error."""


def expect(holds, otherwise):
    if not holds:
        raise Failure(otherwise)


def run(*command, expected=0, **options):
    """What `subprocess.run` returns, with the output as text. A Failure if the exit status is not the expected one."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    expect(done.returncode == expected, f"{' '.join(map(str, command))}: exit status {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done
