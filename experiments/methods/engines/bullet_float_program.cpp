// SPDX-License-Identifier: GPL-3.0-or-later
// Runs Bullet's float build behind standard input and output. Its symbols have the names of the double build, so one
// program cannot link both. See bullet_float.cpp for the protocol.
#include <array>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "experiments/methods/engines/bullet_contact.h"

static_assert(sizeof(btScalar) == sizeof(float), "this is about Bullet's float build");

int main() {
  std::uint32_t count = 0;
  std::array<double, 4> ball{};
  std::vector<double> triangles;
  while (std::fread(&count, sizeof count, 1, stdin) == 1) {
    triangles.resize(9 * std::size_t{count});
    if (std::fread(ball.data(), sizeof(double), ball.size(), stdin) != ball.size() ||
        std::fread(triangles.data(), sizeof(double), triangles.size(), stdin) != triangles.size())
      return 1;
    bool touches = false;
    for (std::size_t i = 0; i < triangles.size() && !touches; i += 9)
      touches = touchstone::methods::bullet_contact(ball.data(), triangles.data() + i);
    if (std::putchar(touches ? 'y' : 'n') == EOF || std::fflush(stdout) != 0) return 1;
  }
}
