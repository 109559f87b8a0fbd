#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: listings.py RECORD [--write]

The listings of the paper's example of a proof: the expression as the sources have it, its record, and its claim for Gappa
and for Coq. Compares listings/ with what RECORD, the program that prints the records, gives (exit status 1 if it differs),
or writes it.
"""
import pathlib
import re
import sys

PAPERS = pathlib.Path(__file__).resolve().parent
ROOT = PAPERS.parent
sys.path.append(str(ROOT / "robust/proofs"))

import claims  # noqa: E402
import prove  # noqa: E402

SIGN = "triangle_filter vertex_out"


def source():
    """The function of the expression, without its comment."""
    text = (ROOT / "robust/filtered/detail/signs/signs.h").read_text()
    return re.search(r"^template <class V, class R>\nconstexpr auto vertex\(.*?^}\n", text, re.M | re.S)[0]


def record_of(node):
    if "input" in node:
        return f'node {node["node"]}: input {node["input"]}'
    return f'node {node["node"]}: {" ".join(map(str, (node["of"][0], node["operation"], node["of"][1])))}'


def listings(program):
    model, records = prove.read(program)
    record = next(record for record in records if SIGN in record.get("uses", ()) and not prove.is_fused(record))
    claim, = claims.of_record(model, record)
    wrapped = re.sub(r" -> ", " ->\n  ", claim.says.for_coq())
    return {"source": source(), "record": "".join(record_of(node) + "\n" for node in record["nodes"]), "gappa": claim.says.for_gappa(),
            "coq": re.sub(r"\n\s*\n", "\n", wrapped) + "\n"}


def main(program, *options):
    status = 0
    for name, text in listings(program).items():
        path = PAPERS / "listings" / f"{name}.txt"
        if options == ("--write",):
            path.parent.mkdir(exist_ok=True)
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            print(f"{path}: differs from what the record gives; listings.py --write updates it")
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
