// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/checkpoint.h"

#include <fmt/core.h>

#include <cctype>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "experiments/run/json.h"
#include "experiments/run/output.h"

namespace touchstone::run {

void Checkpoint::write_text(std::uint64_t done, const std::string& state) const {
  nlohmann::ordered_json whole = {{"version", settings_.version}};
  for (const auto& [name, value] : settings_.options) whole[name] = value;
  if (!settings_.part.empty()) whole["part"] = settings_.part;
  whole["done"] = done;
  whole["state"] = state;
  write_file(path_, whole.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

bool Checkpoint::set_aside() const {
  std::error_code error;
  std::filesystem::rename(path_, path_.string() + ".previous", error);
  if (error && error != std::errc::no_such_file_or_directory) refuse("cannot be set aside: " + error.message());
  return !error;
}

std::optional<std::string> Checkpoint::read_text() const {
  std::ifstream file(path_, std::ios::binary);
  if (!file) {
    const std::error_code error(errno, std::generic_category());
    if (error == std::errc::no_such_file_or_directory) return std::nullopt;
    refuse("cannot be read: " + error.message());
  }
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
    if (const std::string part = whole.value("part", ""); part != settings_.part) {
      found += part.empty() ? " all items" : " --part " + part;
      wanted += settings_.part.empty() ? " all items" : " --part " + settings_.part;
    }
    if (!found.empty()) refuse("is of" + found + ", not of" + wanted);
    return whole.at("state").get<std::string>();
  } catch (const nlohmann::json::exception& error) {
    refuse("is not a checkpoint of this program: " + json_fault(error, text));
  }
}

void Checkpoint::refuse_more(std::uint64_t held, std::uint64_t asked) const {
  if (held > asked) refuse(fmt::format("holds {} items already, more than the {} asked for", held, asked));
}

void Checkpoint::refuse_fewer(std::uint64_t held, std::uint64_t wanted) const {
  if (held < wanted) refuse(fmt::format("holds {} of {} items; --resume continues its run", held, wanted));
}

void Checkpoint::refuse(const std::string& why) const { throw std::runtime_error(path_.string() + ": " + why); }

}  // namespace touchstone::run
