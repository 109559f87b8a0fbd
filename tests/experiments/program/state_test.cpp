// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/state.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "experiments/cases/workloads/random.h"
#include "tests/experiments/program/light.h"

namespace touchstone::program {
namespace {

struct Inner {
  double weight = 0;
  std::optional<std::string> name;

  auto members() { return std::tie(weight, name); }
  friend bool operator==(const Inner&, const Inner&) = default;
};

struct Outer {
  std::int64_t signed_number = 0;
  std::uint64_t count = 0;
  bool flag = false;
  Light colour = Light::Red;
  std::array<std::uint8_t, 2> pair{};
  std::vector<Inner> list;
  std::map<std::tuple<int, std::string>, double> map;
  std::string text;

  auto members() { return std::tie(signed_number, count, flag, colour, pair, list, map, text); }
  friend bool operator==(const Outer&, const Outer&) = default;
};

Outer example() {
  return {.signed_number = std::numeric_limits<std::int64_t>::min(),
          .count = std::numeric_limits<std::uint64_t>::max(),
          .flag = true,
          .colour = Light::Green,
          .pair = {7, 255},
          .list = {{0.1, "a name\nwith 2 lines"}, {-0.0, std::nullopt}, {0x1p-1074, ""}},
          .map = {{{-1, "one two"}, std::numeric_limits<double>::infinity()}, {{3, ""}, -0.5}},
          .text = " 12 34 "};
}

TEST(Archive, GivesBackEveryValue) {
  Outer read;
  read.colour = Light::Red;
  restore(archived(example()), read);
  EXPECT_EQ(read, example());
  EXPECT_TRUE(std::signbit(read.list[1].weight));
}

TEST(Archive, KeepsTheBitsOfEveryDouble) {
  workloads::Random random(5, 0);
  for (int i = 0; i < 2000; ++i) {
    const auto number = std::bit_cast<double>(random.bits());
    if (number != number) continue;
    double read = 0;
    restore(archived(number), read);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(number));
  }
}

TEST(Archive, RefusesATextThatWasCutOrContinued) {
  const std::string text = archived(example());
  for (std::size_t length = 0; length < text.size(); ++length) {
    Outer read;
    EXPECT_THROW(restore(text.substr(0, length), read), DamagedArchive) << length;
  }
  Outer read;
  EXPECT_THROW(restore(text + " 1", read), DamagedArchive);
}

TEST(Archive, RefusesAListThatIsLongerThanTheText) {
  std::vector<double> list;
  EXPECT_THROW(restore("18446744073709551615 1 2", list), DamagedArchive);
}

TEST(Archive, RefusesANumberThatItsTypeCannotHold) {
  std::uint8_t small = 0;
  restore("255", small);
  EXPECT_EQ(small, 255);
  EXPECT_THROW(restore("256", small), DamagedArchive);
  std::int16_t narrow = 0;
  EXPECT_THROW(restore("-32769", narrow), DamagedArchive);
}

TEST(Sum, AddsMemberByMember) {
  struct Counts {
    std::array<int, 2> pair{};
    std::vector<int> list;
    std::map<std::string, int> map;

    auto members() { return std::tie(pair, list, map); }
  };
  Counts sum{{1, 2}, {}, {{"a", 1}}};
  add(sum, Counts{{10, 20}, {5, 6}, {{"a", 2}, {"b", 3}}});
  add(sum, Counts{{100, 200}, {1, 1}, {}});
  EXPECT_EQ(sum.pair, (std::array<int, 2>{111, 222}));
  EXPECT_EQ(sum.list, (std::vector<int>{6, 7}));
  EXPECT_EQ(sum.map, (std::map<std::string, int>{{"a", 3}, {"b", 3}}));
}

}  // namespace
}  // namespace touchstone::program
