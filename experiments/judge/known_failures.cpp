// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/known_failures.h"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "experiments/run/json.h"

namespace touchstone::judge {

KnownFailures::KnownFailures(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file + ": cannot be read");
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    try {
      const auto value = run::read_strict_json(line).value;
      if (value.size() != 3) throw std::invalid_argument("must have three keys");
      known_.insert({value.at("method"), value.at("case"), value.at("key")});
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("{}: line {}: is not a known failure: {}", file, number, error.what()));
    }
  }
}

void KnownFailures::judged(const Failure& possible, bool failed) {
  judged_.insert(possible);
  if (failed) occurred_.insert(possible);
}

std::vector<Failure> KnownFailures::mended() const {
  std::vector<Failure> mended;
  for (const Failure& failure : known_)
    if (judged_.contains(failure) && !occurred_.contains(failure)) mended.push_back(failure);
  return mended;
}

std::size_t KnownFailures::new_ones() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(occurred_, [this](const Failure& failure) { return !known_.contains(failure); }));
}

std::string KnownFailures::text() const {
  std::set<Failure> all = occurred_;
  for (const Failure& failure : known_)
    if (!judged_.contains(failure)) all.insert(failure);
  std::string text;
  for (const Failure& failure : all)
    text +=
        nlohmann::ordered_json{{"method", failure.method}, {"case", failure.id}, {"key", failure.key}}.dump() + "\n";
  return text;
}

}  // namespace touchstone::judge
