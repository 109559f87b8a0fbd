// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace touchstone::harness {

/// What has been done of a long run, in a file that always holds one whole state.
class Checkpoint {
 public:
  /// `settings`: an object of all that the results depend on, by the names of the options (without dashes), and
  /// `version`, which is raised where the state's form or meaning changes.
  Checkpoint(std::filesystem::path path, nlohmann::ordered_json settings)
      : path_(std::move(path)), settings_(std::move(settings)) {}

  /// `state`: an object; its keys differ from those of the settings. Throws std::runtime_error, which names the file,
  /// where it cannot be written.
  void write(const nlohmann::ordered_json& state) const;

  /// The state to go on with (by its from_json); nothing where there is no file yet. Throws std::runtime_error for a
  /// file that is damaged, of another version, or of other settings: it names those that differ.
  template <class State>
  [[nodiscard]] std::optional<State> read() const {
    const nlohmann::json whole = parsed();
    if (whole.is_null()) return std::nullopt;
    try {
      return whole.get<State>();
    } catch (const nlohmann::json::exception& error) {
      refuse(error);
    }
  }

  /// Renames what stands there, if anything does, to the same name and `.previous`: a run that begins anew loses no
  /// other. Returns whether it did. Throws std::runtime_error, which names the file, where that cannot be done.
  bool set_aside() const;

  /// Throws std::runtime_error, which names the file, if it holds more items than are asked for.
  void refuse_more(std::uint64_t held, std::uint64_t asked) const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  /// Throws std::runtime_error, which names the file and says why.
  [[noreturn]] void refuse(const std::string& why) const;
  /// The same, of what is not the JSON of a checkpoint.
  [[noreturn]] void refuse(const nlohmann::json::exception& error, std::string_view text = {}) const;
  /// Null where there is no file.
  [[nodiscard]] nlohmann::json parsed() const;

  std::filesystem::path path_;
  nlohmann::ordered_json settings_;
};

}  // namespace touchstone::harness
