# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: planted.py HTML

A test that cannot fail proves nothing: browser.py must fail on each of these bugs, planted in a copy of the page. Exit
status 1 if one survives, or if its text is not found in the page.
"""

import pathlib
import subprocess
import sys
import tempfile

BUGS = [
    ("the last bit of a coordinate is lost on its way to the library", "this.numbers().set(values);",
     "this.numbers().set(Array.from(values, (x) => Number(x.toPrecision(16))));"),
    ("the address rounds", 'p.join(",")', 'p.map((x) => x.toFixed(12)).join(",")'),
    ("neighbours are two doubles apart", "BigInt(steps)", "2n * BigInt(steps)"),
    ("the map is painted half a window away", "centers.set(plane.point(middle(order.a, i)", "centers.set(plane.point(middle(order.a, i >> 1)"),
    ("fast and thesis are exchanged in the map", '["--fast", "--thesis", "--both"]', '["--thesis", "--fast", "--both"]'),
    ("a hole is filled", "const loops = [polygon.outer, ...(polygon.holes ?? [])];", "const loops = [polygon.outer];"),
    ("lines beyond the window are drawn from rounded ends", "if (ends.flat().every((pixels) => Math.abs(pixels) < FAR)) return ends;",
     "return ends.map((end) => end.map((pixels) => Math.min(Math.max(pixels, -FAR), FAR)));"),
    ("the ball is dragged upside down", "this.b - (y - this.height / 2 + this.restB) / this.scale",
     "this.b + (y - this.height / 2 + this.restB) / this.scale"),
]


def fault_found(page):
    """What browser.py says of the page in its last line; None if it passes."""
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "playground.html"
        copy.write_text(page)
        test = pathlib.Path(__file__).with_name("browser.py")
        done = subprocess.run([sys.executable, "-B", test, copy], capture_output=True, text=True)
    return (done.stderr.strip().splitlines() or ["nothing"])[-1] if done.returncode else None


def main():
    page = pathlib.Path(sys.argv[1]).read_text()
    if fault := fault_found(page):
        sys.exit(f"planted: without any bug the test says: {fault}")
    survivors = 0
    for bug, old, new in BUGS:
        if old not in page:
            sys.exit(f"planted: the page has no {old!r}")
        fault = fault_found(page.replace(old, new))
        print(f"killed: {bug} ({fault[:150]})" if fault else f"SURVIVED: {bug}", flush=True)
        survivors += fault is None
    sys.exit(survivors > 0)


main()
