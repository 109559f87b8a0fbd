// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says of itself: suggestions, completion, manual pages, colours; and tables as JSON.
#include "experiments/run/help.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "experiments/run/command.h"
#include "experiments/run/quoting.h"
#include "experiments/run/similar_words.h"
#include "experiments/run/table.h"
#include "experiments/run/terminal.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::run {
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
  measure.footer("A note.\n  as it is");
  measure.example("measure --samples 3");
  measure.heading("Studies");
  measure.runs([] { return 0; });
  Command shrink("shrink", "Shrinks");
  shrink.flag("--fast", flag, "Quickly");
  shrink.example("corpus shrink");
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
}

TEST(Program, ListsItsCommandsByHeadings) {
  const std::string help = run({"help"}).second;
  EXPECT_TRUE(
      help.starts_with("About it\n\nUsage: touchstone COMMAND [OPTIONS]\n\nStudies:\n"
                       "  measure  Measures things\n\nCommands:\n  corpus   Cases\n\nOptions:\n"))
      << help;
  // Without a command, the same on standard error, and what to do.
  EXPECT_EQ(run({}), std::pair(2, help + "\nname one of these commands, such as `touchstone measure`"));
  EXPECT_TRUE(has(run({"corpus"}).second, "\nname one of these commands, such as `touchstone corpus shrink`"));
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

/// A program with a command of every kind.
CommandDescription program() {
  const OptionDescription samples{.name = "--samples",
                                  .value = "N",
                                  .about = "How many",
                                  .fallback = "7",
                                  .words = {},
                                  .limits = {"Not with --all"}};
  const OptionDescription oracle{.name = "--oracle",
                                 .value = "WORD",
                                 .about = "It's [the] truth: a\\b",
                                 .fallback = "exact,filtered",
                                 .words = {"exact", "filtered"},
                                 .limits = {}};
  const OptionDescription file{
      .name = "FILE", .value = "TEXT", .about = "A file", .fallback = {}, .words = {}, .limits = {}, .required = true};
  const OptionDescription letter{
      .name = "LETTER", .value = "TEXT", .about = "A letter", .fallback = {}, .words = {"b", "c"}, .limits = {}};
  const CommandDescription measure{.name = "measure",
                                   .heading = "Studies",
                                   .about = "Measures",
                                   .footer = ".A note\n'and another",
                                   .options = {samples, oracle, file},
                                   .examples = {"measure --samples 3"},
                                   .subcommands = {}};
  const CommandDescription shrink{.name = "corpus shrink",
                                  .heading = {},
                                  .about = "Shrinks",
                                  .footer = {},
                                  .options = {letter},
                                  .examples = {},
                                  .subcommands = {}};
  const CommandDescription corpus{.name = "corpus",
                                  .heading = "Tools",
                                  .about = "Cases",
                                  .footer = {},
                                  .options = {},
                                  .examples = {},
                                  .subcommands = {shrink}};
  const OptionDescription version{
      .name = "--version", .value = {}, .about = "Its version", .fallback = {}, .words = {}, .limits = {}};
  return {.name = {},
          .heading = {},
          .about = "About",
          .footer = {},
          .options = {version},
          .examples = {},
          .subcommands = {measure, corpus}};
}

/// Returns what bash offers after these words, the last of which is not finished.
std::string completed(const std::string& words) {
  const run_tests::Scratch scratch;
  std::ofstream(scratch.path / "script") << bash_completion(program());
  const std::string command = "bash -c '. " + (scratch.path / "script").string() + "; COMP_WORDS=(" + words +
                              "); COMP_CWORD=$((${#COMP_WORDS[@]}-1)); _touchstone; echo \"${COMPREPLY[*]}\"' > " +
                              (scratch.path / "out").string();
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::string line;
  std::getline(std::ifstream(scratch.path / "out"), line);
  return line;
}

TEST(Completion, OffersCommandsOptionsAndValuesInBash) {
  EXPECT_EQ(completed("touchstone m"), "measure");
  EXPECT_EQ(completed("touchstone \"\""), "measure corpus help --version --help");
  EXPECT_EQ(completed("touchstone --v"), "--version");
  EXPECT_EQ(completed("touchstone help m"), "measure");
  EXPECT_EQ(completed("touchstone help corpus s"), "shrink");
  EXPECT_EQ(completed("touchstone corpus s"), "shrink");
  EXPECT_EQ(completed("touchstone measure --s"), "--samples");
  EXPECT_EQ(completed("touchstone measure --oracle f"), "filtered");
  EXPECT_EQ(completed("touchstone corpus shrink --"), "--help");
  EXPECT_EQ(completed("touchstone corpus shrink \"\""), "b c --help");
  // Files: after an option with a value, and where the command takes them.
  EXPECT_EQ(completed("touchstone measure --samples \"\""), "");
  EXPECT_EQ(completed("touchstone measure --samples -"), "");
  EXPECT_EQ(completed("touchstone measure \"\""), "");
}

TEST(Completion, DescribesEverythingForZsh) {
  const std::string script = zsh_completion(program());
  EXPECT_TRUE(script.starts_with("#compdef touchstone\n"));
  for (const char* part :
       {"'measure:Measures'", "corpus) _touchstone_corpus ;;", "_touchstone_corpus_shrink() {",
        "'*--samples[How many]:N:_files'", "'*--oracle[It'\\''s \\[the\\] truth\\: a\\\\b]:WORD:(exact filtered)'"})
    EXPECT_TRUE(has(script, part)) << part << "\n" << script;
}

TEST(Manual, HasAPageForEachCommand) {
  const auto pages = manual_pages(program(), "touchstone 1.2");
  ASSERT_EQ(pages.size(), 4U);
  EXPECT_TRUE(has(pages.at("touchstone.1"), ".BR touchstone\\-measure (1)\nMeasures\n"));
  EXPECT_TRUE(has(pages.at("touchstone.1"), ".SS Studies\n.TP\n.BR touchstone\\-measure"));
  EXPECT_TRUE(has(pages.at("touchstone.1"), "\\fB\\-\\-version\\fR\nIts version.\n"));
  const std::string& page = pages.at("touchstone-measure.1");
  for (const char* part : {".TH \"touchstone\\-measure\" 1", "touchstone\\-measure \\- Measures", "\\fIFILE\\fR\n",
                           "\\fB\\-\\-samples\\fR \\fIN\\fR\nHow many. Not with \\-\\-all. Default: 7.\n",
                           "One of: exact, filtered. Default: exact,filtered.\n", "a\\eb",
                           "touchstone measure \\-\\-samples 3\n", "\\&.A note\n.br\n\\&'and another"})
    EXPECT_TRUE(has(page, part)) << part << "\n" << page;
  EXPECT_TRUE(pages.contains("touchstone-corpus-shrink.1"));
}

TEST(Colour, IsForTerminalsOnly) {
  std::FILE* file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  EXPECT_FALSE(takes_colours(file));
  EXPECT_EQ(coloured("text", Colour::Red, file), "text");
  std::fclose(file);
}

TEST(TablesAsJson, HaveNumbersNullsAndTexts) {
  const std::string json = json_of_csv("name,\"a,b\",c\n\"x \"\"y\"\"\",1.50,\n-,-2e-3,0x1\n1,nan,007\n");
  EXPECT_EQ(nlohmann::json::parse(json),
            nlohmann::json::parse(R"([{"name":"x \"y\"","a,b":1.5,"c":null},{"name":"-","a,b":-2e-3,"c":"0x1"},
                                      {"name":1,"a,b":"nan","c":"007"}])"));
  EXPECT_NE(json.find("1.50"), std::string::npos);  // as it stands
  EXPECT_EQ(json_of_csv("a\n"), "[]");
  EXPECT_THROW((void)json_of_csv("a,b\n1\n"), std::runtime_error);
}

TEST(TablesAsJson, AreThoseOfTheFolder) {
  const run_tests::Scratch scratch;
  std::ofstream(scratch.path / "a.csv") << "x\n1\n";
  const std::string json =
      tables_json(scratch.path, {{"a.csv", "", {}}, {"missing.csv", "", {}}, {"map-<spot>.csv", "", {}}});
  EXPECT_EQ(nlohmann::json::parse(json), nlohmann::json::parse(R"({"a.csv":[{"x":1}]})"));
}

TEST(XmlText, HasNoMarkupAndNoControlBytes) {
  EXPECT_EQ(xml_text("a<b>&\"'\n\x1b[31m"), "a&lt;b&gt;&amp;&quot;&#39;\n\\x1b[31m");
  EXPECT_EQ(xml_text("\xff"), "\\xff");
}

}  // namespace
}  // namespace touchstone::run
