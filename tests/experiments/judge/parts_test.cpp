// SPDX-License-Identifier: GPL-3.0-or-later
// A judgement in parts, which add up to that of one run.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "experiments/commands.h"
#include "experiments/judge/judge.h"
#include "experiments/program/state.h"
#include "tests/experiments/judge/run_judge.h"

namespace touchstone::judge {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// Cases of all kinds: met, not met, moving, rejected, without an expectation, no JSON, blank, an id twice.
std::string all_kinds() {
  const auto touching = [](const std::string& id, const std::string& members) {
    std::string line = with(kTouching, members);
    return line.replace(line.find("\"t\""), 3, "\"" + id + "\"") + "\n";
  };
  return touching("a", R"(,"expected":{"contact":true,"relation":"touching"},"tags":["one","two"])") + "\n" +
         touching("b", R"(,"expected":{"contact":false,"distance":1},"tags":["two"])") + "nonsense\n" +
         touching("c", R"(,"motion":{"to":[0,0,9]},"expected":{"contact":true})") +
         with(kCollinear, R"(,"expected":{"error":"loops-meet"})") + "\n \t\n" + with(kCollinear, "") + "\n" +
         touching("d", "") + touching("b", R"(,"expected":{"relation":"separate","depth":3})") +
         touching("e", R"(,"expected":{"contact":false,"depth":0})");
}

/// What a run says, and what it wrote to the files that its options name.
struct Told {
  int status;
  std::string printed, complaints, junit, report, known;
  friend bool operator==(const Told&, const Told&) = default;
};

class JudgeParts : public testing::Test {
 protected:
  Told told(const std::function<int()>& run) const {
    fs::remove(scratch.path / "junit.xml");
    fs::remove(scratch.path / "report.html");
    std::ofstream(scratch.path / "known.jsonl") << R"({"method":"fast","case":"e","key":"contact"})"
                                                << "\n"
                                                << R"({"method":"fast","case":"a","key":"relation"})"
                                                << "\n";
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    int status = 2;
    std::string thrown;
    try {
      status = run();
    } catch (const std::exception& error) {
      thrown = error.what();
    }
    std::fflush(stdout);
    const std::string printed = testing::internal::GetCapturedStdout();
    return {status,
            printed,
            testing::internal::GetCapturedStderr() + thrown,
            run_tests::text_of(scratch.path / "junit.xml"),
            run_tests::text_of(scratch.path / "report.html"),
            run_tests::text_of(scratch.path / "known.jsonl")};
  }
  Told part(const Words& words, const std::string& share, const std::string& folder) const {
    Words all = words;
    all.insert(all.end(), {"--part", share, "--output", (scratch.path / folder).string()});
    return told([&] { return commands::judge_command()(all); });
  }
  /// Returns what the sum of the parts says.
  Told merged(Words words, int parts) const {
    std::vector<fs::path> folders;
    for (int i = 1; i <= parts; ++i) {
      const std::string folder = fmt::format("{}-of-{}", i, parts);
      const Told alone = part(words, fmt::format("{}/{}", i, parts), folder);
      EXPECT_EQ(alone.status, 0) << alone.complaints;
      EXPECT_EQ(alone.complaints + alone.junit + alone.report, "") << "a part tells nothing";
      folders.push_back(scratch.path / folder);
    }
    words.insert(words.end(), {"--output", (scratch.path / "merged").string(), "--force"});
    return told([&] { return commands::judge_command().merge(folders, words); });
  }
  void expect_sum(const Words& options) const {
    Words words = options;
    words.insert(words.begin(), {cases, "--junit", (scratch.path / "junit.xml").string(), "--report",
                                 (scratch.path / "report.html").string()});
    const Told whole = told([&] { return commands::judge_command()(words); });
    for (const int parts : {1, 2, 3, 11}) {
      for (const auto& entry : fs::directory_iterator(scratch.path))
        if (entry.is_directory()) fs::remove_all(entry.path());
      const Told sum = merged(words, parts);
      EXPECT_EQ(sum, whole) << parts << " parts\n" << sum.printed << sum.complaints << "but\n" << whole.complaints;
    }
  }

