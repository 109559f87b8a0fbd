// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/part_file.h"

#include <fmt/core.h>

#include <cctype>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "experiments/program/json.h"
#include "experiments/program/output.h"

namespace touchstone::program {
namespace {

/// Returns the 64-bit hash FNV-1a of the text.
std::string hash_of(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

}  // namespace

void PartFile::write_text(const std::string& sum) const {
  nlohmann::ordered_json whole = {{"version", settings_.version}};
  for (const auto& [name, value] : settings_.options) whole[name] = value;
  whole["part"] = settings_.part;
  std::string text = nlohmann::json(sum).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  whole["hash"] = hash_of(text);
  std::string file = whole.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  file.pop_back();  // "}"
  write_file(path_, file + ",\"sum\":" + text + "}\n");
}

std::string PartFile::read_text() const {
  std::ifstream file(path_, std::ios::binary);
  if (!file)
    refuse(errno == ENOENT ? "is missing: its part has not ended, so run it again"
                           : "cannot be read: " + std::generic_category().message(errno));
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  try {
    const auto whole = nlohmann::json::parse(text);
    if (whole.at("version") != settings_.version) refuse("is of another version of this program");
    std::string found, wanted;
    for (const auto& [name, value] : settings_.options) {
      const auto& held = whole.at(name).get_ref<const std::string&>();
      if (held == value) continue;
      const std::string option = std::isupper(static_cast<unsigned char>(name.front())) != 0 ? name : "--" + name;
      found += " " + option + " " + held;
      wanted += " " + option + " " + value;
    }
    if (const auto& part = whole.at("part").get_ref<const std::string&>(); part != settings_.part) {
      found += " --part " + part;
      wanted += " --part " + settings_.part;
    }
    if (!found.empty()) refuse("is of" + found + ", not of" + wanted);
    const auto& sum = whole.at("sum");
    if (whole.at("hash") != hash_of(sum.dump())) refuse("was changed since its run wrote it");
    return sum.get<std::string>();
  } catch (const nlohmann::json::exception& error) {
    refuse("is not of a part of this program: " + json_fault(error, text));
  }
}

void PartFile::refuse(const std::string& why) const { throw std::runtime_error(path_.string() + ": " + why); }

}  // namespace touchstone::program
