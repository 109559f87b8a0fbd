# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: installed_help.py CMAKE SOURCE TOUCHSTONE SCRATCH

What `cmake --install` does for the program's help: the pages of the manual and the completion scripts lie where man and
the shells look for them, and are read without complaint where these are installed. Exit status 1 otherwise.
"""
import pathlib
import shutil
import subprocess
import sys


def main(cmake, source, touchstone, scratch):
    scratch = pathlib.Path(scratch)
    shutil.rmtree(scratch, ignore_errors=True)
    for _ in range(2):  # also over an installation that is there
        subprocess.run([cmake, f"-Dtouchstone_program={touchstone}", f"-Dfolder={scratch}", "-Dman=share/man", "-Ddata=share", "-P",
                        f"{source}/cmake/install_help.cmake"], check=True, stdout=subprocess.DEVNULL)
    pages = sorted((scratch / "share/man/man1").iterdir())
    names = [page.name for page in pages]
    if "touchstone.1" not in names or "touchstone-near-edge.1" not in names:
        sys.exit(f"the pages are {names}")
    readers = {"bash": (["bash", "-n"], scratch / "share/bash-completion/completions/touchstone"),
               "zsh": (["zsh", "-n"], scratch / "share/zsh/site-functions/_touchstone"),
               **{f"groff {page.name}": (["groff", "-man", "-Tutf8", "-ww", "-Wbreak", "-z"], page) for page in pages}}
    for name, (command, file) in readers.items():
        if not file.read_text():
            sys.exit(f"{file} is empty")
        if shutil.which(command[0]):
            done = subprocess.run([*command, str(file)], capture_output=True, text=True)
            if done.returncode != 0 or done.stderr:
                sys.exit(f"{name}: {done.stderr}")
    shutil.rmtree(scratch)


if __name__ == "__main__":
    main(*sys.argv[1:])
