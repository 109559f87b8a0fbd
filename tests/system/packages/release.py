# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: release.py SOURCE

What ./release has made in SOURCE/dist: the files that docs/platforms.md lists and no others, as SHA256SUMS says. The program
answers, the header is C99, and the page holds its library.
"""

import json
import pathlib
import re
import sys

sys.path.append(str(pathlib.Path(__file__).parents[1]))
from running import expect, run  # noqa: E402


def main(source):
    source = pathlib.Path(source).resolve()
    dist = source / "dist"
    corpus = json.loads((source / "tests/corpus/corpus.json").read_text())["version"]
    table = (source / "docs/platforms.md").read_text().partition("## Releases")[2].replace("VERSION", str(corpus))
    promised = sorted(re.findall(r"^\| `(.*?)` \|", table, re.MULTILINE))
    made = sorted(file.name for file in dist.iterdir())
    expect(promised and made == promised, f"docs/platforms.md promises {promised}; ./release made {made}")
    summed = re.findall(r"  (.*)", (dist / "SHA256SUMS").read_text())
    expect(sorted(summed) == [name for name in made if name != "SHA256SUMS"], f"SHA256SUMS names {summed}")
    run("sha256sum", "--check", "--strict", "SHA256SUMS", cwd=dist)

    archive = next(dist.glob("*-x86_64.tar.gz"))
    scratch = source / "build/release-check"
    scratch.mkdir(parents=True, exist_ok=True)
    run("tar", "-xf", archive, "-C", scratch)
    said = run(scratch / archive.name.removesuffix(".tar.gz") / "bin/touchstone", "corpus", "check").stdout
    expect(" 0 faults" in said, f"the program says {said}")
    run("cc", "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only", dist / "touchstone_cases.h")
    page = (dist / "playground.html").read_text()
    expect(len(page) > 500_000 and "<script" in page, f"the playground has {len(page)} letters")
    print(f"{len(made)} files, as docs/platforms.md promises")


if __name__ == "__main__":
    main(*sys.argv[1:])
