# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: references.py SOURCE

Everything that the pages refer to exists: files and headings that links lead to, pictures, entries of the bibliography,
files that studies write. Links lead from README.md to every page, every page is in the site, and a page shows every
drawing. Exit status 1 otherwise.
"""

import os
import pathlib
import re
import sys


def main(source):
    os.chdir(source)
    sys.path.append("docs")
    import site_filter

    folders = ("bindings", "docs", "experiments", "geometry", "papers", "robust", "tests")
    pages = [*pathlib.Path().glob("*.md"), *(page for folder in folders for page in pathlib.Path(folder).rglob("*.md"))]
    prose = {page: "".join(site_filter.FENCE.split(page.read_text())[::2]) for page in pages}
    anchors = {page: {site_filter.slug(heading) for _, heading in site_filter.HEADING.findall(text)}
               for page, text in prose.items()}
    site = pathlib.Path("docs/Doxyfile").read_text()

    faults, leads_to, links, shown = [], {page: set() for page in pages}, 0, set()
    for page, text in prose.items():
        if not re.search(rf"^[^#]* {re.escape(str(page))}( |$)", site, re.MULTILINE):
            faults.append(f"{page}: not a page of the site, docs/Doxyfile")
        for _, link in site_filter.LINK.findall(text):
            if re.match(r"\w+:", link):
                continue
            links += 1
            path, anchor = site_filter.target(page, link)
            if not path.exists():
                faults.append(f"{page}: {link}: no such file: {path}")
            elif anchor and anchor not in anchors.get(path, ()):
                faults.append(f"{page}: {link}: {path} has no such heading")
            leads_to[page].add(path)
        for _, link in site_filter.IMAGE.findall(text):
            path, _ = site_filter.target(page, link)
            shown.add(path)
            if not path.exists():
                faults.append(f"{page}: {link}: no such picture: {path}")
    drawings = set(pathlib.Path("docs").rglob("*.svg"))
    faults += [f"{drawing}: no page shows it" for drawing in sorted(drawings - shown)]

    reached, found = {pathlib.Path("README.md")}, [pathlib.Path("README.md")]
    while found:
        found = [page for page in leads_to[found.pop()] & set(pages) - reached] + found
        reached.update(found)
    faults += [f"{page}: no links from README.md lead to it" for page in pages if page not in reached]

    entries = set(re.findall(r"^@\w+\{(\w+),", pathlib.Path("papers/references.bib").read_text(), re.MULTILINE))
    cited = 0
    code = [file for folder in folders for file in pathlib.Path(folder).rglob("*") if file.suffix in (".h", ".cpp", ".py")]
    for file in [*pages, *code]:
        for key in re.findall(r"\[([a-z]{3,}\d{4}[a-z]?)[],]", file.read_text()):
            cited += 1
            if key not in entries:
                faults.append(f"{file}: [{key}] is not in papers/references.bib")

    sources = "".join(file.read_text() for file in pathlib.Path("experiments").rglob("*.cpp"))
    formats = pathlib.Path("docs/formats.md")
    tables = set(re.findall(r"`([\w-]+\.(?:csv|jsonl|txt))`", prose[formats].partition("## Tables of studies")[2]))
    faults += [f"{formats}: nothing writes {name}" for name in sorted(tables) if f'"{name}"' not in sources]

    print("\n".join(faults) or f"{len(pages)} pages, {links} links, {len(shown)} pictures, {cited} citations, {len(tables)} tables")
    return 1 if faults or min(links, cited, len(shown), len(tables)) == 0 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
