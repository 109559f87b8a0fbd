# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: png.py TOUCHSTONE

`touchstone show --png` leaves a hole white, and the polygon about it has its colour. Exit status 1 otherwise.
"""
import pathlib
import subprocess
import sys
import tempfile

import matplotlib.image

CASE = ('{"id":"a","ball":{"center":[1,1,9],"radius":1},"polygon":{"outer":[[0,0,0],[9,0,0],[9,9,0],[0,9,0]],'
        '"holes":[[[3,3,0],[6,3,0],[6,6,0],[3,6,0]]]}}\n')


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        case, picture = pathlib.Path(folder, "case.jsonl"), pathlib.Path(folder, "case.png")
        case.write_text(CASE)
        subprocess.run([program, "show", case, "--png", picture], check=True)
        pixels = matplotlib.image.imread(picture)
    row = [tuple(round(255 * value) for value in pixel[:3]) for pixel in pixels[492, 44:836]]
    runs = [colour for colour, before in zip(row, [None, *row]) if colour != before and row.count(colour) > 50]
    if len(runs) != 5 or runs[2] != (255, 255, 255) or runs[1] != runs[3] or runs[1] == runs[0]:
        sys.exit(f"along a line through the hole there are {runs}")


if __name__ == "__main__":
    main(*sys.argv[1:])
