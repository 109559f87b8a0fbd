#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# packages.py runs this as root in a new Debian that has a compiler, CMake, Ninja and pkg-config. /input holds `packages`,
# `consumer`, `sample.cpp`, `sample.c` and `cases.jsonl`. Prints a line of each answer: what was asked, a colon, what it
# answered.
set -eu
cd /input
apt-get update -qq
apt-get install -y -qq --no-install-recommends ./packages/*.deb >/dev/null

cmake -S consumer -B /tmp/consumer -G Ninja -DSAMPLE=/input/sample.cpp >/dev/null
cmake --build /tmp/consumer >/dev/null
echo "by find_package: $(/tmp/consumer/sample)"
{ echo '#include <touchstone/touchstone.h>'; cat sample.cpp; } >/tmp/whole.cpp
c++ -std=c++20 -O1 /tmp/whole.cpp $(pkg-config --cflags --libs touchstone) -o /tmp/by_pkg_config
echo "by pkg-config: $(/tmp/by_pkg_config)"
cc -std=c11 sample.c $(pkg-config --cflags --libs touchstone-c) -o /tmp/in_c
echo "in C: $(/tmp/in_c | head -n 1)"

if [ -e packages/touchstone_*.deb ]; then
  touchstone judge --methods filtered --quiet cases.jsonl >/dev/null && echo "program: agrees with the corpus"
  touchstone cell new /tmp/cell >/dev/null && touchstone corpus check | grep -q ' 0 faults$' && echo "data: found"
fi
if [ -e packages/python3-touchstone_*.deb ]; then
  echo "module: $(python3 -c 'import touchstone_contact as touchstone
square = touchstone.Polygon([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
print(touchstone.filtered.contact([0.5, 0.25, 1, 1], square))')"
fi
