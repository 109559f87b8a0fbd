// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <cctype>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "experiments/judge/ask.h"
#include "experiments/program/printing.h"
#include "geometry/io/detail/text_number.h"
#include "geometry/same_number.h"
#include "geometry/shapes/rejection.h"
#include "robust/exact/validate.h"

namespace touchstone::judge {
namespace {

using Texts = std::vector<std::string>;

[[noreturn]] void fail(const std::string& what, const std::string& why) { throw std::runtime_error(what + ": " + why); }

Texts split_at(std::string_view text, char separator) {
  Texts parts;
  boost::split(parts, text, [separator](char c) { return c == separator; });
  return parts;
}

/// Returns the words between white space.
Texts words_of(const std::string& text) {
  const std::string trimmed = boost::trim_copy(text);
  Texts words;
  if (!trimmed.empty()) boost::split(words, trimmed, boost::is_space(), boost::token_compress_on);
  return words;
}

double number_of(const std::string& word, const std::string& what) {
  const auto number = io::nearest_double(word);
  if (!number) fail(what, fmt::format("\"{}\" is not a number", word));
  if (!std::isfinite(*number)) fail(what, fmt::format("\"{}\" is not finite", word));
  return *number;
}

Eigen::Vector3d point_of(const std::string& text, const std::string& what) {
  const Texts words = words_of(text);
  if (words.size() != 2 && words.size() != 3)
    fail(what, fmt::format("\"{}\" has {}, not two or three", boost::trim_copy(text),
                           program::counted(words.size(), "number")));
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < words.size(); ++k) point[static_cast<Eigen::Index>(k)] = number_of(words[k], what);
  return point;
}

Loop loop_of(const std::string& text, const std::string& name) {
  Loop loop;
  for (const std::string& point : split_at(text, ','))
    loop.push_back(point_of(point, fmt::format("{}: point {}", name, loop.size())));
  return loop;
}

/// Returns the loops of WKT as texts, without their parentheses.
Texts loops_of_wkt(std::string_view text) {
  constexpr std::string_view kWord = "POLYGON";
  std::string rest = boost::trim_copy(std::string(text.substr(kWord.size())));
  if (boost::istarts_with(rest, "Z")) rest = boost::trim_copy(rest.substr(1));
  if (!rest.starts_with('(') || !rest.ends_with(')')) fail("WKT", "POLYGON needs its loops in parentheses");
  rest = rest.substr(1, rest.size() - 2);
  Texts loops;
  for (std::size_t at = 0; at < rest.size();) {
    const std::size_t open = rest.find('(', at), close = rest.find(')', at);
    const bool is_loop = open != std::string::npos && close != std::string::npos && open < close &&
                         boost::trim_copy(rest.substr(at, open - at)) == (loops.empty() ? "" : ",");
    if (!is_loop) fail("WKT", fmt::format("after loop {}: expected another one in parentheses", loops.size()));
    loops.push_back(rest.substr(open + 1, close - open - 1));
    at = close + 1;
    if (boost::trim_copy(rest.substr(at)).empty()) break;
  }
  return loops;
}

}  // namespace

Polygon polygon_of(std::string_view text) {
  for (const char* mark : {"\xEF\xBB\xBF", "\xFE\xFF", "\xFF\xFE"})
    if (text.starts_with(mark)) fail("line 1", "begins with a byte order mark; write it in UTF-8 without one");
  const std::string trimmed = boost::trim_copy(std::string(text));
  const bool is_wkt = boost::istarts_with(trimmed, "POLYGON");
  const Texts words = words_of(trimmed.substr(0, trimmed.find(',')));
  const bool is_word = !words.empty() && std::isalpha(static_cast<unsigned char>(words.front().front())) != 0 &&
                       !io::nearest_double(words.front());
  if (!is_wkt && (is_word || trimmed.find(',') == std::string::npos))
    fail(fmt::format("\"{}\"", trimmed.substr(0, 40)), "is neither loops, nor a POLYGON of WKT, nor a file");
  std::vector<Loop> loops;
  for (const std::string& loop : is_wkt ? loops_of_wkt(trimmed) : split_at(trimmed, ';')) {
    const std::string name = loop_name(loops.size());
    loops.push_back(loop_of(loop, name));
    if (!is_wkt) continue;
    if (!same_point(loops.back().front(), loops.back().back())) fail(name, "does not end with its first point");
    loops.back().pop_back();
  }
  if (loops.empty()) fail("WKT", "has no loop");
  Polygon polygon(loops.front(), {loops.begin() + 1, loops.end()});
  if (const auto rejection = exact::validate(polygon)) throw Rejected(*rejection);
  return polygon;
}

Eigen::VectorXd numbers_of(std::string_view text, int count) {
  const Texts words = split_at(text, ',');
  if (words.size() != static_cast<std::size_t>(count))
    fail(fmt::format("\"{}\"", text), fmt::format("has {}, not {}", program::counted(words.size(), "number"), count));
  Eigen::VectorXd numbers(count);
  for (std::size_t i = 0; i < words.size(); ++i)
    numbers[static_cast<Eigen::Index>(i)] = number_of(boost::trim_copy(words[i]), fmt::format("number {}", i));
  return numbers;
}

}  // namespace touchstone::judge
