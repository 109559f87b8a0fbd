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

/// The state of a long run, in a file that always holds one complete state.
class Checkpoint {
 public:
  /// `settings`: an object with everything that affects the results, by the names of the options (without dashes), and
  /// `version`, which must be raised whenever the form or meaning of the state changes.
  Checkpoint(std::filesystem::path path, nlohmann::ordered_json settings)
      : path_(std::move(path)), settings_(std::move(settings)) {}

  /// Writes the state, an object whose keys differ from those of the settings. Throws std::runtime_error, which names
  /// the file, if it cannot be written.
  void write(const nlohmann::ordered_json& state) const;

  /// Reads the state from which to continue (by its from_json); nothing if there is no file yet. Throws
  /// std::runtime_error if the file is damaged, of another version, or of other settings; the message names the
  /// settings that differ.
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

  /// Renames an existing checkpoint to the same name with `.previous`, so that a new run does not destroy an earlier
  /// one. Returns whether there was one. Throws std::runtime_error, which names the file, if that fails.
  bool set_aside() const;

  /// Throws std::runtime_error, which names the file, if the checkpoint holds more items than requested.
  void refuse_more(std::uint64_t held, std::uint64_t asked) const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  /// Throws std::runtime_error, which names the file and says why.
  [[noreturn]] void refuse(const std::string& why) const;
  /// The same for a text that is not the JSON of a checkpoint.
  [[noreturn]] void refuse(const nlohmann::json::exception& error, std::string_view text = {}) const;
  /// Returns the whole file; null if it does not exist.
  [[nodiscard]] nlohmann::json parsed() const;

  std::filesystem::path path_;
  nlohmann::ordered_json settings_;
};

}  // namespace touchstone::harness
