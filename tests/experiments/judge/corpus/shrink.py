# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: python3 shrink.py TOUCHSTONE CORPUS

`touchstone corpus shrink` prints cases that the judge takes and that fail as before, from a file and from standard
input; what it cannot shrink is an error that names the case, the method, or the line, and the other cases are shrunk.
"""

import json
import pathlib
import subprocess
import sys

sys.path.append(str(pathlib.Path(__file__).parents[3] / "system"))
from running import expect, run  # noqa: E402


def main(touchstone, corpus):
    def shrink(text, *options):
        return subprocess.run([touchstone, "corpus", "shrink", "-", *options], input=text, capture_output=True, text=True)

    lines = [line for line in (pathlib.Path(corpus) / "holes.jsonl").read_text().splitlines() if "fails:fast\"" in line]
    some = "\n".join(lines[:12]) + "\n"
    small = shrink(some, "--method", "fast")
    expect(small.returncode == 0, f"twelve failing cases: status {small.returncode}: {small.stderr}")
    cases = [json.loads(line) for line in small.stdout.splitlines()]
    expect([case["id"] for case in cases] == [json.loads(line)["id"] for line in lines[:12]], "ids or their order changed")
    size = [sum(len(json.dumps(json.loads(line)["polygon"])) for line in text.splitlines())
            for text in (some, small.stdout)]
    expect(size[1] < size[0] / 2, f"twelve polygons of {size[0]} characters still have {size[1]}")
    expect(all("shrunk" in case["tags"] and "fails:fast" in case["tags"] for case in cases), "tags are missing")
    expect(shrink(some, "--method", "fast").stdout == small.stdout, "a second run prints something else")
    expect(shrink(small.stdout, "--method", "fast").stdout == small.stdout, "what was shrunk is shrunk again")
    for method, status in (("exact", 0), ("filtered", 0), ("fast", 1)):
        run(touchstone, "judge", "--methods", method, input=small.stdout, expected=status)

    square = {"id": "square", "ball": {"center": [1, 1, 1], "radius": 2},
              "polygon": {"outer": [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]}}
    fine, bad = json.dumps(square), json.dumps(square | {"id": "flat", "ball": {"center": [1, 1], "radius": 2}})
    touching = json.dumps(square | {"id": "touching", "ball": {"center": [1, 1, 1], "radius": 1}})
    for text, options, names in (
            (fine, ("--method", "thesis"), "case square: thesis is not wrong about it"),
            (bad, ("--method", "thesis"), "case flat: rejected: malformed-case"),
            ("{\n", ("--method", "thesis"), "line 1: not JSON"),
            (fine, ("--method", "all"), "--method all: a case is shrunk for one method"),
            ("", ("--method", "thesis"), "there is no case"),
            (touching, ("--method", "thesis", "--key", "foot"), "case touching: thesis is not wrong about its foot"),
            (touching, ("--method", "nobody"), 'there is no method "nobody"')):
        result = shrink(text, *options)
        expect(result.returncode == 2 and names in result.stderr and result.stdout == "",
               f"{names}: status {result.returncode}, {result.stderr}")
    mixed = shrink(f"{fine}\n{touching}\n", "--method", "thesis", "--key", "contact")
    expect(mixed.returncode == 2 and mixed.stdout.count("\n") == 1, "a case that does not fail ends the others")
    missing = run(touchstone, "corpus", "shrink", "/nowhere/at-all", "--method", "fast", expected=2)
    expect("/nowhere/at-all: cannot be read" in missing.stderr, missing.stderr)
    print(f"{len(cases)} polygons shrunk from {size[0]} to {size[1]} characters: all is well")


if __name__ == "__main__":
    main(*sys.argv[1:])
