// SPDX-License-Identifier: GPL-3.0-or-later
// The end of a study, which its exit status tells a script; its parts and their sum.
#include "experiments/program/study.h"

#include <gtest/gtest.h>

#include <csignal>

#include "experiments/program/words.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::program {
namespace {

using run_tests::Scratch;

/// The exit status of a run whose pictures nobody can draw, for no script has this name.
int finish_without_pictures(const std::filesystem::path& folder, bool no_pictures, int status) {
  StudyOptions options;
  options.output = folder.string();
  options.no_pictures = no_pictures;
  StudyRun run("no-such-study", 1, options);
  return run.finish({.done = 1, .text = "", .status = status});
}

TEST(StudyRun, SaysByItsStatusThatPicturesAreMissingAndKeepsTheData) {
  const Scratch scratch;
  EXPECT_EQ(finish_without_pictures(scratch.path / "undrawn", false, 0), 1);
  EXPECT_TRUE(std::filesystem::exists(scratch.path / "undrawn" / "run.json"));
  EXPECT_EQ(finish_without_pictures(scratch.path / "unasked", true, 0), 0);
  EXPECT_EQ(finish_without_pictures(scratch.path / "failed", false, 3), 3) << "the study's own status goes first";
}

/// What a run says of itself that is interrupted before its end.
std::string said_of_interruption(const std::filesystem::path& folder, const std::string& part) {
  StudyOptions options;
  options.output = folder.string();
  options.part = part;
  options.samples = 10;
  StudyRun run("no-such-study", 1, options);
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  std::raise(SIGINT);
  EXPECT_EQ(run.finish({.done = 3, .text = "", .also = "4 of 5 passes"}), kInterrupted);
  EXPECT_EQ(testing::internal::GetCapturedStdout().empty(), !part.empty());
  return testing::internal::GetCapturedStderr();
}

TEST(StudyRun, SaysWhatAnInterruptedRunCoversAndThatAPartKeepsNothing) {
  const Scratch scratch;
  EXPECT_EQ(said_of_interruption(scratch.path / "whole", ""),
            "touchstone: interrupted: " + (scratch.path / "whole").string() +
                " covers 3 of 10 samples and 4 of 5 passes; no pictures\n");
  EXPECT_EQ(said_of_interruption(scratch.path / "part", "1/2"),
            "touchstone: interrupted: a part then keeps nothing; run it again\n");
}

// Every item belongs to one part, and the parts are about as large as each other.
TEST(Part, TakesItsShareOfTheItems) {
  for (const std::uint64_t items : {0U, 1U, 6U, 7U, 100U})
    for (const std::uint64_t of : {1U, 2U, 7U, 8U}) {
      std::uint64_t next = 0;
      for (std::uint64_t number = 1; number <= of; ++number) {
        const Part part{number, of};
        EXPECT_EQ(part.first(items), next) << items << " " << to_string(part);
        EXPECT_LE(part.size(items) - items / of, 1U) << items << " " << to_string(part);
        next += part.size(items);
      }
      EXPECT_EQ(next, items) << of;
    }
}

TEST(Part, IsReadAsItIsWritten) {
  EXPECT_EQ(to_string(Part::read("3/17").value()), "3/17");
  for (const char* text : {"", "/", "3", "3/", "/3", "0/3", "4/3", "-1/3", "1/3/3", "1/1000001", "1 /3"})
    EXPECT_FALSE(Part::read(text)) << text;
}

/// The sum of the numbers of the items, and how many there are.
struct Numbers {
  std::uint64_t sum = 0, count = 0;

  auto members() { return std::tie(sum, count); }
};

std::uint64_t items_done(const Numbers& numbers) { return numbers.count; }

/// Runs a study of that number of items, as its command does.
Numbers run_numbers(const StudyOptions& options) {
  StudyRun run("numbers", 1, options);
  const auto numbers =
      run.phase("items", "part.json", options.samples, Numbers(), [&](const auto& control, Numbers& state) {
        run_sweep(options.samples, 2, control, Numbers(), state, [](std::uint64_t n, Numbers& part) {
          part.sum += n;
          ++part.count;
        });
      });
  run.finish({.done = numbers.count, .text = ""});
  return numbers;
}

StudyOptions numbers_options(const std::filesystem::path& folder, std::uint64_t samples, const std::string& part) {
  StudyOptions options;
  options.quiet = options.no_pictures = true;
  options.samples = samples;
  options.output = folder.string();
  options.part = part;
  options.call.result_options = [] { return std::vector<std::pair<std::string, std::string>>{{"seed", "1"}}; };
  return options;
}

// A part holds its own items alone; together they are all, also if there are fewer items than parts.
TEST(StudyRun, AddsPartsUpToAllItems) {
  for (const std::uint64_t samples : {2U, 10U}) {
    const Scratch scratch;
    StudyOptions all = numbers_options(scratch.path / "all", samples, "");
    std::uint64_t count = 0;
    for (std::uint64_t number = 1; number <= 3; ++number) {
      const Part part{number, 3};
      all.call.parts.push_back(scratch.path / std::to_string(number));
      const Numbers numbers = run_numbers(numbers_options(all.call.parts.back(), samples, to_string(part)));
      EXPECT_EQ(numbers.count, part.size(samples));
      count += numbers.count;
    }
    EXPECT_EQ(count, samples);
    const Numbers merged = run_numbers(all), whole = run_numbers(numbers_options(scratch.path / "one", samples, ""));
    EXPECT_EQ(merged.sum, samples * (samples - 1) / 2);
    EXPECT_EQ(archived(merged), archived(whole));
    EXPECT_FALSE(std::filesystem::exists(scratch.path / "one" / "part.json")) << "a whole run is no part";
  }
}

std::string fault_of(const StudyOptions& options) {
  return run_tests::message_of([&] { return run_numbers(options); });
}

TEST(StudyRun, NamesTheFolderOfAPartThatIsNotOfTheStudy) {
  const Scratch scratch;
  const auto folder = [&](const char* name) { return scratch.path / name; };
  (void)run_numbers(numbers_options(folder("one"), 10, "1/2"));
  (void)run_numbers(numbers_options(folder("two"), 11, "2/2"));
  StudyOptions all = numbers_options(folder("all"), 10, "");
  all.call.parts = {folder("one"), folder("two")};
  EXPECT_EQ(fault_of(all),
            (folder("two") / "part.json").string() + ": is of --part 2/2 of 11 items, not of --part 2/2 of 10 items");
  all.call.parts = {folder("one"), folder("none")};
  EXPECT_EQ(fault_of(all),
            (folder("none") / "part.json").string() + ": is missing: its part has not ended, so run it again");
  EXPECT_FALSE(std::filesystem::exists(folder("all"))) << "nothing is written";
}

// What a shell would make of the line.
TEST(ShellWords, AreThoseThatWereQuoted) {
  const std::vector<std::string> words{"touchstone", "--engine", "./it's a \"test\"", "", "\\", "'", "$x"};
  std::string line;
  for (const std::string& word : words) line += " " + shell_quoted(word);
  EXPECT_EQ(shell_words(line), words);
  EXPECT_EQ(shell_words("a  b\\ c"), (std::vector<std::string>{"a", "b c"}));
  EXPECT_EQ(shell_words(""), std::vector<std::string>());
}

}  // namespace
}  // namespace touchstone::program
