// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/json.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace touchstone::program {
namespace {

std::string fault(const std::string& text) {
  try {
    return "nothing: " + nlohmann::json::parse(text).dump();
  } catch (const nlohmann::json::exception& error) {
    return json_fault(error, text);
  }
}

TEST(JsonFault, NamesLineAndColumnOfTheByteThatIsWrong) {
  EXPECT_EQ(fault("{x}"),
            "column 2: syntax error while parsing object key - invalid literal; last read: '{x'; expected string "
            "literal");
  for (const auto& [text, place] : {std::pair{"?", "column 1: "},
                                    {"[1,", "column 4: "},
                                    {"x\n", "line 1, column 1: "},
                                    {"\n\nx", "line 3, column 1: "},
                                    {"{\n  \"a\": 1,\n  \"b\": ?\n}", "line 3, column 8: "},
                                    {"[\n1,\n", "line 3, column 1: "}})
    EXPECT_TRUE(fault(text).starts_with(place)) << text << ": " << fault(text);
}

TEST(JsonFault, IsLegibleAndShort) {
  EXPECT_EQ(fault("[\"\xff\x1b\"]").find_first_of("\xff\x1b"), std::string::npos);
  EXPECT_LT(fault('"' + std::string(100'000, 'x')).size(), 300U);
}

TEST(JsonFault, NamesTheLineOfATextThatIsNotGiven) {
  try {
    FAIL() << nlohmann::json::parse("{x}");
  } catch (const nlohmann::json::exception& error) {
    EXPECT_TRUE(json_fault(error).starts_with("line 1, column 2: syntax error")) << json_fault(error);
  }
}

TEST(JsonFault, SaysWhichKeyIsMissing) {
  try {
    FAIL() << nlohmann::json::object().at("a");
  } catch (const nlohmann::json::exception& error) {
    EXPECT_EQ(json_fault(error), "key 'a' not found");
  }
}

}  // namespace
}  // namespace touchstone::program
