// SPDX-License-Identifier: GPL-3.0-or-later
// Every figure and table has one entry, and every number that a caption states is found again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "experiments/program/input.h"
#include "experiments/program/output.h"
#include "experiments/thesis/cell/model/cell_entry.h"
#include "experiments/thesis/figures/entry.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/thesis/figures/begun_study.h"

namespace touchstone::figures {
namespace {

const Entry& entry_of(const std::vector<Entry>& entries, std::string_view id) {
  return *std::ranges::find_if(entries, [&](const Entry& entry) { return entry.id == id; });
}

std::string text_of_figures() { return run_tests::text_of(program::data("experiments/thesis/figures/figures.json")); }

/// Whether a number from the thesis's text stands there, so called, and agrees.
bool holds(const Entry& entry, const std::string& what, double stated) {
  return std::ranges::any_of(entry.numbers, [&](const Number& n) {
    return n.what.find(what) != std::string::npos && n.basis && label_of(*n.basis) == Label::Text &&
           n.stated == stated && n.agrees() == true;
  });
}

TEST(Entries, AreOneForEveryCaptionOfTheListsOfFiguresAndTables) {
  std::vector<std::string> expected{"2.1"};
  for (const auto& [chapter, last] : std::map<int, int>{{3, 2}, {4, 12}, {5, 26}, {6, 31}})
    for (int i = 1; i <= last; ++i) expected.push_back(std::to_string(chapter) + "." + std::to_string(i));
  for (const char* table : {"table 5.1", "table 5.2", "table 6.1", "table 6.2"}) expected.emplace_back(table);
  std::vector<std::string> ids;
  int page = 0;
  for (const Entry& entry : entries_of(begun())) {
    EXPECT_EQ(entry.page == 0, entry.id.starts_with("E.")) << entry.id;
    if (entry.page == 0) continue;
    ids.push_back(entry.id);
    if (entry.id.starts_with("table")) continue;
    EXPECT_GE(entry.page, page) << entry.id;
    page = entry.page;
  }
  std::ranges::sort(expected);
  std::ranges::sort(ids);
  EXPECT_EQ(ids, expected);
}

// What figures.json names is computed, and all that is computed is named there: as a value, or in a hole of a text.
TEST(Figures, NameWhatIsComputedAndNothingElse) {
  std::set<std::string> named;
  const std::regex hole(R"(\{([^}]*)\})");
  const auto take = [&](const nlohmann::json& value) {
    if (!value.is_string()) return;
    const auto text = value.get<std::string>();
    for (std::sregex_iterator m(text.begin(), text.end(), hole), end; m != end; ++m) named.insert((*m)[1]);
  };
  for (const auto& entry : nlohmann::json::parse(text_of_figures())) {
    take(entry.at("text"));
    for (const auto& number : entry.at("numbers")) {
      take(number.at("what"));
      for (const char* key : {"name", "stated", "tolerance"})
        if (number.contains(key) && number.at(key).is_string()) named.insert(number.at(key).get<std::string>());
    }
  }
  std::set<std::string> known;
  const Computed all = computed(begun());
  for (const auto& [name, value] : all.numbers) known.insert(name);
  for (const auto& [name, text] : all.texts) EXPECT_TRUE(known.insert(name).second) << name << " is two things";
  EXPECT_EQ(named, known);
}

/// Returns what is said of a file of figures; nothing of one that is read.
std::string complaint_of(const std::string& text) {
  const run_tests::Scratch scratch;
  const auto file = scratch.path / "figures.json";
  program::write_file(file, text);
  return run_tests::after_file(
      file, run_tests::message_of<cell::BadCell>([&] { return read_entries(file, computed(begun())); }));
}

TEST(Figures, RefuseAMalformedFileByEntryAndKey) {
  const std::string head = R"([{"id": "4.1", "caption": "c", "page": 1, "status": "derived", "text": "t)",
                    number = R"(", "numbers": [{"name": "upper arm", "what": "w", "chosen": true)", end = "}]}]";
  EXPECT_EQ(complaint_of(head + number + end), "");
  EXPECT_EQ(complaint_of(head + " {upper arm} {above}" + number + R"(, "stated": "forearm", "basis": "input")" + end),
            "");
  EXPECT_EQ(complaint_of("[{}]"), "[0]: the key \"id\" is missing");
  EXPECT_EQ(complaint_of(R"([{"id": "4.1"}])"), "entry 4.1: the key \"caption\" is missing");
  EXPECT_EQ(complaint_of(head + "{no}" + number + end), R"(entry 4.1.text: nothing computes "no")");
  EXPECT_EQ(complaint_of(head + "{no" + number + end), "entry 4.1.text: has { without }");
  EXPECT_EQ(complaint_of(head + number + R"(, "stated": "no", "basis": "input")" + end),
            R"(entry 4.1.numbers[0].stated: nothing computes "no")");
  EXPECT_EQ(complaint_of(head + number + R"(, "stated": 1)" + end),
            "entry 4.1.numbers[0]: needs `stated` and `basis` together");
  EXPECT_EQ(complaint_of(head + number + R"(, "stated": 1, "basis": "guess")" + end),
            "entry 4.1.numbers[0].basis: must be one of: fitted, input, predicted, own check, other source");
  EXPECT_EQ(complaint_of(head + number + R"(, "sample": 1)" + end),
            "entry 4.1.numbers[0].sample: is an unknown key; there are name, what, unit, chosen, stated, basis, "
            "tolerance, stated samples, rounded to");
  const std::string one = (head + number + end).substr(1, (head + number + end).size() - 2);
  EXPECT_EQ(complaint_of("[" + one + "," + one + "]"), "[1]: is the second entry for 4.1");
  EXPECT_EQ(complaint_of("[").find("is not JSON: column 2: "), 0U);
  EXPECT_EQ(complaint_of(R"([{"id": "4.1", "id": "4.1"}])"), "the whole: duplicate key \"id\"");
}

