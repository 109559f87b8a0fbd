// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/harness/checkpoint.h"

#include <fmt/core.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "experiments/harness/json/json_fault.h"
#include "experiments/harness/write_file.h"

namespace touchstone::harness {
namespace {

/// Returns the option as written on the command line: ` --seed 3 --method fast,thesis`.
std::string option(const std::string& name, const nlohmann::ordered_json& value) {
  return " --" + name + " " + (value.is_string() ? value.get<std::string>() : value.dump());
}

}  // namespace

void Checkpoint::write(const nlohmann::ordered_json& state) const {
  nlohmann::ordered_json whole = settings_;
  whole.update(state);
  write_file(path_, whole.dump() + "\n");
}

bool Checkpoint::set_aside() const {
  std::error_code error;
  std::filesystem::rename(path_, path_.string() + ".previous", error);
  if (error && error != std::errc::no_such_file_or_directory) refuse("cannot be set aside: " + error.message());
  return !error;
}

nlohmann::json Checkpoint::parsed() const {
  std::ifstream file(path_, std::ios::binary);
  if (!file) return nullptr;
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  try {
    const auto whole = nlohmann::json::parse(text);
    if (whole.at("version") != nlohmann::json(settings_.at("version"))) refuse("is of another version of this program");
    std::string found, wanted;
    for (const auto& [name, value] : settings_.items()) {
      if (whole.at(name) == nlohmann::json(value)) continue;
      found += option(name, whole.at(name));
      wanted += option(name, value);
    }
    if (!found.empty()) refuse("is of" + found + ", not of" + wanted);
    return whole;
  } catch (const nlohmann::json::exception& error) {
    refuse(error, text);
  }
}

void Checkpoint::refuse_more(std::uint64_t held, std::uint64_t asked) const {
  if (held > asked) refuse(fmt::format("holds {} already, more than the {} asked for", held, asked));
}

void Checkpoint::refuse(const std::string& why) const { throw std::runtime_error(path_.string() + ": " + why); }

void Checkpoint::refuse(const nlohmann::json::exception& error, std::string_view text) const {
  refuse("is not a checkpoint of this program: " + harness::json_fault(error, text));
}

}  // namespace touchstone::harness
