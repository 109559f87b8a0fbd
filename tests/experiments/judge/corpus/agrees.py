# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: python3 agrees.py TOUCHSTONE CORPUS SCRATCH

The corpus is what it claims to be: `corpus check` and the independent checker derive the same answers, plain doubles and
the thesis's method do not pass, and every file comes out of `corpus make` again, byte for byte, page and counts
included, whatever the number of threads.
"""

import json
import pathlib
import shutil
import sys

sys.path.append(str(pathlib.Path(__file__).parents[3] / "system"))
from running import run  # noqa: E402


def main(touchstone, corpus, scratch):
    corpus, scratch = pathlib.Path(corpus), pathlib.Path(scratch)
    files = sorted(corpus.rglob("*.jsonl"))
    cases = scratch / "cases.jsonl"
    verdicts = scratch / "verdicts.jsonl"
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    cases.write_text("".join(file.read_text() for file in files))

    run(touchstone, "corpus", "check", *files)
    verdicts.write_text(run(touchstone, "judge", "--methods", "exact", cases).stdout)
    run(sys.executable, "-B", corpus.parent / "system/independent/checker.py", cases, verdicts)
    for method in ("fast", "thesis"):  # the corpus is there to fail them
        run(touchstone, "judge", "--methods", method, cases, expected=1)

    stored = {str(file.relative_to(corpus)): file.read_bytes() for file in [*files, corpus / "README.md", corpus / "corpus.json"]}
    again = scratch / "again"
    run(touchstone, "corpus", "make", "--threads", "3", again)  # stored: by two
    made = {str(file.relative_to(again)): file.read_bytes() for file in again.rglob("*") if file.is_file()}
    faults = [f"{name} is not what make writes" for name in sorted(stored.keys() | made.keys())
               if stored.get(name) != made.get(name)]
    faults += [f"{name} is larger than 350 kB" for name, content in stored.items() if len(content) > 350_000]
    counted = {entry["file"]: entry["cases"] for entry in json.loads(stored["corpus.json"])["files"]}
    faults += [f"{name}: corpus.json counts {counted.get(name)} cases" for name, content in stored.items()
               if name.endswith(".jsonl") and counted.get(name) != content.count(b"\n")]
    print("\n".join(faults) or f"{sum(counted.values())} cases in {len(files)} files: all is well")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
