# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: page_runs.py PAGE TOUCHSTONE [--build BUILD] [--configure=OPTION]... [--without-python] [--write]

Runs the samples of a page and compares what they print with the page's `text` blocks. A `text` block belongs to the C++
program (`cpp`), the commands (`sh`) or the script (`python`) before it. Commands without a `text` block are not run. A block
after "`NAME`:" is written to a file of that name. Everything runs in one folder, empty at first, in the order of the page.
Exit status 1 if a sample prints something else; --write puts that into the page.

Programs in C++ are compiled as a reader would: the library of BUILD is installed into a new folder, and a project that says
what the page's block `cmake` says makes each program a target of its own. A program that reads a file of Touchstone's from
anywhere else is an error. OPTION: for the configuration of that project.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parents[1] / "system"))
import running  # noqa: E402

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


def compile_samples(blocks, options, folder):
    """Returns the programs of the blocks `cpp`, in their order."""
    texts = [block.text for block in blocks if block.language == "cpp" and block.output]
    if not texts:
        return []
    prefix, build = folder / "prefix", folder / "build"
    for component in "library", "development":
        running.run("cmake", "--install", options.build, "--prefix", prefix, "--component", component)
    use = next(block.text for block in blocks if block.language == "cmake")
    project = "cmake_minimum_required(VERSION 3.25)\nproject(Reader LANGUAGES CXX)\n"
    for number, text in enumerate(texts):
        (folder / f"sample_{number}.cpp").write_text(text)
        project += f"add_executable(sample_{number} sample_{number}.cpp)\n" + use.replace("yours", f"sample_{number}")
    (folder / "CMakeLists.txt").write_text(project)
    running.run("cmake", "-G", "Ninja", "-S", folder, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}", *options.configure)
    running.run("cmake", "--build", build)
    read = set(re.findall(r"^    (.*\b(?:geometry|robust|touchstone)/.*\.h)$", running.run("ninja", "-C", build, "-t", "deps").stdout, re.MULTILINE))
    elsewhere = sorted(header for header in read if prefix not in (build / header).resolve().parents)
    if not read or elsewhere:
        sys.exit(f"headers were read from outside of the installation: {elsewhere}")
    return [str(build / f"sample_{number}") for number in range(len(texts))]


def run(blocks, options, programs, folder):
    """Yields each block that has a `text` block, with what it prints. `programs`: of the blocks `cpp`."""
    environment = dict(os.environ, PATH=f"{pathlib.Path(options.touchstone).resolve().parent}:{os.environ['PATH']}")
    programs = iter(programs)
    for block in blocks:
        if block.file:
            (folder / block.file).write_text(block.text)
        if not block.output:
            continue
        if block.language == "cpp":
            command = [next(programs)]
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
    parser.add_argument("touchstone", type=pathlib.Path)
    parser.add_argument("--build", type=pathlib.Path)
    parser.add_argument("--configure", action="append", default=[])
    parser.add_argument("--without-python", action="store_true")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    page = options.page.read_text()
    blocks = blocks_of(page)
    with tempfile.TemporaryDirectory() as compiled, tempfile.TemporaryDirectory() as folder:
        programs = compile_samples(blocks, options, pathlib.Path(compiled).resolve())
        results = list(run(blocks, options, programs, pathlib.Path(folder)))
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
