#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: draw.py NAME FOLDER

Draws what lies in FOLDER by studies/NAME.py."""
import importlib
import pathlib
import sys


def main(name, folder):
    importlib.import_module(f"studies.{name}").main(pathlib.Path(folder))


if __name__ == "__main__":
    main(*sys.argv[1:])
