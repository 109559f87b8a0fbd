# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: completion.py TOUCHSTONE SCRATCH

The Tab key in a zsh and in a bash that have read the program's scripts, typed on a terminal. Exit status 1 if a word is
completed otherwise than it should be; says so and goes on where a shell is not installed.
"""
import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import sys
import time

PATIENCE = 60
# What is typed before Tab, and the line that it becomes. A file `notes.txt` lies there.
TYPED = {
    "touchstone jud": "touchstone judge ",
    "touchstone cell lay": "touchstone cell layout ",
    "touchstone cell run --pre": "touchstone cell run --preset ",
    "touchstone near-edge --fam": "touchstone near-edge --families ",
    "touchstone near-edge --oracle fil": "touchstone near-edge --oracle filtered ",
    "touchstone near-edge --output no": "touchstone near-edge --output notes.txt ",
    "touchstone judge no": "touchstone judge notes.txt ",
    "touchstone judge --engine x --summ": "touchstone judge --engine x --summary ",
    "touchstone corpus shr": "touchstone corpus shrink ",
    "touchstone completion z": "touchstone completion zsh ",
    "touchstone help tun": "touchstone help tunnelling ",
    "touchstone --ver": "touchstone --version ",
}
SHELLS = {  # the command, and what it reads first: control-X then Y prints the line and empties it
    "bash": (["bash", "--norc", "-i"], """bind 'set enable-bracketed-paste off'; show() { echo "LINE[$READLINE_LINE]"; READLINE_LINE=; }
bind -x '"\\C-xy": show'; PS1=; . ./_touchstone"""),
    "zsh": (["zsh", "-f", "-i"], """PS1=; unset zle_bracketed_paste; fpath=($PWD $fpath); autoload -Uz compinit; compinit -D -u
show() { zle -I; print -r -- "LINE[$BUFFER]"; BUFFER=; }; zle -N show; bindkey -e; bindkey '^Xy' show"""),
}


class Terminal:
    """A shell on a terminal of its own."""

    def __init__(self, command, folder):
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            os.environ.update(TERM="dumb", HOME=str(folder), INPUTRC="/dev/null")
            os.execvp(command[0], command)

    def type(self, text):
        os.write(self.terminal, text.encode())

    def read_until(self, pattern):
        text, end = "", time.monotonic() + PATIENCE
        while not (found := re.search(pattern, text)):
            if not select.select([self.terminal], [], [], max(0, end - time.monotonic()))[0]:
                raise TimeoutError(f"there is no {pattern} in {text!r}")
            text += os.read(self.terminal, 65536).decode(errors="replace")
        return found[1]

    def close(self):
        os.close(self.terminal)  # which hangs up
        os.waitpid(self.process, 0)


def faults(shell, program, folder):
    command, preparation = SHELLS[shell]
    script = subprocess.run([program, "completion", shell], capture_output=True, text=True, check=True).stdout
    (folder / "_touchstone").write_text(script)
    (folder / "notes.txt").touch()
    terminal = Terminal(command, folder)
    try:
        terminal.type(preparation + "\necho RE''ADY[1]\n")
        terminal.read_until(r"READY\[(1)\]")
        for typed, wanted in TYPED.items():
            terminal.type(f"{typed}\t\x18y")
            line = terminal.read_until(r"LINE\[(.*?)\]")
            if line != wanted:
                yield f"{shell}: {typed!r} becomes {line!r}, not {wanted!r}"
    finally:
        terminal.close()


def main(program, scratch):
    found = []
    for shell in SHELLS:
        if not shutil.which(shell):
            print(f"{shell} is not installed: its completion is not tried")
            continue
        folder = pathlib.Path(scratch) / shell
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        found += faults(shell, program, folder)
        shutil.rmtree(folder)
    sys.exit("\n".join(found) or 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
