#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# wheel.py runs this as root in a new Debian that has Python, NumPy and pip. Installs the wheel, and runs the tests of the
# module.
set -eu
cd /use
if command -v cc c++ gcc g++ cmake || [ -e /usr/include/c++ ] || [ -e /usr/include/stdio.h ]; then exit 1; fi
python3 -m venv --system-site-packages /venv
/venv/bin/pip install --quiet --no-index ./*.whl
timeout 60 /venv/bin/python -B tests/bindings/python/test_touchstone.py >&2
/venv/bin/python -c 'import touchstone_contact; print("in a clean root,", touchstone_contact.__file__, "passes its tests")'
