# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: site.py FOLDER

Every link, menu entry and picture of the site that Doxygen made leads to an existing file, and to an existing place in it.
Every namespace of a header has a page; without one, the site would not show its functions. Exit status 1 otherwise.
"""

import html.parser
import pathlib
import re
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.places, self.text = set(), set(), path.read_text()
        self.feed(self.text)

    def handle_starttag(self, _, attributes):
        for name, value in attributes:
            if name in ("id", "name"):
                self.places.add(value)
            elif name in ("href", "src") and value and not urllib.parse.urlsplit(value).scheme:
                self.links.add(urllib.parse.unquote(value))


def main(folder):
    folder = pathlib.Path(folder)
    pages = {path.name: Page(path) for path in folder.glob("*.html")}
    links_of = {name: page.links for name, page in pages.items()}
    links_of["menudata.js"] = set(re.findall(r'url:"([^"]+)"', (folder / "menudata.js").read_text()))
    faults, links = [], 0
    for name, found in links_of.items():
        for link in found:
            file, _, place = link.partition("#")
            links += 1
            if file and not (folder / file).exists():
                faults.append(f"{name}: {link}: no such file")
            elif place and (file or name) in pages and place not in pages[file or name].places:
                faults.append(f"{name}: {link}: no such place")
    for name, page in pages.items():
        if "](<a " in page.text:
            faults.append(f"{name}: Doxygen did not understand a link")
        for namespace in re.findall(r"namespace </span>(\w[\w:]*) {", page.text if "_8h_source" in name else ""):
            faults.append(f"{name}: namespace {namespace} has no comment, so the site has no page for it")
    print("\n".join(sorted(faults)) or f"{len(pages)} pages, {links} links")
    return 1 if faults or not links else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
