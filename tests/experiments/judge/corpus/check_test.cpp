// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <filesystem>

#include "experiments/cases/verdict.h"
#include "experiments/judge/corpus/corpus.h"
#include "experiments/program/output.h"
#include "tests/experiments/judge/corpus/stored.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::corpus {
namespace {

constexpr const char* kGood =
    R"({"id":"good","ball":{"center":[1,1,2],"radius":2},"polygon":{"outer":[[0,0,0],[4,0,0],[0,4,0]]},"expected":{"plane":"intersects","plane_tangent":true,"foot":"inside","edges_hit":[],"relation":"touching","contact":true,"nearest":{"kind":"face"},"point":[1,1,0],"distance":2,"contact_normal":[0,0,1],"depth":0,"off_plane":0}})";

Findings check_files(const std::vector<std::string>& files, program::Part part = {}) {
  const std::atomic<bool> stop = false;
  return corpus::check_files(files, part, stop, [](std::uint64_t) {});
}

/// Writes the lines, and returns the file.
std::string file_of(const std::filesystem::path& file, const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  program::write_file(file, text);
  return file.string();
}

/// Returns the findings about a file of these lines.
Findings check(const std::vector<std::string>& lines) {
  const run_tests::Scratch scratch;
  return check_files({file_of(scratch.path / "file.jsonl", lines)});
}

std::string with(const std::string& part, const std::string& other, const std::string& id = "bad") {
  std::string line = kGood;
  line.replace(line.find(part), part.size(), other);
  return line.replace(line.find("good"), 4, id);
}

TEST(Check, NamesFileLineCaseAndKeyOfEveryPlantedFault) {
  const std::pair<std::string, std::string> planted[] = {
      {R"("plane":"intersects")", R"("plane":"behind")"},
      {R"("plane_tangent":true)", R"("plane_tangent":false)"},
      {R"("foot":"inside")", R"("foot":"boundary")"},
      {R"("edges_hit":[])", R"("edges_hit":[2])"},
      {R"("relation":"touching")", R"("relation":"overlapping")"},
      {R"("contact":true)", R"("contact":false)"},
      {R"("nearest":{"kind":"face"})", R"("nearest":{"kind":"edge","index":0})"},
      {R"("point":[1,1,0])", R"("point":[1,1.0000000000000002,0])"},
      {R"("distance":2)", R"("distance":2.0000000000000004)"},
      {R"("contact_normal":[0,0,1])", R"("contact_normal":[0,0,0.9999999999999999])"},
      {R"("depth":0)", R"("depth":5e-324)"},
      {R"("off_plane":0)", R"("off_plane":5e-324)"}};
  for (const auto& [stands, wrong] : planted) {
    const std::string key = stands.substr(1, stands.find(':') - 2);
    const auto findings = check({kGood, with(stands, wrong)});
    EXPECT_EQ(findings.cases, 2u);
    ASSERT_EQ(findings.faults.size(), 2u) << key;  // one by each path
    for (const std::string& fault : findings.faults)
      EXPECT_NE(fault.find("/file.jsonl: line 2: case bad: " + key + ": "), std::string::npos) << fault;
  }
}

TEST(Check, WantsEveryKey) {
  const auto findings = check({with(R"("distance":2,)", "")});
  ASSERT_EQ(findings.faults.size(), 1u);
  EXPECT_NE(findings.faults[0].find("distance: is missing"), std::string::npos);
}

TEST(Check, NamesLinesThatAreNotCasesAndContinues) {
  const auto findings =
      check({"{", kGood, R"({"id":"none"})", with(R"("radius":2)", R"("radius":-2)", "negative"), kGood});
  EXPECT_EQ(findings.cases, 5u);
  ASSERT_EQ(findings.faults.size(), 4u);
  EXPECT_NE(findings.faults[0].find("line 1: case without id: not JSON"), std::string::npos);
  EXPECT_NE(findings.faults[1].find("line 3: case none: rejected: malformed-case"), std::string::npos);
  EXPECT_NE(findings.faults[2].find("line 4: case negative: rejected: negative-radius"), std::string::npos);
  EXPECT_NE(findings.faults[3].find("line 5: case good: id: duplicate"), std::string::npos);
}

TEST(Check, FindsInAllPartsWhatOneRunFinds) {
  const run_tests::Scratch scratch;
  const auto wrong = [](const std::string& id) { return with(R"("distance":2)", R"("distance":3)", id); };
  const std::vector<std::string> files = {
      file_of(scratch.path / "one.jsonl", {kGood, wrong("first"), "", "{", R"({"id":"none"})"}),
      (scratch.path / "missing.jsonl").string(),
      file_of(scratch.path / "empty.jsonl", {}),
      file_of(scratch.path / "two.jsonl", {wrong("second"), kGood, wrong("third")}),
  };
  const Findings whole = check_files(files);
  ASSERT_EQ(whole.cases, 7U);
  ASSERT_EQ(whole.faults.size(), 11U);
  for (const std::uint64_t parts : {2U, 3U, 8U, 20U}) {
    Findings sum;
    for (std::uint64_t i = 1; i <= parts; ++i) {
      const Findings part = check_files(files, {i, parts});
      sum.cases += part.cases;
      sum.faults.insert(sum.faults.end(), part.faults.begin(), part.faults.end());
    }
    EXPECT_EQ(sum.cases, whole.cases);
    EXPECT_TRUE(std::ranges::is_permutation(sum.faults, whole.faults)) << parts << " parts";
  }
}

TEST(Check, FindsInTheFirstCasesWhenItIsStopped) {
  const run_tests::Scratch scratch;
  const std::string bad = with(R"("distance":2)", R"("distance":3)");
  const auto file = file_of(scratch.path / "file.jsonl", {kGood, bad, bad});
  std::atomic<bool> stop = false;
  const auto findings = corpus::check_files({file}, {}, stop, [&stop](std::uint64_t) { stop = true; });
  EXPECT_EQ(findings.cases, 1U);
  EXPECT_TRUE(findings.faults.empty());
}

TEST(Check, NamesAFileThatCannotBeRead) {
  const auto findings = check_files({"/nowhere/at-all.jsonl"});
  ASSERT_EQ(findings.faults.size(), 1u);
  EXPECT_EQ(findings.faults[0], "/nowhere/at-all.jsonl: cannot be read: No such file or directory");
  const std::string folder = std::filesystem::temp_directory_path();
  EXPECT_EQ(check_files({folder}).faults, std::vector<std::string>{folder + ": cannot be read: Is a directory"});
}

TEST(Check, NamesAFileWithoutCases) {
  for (const auto& lines : {std::vector<std::string>{}, {"", "  "}}) {
    const auto findings = check(lines);
    ASSERT_EQ(findings.faults.size(), 1U);
    EXPECT_NE(findings.faults[0].find("holds no case"), std::string::npos) << findings.faults[0];
  }
}

TEST(Check, NamesAWrongErrorCode) {
  const std::string spike =
      R"({"id":"spike","ball":{"center":[1,1,2],"radius":2},"polygon":{"outer":[[0,0,0],[4,0,0],[2,0,0],[0,4,0]]},"expected":{"error":)";
  EXPECT_TRUE(check({spike + R"("loop-meets-itself"}})"}).faults.empty());
  const auto findings = check({spike + R"("zero-normal"}})"});
  ASSERT_EQ(findings.faults.size(), 1u);
  EXPECT_NE(findings.faults[0].find("error: the file says \"zero-normal\", found \"loop-meets-itself\""),
            std::string::npos);
}

}  // namespace
}  // namespace touchstone::corpus
