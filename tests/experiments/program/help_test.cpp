// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says of itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "experiments/program/command.h"
#include "experiments/program/program.h"
#include "experiments/program/table.h"
#include "experiments/program/words.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::program {
namespace {

const std::vector<std::string> kKnown{"judge", "cases", "near-edge", "bench", "bench-scenes", "soak"};

TEST(SimilarWords, CountMisspellings) {
  EXPECT_EQ(misspellings("judge", "judge"), 0U);
  EXPECT_EQ(misspellings("judg", "judge"), 1U);
  EXPECT_EQ(misspellings("jugde", "judge"), 1U);  // neighbours swapped
  EXPECT_EQ(misspellings("fudges", "judge"), 2U);
  EXPECT_EQ(misspellings("", "abc"), 3U);
}

TEST(SimilarWords, FindWhatWasMeant) {
  EXPECT_EQ(most_similar("jugde", kKnown), "judge");
  EXPECT_EQ(most_similar("near", kKnown), "near-edge");  // the only one that begins so
  EXPECT_EQ(most_similar("nearedge", kKnown), "near-edge");
  EXPECT_EQ(most_similar("benhc", kKnown), "bench");
  EXPECT_EQ(most_similar("xyz", kKnown), std::nullopt);
  EXPECT_EQ(most_similar("s", kKnown), "soak");
  EXPECT_EQ(suggestion("caess", kKnown), "; did you mean cases?");
  EXPECT_EQ(suggestion("q", kKnown), "");
}

/// Runs the program with these words. Returns the status and what it printed.
std::pair<int, std::string> run(std::vector<std::string> words) {
  bool flag = false;
  std::uint64_t samples = 7;
  std::string oracle = "exact", file;
  std::vector<std::string> methods{"fast", "filtered"};
  Command measure("measure", "Measures things");
  measure.choice("--oracle", oracle, {"exact", "filtered"}, "The truth's method");
  measure.whole("--samples", samples,
                "How many, in a sentence that is too long for one line of eighty columns, though");
  measure.text("FILE", file, "A file");
  measure.names("--methods", methods, "Methods");
  measure.flag("--alone", flag, "Alone").excludes_all_but({"--oracle"});
  measure.help().footer = "A note.\n  as it is";
  measure.help().examples.emplace_back("measure --samples 3");
  measure.help().heading = "Studies";
  measure.runs([] { return 0; });
  Command shrink("shrink", "Shrinks");
  shrink.flag("--fast", flag, "Quickly");
  shrink.help().examples.emplace_back("corpus shrink");
  shrink.runs([] { return 0; });
  const std::vector<Command> commands{measure, Command("corpus", "Cases", {shrink})};
  words.insert(words.begin(), "touchstone");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::string thrown;
  int status = 2;
  try {
    status =
        run_program({"About it", "touchstone 1.2"}, commands, static_cast<int>(arguments.size()), arguments.data());
  } catch (const UsageError& error) {
    thrown = error.what();
  }
  const std::string out = testing::internal::GetCapturedStdout();
  return {status, out + testing::internal::GetCapturedStderr() + thrown};
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Program, NamesWhatIsMisspelt) {
  const auto [status, said] = run({"mesure"});
  EXPECT_EQ(status, 2);
  EXPECT_EQ(said, "there is no command \"mesure\"; did you mean measure?");
  EXPECT_EQ(run({"corpus", "shrnik"}).second, "corpus has no command \"shrnik\"; did you mean shrink?");
  EXPECT_EQ(run({"zzz"}).second, "there is no command \"zzz\"; see `touchstone --help`");
  EXPECT_EQ(run({"measure", "--sampels", "3"}),
            std::pair(2, std::string("measure does not take: --sampels; did you mean --samples?")));
  EXPECT_EQ(run({"measure", "--oracle", "filterd"}).second,
            "--oracle: \"filterd\" is not one of exact, filtered; did you mean filtered?");
  EXPECT_EQ(run({"measure", "--samples"}).second, "--samples: its value is missing; see `touchstone measure --help`");
  EXPECT_EQ(run({"--zzz"}).second, "the program does not take: --zzz; see `touchstone --help`");
  EXPECT_EQ(run({"corpus", "shrink", "--fsat", "5"}).second,
            "corpus shrink does not take: --fsat 5; did you mean --fast?");
  EXPECT_EQ(run({"a\033[31m"}).second, "there is no command \"a\\x1b[31m\"; see `touchstone --help`");
}

TEST(Program, ExplainsItself) {
  EXPECT_EQ(run({"--version"}), std::pair(0, std::string("touchstone 1.2\n")));
  const auto help = run({"measure", "--help"});
  EXPECT_EQ(help.first, 0);
  EXPECT_EQ(run({"help", "measure"}), help);
  EXPECT_EQ(run({"help", "corpus", "shrink"}), run({"corpus", "shrink", "--help"}));
  EXPECT_TRUE(has(help.second, "A note.")) << help.second;
  EXPECT_TRUE(has(help.second, "Example:\n  touchstone measure --samples 3")) << help.second;
  EXPECT_EQ(run({"help", "mesure"}).first, 2);
  EXPECT_EQ(run({}), std::pair(2, run({"help"}).second + "\nname one of these commands, such as `touchstone measure`"));
}

TEST(Help, IsWrappedBetweenWords) {
  constexpr const char* kEighty = R"(Measures things

Usage: touchstone measure [OPTIONS] [FILE]

Arguments:
  FILE             A file.

Options:
  --oracle WORD    The truth's method. One of: exact, filtered. Default: exact.
  --samples N      How many, in a sentence that is too long for one line of
                   eighty columns, though. Default: 7.
  --methods NAMES  Methods. Default: fast,filtered.
  --alone          Alone. Only with --oracle.
  --help           Print this help.

A note.
  as it is

Example:
  touchstone measure --samples 3
)";
  ASSERT_EQ(setenv("COLUMNS", "80", 1), 0);
  EXPECT_EQ(run({"measure", "--help"}).second, kEighty);
  ASSERT_EQ(setenv("COLUMNS", "no number", 1), 0);
  EXPECT_EQ(run({"measure", "--help"}).second, kEighty);  // the output is not a terminal
  ASSERT_EQ(setenv("COLUMNS", "120", 1), 0);
  EXPECT_TRUE(has(run({"measure", "--help"}).second, "for one line of eighty columns, though. Default: 7.\n"));
  ASSERT_EQ(unsetenv("COLUMNS"), 0);
}

