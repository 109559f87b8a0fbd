#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: page_picture.py TOUCHSTONE ROOT [--write]

Draws the README's picture from a small study: where methods place the foot around a reflex vertex, one double per square.
Compares it with the stored picture (exit status 1 if it differs), or writes it. It uses no drawing library, so the bytes
are the same on every machine.
"""
import pathlib
import subprocess
import sys
import tempfile

from studies.near_edge import TRUTH, WRONG, read_map

PICTURE = "docs/reflex-vertex.svg"
PANELS = {"filtered": "ours, certified", "fast": "ours, plain doubles", "thesis": "the 2008 thesis",
          "thesis-signed": "with signed angles"}
SQUARE, GAP, TOP, BOTTOM = 2, 16, 46, 46


def maps(touchstone):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([touchstone, "near-edge", "--methods", ",".join(PANELS), "--families", "l", "--samples", "1", "--seed", "1",
                        "--search", "0", "--no-pictures", "--output", folder], check=True, stdout=subprocess.DEVNULL)
        return read_map(pathlib.Path(folder, "map-reflex-vertex-foot-0.csv"))


def colour_of(truth, verdict):
    return WRONG[verdict][0] if verdict in WRONG else TRUTH[truth][0]


def squares(truth, verdicts, left):
    """One path per colour, of runs of squares in a row."""
    runs = {}
    for y, (truths, row) in enumerate(zip(truth, verdicts)):
        colours = [colour_of(t, v) for t, v in zip(truths, row)]
        begin = 0
        for x in range(1, len(colours) + 1):
            if x == len(colours) or colours[x] != colours[begin]:
                length = SQUARE * (x - begin)
                runs.setdefault(colours[begin], []).append(f"M{left + SQUARE * begin} {TOP + SQUARE * y}h{length}v{SQUARE}h-{length}z")
                begin = x
    return "".join(f'<path fill="{colour}" d="{"".join(parts)}"/>\n' for colour, parts in sorted(runs.items()))


def legend(letters, y):
    """The colours that occur."""
    verdicts = {v for method in PANELS for row in letters[method] for v in row}
    words = [TRUTH[t][:2] for t in "iob" if (letters["truth"] == t).any()] + [WRONG[v][:2] for v in "-+b" if v in verdicts]
    x, text = GAP, ""
    for colour, meaning in words:
        meaning = meaning.replace("right:", "correctly").replace("wrong: says", "wrongly").replace("wrong: inside and boundary confused", "inside and boundary confused")
        text += (f'<rect x="{x}" y="{y}" width="9" height="9" fill="{colour}" stroke="#888" stroke-width=".5"/>'
                 f'<text x="{x + 13}" y="{y + 8}">{meaning}</text>\n')
        x += 26 + 5.6 * len(meaning)
    return text


def picture(touchstone):
    letters = maps(touchstone)
    size = len(letters["truth"])
    side = SQUARE * size
    width, height = GAP + len(PANELS) * (side + GAP), TOP + side + BOTTOM
    text = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="10.5">\n'
            f'<title>Where methods put the foot around a reflex vertex</title>\n<rect width="{width}" height="{height}" fill="#fff"/>\n')
    for i, (method, words) in enumerate(PANELS.items()):
        left = GAP + i * (side + GAP)
        wrong = sum(v in WRONG for row in letters[method] for v in row)
        count = f"{wrong:,} of {size * size:,} wrong" if wrong else f"0 of {size * size:,} wrong"
        text += (f'<text x="{left}" y="20"><tspan font-family="monospace" font-weight="bold">{method}</tspan> {words}</text>'
                 f'<text x="{left}" y="36">{count}</text>\n' + squares(letters["truth"], letters[method], left) +
                 f'<rect x="{left}" y="{TOP}" width="{side}" height="{side}" fill="none" stroke="#888" stroke-width=".5"/>\n')
    return text + legend(letters, TOP + side + 14) + (f'<text x="{GAP}" y="{height - 8}" fill="#555">Each square moves the ball\'s centre by one double. At the '
                                             f'middle square the foot is the reflex vertex of an L.</text>\n</svg>\n')


def main(touchstone, root, *options):
    path, made = pathlib.Path(root, PICTURE), picture(touchstone)
    if "--write" in options:
        path.parent.mkdir(exist_ok=True)
        path.write_text(made)
    elif not path.exists() or path.read_text() != made:
        print(f"{path}: differs from what the study gives; page_picture.py --write updates it")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
