// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/table.h"

#include <gtest/gtest.h>

#include <limits>

#include "experiments/program/statistics/shares.h"
#include "tests/experiments/program/light.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::program {
namespace {

struct Measured {
  double size;
};

struct Row {
  std::string name;
  Light colour;
  std::int64_t offset;
  std::optional<double> mean;
  const Measured* part;
  Rate rate;
};

const Table<Row>& table() {
  static const Table<Row> table("rows.csv", "a name",
                                all_columns<Row>({{{"name", "the name", &Row::name},
                                                   {"colour", "its colour", &Row::colour},
                                                   {"offset", "in doubles", &Row::offset},
                                                   {"mean", "rounded", &Row::mean, "{:.2g}"},
                                                   {"size", "of the part", path(&Row::part, &Measured::size)}},
                                                  rate_columns<Row>("names", &Row::rate, "far_")}));
  return table;
}

const Measured kPart{0.1};
const std::vector<Row> kRows{
    {"plain", Light::Red, -3, 2.345, &kPart, rate(0, 0)},
    {"with, comma \"and\" quotes", Light::Green, std::numeric_limits<std::int64_t>::min(), {}, &kPart, {0.5, 0.25, 1}}};

TEST(Table, PrintsEveryColumnOfEveryRow) {
  EXPECT_EQ(table().csv(kRows),
            "name,colour,offset,mean,size,far_rate,far_lower,far_upper\n"
            "plain,red,-3,2.3,0.1,0,0,1\n"
            "\"with, comma \"\"and\"\" quotes\",green,-9223372036854775808,,0.1,0.5,0.25,1\n");
}

TEST(Table, DescribesTheColumnsThatItPrints) {
  const TableDescription description = table().description();
  EXPECT_EQ(description.file, "rows.csv");
  std::string names;
  for (const auto& [name, meaning] : description.columns) names.append(names.empty() ? "" : ",").append(name);
  EXPECT_EQ(names + "\n", table().csv({}));
  EXPECT_EQ(description.columns[5].second, "the share of names");
}

TEST(Table, IsWrittenIntoItsFolder) {
  const run_tests::Scratch scratch;
  table().write(scratch.path, kRows);
  EXPECT_EQ(run_tests::text_of(scratch.path / "rows.csv"), table().csv(kRows));
  EXPECT_THROW(table().write(scratch.path / "rows.csv", kRows), std::runtime_error);
}

TEST(Table, AlignsNumbersToTheRightAndTextsToTheLeft) {
  EXPECT_EQ(aligned({{"name", "count", "mixed"}, {"a", "1", "3"}, {"bcdef", "-100", "none"}, {"g", "", "4"}}),
            "name   count  mixed\n"
            "a          1  3\n"
            "bcdef   -100  none\n"
            "g             4\n");
}

TEST(Rate, HasTheLimitsOfClopperAndPearson) {
  const auto limits = statistics::clopper_pearson(3, 10);
  EXPECT_EQ(rate(3, 10).share, 0.3);
  EXPECT_EQ(rate(3, 10).lower, limits.lower);
  EXPECT_EQ(rate(3, 10).upper, limits.upper);
}

}  // namespace
}  // namespace touchstone::program
