#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# wheel.py runs this as root in a new Debian that has Python and pip. Installs the packages that the build of the wheel
# names when it refuses, one after the other, and prints them. Leaves the wheel in /made.
set -eu
cd /build
apt-get update -qq
python3 -m venv /venv
last=""
until /venv/bin/pip wheel --no-index --no-deps --wheel-dir /made ./*.tar.gz >log 2>&1; do
  package=$(sed -n 's/.* In Debian it is the package \([^ ]*\)\.$/\1/p' log | head -n 1)
  if [ -z "$package" ] || [ "$package" = "$last" ]; then cat log >&2; exit 1; fi
  echo "$package"
  apt-get install -y -qq --no-install-recommends "$package" >/dev/null
  last=$package
done
