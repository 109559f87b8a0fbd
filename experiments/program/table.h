// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "experiments/program/output.h"

namespace touchstone::program {

/// @{
/// Returns a value as a field of a CSV file: a text, quoted if needed; a number by a format of fmt, in which `{}` is
/// the shortest text that reads back as the same number.
[[nodiscard]] std::string text_field(std::string_view text);
[[nodiscard]] std::string number_field(std::int64_t number, const char* format);
[[nodiscard]] std::string number_field(std::uint64_t number, const char* format);
[[nodiscard]] std::string number_field(double number, const char* format);
/// @}

/// Returns `yes` or `no`.
[[nodiscard]] constexpr const char* yes_or_no(bool yes) { return yes ? "yes" : "no"; }

/// Returns any value as a field: texts and numbers as above, an enumerator by its to_string(), a missing value as an
/// empty field.
template <class T>
[[nodiscard]] std::string field(const T& value, const char* format = "{}") {
  if constexpr (std::is_enum_v<T>)
    return text_field(to_string(value));
  else if constexpr (std::signed_integral<T>)
    return number_field(std::int64_t{value}, format);
  else if constexpr (std::unsigned_integral<T>)
    return number_field(std::uint64_t{value}, format);
  else if constexpr (std::floating_point<T>)
    return number_field(double{value}, format);
  else if constexpr (std::convertible_to<T, std::string_view>)
    return text_field(value);
  else
    return value ? field(*value, format) : std::string();
}

/// Returns the function of a row that finds a member of a member: path(&Row::tally, &Tally::wrong) is row.tally.wrong.
/// A member that is a pointer is followed.
template <class First, class Second>
[[nodiscard]] auto path(First first, Second second) {
  return [=](const auto& row) { return std::invoke(second, std::invoke(first, row)); };
}

/// A column of a table: its name in the heading, with the unit at its end (`_ns`), its meaning, and how the field of a
/// row is found and printed.
template <class Row>
struct Column {
  /// `value`: a member of Row, or a function of a row; the value is printed by `field`.
  template <class Value>
  Column(std::string column, std::string about, Value value, const char* format = "{}")
      : name(std::move(column)),
        meaning(std::move(about)),
        print([value, format](const Row& row) { return field(std::invoke(value, row), format); }) {}

  std::string name, meaning;
  std::function<std::string(const Row&)> print;
};

/// A table without its rows, for help and pages.
struct TableDescription {
  std::string file;
  std::string row;                                           ///< the subject of a row, as in `a method and a test`
  std::vector<std::pair<std::string, std::string>> columns;  ///< names and meanings
};

/// Returns lines of fields in columns: numbers to the right, texts to the left. The first line is the heading.
[[nodiscard]] std::string aligned(const std::vector<std::vector<std::string>>& lines);

/// A CSV file that a command writes. Its columns are declared here and nowhere else: heading, rows and description all
/// follow from the declaration. The same rows give the same bytes.
template <class Row>
class Table {
 public:
  Table(std::string file, std::string row, std::vector<Column<Row>> columns)
      : file_(std::move(file)), row_(std::move(row)), columns_(std::move(columns)) {}

  /// Returns the text of the file.
  [[nodiscard]] std::string csv(const std::vector<Row>& rows) const {
    std::string text;
    for (const Column<Row>& column : columns_) text.append(text.empty() ? "" : ",").append(text_field(column.name));
    for (const Row& row : rows) {
      char separator = '\n';
      for (const Column<Row>& column : columns_) {
        text.append(1, separator).append(column.print(row));
        separator = ',';
      }
    }
    return text + '\n';
  }
  /// Returns the same for the terminal: fields in columns.
  [[nodiscard]] std::string aligned(const std::vector<Row>& rows) const {
    std::vector<std::vector<std::string>> lines(1);
    for (const Column<Row>& column : columns_) lines.front().push_back(column.name);
    for (const Row& row : rows)
      for (auto& line = lines.emplace_back(); const Column<Row>& column : columns_) line.push_back(column.print(row));
    return program::aligned(lines);
  }
  /// Writes the file into the folder. Throws as write_file does.
  void write(const std::filesystem::path& folder, const std::vector<Row>& rows) const {
    write_file(folder / file_, csv(rows));
  }
  [[nodiscard]] TableDescription description() const {
    TableDescription description{file_, row_, {}};
    for (const Column<Row>& column : columns_) description.columns.emplace_back(column.name, column.meaning);
    return description;
  }

 private:
  std::string file_, row_;
  std::vector<Column<Row>> columns_;
};

/// A share and its confidence limits.
struct Rate {
  double share, lower, upper;
};

/// Returns the share with its Clopper-Pearson limits of 95 %; the share of no trials is 0. Requires count <= trials,
/// and independent trials.
[[nodiscard]] Rate rate(std::uint64_t count, std::uint64_t trials);

/// Returns the columns `rate`, `lower` and `upper`, each with the prefix before its name. `counted`: the events;
/// `value`: a member of Row, or a function of a row, that is a Rate.
template <class Row, class Value>
[[nodiscard]] std::vector<Column<Row>> rate_columns(const std::string& counted, const Value& value,
                                                    const std::string& prefix = "") {
  const auto part = [value](double Rate::*member) {
    return [value, member](const Row& row) { return std::invoke(value, row).*member; };
  };
  constexpr const char* kFormat = "{:.6g}";
  return {{prefix + "rate", "the share of " + counted, part(&Rate::share), kFormat},
          {prefix + "lower", "its lower limit", part(&Rate::lower), kFormat},
          {prefix + "upper", "its upper limit", part(&Rate::upper), kFormat}};
}

/// Returns the columns of all lists, in order.
template <class Row>
[[nodiscard]] std::vector<Column<Row>> all_columns(std::initializer_list<std::vector<Column<Row>>> lists) {
  std::vector<Column<Row>> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace touchstone::program
