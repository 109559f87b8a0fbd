// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/regress/baseline.h"

#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace touchstone::regress {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;  // raised where a case of a seed becomes another one

std::string digits_of(const Failures& failures) {
  std::string digits;
  for (std::size_t i = 0; i < failures.size(); i += 4) {
    unsigned value = 0;
    for (std::size_t j = i; j < i + 4; ++j) value = 2 * value + (j < failures.size() && failures[j] ? 1U : 0U);
    digits += "0123456789abcdef"[value];
  }
  return digits;
}

Failures failures_of(const std::string& digits, std::size_t cases) {
  if (digits.size() != (cases + 3) / 4 || digits.find_first_not_of("0123456789abcdef") != std::string::npos)
    throw std::runtime_error("are not the digits of so many cases");
  Failures failures(cases);
  for (std::size_t i = 0; i < cases; ++i) {
    const char digit = digits[i / 4];
    const int value = digit <= '9' ? digit - '0' : digit - 'a' + 10;
    failures[i] = ((value >> (3 - i % 4)) & 1) != 0;
  }
  return failures;
}

}  // namespace

std::string baseline_text(const Baseline& baseline) {
  Json json{{"version", kVersion}, {"seed", baseline.settings.seed}, {"samples", baseline.settings.samples}};
  for (const auto& [method, families] : baseline.standing)
    for (const auto& family : workloads::all_families()) {
      const auto name = std::string(word(family));
      json["methods"][method][name] = digits_of(families.at(name));
    }
  return json.dump(1) + "\n";
}

Baseline read_baseline(const std::filesystem::path& file) {
  const auto bad = [&](const std::string& what) { return std::runtime_error(file.string() + ": " + what); };
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream || std::filesystem::is_directory(file)) throw bad("cannot be read");
  try {
    const Json json = Json::parse(text);
    if (json.at("version") != kVersion)
      throw bad(fmt::format("is of version {}, this program's is {}", json.at("version").dump(), kVersion));
    for (const char* key : {"seed", "samples"})
      if (!json.at(key).is_number_unsigned()) throw bad(fmt::format("\"{}\" is no whole number without a sign", key));
    Baseline baseline;
    baseline.settings = {json.at("seed").get<std::uint64_t>(), json.at("samples").get<std::size_t>()};
    if (baseline.settings.samples < 1 || baseline.settings.samples > kMostSamples)
      throw bad(fmt::format("\"samples\" must be from 1 to {}", kMostSamples));
    if (!json.at("methods").is_object() || json.at("methods").empty()) throw bad("\"methods\" has no method");
    for (const auto& [method, families] : json.at("methods").items())
      for (const auto& family : workloads::all_families()) {
        const auto name = std::string(word(family));
        try {
          baseline.standing[method][name] =
              failures_of(families.at(name).get<std::string>(), baseline.settings.cases());
        } catch (const std::exception& error) {
          throw bad(fmt::format("{} of {}: {}", name, method, error.what()));
        }
      }
    return baseline;
  } catch (const Json::exception& error) {
    throw bad(error.what());
  }
}

std::vector<Change> changes(const Standing& baseline, const Standing& now) {
  std::vector<Change> changes;
  for (const auto& [method, families] : now) {
    const auto before = baseline.find(method);
    if (before == baseline.end()) continue;
    for (const auto& each : workloads::all_families()) {
      const auto family = std::string(word(each));
      const Failures &was = before->second.at(family), &is = families.at(family);
      Change change{method, family, {}, {}};
      for (std::size_t n = 0; n < is.size(); ++n)
        if (was[n] != is[n]) (is[n] ? change.worse : change.better).push_back(n);
      if (!change.better.empty() || !change.worse.empty()) changes.push_back(std::move(change));
    }
  }
  return changes;
}

}  // namespace touchstone::regress