  run_tests::Scratch scratch;
  std::string cases = write_file("cases.jsonl", all_kinds());
};

TEST_F(JudgeParts, AddUpToWhatOneRunTells) {
  expect_sum({"--methods", "fast,cgal-double-intersect"});
  expect_sum({"--methods", "fast", "--summary", "--at-rest"});
  expect_sum({"--methods", "fast,exact", "--keys", "contact,depth", "--quiet", "--explain"});
}

TEST_F(JudgeParts, AddUpWithKnownFailures) {
  const std::string known = (scratch.path / "known.jsonl").string();
  expect_sum({"--methods", "fast", "--known", known});
  expect_sum({"--methods", "fast", "--known", known, "--update"});
}

// It is restarted after the first case, for which it prints no verdict, and ends with an error after the last.
TEST_F(JudgeParts, AddUpForAnEngine) {
  char engine[500];
  std::snprintf(engine, sizeof engine, kMoody, "print('{}') if id=='a' else None");
  expect_sum({"--engine", std::string(engine) + " 2>/dev/null; exit 3 =mine", "--beyond", "1e-9"});
}

TEST_F(JudgeParts, AreRefusedIfAMeshFileHasChanged) {
  const auto write_mesh = [](const std::string& name, const std::string& height) {
    return write_file(name, "v 0 0 " + height + "\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  };
  const auto line = [](const std::string& id, const std::string& mesh) {
    return R"({"id":")" + id + R"(","ball":{"center":[0,0,1],"radius":1},"mesh":)" + mesh + "}\n";
  };
  const std::string one = write_mesh("one.obj", "0"), two = write_mesh("two.obj", "0");
  // JSON may escape any character of a key.
  const Words words{write_file("meshes.jsonl", line("1", R"({"file":"one.obj"})") +
                                                   line("2", R"({"fi\u006ce":"two.obj"})") +
                                                   line("3", R"({"file":"missing.obj"})"))};
  Words all = words;
  all.insert(all.end(), {"--output", (scratch.path / "all").string(), "--force"});
  const auto refused = [&] {
    return told([&] {
             return commands::judge_command().merge({scratch.path / "one", scratch.path / "two"}, all);
           })
        .complaints;
  };
  EXPECT_EQ(part(words, "1/2", "one").status, 0);
  EXPECT_EQ(part(words, "2/2", "two").status, 0);
  const std::string sound = refused();
  for (const std::string& changed : {one, two}) {
    write_mesh(fs::path(changed).filename().string(), "1");
    const std::string said = refused();
    EXPECT_NE(said.find(changed + " (hash "), std::string::npos) << said;
    EXPECT_NE(said.find(", not of FILE "), std::string::npos) << said;
    write_mesh(fs::path(changed).filename().string(), "0");
    EXPECT_EQ(refused(), sound);
  }
}

TEST(Judgement, IsReadAsItWasWritten) {
  Judged judged;
  judged.id = " a\n1 ";
  judged.differences = {{"depth", "1", "2"}, {"foot", "\"inside\"", std::nullopt}};
  judged.doubles = -7;
  Judgement judgement, read;
  judgement.lines = 2;
  judgement.entries = {{.complaint = "12 \n", .status = InputRejected}, {.judged = judged}};
  const std::string text = touchstone::program::archived(judgement);
  touchstone::program::restore(text, read);
  EXPECT_EQ(touchstone::program::archived(read), text);
  ASSERT_EQ(read.entries.size(), 2U);
  EXPECT_EQ(read.entries[0].complaint, "12 \n");
  EXPECT_EQ(read.entries[1].judged->doubles, -7);
}

}  // namespace
}  // namespace touchstone::judge
