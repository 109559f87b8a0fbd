// SPDX-License-Identifier: GPL-3.0-or-later
// Every figure and table has one entry, and every number that a caption states is found again.
#include "experiments/thesis/figures/entries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/experiments/support/scratch.h"
#include "tests/experiments/thesis/figures/begun_study.h"

namespace touchstone::figures_tests {
namespace {

using namespace figures;

const Entry& entry_of(const std::vector<Entry>& entries, std::string_view id) {
  return *std::ranges::find_if(entries, [&](const Entry& entry) { return entry.caption->id == id; });
}

/// Whether a number from the thesis's text stands there, so called, and agrees.
bool holds(const Entry& entry, const std::string& what, double stated) {
  return std::ranges::any_of(entry.numbers, [&](const Number& n) {
    return n.what.find(what) != std::string::npos && n.label == Label::Text && n.stated == stated && n.agrees() == true;
  });
}

TEST(Captions, AreThoseOfTheListsOfFiguresAndTables) {
  std::vector<std::string> expected{"2.1"};
  for (const auto& [chapter, last] : std::map<int, int>{{3, 2}, {4, 12}, {5, 26}, {6, 31}})
    for (int i = 1; i <= last; ++i) expected.push_back(std::to_string(chapter) + "." + std::to_string(i));
  for (const char* table : {"table 5.1", "table 5.2", "table 6.1", "table 6.2"}) expected.emplace_back(table);
  std::vector<std::string> ids;
  int page = 0;
  for (const Caption& caption : captions()) {
    if (caption.id.starts_with("E.")) continue;
    ids.emplace_back(caption.id);
    if (caption.id.starts_with("table")) continue;
    EXPECT_GE(caption.page, page) << caption.id;
    page = caption.page;
  }
  std::ranges::sort(expected);
  std::ranges::sort(ids);
  EXPECT_EQ(ids, expected);
}

TEST(Entries, AreOneForEveryCaption) {
  const std::vector<Entry> entries = entries_of(begun());
  ASSERT_EQ(entries.size(), captions().size());
  std::set<std::string> stems;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    EXPECT_EQ(entries[i].caption, &captions()[i]);
    EXPECT_FALSE(entries[i].text.empty()) << captions()[i].id;
    EXPECT_TRUE(stems.insert(entries[i].file_stem()).second);
  }
}

// What has no number and no picture says why; what claims to be reproduced has one or the other.
TEST(Entries, ClaimNothingWithoutShowingIt) {
  for (const Entry& entry : entries_of(begun())) {
    const bool nothing = entry.numbers.empty() && entry.shows.empty();
    const bool claimed = entry.status == Status::Reproduced || entry.status == Status::WithChosen;
    EXPECT_FALSE(claimed && nothing) << entry.caption->id;
    if (entry.status == Status::Photograph) {
      EXPECT_TRUE(entry.shows.empty()) << entry.caption->id;
    }
    const bool chosen = std::ranges::any_of(entry.numbers, &Number::chosen);
    EXPECT_FALSE(entry.status == Status::Reproduced && chosen) << entry.caption->id << " rests on chosen values";
  }
}

TEST(Entries, HaveEveryAngleThatACaptionStates) {
  const std::vector<Entry> entries = entries_of(begun());
  const std::regex angle(R"((\d+) Degree)"), move(R"((Elbow|Shoulder) Moves (Down|Up|up) (\d+) Degree)"),
      turn(R"((\d+) Degrees (Clockwise|Counter-?[Cc]lockwise))");
  std::size_t angles = 0, moves = 0;
  for (const Entry& entry : entries) {
    const std::string text(entry.caption->text);
    if (entry.caption->id.starts_with("E.")) continue;
    for (std::sregex_iterator m(text.begin(), text.end(), angle), end; m != end; ++m, ++angles)
      EXPECT_TRUE(holds(entry, "", std::stod((*m)[1]))) << entry.caption->id << ": " << text;
    for (std::sregex_iterator m(text.begin(), text.end(), move), end; m != end; ++m, ++moves) {
      const std::string what =
          ((*m)[1] == "Elbow" ? "elbow " : "shoulder ") + std::string((*m)[2] == "Down" ? "down" : "up");
      EXPECT_TRUE(holds(entry, what, std::stod((*m)[3]))) << entry.caption->id << ": " << text;
    }
    for (std::sregex_iterator m(text.begin(), text.end(), turn), end; m != end; ++m, ++moves)
      EXPECT_TRUE(
          holds(entry, (*m)[2] == "Clockwise" ? "base clockwise" : "base counter-clockwise", std::stod((*m)[1])))
          << entry.caption->id << ": " << text;
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
  const std::vector<Entry> entries = entries_of(
      begin_study({}, {R"(machine.parts[6]={"name":"wall","box":{"from":[-160,-20,-250],"to":[-120,20,100]}})"}));
  for (const char* id : {"6.6", "6.22", "6.23", "6.25", "6.27", "6.28", "table 6.2"})
    EXPECT_EQ(entry_of(entries, id).status_words(), "differs") << id;
}

TEST(EntryList, RefusesWhatTheListsDoNotHave) {
  EntryList list;
  list.add("4.1", Status::NotComputable, "why", {});
  EXPECT_THROW(list.add("4.1", Status::NotComputable, "why", {}), std::logic_error);
  EXPECT_THROW(list.add("7.1", Status::NotComputable, "why", {}), std::logic_error);
  EXPECT_THROW(static_cast<void>(std::move(list).all()), std::logic_error);
}

TEST(Number, AgreesWithinItsToleranceAlone) {
  EXPECT_FALSE(found("x", "", 3, false).agrees().has_value());
  EXPECT_EQ(beside(found("x", "", 3, false), Label::Text, 3).agrees(), true);
  EXPECT_EQ(beside(found("x", "", 3, false), Label::Text, 4).agrees(), false);
  EXPECT_EQ(beside(found("x", "", 3, false), Label::Text, 4, 1).agrees(), true);
  EXPECT_EQ(beside(found("x", "", std::nan(""), false), Label::Text, 4, 1).agrees(), false);
  const Number half = share("x", 5, 10, false);
  EXPECT_EQ(half.ours, 50);
  EXPECT_LT(half.limits->lower, 20);
  EXPECT_GT(half.limits->upper, 80);
}

// The report draws what entries say they show, and nothing else.
TEST(Report, HasAPictureForEveryEntryThatShowsOne) {
  const std::string script =
      run_tests::text_of(std::string(TOUCHSTONE_SOURCE_DIR) + "/experiments/report/pictures/thesis.py");
  for (const Entry& entry : entries_of(begun()))
    EXPECT_EQ(script.find("\"" + entry.file_stem() + "\":") != std::string::npos, !entry.shows.empty())
        << entry.caption->id;
}

}  // namespace
}  // namespace touchstone::figures_tests
