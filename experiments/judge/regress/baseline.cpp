// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "experiments/judge/regress/regress.h"
#include "experiments/program/input.h"
#include "experiments/program/json.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::regress {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 2;  // raised whenever the cases of a seed change

/// Returns the digits of the cases with that outcome.
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

/// Assigns that outcome to the cases that the digits mark.
void read_digits(const std::string& digits, Outcome outcome, Outcomes& outcomes) {
  if (digits.size() != (outcomes.size() + 3) / 4 || digits.find_first_not_of("0123456789abcdef") != std::string::npos)
    throw std::runtime_error(fmt::format("are not the digits of {} cases", outcomes.size()));
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const char digit = digits[i / 4];
    const int value = digit <= '9' ? digit - '0' : digit - 'a' + 10;
    if (((value >> (3 - i % 4)) & 1) == 0) continue;
    if (outcomes[i] != Outcome::Right) throw std::runtime_error(fmt::format("case {} is wrong and unsure", i));
    outcomes[i] = outcome;
  }
}

/// Throws if an object has an unknown key; `where` is empty, or names the object.
void check_keys(const Json& object, const std::string& where, const std::vector<std::string>& known) {
  for (const auto& [key, value] : object.items())
    if (std::ranges::find(known, key) == known.end())
      throw std::runtime_error(fmt::format("{}has the unknown key \"{}\"", where, io::legible(key)));
}

std::vector<std::string> group_names() {
  std::vector<std::string> names;
  for (const Group& group : all_groups()) names.push_back(group.name());
  return names;
}

/// Adds methods, by name, each with the digits of every group, to the table.
void read_methods(const Json& methods, Outcome outcome, std::size_t cases, OutcomeTable& table) {
  for (const auto& [method, families] : methods.items()) {
    const std::string shown = io::legible(method);
    if (!families.is_object()) throw std::runtime_error(shown + " is not an object");
    check_keys(families, shown + " ", group_names());
    for (const std::string& name : group_names()) {
      if (!families.contains(name)) throw std::runtime_error(fmt::format("{} has no key \"{}\"", shown, name));
      if (!families[name].is_string()) throw std::runtime_error(fmt::format("{} of {}: is not a string", name, shown));
      Outcomes& outcomes = table[method][name];
      outcomes.resize(cases);
      try {
        read_digits(families[name].get_ref<const std::string&>(), outcome, outcomes);
      } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("{} of {}: {}", name, shown, error.what()));
      }
    }
  }
}

std::string text_of(std::ifstream& stream, std::size_t longest) {
  std::string text;
  std::vector<char> part(std::size_t{1} << 20);
  while (stream && text.size() <= longest) {
    stream.read(part.data(), static_cast<std::streamsize>(part.size()));
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (text.size() > longest) throw std::runtime_error(fmt::format("is longer than {} MiB", longest >> 20));
  if (!stream.eof() || stream.bad()) throw std::runtime_error("cannot be read to its end");
  return text;
}

Baseline baseline_of(const std::string& text) {
  const program::StrictJson read = program::read_strict_json(text);
  if (read.duplicate_key)
    throw std::runtime_error(fmt::format("has the duplicate key \"{}\"", io::legible(*read.duplicate_key)));
  const Json json = read.value;
  if (!json.is_object()) throw std::runtime_error("is not an object");
  if (json.at("version") != kVersion)
    throw std::runtime_error(
        fmt::format("is of version {}, this program's is {}", io::legible(json.at("version").dump()), kVersion));
  check_keys(json, "", {"version", "seed", "samples", "methods", "unsure"});
  for (const char* key : {"seed", "samples"})
    if (!json.at(key).is_number_unsigned())
      throw std::runtime_error(fmt::format("\"{}\" is not a whole number without a sign", key));
  Baseline baseline;
  baseline.settings = {json.at("seed").get<std::uint64_t>(), json.at("samples").get<std::size_t>()};
  if (baseline.settings.samples < 1 || baseline.settings.samples > kMostSamples)
    throw std::runtime_error(fmt::format("\"samples\" must be from 1 to {}", kMostSamples));
  if (!json.at("methods").is_object() || json.at("methods").empty())
    throw std::runtime_error("\"methods\" has no method");
  read_methods(json.at("methods"), Outcome::Wrong, baseline.settings.cases(), baseline.table);
  if (json.contains("unsure")) {
    if (!json.at("unsure").is_object()) throw std::runtime_error("\"unsure\" is not an object");
    for (const auto& [method, families] : json.at("unsure").items())
      if (baseline.table.count(method) == 0)
        throw std::runtime_error(fmt::format("\"unsure\" has {}, which \"methods\" has not", io::legible(method)));
    read_methods(json.at("unsure"), Outcome::Unsure, baseline.settings.cases(), baseline.table);
  }
  return baseline;
}

bool is_unsure(const std::map<std::string, Outcomes>& groups) {
  return std::ranges::any_of(
      groups, [](const auto& each) { return std::ranges::find(each.second, Outcome::Unsure) != each.second.end(); });
}

}  // namespace

std::string baseline_text(const Baseline& baseline) {
  Json json{{"version", kVersion}, {"seed", baseline.settings.seed}, {"samples", baseline.settings.samples}};
  for (const auto& [method, groups] : baseline.table)
    for (const std::string& name : group_names()) {
      json["methods"][method][name] = digits_of(groups.at(name), Outcome::Wrong);
      if (is_unsure(groups)) json["unsure"][method][name] = digits_of(groups.at(name), Outcome::Unsure);
    }
  return json.dump(1) + "\n";
}

Baseline read_baseline(const std::filesystem::path& file, std::size_t longest) {
  std::ifstream stream = program::open_file(file);
  try {
    return baseline_of(text_of(stream, longest));
  } catch (const program::NotJson& error) {
    throw std::runtime_error(file.string() + ": not JSON: " + error.what());
  } catch (const nlohmann::json::exception& error) {  // a missing key
    throw std::runtime_error(file.string() + ": " + program::json_fault(error));
  } catch (const std::bad_alloc&) {
    throw std::runtime_error(file.string() + ": there is not enough memory to read it");
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

std::vector<Change> changes(const OutcomeTable& baseline, const OutcomeTable& now) {
  std::vector<Change> changes;
  for (const auto& [method, groups] : now) {
    const auto before = baseline.find(method);
    if (before == baseline.end()) continue;
    for (const Group& group : all_groups()) {
      const Outcomes &was = before->second.at(group.name()), &is = groups.at(group.name());
      Change change{method, group, {}, {}};
      for (std::size_t n = 0; n < is.size(); ++n)
        if (was[n] != is[n]) (was[n] < is[n] ? change.worse : change.better).push_back(n);
      if (!change.better.empty() || !change.worse.empty()) changes.push_back(std::move(change));
    }
  }
  return changes;
}

}  // namespace touchstone::regress
