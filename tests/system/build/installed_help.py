# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: installed_help.py CMAKE SOURCE TOUCHSTONE SCRATCH

What `cmake --install` does for the program's help: the pages of the manual and the completion scripts lie where man and
the shells look for them, and are read without complaint where these are installed. Exit status 1 otherwise.
"""
import pathlib
import shutil
import sys

sys.path.append(str(pathlib.Path(__file__).parents[1]))
from running import expect, run  # noqa: E402


def main(cmake, source, touchstone, scratch):
    scratch = pathlib.Path(scratch)
    shutil.rmtree(scratch, ignore_errors=True)
    for _ in range(2):  # also over an installation that is there
        run(cmake, f"-Dtouchstone_program={touchstone}", f"-Dfolder={scratch}", "-Dman=share/man", "-Ddata=share", "-P",
            f"{source}/cmake/install_help.cmake")
    pages = sorted((scratch / "share/man/man1").iterdir())
    names = [page.name for page in pages]
    expect({"touchstone.1", "touchstone-near-edge.1"} <= set(names), f"the pages are {names}")
    readers = {"bash": (["bash", "-n"], scratch / "share/bash-completion/completions/touchstone"),
               "zsh": (["zsh", "-n"], scratch / "share/zsh/site-functions/_touchstone"),
               **{f"groff {page.name}": (["groff", "-man", "-Tutf8", "-ww", "-Wbreak", "-z"], page) for page in pages}}
    for name, (command, file) in readers.items():
        expect(file.read_text(), f"{file} is empty")
        if shutil.which(command[0]):
            said = run(*command, file).stderr
            expect(not said, f"{name}: {said}")
    shutil.rmtree(scratch)


if __name__ == "__main__":
    main(*sys.argv[1:])