TEST(Entries, HaveFilesOfTheirOwnAndSayWhatWasDone) {
  std::set<std::string> stems;
  for (const Entry& entry : entries_of(begun())) {
    EXPECT_FALSE(entry.text.empty()) << entry.id;
    EXPECT_TRUE(stems.insert(entry.file_stem()).second) << entry.id;
  }
}

// What has no number and no picture says why; what claims to be reproduced has one or the other.
TEST(Entries, ClaimNothingWithoutShowingIt) {
  for (const Entry& entry : entries_of(begun())) {
    const bool nothing = entry.numbers.empty() && entry.shows.empty();
    const bool computable = entry.status < Status::Photograph;
    EXPECT_FALSE(computable && nothing) << entry.id;
    if (entry.status == Status::Photograph) {
      EXPECT_TRUE(entry.shows.empty()) << entry.id;
    }
  }
}

// Statuses say what numbers are compared with. What is compared with nothing of the thesis does not count as
// reproduced, and what differs is not filed as not computable.
TEST(Entries, SayWhatTheyAreComparedWith) {
  const std::vector<Entry> entries = entries_of(begun());
  std::map<Status, std::vector<std::string>> ids;
  for (const Entry& entry : entries) {
    ids[entry.status].push_back(entry.id);
    const auto of_thesis = [](const Number& n) { return n.basis == Basis::Fitted || n.basis == Basis::Predicted; };
    if (entry.status == Status::Derived || entry.status == Status::SelfCheck) {
      EXPECT_TRUE(std::ranges::none_of(entry.numbers, of_thesis)) << entry.id;
    }
  }
  EXPECT_EQ(ids[Status::SelfCheck], (std::vector<std::string>{"3.2", "4.4", "4.5", "5.12", "5.13", "5.14", "5.15"}));
  EXPECT_EQ(ids[Status::Derived], (std::vector<std::string>{"4.6", "table 5.1", "E.1", "E.2", "E.3", "E.4", "E.5",
                                                            "E.6", "E.7", "E.8", "E.9"}));
  EXPECT_EQ(ids[Status::NotComputable], (std::vector<std::string>{"2.1", "3.1", "5.1", "table 5.2"}));
  for (const auto& [id, words] : {std::pair("4.4", "self-check"), {"4.6", "derived"}}) {
    Entry unmeasured = entry_of(entries, id);
    EXPECT_EQ(unmeasured.status_words(), "differs");  // of no balls, none is called so
    unmeasured.numbers.clear();
    EXPECT_EQ(unmeasured.status_words(), words);
  }
  EXPECT_EQ(entry_of(entries, "table 5.1").numbers.size(), 9U);
  EXPECT_EQ(entry_of(entries, "table 5.1").status_words(), "differs");
}

