// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/tunnelling/misses.h"

#include "robust/filtered/motion.h"

namespace touchstone::tunnelling {
namespace {

void count(const Motion& motion, const filtered::PreparedPolygon& polygon, Contacts& contacts) {
  const bool touches = filtered::contact(motion, polygon);
  const auto level = first_level_that_touches(motion, polygon);
  if (!touches) {
    contacts.beside += level ? 1 : 0;
    return;
  }
  ++contacts.all;
  for (std::size_t i = 0; i < contacts.missed.size(); ++i) contacts.missed[i] += !level || i < *level ? 1 : 0;
}

}  // namespace

void count_misses(const Settings& settings, const run::RunControl<Misses>& control, Misses& misses) {
  run::run_sweep(
      settings.samples, settings.threads, control, Misses(), misses,
      [&](std::uint64_t n, Misses& part) {
        ++part.samples;
        const auto pass = draw_pass(settings.vertices, settings.seed, n);
        if (!pass) {
          ++part.missing;
          return;
        }
        const filtered::PreparedPolygon polygon(pass->polygon);
        for (std::size_t i = 0; i < kRadii.size(); ++i) count(pass->of(kRadii[i]), polygon, part.of[i]);
      },
      8);
}

}  // namespace touchstone::tunnelling
