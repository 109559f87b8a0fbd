// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <tuple>

#include "experiments/program/output.h"
#include "experiments/program/study.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::program {
namespace {

namespace fs = std::filesystem;

struct Done {
  std::uint64_t done = 0;

  auto members() { return std::tie(done); }
};

std::uint64_t items_done(const Done& sum) { return sum.done; }

/// The settings of the first of two parts by this version, seed and these methods.
ResultSettings settings(int version, const char* seed, const char* methods, const char* part = "1/2 of 8 items") {
  return {version, {{"seed", seed}, {"methods", methods}}, part};
}

class SumOfAPart : public testing::Test {
 protected:
  [[nodiscard]] fs::path path() const { return folder_ / "part.json"; }
  [[nodiscard]] PartFile with(const ResultSettings& settings) const { return {path(), settings}; }
  [[nodiscard]] std::string refusal(const ResultSettings& settings, std::uint64_t items = 4) const {
    const std::string said = run_tests::message_of([&] { return with(settings).read(Done(), items); });
    return said.empty() ? said : run_tests::after_file(path(), said);
  }

  const run_tests::Scratch scratch_;
  const fs::path folder_ = scratch_.path;
};

const ResultSettings kSettings = settings(1, "3", "fast,thesis");

TEST_F(SumOfAPart, IsReadAsItWasWritten) {
  EXPECT_EQ(refusal(kSettings), "is missing: its part has not ended, so run it again");
  with(kSettings).write(Done{3});
  with(kSettings).write(Done{4});
  EXPECT_EQ(with(kSettings).read(Done(), 4).done, 4U);
  EXPECT_EQ(refusal(kSettings, 5), "does not hold all items of its part");
}

TEST_F(SumOfAPart, NamesTheSettingsThatDiffer) {
  with(kSettings).write(Done{4});
  EXPECT_EQ(refusal(kSettings), "");
  EXPECT_EQ(refusal(settings(1, "4", "fast,thesis")), "is of --seed 3, not of --seed 4");
  EXPECT_EQ(refusal(settings(1, "4", "fast")), "is of --seed 3 --methods fast,thesis, not of --seed 4 --methods fast");
  EXPECT_EQ(refusal(settings(1, "3", "fast,thesis", "1/2 of 9 items")),
            "is of --part 1/2 of 8 items, not of --part 1/2 of 9 items");
  EXPECT_EQ(refusal(settings(2, "3", "fast,thesis")), "is of another version of this program");
}

TEST_F(SumOfAPart, IsRefusedIfItCannotBeOpened) {
  write_file(folder_ / "file", "");
  const PartFile below(folder_ / "file" / "part.json", kSettings);
  EXPECT_THROW((void)below.read(Done(), 4), std::runtime_error);
}

TEST_F(SumOfAPart, IsRefusedWhereItIsDamaged) {
  with(kSettings).write(Done{4});
  const std::string sound = run_tests::text_of(path());
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[]"), sound.substr(0, sound.size() / 2)}) {
    write_file(path(), text);
    EXPECT_TRUE(refusal(kSettings).starts_with("is not of a part of this program: ")) << text;
  }
}

// An edit of equal length is one, too.
TEST_F(SumOfAPart, IsRefusedWhereItWasEdited) {
  with(kSettings).write(Done{4});
  std::string text = run_tests::text_of(path());
  const std::size_t at = text.find("\"sum\":\"4\"");
  ASSERT_NE(at, std::string::npos) << text;
  text[at + 7] = '5';
  write_file(path(), text);
  EXPECT_EQ(refusal(kSettings, 5), "was changed since its run wrote it");
}

}  // namespace
}  // namespace touchstone::program
