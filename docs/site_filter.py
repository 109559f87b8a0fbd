# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: site_filter.py FILE

Prints a page or a header in the form that Doxygen expects. Doxygen calls this script for each of its inputs, from the root
of the sources.

A page gets a table of contents, anchors at its headings, and links that lead to them within the site. A link to a file
that is not a page becomes the file's path, which Doxygen links if it knows the file. In a header, numbered guarantees
become lists.
"""

import pathlib
import re
import sys

FENCE = re.compile(r"^(```.*?^```$)", re.MULTILINE | re.DOTALL)
HEADING = re.compile(r"^(#+) +(.+?)$", re.MULTILINE)
CODE = re.compile(r"(`+)(.+?)\1")
LINK = re.compile(r"(?<!!)\[([^][]+)\]\(([^()\s]+)\)")
IMAGE = re.compile(r"!\[([^][]+)\]\(([^()\s]+)\)")


def slug(heading):
    """The anchor of a heading, as hosts of git repositories name it."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def page_name(path):
    """The site's name of a page, such as `robust-proofs` for robust/proofs/README.md. Its file adds `.html`."""
    name = "-".join(path.with_suffix("").parts).lower()
    return "index" if name == "readme" else name.removesuffix("-readme")


def target(page, link):
    """The file and the anchor ("" for none) that a page's relative link leads to."""
    path, _, anchor = link.partition("#")
    return (page.parent / path if path else page).resolve().relative_to(pathlib.Path.cwd()), anchor


def quotable(text):
    """Puts code with a quote between double backticks: between single ones, Doxygen takes the quote for the end."""
    return CODE.sub(lambda code: f"``{code[2]}``" if "'" in code[2] else code[0], text)


def site_page(page, text):
    def heading(match):
        anchor = page_name(page) + ("" if match[1] == "#" else "-" + slug(match[2]))
        contents = "\n\n[TOC]" if match[1] == "#" else ""
        return match[0] + (f" {{#{anchor}}}" if anchor != "index" else "") + contents

    def link(match):
        if re.match(r"\w+:", match[2]):
            return match[0]
        path, anchor = target(page, match[2])
        if path.suffix != ".md":
            return f"`{path}`"
        words = " ".join(match[1].split())  # Doxygen wants them on one line
        return f"[{words}](@ref {page_name(path)}{'-' + anchor if anchor else ''})"

    def image(match):
        return f"![{' '.join(match[1].split())}]({target(page, match[2])[0].name})"

    parts = FENCE.split(text)
    parts[::2] = [quotable(IMAGE.sub(image, LINK.sub(link, HEADING.sub(heading, part)))) for part in parts[::2]]
    return "".join(parts)


def site_header(text):
    lines, in_list = [], False
    for line in text.splitlines():
        item = re.match(r"( *///) +\((\d+)\) (.*)", line)
        if item:
            line = f"{item[1]}  {item[2]}. {item[3]}"
        elif in_list and re.match(r" */// \S", line):
            lines.append("///")
        in_list = bool(item) or in_list and bool(re.match(r" *///  ", line))
        lines.append(line)
    return quotable("\n".join(lines) + "\n")


def main(file):
    page = pathlib.Path(file).resolve().relative_to(pathlib.Path.cwd())
    text = page.read_text()
    print(site_page(page, text) if page.suffix == ".md" else site_header(text), end="")


if __name__ == "__main__":
    main(*sys.argv[1:])
