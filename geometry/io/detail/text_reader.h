// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/io/detail/legible.h"
#include "geometry/io/detail/mesh_source.h"
#include "geometry/io/detail/text_number.h"

namespace touchstone::io {

struct TextSyntax {
  bool comments = false;  ///< '#' at the start of a word begins a comment that ends with the line
  /// Whether a line that begins with this word, and ends with '\' and any blanks, continues on the next.
  bool (*continues)(std::string_view word) = nullptr;
};

/// Reads the lines of a text file that are not blank, each as fields separated by blanks; or words, whatever lines they
/// are on.
///
/// Lines end with "\n", "\r\n" or "\r". Only continued lines are copied.
class TextReader {
 public:
  TextReader(const MeshSource& source, TextSyntax syntax) : source_(source), text_(source.bytes), syntax_(syntax) {
    if (text_.starts_with("\xEF\xBB\xBF")) position_ = 3;  // the byte order mark of UTF-8
    if (source.has_wide_byte_order_mark())
      source.lost(place(), "the byte order mark is that of UTF-16 or UTF-32; text must be UTF-8");
  }
  /// Reads on from where the other is. Requires a syntax without continuations.
  TextReader(const TextReader&) = default;
  TextReader& operator=(const TextReader&) = delete;

  /// Moves to the next line that is not blank. Returns false at the end of the file.
  bool next_line() {
    while (position_ < text_.size()) {
      line_number_ = lines_passed_ + 1;
      rest_ = physical_line();
      skip_blanks();
      is_joined_ = syntax_.continues != nullptr && ends_with_backslash() && syntax_.continues(peek_keyword());
      joints_.clear();
      if (is_joined_) join_continuations();
      skip_blanks();
      if (!rest_.empty()) return true;
    }
    return false;
  }

  /// Where the current line begins.
  [[nodiscard]] SourceLocation place() const {
    return {SourceLocation::Unit::Line, std::max<std::size_t>(line_number_, 1)};
  }
  /// Where the last word that was taken stands: on a later line than `place` if the current line is continued.
  [[nodiscard]] SourceLocation word_place() const {
    SourceLocation where = place();
    where.number += static_cast<std::size_t>(std::ranges::upper_bound(joints_, word_begin_) - joints_.begin());
    return where;
  }
  [[nodiscard]] bool line_is_done() const { return rest_.empty(); }
  [[nodiscard]] bool line_is_continued() const { return is_joined_; }
  /// Returns the position of the byte after the current line. If all lines before it end with "\r" alone, so does this
  /// one: a "\n" that follows is data.
  [[nodiscard]] std::size_t position() const {
    const bool first_other_end = other_ends_ == 1 && lines_passed_ > 1;
    return first_other_end && text_.substr(0, position_).ends_with("\r\n") ? position_ - 1 : position_;
  }

  /// From here on parts are words on any lines: after a fault it is unknown where the next begins.
  void read_words() { reads_words_ = true; }

  /// Reports a fault of this part. If another part may have begun within it, the rest of the file is lost.
  [[noreturn]] void broken(const std::string& reason) const { broken(word_place(), reason); }
  [[noreturn]] void broken(SourceLocation where, const std::string& reason) const {
    if (reads_words_ || is_joined_) source_.lost(where, reason);
    source_.broken(where, reason);
  }
  /// Reports a fault after which the next part cannot be found.
  [[noreturn]] void lost(const std::string& reason) const { source_.lost(word_place(), reason); }

  /// Reports that something is missing at the end of the file. The place is the last line.
  [[noreturn]] void truncated(const std::string& reason) const { lost("the file is truncated: " + reason); }

  /// Takes the next field of the line; empty at its end.
  std::string_view take() {
    const std::string_view field = peek();
    if (is_joined_ && !field.empty()) word_begin_ = joined_.size() - rest_.size();
    rest_.remove_prefix(field.size());
    skip_blanks();
    return field;
  }

  /// Moves to the next word, which may be on a later line. Returns false at the end of the file.
  bool next_word() { return !line_is_done() || next_line(); }
  /// Returns whether the next line that is not blank is one whole number.
  [[nodiscard]] bool next_line_is_whole_number() {
    TextReader ahead(*this);
    return ahead.next_line() && whole_number(ahead.take()) && ahead.line_is_done();
  }
  /// Returns whether what is left of the line ends with a '\' and any blanks.
  [[nodiscard]] bool ends_with_backslash() const { return before_continuation(rest_).has_value(); }
  /// Returns what is left of the line.
  [[nodiscard]] std::string_view rest_of_line() const { return rest_; }
  /// Takes the next words, if they are this many numbers, and returns whether they are.
  bool take_words(std::int64_t count) {
    for (; count > 0; --count)
      if (!next_word() || !nearest_double(take())) return false;
    return true;
  }
  /// Takes the next word, if it is a count, and as many numbers; returns whether they are.
  bool take_list_of_words() {
    if (!next_word()) return false;
    const std::optional<std::int64_t> count = whole_decimal(take());
    return count && *count >= 0 && take_words(*count);
  }
  /// Takes numbers up to the end of the line or to a field that is not a number. Returns how many.
  int take_numbers() {
    int count = 0;
    for (; !line_is_done() && nearest_double(peek()); ++count) take();
    return count;
  }
  /// Returns the number of lines from the next on. Moves to the end of the file.
  std::int64_t count_lines() {
    std::int64_t count = 0;
    while (next_line()) ++count;
    return count;
  }

