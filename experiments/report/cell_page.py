#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: cell_page.py TOUCHSTONE ROOT

Takes the picture of the cell's page that stands for Figure 5.16 of the thesis, in a headless Chromium, at the moment at
which the gripper puts the material into the machine. Run it again when the page changes: the picture is stored, because a report is also
drawn where there is no browser.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

PICTURE = "docs/cell-page.png"


def main(touchstone, root):
    cell = pathlib.Path(root, "experiments/thesis/cell/cells/aristo.json")
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder, "page.html")
        subprocess.run([touchstone, "cell", "export", cell, page], check=True, stdout=subprocess.DEVNULL)
        recorded = json.loads(re.search(r'id="recorded">(.*?)</script>', page.read_text(encoding="utf-8"), re.DOTALL)[1])
        stop = next(i for i, stop in enumerate(recorded["run"]["stops"]) if stop["touched"] is not None and stop["target"] == "machine")
        subprocess.run(["chromium", "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                        "--hide-scrollbars", "--window-size=1280,1000", "--virtual-time-budget=10000",
                        f"--screenshot={pathlib.Path(root, PICTURE).absolute()}", f"{page.as_uri()}#{stop}"],
                       check=True, stderr=subprocess.DEVNULL)


if __name__ == "__main__":
    main(*sys.argv[1:])