TEST(Entries, HaveEveryAngleThatACaptionStates) {
  const std::vector<Entry> entries = entries_of(begun());
  const std::regex angle(R"((\d+) Degree)"), move(R"((Elbow|Shoulder) Moves (Down|Up|up) (\d+) Degree)"),
      turn(R"((\d+) Degrees (Clockwise|Counter-?[Cc]lockwise))");
  std::size_t angles = 0, moves = 0;
  for (const Entry& entry : entries) {
    const std::string& text = entry.caption;
    if (entry.id.starts_with("E.")) continue;
    for (std::sregex_iterator m(text.begin(), text.end(), angle), end; m != end; ++m, ++angles)
      EXPECT_TRUE(holds(entry, "", std::stod((*m)[1]))) << entry.id << ": " << text;
    for (std::sregex_iterator m(text.begin(), text.end(), move), end; m != end; ++m, ++moves) {
      const std::string what =
          ((*m)[1] == "Elbow" ? "elbow " : "shoulder ") + std::string((*m)[2] == "Down" ? "down" : "up");
      EXPECT_TRUE(holds(entry, what, std::stod((*m)[3]))) << entry.id << ": " << text;
    }
    for (std::sregex_iterator m(text.begin(), text.end(), turn), end; m != end; ++m, ++moves)
      EXPECT_TRUE(
          holds(entry, (*m)[2] == "Clockwise" ? "base clockwise" : "base counter-clockwise", std::stod((*m)[1])))
          << entry.id << ": " << text;
  }
  EXPECT_EQ(angles, 31U);
  EXPECT_EQ(moves, 21U);
}

TEST(Entries, HaveEveryCountThatACaptionStates) {
  const std::vector<Entry> entries = entries_of(begun());
  EXPECT_TRUE(holds(entry_of(entries, "5.9"), "cylinders", 2));
  EXPECT_TRUE(holds(entry_of(entries, "5.10"), "boxes", 1));
  EXPECT_TRUE(holds(entry_of(entries, "5.10"), "cylinders", 2));
  EXPECT_TRUE(holds(entry_of(entries, "5.13"), "parts", 3));
  EXPECT_TRUE(holds(entry_of(entries, "5.14"), "parts", 1));
}

// A bug in a sign, or a layout that is off, must not go unnoticed.
TEST(Entries, DifferWhereAMoveHasTheWrongSign) {
  Study study = begun();
  for (const char* id : {"6.4", "6.5", "table 6.1"}) EXPECT_TRUE(entry_of(entries_of(study), id).agrees()) << id;
  study.cases[0].process.moves[0].degrees *= -1;
  const std::vector<Entry> entries = entries_of(study);
  for (const char* id : {"6.4", "6.5", "table 6.1"}) EXPECT_FALSE(entry_of(entries, id).agrees()) << id;
  EXPECT_EQ(entry_of(entries, "6.4").status_words(), "differs");
  EXPECT_EQ(entry_of(entries, "6.5").status_words(), "photograph: not computable");
  EXPECT_TRUE(entry_of(entries, "6.20").agrees());
}

TEST(Entries, DifferInALayoutThatIsOff) {
  const std::vector<Entry> entries = entries_of(begin_study({}, {"machine.height=393"}));
  EXPECT_TRUE(entry_of(entries, "6.4").agrees());
  for (const char* id : {"6.11", "6.14", "table 6.1", "6.25", "table 6.2"})
    EXPECT_EQ(entry_of(entries, id).status_words(), "differs") << id;
}

// Where a case cannot be simulated there are no moves, and nothing agrees by accident.
TEST(Entries, DifferWhereACaseFails) {
  const std::vector<Entry> entries = entries_of(begin_study({}, {"storage.radius=150"}));
  for (const char* id : {"6.6", "6.22", "6.23", "6.25", "6.27", "6.28", "table 6.2"})
    EXPECT_EQ(entry_of(entries, id).status_words(), "differs") << id;
}

TEST(Number, AgreesWithinItsToleranceAlone) {
  const auto agrees = [](double ours, std::optional<double> stated, double tolerance) {
    return Number{.what = "x", .unit = "", .ours = ours, .stated = stated, .tolerance = tolerance}.agrees();
  };
  EXPECT_FALSE(agrees(3, std::nullopt, 0).has_value());
  EXPECT_EQ(agrees(3, 3, 0), true);
  EXPECT_EQ(agrees(3, 4, 0), false);
  EXPECT_EQ(agrees(3, 4, 1), true);
  EXPECT_EQ(agrees(std::nan(""), 4, 1), false);
  const Value half = share(5, 10);
  EXPECT_EQ(half.value, 50);
  EXPECT_LT(half.limits->lower, 20);
  EXPECT_GT(half.limits->upper, 80);
}

// The report draws what entries say they show, and nothing else.
TEST(Report, HasAPictureForEveryEntryThatShowsOne) {
  const std::string script =
      run_tests::text_of(std::string(TOUCHSTONE_SOURCE_DIR) + "/experiments/report/studies/thesis.py");
  for (const Entry& entry : entries_of(begun()))
    EXPECT_EQ(script.find("\"" + entry.file_stem() + "\":") != std::string::npos, !entry.shows.empty()) << entry.id;
}

}  // namespace
}  // namespace touchstone::figures
