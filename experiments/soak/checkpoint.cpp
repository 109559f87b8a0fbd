// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/soak/checkpoint.h"

#include <fmt/core.h>

namespace touchstone::soak {
namespace {

// Raised where case i of a seed becomes another one, or the tally's form changes.
constexpr int kVersion = 1;

}  // namespace

Checkpoint::Checkpoint(std::filesystem::path path, const Settings& settings)
    : file_(std::move(path), {{"version", kVersion}, {"seed", settings.seed}, {"from", settings.from}}),
      cases_(settings.cases) {}

void Checkpoint::write(const Tally& tally) const { file_.write(tally); }

Tally Checkpoint::read() const {
  const auto tally = file_.read<Tally>().value_or(Tally());
  if (tally.cases() > cases_)
    file_.refuse(fmt::format("holds {} cases already, more than the {} asked for", tally.cases(), cases_));
  return tally;
}

}  // namespace touchstone::soak
