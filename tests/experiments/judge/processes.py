# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: processes.py TOUCHSTONE

No process of an engine outlives the judge, which waits for none: neither where it is interrupted or killed, nor where
the engine ended by itself. Every one of them inherits the end of a pipe, which is closed with the last. And a judge
whose standard input is closed, or cannot be read, says so and ends. A signal that the judge was started to ignore, as by nohup, ends nothing. Exit status 1 otherwise.
"""

import os
import pathlib
import select
import signal
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parents[2] / "system"))
from running import expect, run  # noqa: E402

CASE = b'{"id":"a","ball":{"center":[1,1,1],"radius":1},"polygon":{"outer":[[0,0,0],[4,0,0],[0,4,0]]}}\n'
SECONDS = 60  # until what does not end is taken for a fault
HELPERS = [  # that an engine leaves behind
    "sleep 1000 >/dev/null & ",
    "sleep 1000 & ",  # which goes on holding the engine's output
    "(setsid sleep 1000 </dev/null >/dev/null 2>&1 &); ",
    "(setsid sh -c 'setsid sleep 1000 & exec sleep 1000' &); ",
    # A thousand processes, each of which starts the next and ends.
    "(python3 -c 'import os, signal\nfor i in range(1000): os.fork() and os._exit(0)\nsignal.pause()' &); ",
]
# It ends when what it has left behind, and has ended since, is gone: a process that is not waited for stays in the list.
LEAVES_MANY = "for i in 1 2 3 4 5; do (true &); done; while read pids </proc/$PPID/task/$PPID/children; " \
              "[ \"$pids\" != $$ ]; do :; done; "
END_SIGNALS = (signal.SIGHUP, signal.SIGINT, signal.SIGTERM)
VERDICT = "read line; echo '{{\"id\":\"a\"}}'"


def start(program, engine, *options, ignored=()):
    """The judge, whose input stays open and which ignores these signals from the beginning, and the pipe; `{pipe}` in the
    engine is its other end."""
    reader, writer = os.pipe()
    engine = engine.format(pipe=f"/proc/self/fd/{writer}")
    handle = lambda: [signal.signal(each, signal.SIG_IGN if each in ignored else signal.SIG_DFL) for each in END_SIGNALS]
    judge = subprocess.Popen([program, "judge", "--methods", "fast", "--engine", engine, *options], pass_fds=[writer],
                             stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, preexec_fn=handle)
    os.close(writer)
    judge.stdin.write(CASE)
    judge.stdin.flush()
    return judge, reader


def all_have_ended(reader):
    while select.select([reader], [], [], SECONDS)[0]:
        if not os.read(reader, 1):
            return True
    return False


def check_signal(program, which, status, engine):
    judge, reader = start(program, engine + "echo > {pipe}; exec sleep 1000")
    os.read(reader, 1)  # the engine runs
    verdict = judge.stdout.readline()  # and the judge waits for it
    judge.send_signal(which)
    what = f"{which.name}, engine {engine!r}"
    expect(verdict.startswith(b'{"id":"a","method":"fast"') and verdict.endswith(b"}\n"), f"{what}: {verdict}")
    expect(judge.wait(SECONDS) == status, f"{what}: exit status {judge.returncode}")
    expect(all_have_ended(reader), f"{what}: the engine goes on")


def expect_verdicts(judge, what):
    """Of both methods."""
    verdicts, _ = judge.communicate(timeout=SECONDS)
    expect(judge.returncode == 0 and verdicts.count(b"\n") == 2, f"{what}: exit status {judge.returncode}: {verdicts}")


def check_ignored_signal(program, which):
    judge, reader = start(program, "echo > {pipe}; " + VERDICT, ignored=[which])
    os.read(reader, 1)  # the engine runs
    judge.send_signal(which)
    expect_verdicts(judge, f"{which.name}, which is ignored")


def check_engine_that_ends(program, before):
    judge, reader = start(program, before + VERDICT)
    expect_verdicts(judge, f"engine {before + VERDICT!r}")
    expect(all_have_ended(reader), f"engine {before + VERDICT!r}: what it started goes on")


def check_foreign_holder(program):
    """This process holds the engine's output open, too, and nobody kills it for that."""
    with tempfile.TemporaryDirectory() as folder:
        go = os.path.join(folder, "go")
        os.mkfifo(go)
        judge, reader = start(program, f"echo $$ > {{pipe}}; read go <{go}; " + VERDICT)
        held = os.open(f"/proc/{int(os.read(reader, 20))}/fd/1", os.O_WRONLY)
        with open(go, "w") as file:
            file.write("go\n")
        expect_verdicts(judge, "output held open")
        os.close(held)


def check_stopped_supervisor(program):
    judge, reader = start(program, "kill -STOP $PPID; exec sleep 1000", "--time-limit", "0.2")
    judge.communicate(timeout=SECONDS)
    expect(all_have_ended(reader), "an engine that stops what watches it goes on")


def check_unreadable_input(program, redirection):
    for options in "", "--engine cat":
        command = f"judge {options} {redirection}"
        done = run("sh", "-c", f"exec {program} {command}", expected=2, timeout=SECONDS)
        expect(done.stderr == "touchstone: standard input: cannot be read to its end\n", f"{command}: {done.stderr}")


def main(program):
    check_unreadable_input(program, "<&-")
    check_unreadable_input(program, "</")
    for _ in range(5):  # the engine may stop it before it has told the judge that the engine runs
        check_stopped_supervisor(program)
    for which in END_SIGNALS:
        check_ignored_signal(program, which)
    for helper in HELPERS:
        for which in END_SIGNALS:
            check_signal(program, which, 130, helper)
        check_signal(program, signal.SIGKILL, -signal.SIGKILL, helper)
        check_engine_that_ends(program, helper)
    check_engine_that_ends(program, LEAVES_MANY)
    check_foreign_holder(program)


if __name__ == "__main__":
    main(*sys.argv[1:])
