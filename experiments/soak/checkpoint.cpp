// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/soak/checkpoint.h"

#include <fmt/core.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "experiments/run/write_file.h"

namespace touchstone::soak {
namespace {

using nlohmann::ordered_json;

// Raised where case i of a seed becomes another one, or the tally's form changes.
constexpr int kVersion = 1;

}  // namespace

void Checkpoint::write(const Settings& settings, const Tally& tally) const {
  ordered_json outcomes = ordered_json::array(), kept = ordered_json::array();
  for (const Outcomes& o : tally.outcomes_) outcomes.push_back({o.cases, o.by_stage, o.differences});
  for (const Difference& difference : tally.kept_) kept.push_back({difference.index, difference.line});
  const ordered_json state = {{"version", kVersion},   {"seed", settings.seed},         {"from", settings.from},
                              {"cases", tally.cases_}, {"differing", tally.differing_}, {"outcomes", outcomes},
                              {"kept", kept}};
  std::filesystem::path beside = path_;
  beside += ".new";
  run::write_file(beside, state.dump() + "\n");
  std::error_code error;
  std::filesystem::rename(beside, path_, error);
  if (error) throw std::runtime_error(path_.string() + ": cannot be written: " + error.message());
}

Tally Checkpoint::read(const Settings& settings) const {
  Tally tally;
  std::ifstream file(path_, std::ios::binary);
  if (!file) return tally;
  const auto refuse = [&](const std::string& why) { throw std::runtime_error(path_.string() + ": " + why); };
  try {
    const auto state = nlohmann::json::parse(file);
    if (state.at("version") != kVersion) refuse("is of another version of this program");
    const auto seed = state.at("seed").get<std::uint64_t>(), from = state.at("from").get<std::uint64_t>();
    if (seed != settings.seed || from != settings.from)
      refuse(fmt::format("is of --seed {} --from {}, not of --seed {} --from {}", seed, from, settings.seed,
                         settings.from));
    tally.cases_ = state.at("cases").get<std::uint64_t>();
    if (tally.cases_ > settings.cases)
      refuse(fmt::format("holds {} cases already, more than the {} asked for", tally.cases_, settings.cases));
    tally.differing_ = state.at("differing").get<std::uint64_t>();
    const auto& outcomes = state.at("outcomes");
    for (std::size_t i = 0; i < tally.outcomes_.size(); ++i) {
      Outcomes& o = tally.outcomes_[i];
      o.cases = outcomes.at(i).at(0).get<std::uint64_t>();
      o.by_stage = outcomes.at(i).at(1).get<decltype(o.by_stage)>();
      o.differences = outcomes.at(i).at(2).get<std::uint64_t>();
    }
    for (const auto& difference : state.at("kept"))
      tally.kept_.push_back({difference.at(0).get<std::uint64_t>(), difference.at(1).get<std::string>()});
  } catch (const nlohmann::json::exception& error) {
    refuse(std::string("is no checkpoint of this program: ") + error.what());
  }
  return tally;
}

}  // namespace touchstone::soak
