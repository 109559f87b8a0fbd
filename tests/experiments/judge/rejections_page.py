# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: python3 rejections_page.py TOUCHSTONE SOURCE

Every code of the contract has its paragraph, in the order in which they are looked for, and the judge gives the case of
each that code and that sentence.
"""

import json
import pathlib
import re
import subprocess
import sys


def main(touchstone, source):
    page = pathlib.Path(source, "docs/rejections.md").read_text()
    codes = re.findall(r'RejectionCode::\w+: return "([a-z-]+)"',
                       pathlib.Path(source, "geometry/shapes/rejection.cpp").read_text())
    entries = re.findall(r"^## (\S+)\n\n(.+?)\n\n```json\n(.+?)\n```\n\n> (.+?)$", page, re.MULTILINE | re.DOTALL)
    told = [code for code, *_ in entries]
    faults = [] if told == codes else [f"the page has {told}, not {codes}"]
    for code, _, case, sentence in entries:
        given = json.loads(subprocess.run([touchstone, "judge"], input=case, capture_output=True, text=True).stdout)
        if (given.get("error"), given.get("message")) != (code, sentence):
            faults.append(f"{code}: the judge says {given.get('error')}: {given.get('message')}")
    print("\n".join(faults) or f"{len(entries)} codes")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
