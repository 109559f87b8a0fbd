// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/known_failures.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "experiments/cases/key.h"
#include "experiments/program/input.h"
#include "experiments/program/json.h"

namespace touchstone::judge {

namespace {

Failure read_failure(const std::string& line) {
  const program::StrictJson text = program::read_strict_json(line);
  const auto word = [&](const char* key) {
    const bool has = text.value.is_object() && text.value.contains(key) && text.value[key].is_string();
    if (!has)
      throw std::invalid_argument(
          fmt::format("it needs the words method, case and key alone, and \"{}\" is missing", key));
    return text.value[key].get<std::string>();
  };
  Failure failure{word("method"), word("case"), word("key")};
  const auto given = text.value.find("given");
  if (given != text.value.end() && *given != nlohmann::json(false))
    throw std::invalid_argument("\"given\" is not false");
  failure.omits = given != text.value.end();
  if (text.duplicate_key || text.value.size() != (failure.omits ? 4U : 3U))
    throw std::invalid_argument("it has more than method, case, key and given, once each");
  constexpr std::array<std::string_view, 3> kOthers{Failure::kNoAnswer, "error", "message"};
  if (!cases::find_key(failure.key) && std::ranges::find(kOthers, failure.key) == kOthers.end())
    throw std::invalid_argument(fmt::format("no answer has a key \"{}\"", failure.key));
  return failure;
}

}  // namespace

KnownFailures::KnownFailures(const std::string& file) {
  std::ifstream in = program::open_file(file);
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    try {
      known_.insert(read_failure(line));
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
  for (const Failure& failure : all) {
    nlohmann::ordered_json object{{"method", failure.method}, {"case", failure.id}, {"key", failure.key}};
    if (failure.omits) object["given"] = false;
    text += object.dump() + "\n";
  }
  return text;
}

}  // namespace touchstone::judge
