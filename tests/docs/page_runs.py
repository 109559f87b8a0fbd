# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: page_runs.py PAGE --samples              prints the page's programs in C++ as one program
       page_runs.py PAGE TOUCHSTONE [SAMPLES] [--without-python] [--write]

Runs the samples of a page and compares what they print with the page's `text` blocks. A `text` block belongs to the C++
program (`cpp`; SAMPLES is the program compiled from all of them), the commands (`sh`) or the script (`python`) before it.
Commands without a `text` block are not run. A block after "`NAME`:" is written to a file of that name. Everything runs in
one folder, empty at first, in the order of the page. Exit status 1 if a sample prints something else; --write puts that
into the page.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PROGRAMS = ("cpp", "sh", "python")


class Block:
    def __init__(self, before, match):
        self.language, self.text, self.span = match[1], match[2], match.span(2)
        name = re.search(r"`([\w.-]+)`:\n\n$", before)
        self.file = name[1] if name else None
        self.output = None  # the `text` block


def blocks_of(page):
    blocks, end = [], 0
    for match in BLOCK.finditer(page):
        block = Block(page[end:match.start()], match)
        end = match.end()
        if block.language != "text":
            blocks.append(block)
        elif not blocks or blocks[-1].output or blocks[-1].language not in PROGRAMS:
            sys.exit(f"{sys.argv[1]}: no sample prints this:\n{block.text}")
        else:
            blocks[-1].output = block
    for block in blocks:
        if block.language in ("cpp", "python") and not block.output and not block.file:
            sys.exit(f"{sys.argv[1]}: the page does not say what this sample prints:\n{block.text}")
    return blocks


def samples(blocks):
    includes, bodies = [], []
    for block in (b for b in blocks if b.language == "cpp" and not b.file):
        includes += re.findall(r"^#include .*$", block.text, re.MULTILINE)
        rest = re.sub(r"^#include .*\n", "", block.text, flags=re.MULTILINE)
        bodies.append(rest.replace("int main()", f"void sample_{len(bodies)}()"))
    calls = "".join(f"    case {i}: sample_{i}(); break;\n" for i in range(len(bodies)))
    return ("\n".join(dict.fromkeys([*includes, "#include <cstdlib>"])) + "\n\nnamespace {\n\n" + "\n".join(bodies) +
            "\n}  // namespace\n\nint main(int, char** arguments) {\n  switch (std::atoi(arguments[1])) {\n" + calls +
            "  }\n}\n")


def run(blocks, options, folder):
    """Yields each block that has a `text` block, with what it prints."""
    environment = dict(os.environ, PATH=f"{pathlib.Path(options.touchstone).resolve().parent}:{os.environ['PATH']}")
    number_of_sample = 0
    for block in blocks:
        if block.file:
            (folder / block.file).write_text(block.text)
        if not block.output:
            continue
        if block.language == "cpp":
            command = [options.samples, str(number_of_sample)]
            number_of_sample += 1
        elif block.language == "sh":
            command = ["bash", "-c", block.text]
        elif options.without_python:
            continue
        else:
            command = [sys.executable, "-B", "-c", block.text]
        done = subprocess.run(command, cwd=folder, env=environment, text=True, timeout=300, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        yield block, done.stdout


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("touchstone", nargs="?", type=pathlib.Path)
    parser.add_argument("samples", nargs="?", type=pathlib.Path)
    parser.add_argument("--samples", action="store_true", dest="print_samples")
    parser.add_argument("--without-python", action="store_true")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    page = options.page.read_text()
    blocks = blocks_of(page)
    if options.print_samples:
        print(samples(blocks), end="")
        return 0

    if options.samples:
        options.samples = options.samples.resolve()
    with tempfile.TemporaryDirectory() as folder:
        results = list(run(blocks, options, pathlib.Path(folder)))
    wrong = [(block, printed) for block, printed in results if printed != block.output.text]
    if options.write:
        for block, printed in reversed(wrong):
            begin, end = block.output.span
            page = page[:begin] + printed + page[end:]
        options.page.write_text(page)
    for block, printed in wrong:
        print(f"{options.page}: the sample\n{block.text}\nshould print\n{block.output.text}\nIt prints\n{printed}")
    print(f"{len(results)} outputs, {len(wrong)} differ from the page")
    return 1 if wrong or not results else 0


if __name__ == "__main__":
    sys.exit(main())
