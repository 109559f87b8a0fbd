// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/program/input.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::cell {

/// Thrown for an invalid cell. The message begins with the file and the key, as in `cell.json: machine.height: ...`,
/// and is legible, whatever the file contains.
class BadCell : public std::runtime_error {
 public:
  explicit BadCell(const std::string& message) : std::runtime_error(io::all_legible(message)) {}
};

/// The largest size of a cell file and of a URDF file.
inline constexpr std::size_t kMostCellMib = 16;

/// Returns whether a word can name a part and the file that it is written to: letters, digits, '-' and '_', at least
/// one.
[[nodiscard]] bool is_name(std::string_view word);

/// A value of a cell file with its path of keys, such as `storage.slots[2].place`. Accessors check the value and throw
/// BadCell if it is wrong.
class CellEntry {
 public:
  /// Requires that `value` outlives the entry.
  CellEntry(std::string file, std::string path, const nlohmann::json& value)
      : file_(std::move(file)), path_(std::move(path)), value_(&value) {}

  [[nodiscard]] const std::string& path() const { return path_; }
  [[noreturn]] void bad(const std::string& reason) const;

  /// Throws BadCell unless it is an object of these keys only.
  void has_only(const std::vector<std::string_view>& keys) const;
  [[nodiscard]] CellEntry at(const std::string& key) const;
  [[nodiscard]] std::optional<CellEntry> find(const std::string& key) const;
  /// Returns the members of an object in alphabetic order of keys, or the elements of an array in order.
  [[nodiscard]] std::vector<std::pair<std::string, CellEntry>> members() const;
  [[nodiscard]] std::vector<CellEntry> items() const;

  [[nodiscard]] bool is_number() const;
  [[nodiscard]] bool is_object() const;
  [[nodiscard]] bool is_array() const;

  [[nodiscard]] std::string text() const;     ///< not empty, legible
  [[nodiscard]] std::string name() const;     ///< `is_name`
  [[nodiscard]] bool yes() const;             ///< true or false
  [[nodiscard]] double number() const;        ///< finite
  [[nodiscard]] double positive() const;      ///< > 0
  [[nodiscard]] double not_negative() const;  ///< >= 0
  [[nodiscard]] double seconds() const;       ///< > 0 and at most 1e9, so that sums are finite
  [[nodiscard]] int whole(int least, int most) const;
  /// Returns an array of `count` finite numbers.
  [[nodiscard]] Eigen::Vector3d point() const;
  [[nodiscard]] Eigen::Vector2d point2() const;

 private:
  [[nodiscard]] std::vector<double> numbers(std::size_t count) const;

  std::string file_, path_;
  const nlohmann::json* value_;
};

/// Returns all bytes of a file. Throws an `Error`, whose message names the file, if the file cannot be read or has more
/// than `most_mib` MiB. Reads no more than that, even from a device that never ends.
template <class Error>
[[nodiscard]] std::string read_at_most(const std::filesystem::path& file, std::size_t most_mib) {
  std::ifstream stream;
  try {
    stream = program::open_file(file);
  } catch (const std::runtime_error& error) {
    throw Error(error.what());
  }
  std::string text;
  constexpr std::size_t kBlock = std::size_t{1} << 16;
  while (stream && text.size() <= most_mib << 20) {
    const std::size_t size = text.size();
    text.resize(size + kBlock);
    stream.read(text.data() + size, kBlock);
    text.resize(size + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw Error(file.string() + ": cannot be read to its end");
  if (text.size() > most_mib << 20) throw Error(fmt::format("{}: has more than {} MiB", file.string(), most_mib));
  return text;
}

}  // namespace touchstone::cell
