#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: archive.py SOURCE FOLDER

Packs the certified corpus as FOLDER/touchstone-corpus-VERSION.tar.gz: the cases, those in floats as code, the pages that say
what they mean and how they were made, the licences, and SHA256SUMS. The same sources give the same bytes. Prints the archive's name and checksum.
"""
import gzip
import hashlib
import io
import json
import pathlib
import posixpath
import re
import sys
import tarfile

import as_code

CORPUS = pathlib.PurePosixPath("tests/corpus")
PAGES = {  # in the sources: its name in the archive
    "tests/corpus/README.md": "README.md", "tests/corpus/DATASHEET.md": "DATASHEET.md", "geometry/contact/CONTRACT.md": "CONTRACT.md",
    "docs/engines.md": "JUDGING.md", "docs/contract.svg": "contract.svg", "CITATION.cff": "CITATION.cff", "LICENSE": "LICENSE",
    "LICENSE-APACHE": "LICENSE-APACHE", "LICENSE-GPL": "LICENSE-GPL"}
UNDER_GPL = ("floats/real-meshes.jsonl",)
LINK = re.compile(r"(!?)\[([^]]*)\]\(([^)\s#]*)(#[^)\s]*)?\)")


def with_links(page, text):
    """Links between pages of the archive lead to them; of other links the words stay."""
    def link(found):
        picture, words, target, anchor = found.groups()
        if re.match("[a-z]+:", target) or not target:
            return found[0]
        path = pathlib.PurePosixPath(posixpath.normpath(f"{pathlib.PurePosixPath(page).parent}/{target}"))
        name = PAGES.get(str(path)) or (path.name if path.parent == CORPUS else None)
        return f"{picture}[{words}]({name}{anchor or ''})" if name else words

    return LINK.sub(link, text)


def files(source):
    """Name in the archive: content. Only the cases that corpus.json counts."""
    record = source / CORPUS / "corpus.json"
    found = {"corpus.json": record.read_bytes()}
    for entry in json.loads(found["corpus.json"])["files"]:
        found[entry["file"]] = (source / CORPUS / entry["file"]).read_bytes()
    free = [source / CORPUS / name for name in found if re.fullmatch(r"floats/[\w-]+\.jsonl", name) and name not in UNDER_GPL]
    for language, name in {"c": "touchstone_cases.h", "rust": "touchstone_cases.rs", "python": "touchstone_cases.py"}.items():
        found[f"code/{name}"] = as_code.text(language, free).encode()
    for page, name in PAGES.items():
        content = (source / page).read_bytes()
        found[name] = with_links(page, content.decode()).encode() if page.endswith(".md") else content
    found["SHA256SUMS"] = "".join(f"{hashlib.sha256(content).hexdigest()}  {name}\n" for name, content in sorted(found.items())).encode()
    return found


def archive(source):
    """The version and the bytes."""
    content = files(source)
    version = json.loads(content["corpus.json"])["version"]
    plain = io.BytesIO()
    with tarfile.open(fileobj=plain, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        for name, data in sorted(content.items()):
            member = tarfile.TarInfo(f"touchstone-corpus-{version}/{name}")
            member.size, member.mode, member.mtime = len(data), 0o644, 0
            tar.addfile(member, io.BytesIO(data))
    return version, gzip.compress(plain.getvalue(), mtime=0)


def main(source, folder):
    try:
        version, content = archive(pathlib.Path(source))
        path = pathlib.Path(folder) / f"touchstone-corpus-{version}.tar.gz"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    except OSError as error:
        sys.exit(f"archive.py: {error.filename}: {error.strerror}")
    print(f"{hashlib.sha256(content).hexdigest()}  {path}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: archive.py SOURCE FOLDER")
    main(*sys.argv[1:])