  /// Returns the next field without taking it.
  [[nodiscard]] std::string_view peek() const {
    return rest_.substr(0,
                        static_cast<std::size_t>(std::find_if(rest_.begin(), rest_.end(), is_blank) - rest_.begin()));
  }

  void skip_fields(std::int64_t count) {
    for (; count > 0; --count)
      if (take().empty()) broken("too few values on the line");
  }

  /// Takes the next field as a double, which may be infinite or NaN.
  double take_double() {
    const std::string_view field = take();
    if (field.empty()) broken("expected a number, found the end of the line");
    const std::optional<double> value = nearest_double(field);
    if (!value) broken(quoted(field) + " is not a number");
    return *value;
  }
  /// Takes the next field as a finite double.
  double take_number() {
    const std::string_view field = peek();
    const double value = take_double();
    if (!std::isfinite(value)) broken(quoted(field) + " is not a finite double");
    return value;
  }

  /// Takes the next three fields as a point, each by `coordinate`. `after` says in messages where they stand.
  Eigen::Vector3d take_point(const char* after, double (TextReader::*coordinate)() = &TextReader::take_number) {
    Eigen::Vector3d point;
    for (int axis = 0; axis < 3; ++axis) {
      if (rest_.empty()) broken(std::string("expected three numbers ") + after + ", found " + std::to_string(axis));
      point[axis] = (this->*coordinate)();
    }
    return point;
  }

  /// How integers may be written: as digits, or as any decimal, such as `3.0`.
  enum class Whole { Digits, Decimal };

  /// Takes the next field as an integer. `what` names it in messages.
  std::int64_t take_whole(const char* what, Whole written = Whole::Digits) {
    const std::string_view field = take();
    if (field.empty()) broken(std::string("expected a ") + what + ", found the end of the line");
    const std::optional<std::int64_t> value = written == Whole::Digits ? whole_number(field) : whole_decimal(field);
    if (!value) broken(quoted(field) + " is not a " + what);
    return *value;
  }

  /// Takes the next field as an integer that must not be negative.
  std::int64_t take_count(Whole written = Whole::Digits) {
    const std::int64_t count = take_whole("count", written);
    if (count < 0) broken("the count " + std::to_string(count) + " is negative");
    return count;
  }

  /// Takes the next `count` fields as vertex numbers, which replace the content of `corners`.
  void take_corners(std::int64_t count, std::vector<std::int64_t>& corners, Whole written = Whole::Digits) {
    corners.clear();
    for (std::int64_t i = 0; i < count; ++i) {
      if (rest_.empty()) broken("expected " + std::to_string(count) + " vertex numbers, found " + std::to_string(i));
      corners.push_back(take_whole("vertex number", written));
    }
  }

  /// Takes the rest of the line, and returns how many numbers it holds. Reports a fault if it holds anything else.
  int take_rest_of_numbers() {
    const int count = take_numbers();
    if (!line_is_done()) broken(quoted(take()) + " is not a number");
    return count;
  }

  static std::string quoted(std::string_view field) {
    constexpr std::size_t kLongest = 40;
    return "'" + legible(field, kLongest) + "'";
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool ends_line(char c) { return c == '\n' || c == '\r'; }

  static std::string_view without_comment(std::string_view line) {
    for (std::size_t i = line.find('#'); i < line.size(); i = line.find('#', i + 1))
      if (i == 0 || is_blank(line[i - 1])) return line.substr(0, i);
    return line;
  }
  /// Returns the line without the '\' at its end and the blanks after that; nothing if it has none.
  static std::optional<std::string_view> before_continuation(std::string_view line) {
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    if (!line.ends_with('\\')) return std::nullopt;
    return line.substr(0, line.size() - 1);
  }
  /// Returns the next field without a '\' at its end.
  [[nodiscard]] std::string_view peek_keyword() const { return before_continuation(peek()).value_or(peek()); }

  void skip_blanks() {
    std::size_t blanks = 0;
    while (blanks < rest_.size() && is_blank(rest_[blanks])) ++blanks;
    rest_.remove_prefix(blanks);
  }

  std::string_view physical_line() {
    const std::size_t begin = position_;
    while (position_ < text_.size() && !ends_line(text_[position_])) ++position_;
    const std::string_view line = text_.substr(begin, position_ - begin);
    if (text_.substr(position_, 2) == "\r\n") ++position_;
    if (text_.substr(position_, 1) == "\n") ++other_ends_;
    if (position_ < text_.size()) ++position_;
    ++lines_passed_;
    return syntax_.comments ? without_comment(line) : line;
  }

  void join_continuations() {
    joined_.clear();
    word_begin_ = 0;
    while (const auto part = before_continuation(rest_)) {
      joined_.append(*part).push_back(' ');
      joints_.push_back(joined_.size());
      rest_ = position_ < text_.size() ? physical_line() : std::string_view{};
    }
    joined_.append(rest_);
    rest_ = joined_;
  }

  const MeshSource& source_;
  std::string_view text_;
  TextSyntax syntax_;
  std::size_t position_ = 0;
  std::size_t lines_passed_ = 0;
  std::size_t other_ends_ = 0;       // of the lines passed, not "\r" alone
  std::size_t line_number_ = 0;      // where the current line begins
  std::string_view rest_;            // the rest of the current line, from the next field on
  std::string joined_;               // the current line, if it was continued
  std::vector<std::size_t> joints_;  // where in it each line after its first begins; empty if it was not
  std::size_t word_begin_ = 0;       // where in it the last word taken begins
  bool reads_words_ = false, is_joined_ = false;
};

}  // namespace touchstone::io
