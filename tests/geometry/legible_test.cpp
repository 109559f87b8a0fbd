// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/io/detail/legible.h"

#include <gtest/gtest.h>

#include <utility>

namespace touchstone::geometry_tests {
namespace {

using io::all_legible;
using io::legible;

TEST(Legible, KeepsWhatCanBePrinted) {
  for (const char* text : {"", R"({"id":"a\\b"})", "caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80 \xc2\xa0"})
    EXPECT_EQ(legible(text), text);
}

TEST(Legible, ShowsControlCharactersAndWhatIsNotUtf8AsBytes) {
  for (const auto& [bytes, shown] : {std::pair{"\x1b[31mred\x07", R"(\x1b[31mred\x07)"},
                                     {"a\tb\x7f", R"(a\x09b\x7f)"},
                                     {"a\nb\r", R"(a\x0ab\x0d)"},
                                     {"\xc2\x9b", R"(\xc2\x9b)"},
                                     {"\xd8\x9c", R"(\xd8\x9c)"},
                                     {"\xe2\x80\xae", R"(\xe2\x80\xae)"},
                                     {"\xe2\x81\xa6", R"(\xe2\x81\xa6)"},
                                     {"\xef\xbb\xbf{}", R"(\xef\xbb\xbf{})"},
                                     {"\xff\xfe", R"(\xff\xfe)"},
                                     {"\xc0\xaf", R"(\xc0\xaf)"},
                                     {"\xe0\x80\xaf", R"(\xe0\x80\xaf)"},
                                     {"\xed\xa0\x80", R"(\xed\xa0\x80)"},
                                     {"\xf4\x90\x80\x80", R"(\xf4\x90\x80\x80)"},
                                     {"\xe2\x82", R"(\xe2\x82)"},
                                     {"\xe2x", R"(\xe2x)"}})
    EXPECT_EQ(legible(bytes), shown);
  EXPECT_EQ(legible({"a\0b", 3}), R"(a\x00b)");
}

TEST(Legible, ShowsABeginningOfWhatIsLong) {
  EXPECT_EQ(legible(std::string(200, 'x')), std::string(200, 'x'));
  EXPECT_EQ(legible(std::string(100'000, 'x')), std::string(200, 'x') + "...");
  EXPECT_EQ(legible(std::string(199, 'x') + "\xc3\xa9"), std::string(199, 'x') + "...");
  EXPECT_EQ(legible("abcd", 3), "abc...");
  EXPECT_EQ(all_legible(std::string(100'000, 'x') + "\x1b"), std::string(100'000, 'x') + R"(\x1b)");
}

TEST(Legible, KeepsWhatItReturns) {
  for (int first = 0; first < 256; ++first)
    for (int second = 0; second < 256; ++second) {
      const std::string shown = all_legible(std::string{static_cast<char>(first), static_cast<char>(second)});
      EXPECT_EQ(all_legible(shown), shown);
    }
}

}  // namespace
}  // namespace touchstone::geometry_tests
