// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/regress/baseline.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "experiments/judge/strict_json.h"

namespace touchstone::regress {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;  // raised where a case of a seed becomes another one

/// The cases of that outcome.
std::string digits_of(const Outcomes& outcomes, Outcome outcome) {
  std::string digits;
  for (std::size_t i = 0; i < outcomes.size(); i += 4) {
    unsigned value = 0;
    for (std::size_t j = i; j < i + 4; ++j)
      value = 2 * value + (j < outcomes.size() && outcomes[j] == outcome ? 1U : 0U);
    digits += "0123456789abcdef"[value];
  }
  return digits;
}

/// Gives that outcome to the cases that the digits name.
void read_digits(const std::string& digits, Outcome outcome, Outcomes& outcomes) {
  if (digits.size() != (outcomes.size() + 3) / 4 || digits.find_first_not_of("0123456789abcdef") != std::string::npos)
    throw std::runtime_error("are not the digits of so many cases");
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const char digit = digits[i / 4];
    const int value = digit <= '9' ? digit - '0' : digit - 'a' + 10;
    if (((value >> (3 - i % 4)) & 1) == 0) continue;
    if (outcomes[i] != Outcome::Right) throw std::runtime_error(fmt::format("case {} is wrong and unsure", i));
    outcomes[i] = outcome;
  }
}

/// Methods by name, each with the digits of every family, go into the standing.
void read_methods(const Json& methods, Outcome outcome, std::size_t cases, Standing& standing) {
  for (const auto& [method, families] : methods.items()) {
    if (families.size() != workloads::all_families().size())
      throw std::runtime_error(
          fmt::format("{} has {} families, not {}", method, families.size(), workloads::all_families().size()));
    for (const auto& family : workloads::all_families()) {
      const auto name = std::string(word(family));
      Outcomes& outcomes = standing[method][name];
      outcomes.resize(cases);
      try {
        read_digits(families.at(name).get<std::string>(), outcome, outcomes);
      } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("{} of {}: {}", name, method, error.what()));
      }
    }
  }
}

std::string text_of(const std::filesystem::path& file) {
  if (std::ifstream stream(file, std::ios::binary); stream && !std::filesystem::is_directory(file)) {
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (stream) return text;
  }
  throw std::runtime_error("cannot be read");
}

Baseline baseline_of(const std::string& text) {
  const judge::StrictJson read = judge::read_strict_json(text);
  if (read.duplicate_key) throw std::runtime_error(fmt::format("has the key \"{}\" twice", *read.duplicate_key));
  const Json json = read.value;
  if (json.at("version") != kVersion)
    throw std::runtime_error(
        fmt::format("is of version {}, this program's is {}", json.at("version").dump(), kVersion));
  for (const char* key : {"seed", "samples"})
    if (!json.at(key).is_number_unsigned())
      throw std::runtime_error(fmt::format("\"{}\" is no whole number without a sign", key));
  Baseline baseline;
  baseline.settings = {json.at("seed").get<std::uint64_t>(), json.at("samples").get<std::size_t>()};
  if (baseline.settings.samples < 1 || baseline.settings.samples > kMostSamples)
    throw std::runtime_error(fmt::format("\"samples\" must be from 1 to {}", kMostSamples));
  if (!json.at("methods").is_object() || json.at("methods").empty())
    throw std::runtime_error("\"methods\" has no method");
  read_methods(json.at("methods"), Outcome::Wrong, baseline.settings.cases(), baseline.standing);
  if (json.contains("unsure")) {
    for (const auto& [method, families] : json.at("unsure").items())
      if (baseline.standing.count(method) == 0)
        throw std::runtime_error(fmt::format("\"unsure\" has {}, which \"methods\" has not", method));
    read_methods(json.at("unsure"), Outcome::Unsure, baseline.settings.cases(), baseline.standing);
  }
  return baseline;
}

bool is_unsure(const std::map<std::string, Outcomes>& families) {
  return std::ranges::any_of(families, [](const auto& each) { return summary_of(each.second).unsure > 0; });
}

}  // namespace

std::string baseline_text(const Baseline& baseline) {
  Json json{{"version", kVersion}, {"seed", baseline.settings.seed}, {"samples", baseline.settings.samples}};
  for (const auto& [method, families] : baseline.standing)
    for (const auto& family : workloads::all_families()) {
      const auto name = std::string(word(family));
      json["methods"][method][name] = digits_of(families.at(name), Outcome::Wrong);
      if (is_unsure(families)) json["unsure"][method][name] = digits_of(families.at(name), Outcome::Unsure);
    }
  return json.dump(1) + "\n";
}

Baseline read_baseline(const std::filesystem::path& file) {
  try {
    return baseline_of(text_of(file));
  } catch (const std::exception& error) {  // of ours, or of the JSON
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

std::vector<Change> changes(const Standing& baseline, const Standing& now) {
  std::vector<Change> changes;
  for (const auto& [method, families] : now) {
    const auto before = baseline.find(method);
    if (before == baseline.end()) continue;
    for (const auto& each : workloads::all_families()) {
      const auto family = std::string(word(each));
      const Outcomes &was = before->second.at(family), &is = families.at(family);
      Change change{method, family, {}, {}};
      for (std::size_t n = 0; n < is.size(); ++n)
        if (was[n] != is[n]) (was[n] < is[n] ? change.worse : change.better).push_back(n);
      if (!change.better.empty() || !change.worse.empty()) changes.push_back(std::move(change));
    }
  }
  return changes;
}

}  // namespace touchstone::regress
