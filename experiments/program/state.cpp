// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/state.h"

#include <charconv>

namespace touchstone::program {
namespace {

template <class Number>
std::string written(Number number) {
  std::array<char, 32> digits;
  return {digits.begin(), std::to_chars(digits.begin(), digits.end(), number).ptr};
}

template <class Number>
Number read_number(std::string_view token) {
  Number number{};
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), number);
  if (error != std::errc() || end != token.data() + token.size())
    throw DamagedArchive("\"" + std::string(token.substr(0, 20)) + "\" is not a number");
  return number;
}

}  // namespace

void Archive::append(std::string_view token) {
  if (!text_.empty()) text_ += ' ';
  text_ += token;
}

std::string_view Archive::token() {
  if (read_ >= text_.size()) throw DamagedArchive("it ends too early");
  const std::size_t end = std::min(text_.find(' ', read_), text_.size());
  const std::string_view token = std::string_view(text_).substr(read_, end - read_);
  read_ = end + 1;
  return token;
}

void Archive::pass_integer(std::uint64_t& value) {
  reading_ ? void(value = read_number<std::uint64_t>(token())) : append(written(value));
}

void Archive::pass_integer(std::int64_t& value) {
  reading_ ? void(value = read_number<std::int64_t>(token())) : append(written(value));
}

void Archive::pass_real(double& value) {
  reading_ ? void(value = read_number<double>(token())) : append(written(value));
}

// Its length, a blank, and its characters as they are.
void Archive::pass_text(std::string& value) {
  std::uint64_t size = value.size();
  pass_integer(size);
  if (!reading_) {
    append(value);
    return;
  }
  if (read_ > text_.size() || size > text_.size() - read_) throw DamagedArchive("it ends within a text");
  value = text_.substr(read_, size);
  read_ += size + 1;
}

void Archive::expect_end() const {
  if (read_ < text_.size()) throw DamagedArchive("something follows what was archived");
}

}  // namespace touchstone::program