TEST(Help, KeepsItsWidthAndAllWords) {
  const CommandDescription command{.name = "measure",
                                   .heading = {},
                                   .about = "Measures a great number of things",
                                   .footer = "A note that is longer than the least of these widths.",
                                   .options = {{.name = "--a-rather-long-name",
                                                .value = "N",
                                                .about = "How many of them, in some more words",
                                                .fallback = "7",
                                                .words = {},
                                                .limits = {}}},
                                   .examples = {"measure --engine './it --has =spaces' --a-rather-long-name 3 --a 7"},
                                   .subcommands = {}};
  const auto words = [](const std::string& text) {
    std::vector<std::string> found;
    std::istringstream stream(text);
    for (std::string word; stream >> word;)
      if (word != "\\") found.push_back(word);
    return found;
  };
  for (std::size_t width = 40; width < 130; ++width) {
    const std::string text = help_text(command, width);
    EXPECT_EQ(words(text), words(help_text(command, 1000)));
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(line.size(), width) << line;
      EXPECT_EQ(std::ranges::count(line, '\'') % 2, 0) << line;  // no break within quotes
    }
  }
  EXPECT_TRUE(has(help_text(command, 60), "touchstone measure --engine './it --has =spaces' \\\n    --a-rather"));
}

}  // namespace
}  // namespace touchstone::program
