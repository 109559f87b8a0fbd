# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: python3 agrees.py TOUCHSTONE CORPUS SCRATCH

The corpus is what it claims to be: `exact` meets every expectation, the independent checker derives the same answers,
plain doubles do not pass, and the generated files come out of `make` again, byte for byte.
"""

import filecmp
import pathlib
import subprocess
import sys


def main(touchstone, corpus, scratch):
    corpus, scratch = pathlib.Path(corpus), pathlib.Path(scratch)
    files = sorted(corpus.glob("*.jsonl"))
    cases = scratch / "cases.jsonl"
    verdicts = scratch / "verdicts.jsonl"
    scratch.mkdir(parents=True, exist_ok=True)
    cases.write_text("".join(file.read_text() for file in files))
    faults = []

    with verdicts.open("w") as out:
        if subprocess.run([touchstone, "judge", "--method", "exact", cases], stdout=out).returncode != 0:
            faults.append("exact does not meet the corpus")
    checker = corpus.parent / "independent" / "checker.py"
    if subprocess.run([sys.executable, "-B", checker, cases, verdicts]).returncode != 0:
        faults.append("the independent checker disagrees")
    for method in ("fast", "thesis"):
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        if subprocess.run([touchstone, "judge", "--method", method, cases], **quiet).returncode != 1:
            faults.append(f"{method} passes the corpus, which is there to fail it")

    again = scratch / "again"
    subprocess.run([corpus / "make", touchstone, again], check=True)
    faults += [f"{file.name} is not what make writes" for file in sorted(again.glob("*.jsonl"))
               if not filecmp.cmp(file, corpus / file.name, shallow=False)]
    faults += [f"{file.name} is larger than 300 kB" for file in files if file.stat().st_size > 300_000]
    print("\n".join(faults) or f"{sum(1 for _ in cases.open())} cases in {len(files)} files: all is well")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
