// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace touchstone::harness {

// Fields of CSV.

/// A text, in quotes where it needs them.
[[nodiscard]] std::string field(std::string_view text);
template <std::integral T>
[[nodiscard]] std::string field(T number) {
  return std::to_string(number);
}
/// The value's field, or an empty one.
template <class T>
[[nodiscard]] std::string field(const std::optional<T>& value) {
  return value ? field(*value) : std::string();
}
/// With this many significant digits.
[[nodiscard]] std::string digits(double number, int count = 6);
/// With this many decimal places.
[[nodiscard]] std::string places(double number, int count);
/// The shortest text that reads back as the same double.
[[nodiscard]] std::string shortest(double number);

/// One column: its name in the heading, with the unit at its end (`_ns`), what it means, and how a row's field is
/// printed.
template <class Row>
struct Column {
  std::string name, meaning;
  std::function<std::string(const Row&)> print;
};

/// A table's file and columns, without rows.
struct TableDescription {
  std::string file;
  std::string rows;                                          ///< what a row is, as in `a method and a test`
  std::vector<std::pair<std::string, std::string>> columns;  ///< names and meanings
};

/// A CSV file that a study writes: every column is declared here, and nowhere else.
template <class Row>
class Table {
 public:
  Table(std::string file, std::string rows, std::vector<Column<Row>> columns)
      : file_(std::move(file)), rows_(std::move(rows)), columns_(std::move(columns)) {}

  [[nodiscard]] std::string csv(const std::vector<Row>& rows) const {
    std::string text;
    for (const Column<Row>& column : columns_) text.append(text.empty() ? "" : ",").append(column.name);
    for (const Row& row : rows) {
      char separator = '\n';
      for (const Column<Row>& column : columns_) {
        text += separator;
        text += column.print(row);
        separator = ',';
      }
    }
    return text + '\n';
  }
  /// Writes the file. Throws std::runtime_error, which names it, where it cannot be written.
  void write(const std::filesystem::path& folder, const std::vector<Row>& rows) const {
    write_text(folder / file_, csv(rows));
  }
  [[nodiscard]] TableDescription description() const {
    TableDescription description{file_, rows_, {}};
    for (const Column<Row>& column : columns_) description.columns.emplace_back(column.name, column.meaning);
    return description;
  }

 private:
  static void write_text(const std::filesystem::path& file, const std::string& text);

  std::string file_, rows_;
  std::vector<Column<Row>> columns_;
};

/// The file, whole. Throws std::runtime_error.
void write_table_file(const std::filesystem::path& file, const std::string& text);

template <class Row>
void Table<Row>::write_text(const std::filesystem::path& file, const std::string& text) {
  write_table_file(file, text);
}

/// Successes of trials; three columns: their share and its Clopper-Pearson limits of 95 %.
struct Share {
  std::uint64_t count, trials;
};
[[nodiscard]] double rate_of(const Share& share);
[[nodiscard]] std::string rate_field(const Share& share);
[[nodiscard]] std::string lower_field(const Share& share);
[[nodiscard]] std::string upper_field(const Share& share);

/// The columns `rate`, `lower` and `upper`, each with this in front of its name.
template <class Row>
[[nodiscard]] std::vector<Column<Row>> share_columns(const std::string& of, std::function<Share(const Row&)> share,
                                                     const std::string& prefix = "") {
  return {{prefix + "rate", "the share of " + of, [share](const Row& row) { return rate_field(share(row)); }},
          {prefix + "lower", "its lower limit", [share](const Row& row) { return lower_field(share(row)); }},
          {prefix + "upper", "its upper limit", [share](const Row& row) { return upper_field(share(row)); }}};
}

/// One list of columns after the other.
template <class Row>
[[nodiscard]] std::vector<Column<Row>> columns(std::initializer_list<std::vector<Column<Row>>> lists) {
  std::vector<Column<Row>> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace touchstone::harness
