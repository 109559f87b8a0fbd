// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "experiments/program/state.h"

namespace touchstone::program {

/// Everything that results depend on: the values of options by their names (without dashes), and a version. The version
/// is raised when sample n of a seed changes, or when the form or the meaning of a sum changes.
struct ResultSettings {
  int version;
  std::vector<std::pair<std::string, std::string>> options;
  std::string part;  ///< of how many items
};

/// The sum of a part, in a file that says what it is of. A sum is written as an Archive; a function items_done(sum) in
/// its namespace returns how many items it covers.
class PartFile {
 public:
  PartFile(std::filesystem::path path, ResultSettings settings)
      : path_(std::move(path)), settings_(std::move(settings)) {}

  /// Throws std::runtime_error, which names the file, if it cannot be written.
  template <class Sum>
  void write(const Sum& sum) const {
    write_text(archived(sum));
  }

  /// Returns the sum. Throws std::runtime_error, which names the file, if there is none, if it was damaged or edited,
  /// does not cover this many items, or is of another version or of other settings: it names those that differ.
  template <class Sum>
  [[nodiscard]] Sum read(Sum sum, std::uint64_t items) const {
    const std::string text = read_text();
    try {
      restore(text, sum);
    } catch (const DamagedArchive& error) {
      refuse(std::string("is damaged: ") + error.what());
    }
    if (items_done(sum) != items) refuse("does not hold all items of its part");
    return sum;
  }

 private:
  void write_text(const std::string& sum) const;
  [[nodiscard]] std::string read_text() const;
  [[noreturn]] void refuse(const std::string& why) const;

  std::filesystem::path path_;
  ResultSettings settings_;
};

}  // namespace touchstone::program
