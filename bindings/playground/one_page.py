# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: one_page.py PAGE WASM HTML

Writes PAGE/index.html with everything that it names inside: a line `<!-- put FILE... -->` stands for the text of these
files, and WASM among them for the module in base64.
"""

import base64
import pathlib
import re
import sys


def main():
    page, wasm, html = (pathlib.Path(argument) for argument in sys.argv[1:])

    def text(name):
        if name == "WASM":
            return base64.b64encode(wasm.read_bytes()).decode() + "\n"
        return (page / name).read_text()

    whole = re.sub(r" *<!-- put (.*) -->\n", lambda found: "".join(map(text, found[1].split())), (page / "index.html").read_text())
    html.write_text(whole)


main()
