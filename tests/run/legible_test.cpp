// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/legible.h"

#include <gtest/gtest.h>

#include <utility>

namespace touchstone::run {
namespace {

TEST(Legible, KeepsWhatCanBePrinted) {
  for (const char* text : {"", R"({"id":"a\\b"})", "caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80 \xc2\xa0"})
    EXPECT_EQ(legible(text), text);
}

TEST(Legible, ShowsControlCharactersAndWhatIsNotUtf8AsBytes) {
  for (const auto& [bytes, shown] : {std::pair{"\x1b[31mred\x07", R"(\x1b[31mred\x07)"},
                                     {"a\tb\x7f", R"(a\x09b\x7f)"},
                                     {"\xc2\x9b", R"(\xc2\x9b)"},
                                     {"\xef\xbb\xbf{}", R"(\xef\xbb\xbf{})"},
                                     {"\xff\xfe", R"(\xff\xfe)"},
                                     {"\xc0\xaf", R"(\xc0\xaf)"},
                                     {"\xe0\x80\xaf", R"(\xe0\x80\xaf)"},
                                     {"\xed\xa0\x80", R"(\xed\xa0\x80)"},
                                     {"\xf4\x90\x80\x80", R"(\xf4\x90\x80\x80)"},
                                     {"\xe2\x82", R"(\xe2\x82)"},
                                     {"\xe2x", R"(\xe2x)"}})
    EXPECT_EQ(legible(bytes), shown);
  EXPECT_EQ(legible({"\0", 1}), R"(\x00)");
}

TEST(Legible, ShowsABeginningOfWhatIsLong) {
  EXPECT_EQ(legible(std::string(200, 'x')), std::string(200, 'x'));
  EXPECT_EQ(legible(std::string(100'000, 'x')), std::string(200, 'x') + "...");
  EXPECT_EQ(legible(std::string(199, 'x') + "\xc3\xa9"), std::string(199, 'x') + "...");
}

}  // namespace
}  // namespace touchstone::run
