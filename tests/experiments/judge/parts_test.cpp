// SPDX-License-Identifier: GPL-3.0-or-later
// A judgement in parts, which add up to that of one run.
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "experiments/commands.h"
#include "experiments/judge/judgement.h"
#include "experiments/run/state.h"
#include "experiments/run/stop_signal.h"
#include "tests/experiments/judge/run_judge.h"
#include "tests/experiments/support/message_of.h"

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
  Told part(const Words& words, const std::string& share, const std::string& folder, bool resume = false) const {
    Words all = words;
    all.insert(all.end(), {"--part", share, "--output", (scratch.path / folder).string()});
    if (resume) all.emplace_back("--resume");
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

// It ends with an error after some verdicts: before the next case, whether or not that is in another part.
TEST_F(JudgeParts, AddUpForAnEngineThatEndsBetweenCases) {
  for (const std::string ends : {"True", "id=='d'", "id=='b'"}) {
    char engine[500];
    const std::string verdict = "print(json.dumps({'id':id,'relation':'touching'}))";
    std::snprintf(engine, sizeof engine, kMoody, fmt::format("{} and ({},sys.exit(3))", ends, verdict).c_str());
    expect_sum({"--engine", std::string(engine) + " =mine", "--methods", "fast", "--at-rest"});
  }
}

TEST_F(JudgeParts, ContinueWhereTheyWereStopped) {
  std::signal(SIGINT, SIG_DFL);  // a shell ignores it for what it starts in the background
  const std::string many = write_file("many.jsonl", numbered(9));
  const std::string mark = (scratch.path / "asked").string();
  char engine[900];  // stops the judge in the middle of its part, once
  std::snprintf(
      engine, sizeof engine, kMoody,
      fmt::format("(open('{0}','w'),os.kill({1}, signal.SIGINT)) if id=='t5' and not os.path.exists('{0}') else None",
                  mark, ::getpid())
          .c_str());
  const Words words{many, "--engine", std::string(engine) + " =mine"};
  EXPECT_EQ(part(words, "2/2", "two").status, touchstone::run::kInterrupted);
  std::ofstream(scratch.path / "two" / "judgement", std::ios::app) << "99 what a killed run did not complete";
  const Told resumed = part(words, "2/2", "two", true);
  EXPECT_EQ(resumed.status, 0) << resumed.complaints;
  EXPECT_EQ(part(words, "1/2", "one").status, 0);
  Words all = words;
  all.insert(all.end(), {"--output", (scratch.path / "all").string()});
  const std::vector<fs::path> parts{scratch.path / "one", scratch.path / "two"};
  EXPECT_EQ(told([&] { return commands::judge_command().merge(parts, all); }),
            told([&] { return commands::judge_command()(words); }));
  const auto refused = [&](const Words& other, const std::string& share) {
    const std::string said = part(other, share, "two", true).complaints;
    return run_tests::after_file(scratch.path / "two" / "checkpoint.json", said);
  };
  EXPECT_TRUE(refused({many, "--engine", "cat =mine"}, "2/2").ends_with(", not of --methods cat =mine"));
  Words others = words;
  others.insert(others.end(), {"--keys", "contact"});
  EXPECT_EQ(refused(others, "2/2"), "is of --keys , not of --keys contact");
  EXPECT_EQ(refused(words, "1/2"), "is of --part 2/2 of 9 items, not of --part 1/2 of 9 items");
  std::ofstream(many, std::ios::app) << numbered(1);
  EXPECT_TRUE(refused(words, "2/2").starts_with("is of FILE " + many + " (9 lines, hash "));
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
  const auto refused = [&] { return part(words, "1/2", "one", true).complaints; };
  EXPECT_EQ(part(words, "1/2", "one").status, 0);
  EXPECT_EQ(part(words, "2/2", "two").status, 0);
  EXPECT_EQ(refused(), "");
  for (const std::string& changed : {one, two}) {
    write_mesh(fs::path(changed).filename().string(), "1");
    const std::string said = refused();
    EXPECT_NE(said.find(changed + " (hash "), std::string::npos) << said;
    EXPECT_NE(said.find(", not of FILE "), std::string::npos) << said;
    Words all = words;
    all.insert(all.end(), {"--output", (scratch.path / "all").string(), "--force"});
    const auto merged = [&] {
      return commands::judge_command().merge({scratch.path / "one", scratch.path / "two"}, all);
    };
    EXPECT_NE(told(merged).complaints.find(changed + " (hash "), std::string::npos);
    write_mesh(fs::path(changed).filename().string(), "0");
    EXPECT_EQ(refused(), "");
  }
}

TEST(Judgement, IsReadAsItWasWritten) {
  const std::string file = write_file("judgement", "");
  Judged judged;
  judged.id = " a\n1 ";
  judged.differences = {{"depth", "1", "2"}, {"foot", "\"inside\"", std::nullopt}};
  judged.doubles = -7;
  Judgement judgement(file, 0);
  judgement.add({.complaint = "12 \n", .status = InputRejected});
  const std::uint64_t bytes = judgement.save();
  judgement.add({.judged = judged});
  (void)judgement.save();
  std::vector<Entry> entries;
  read_judgement(file, [&](Entry&& entry) { entries.push_back(std::move(entry)); });
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].complaint, "12 \n");
  EXPECT_EQ(entries[0].status, InputRejected);
  EXPECT_FALSE(entries[0].judged);
  EXPECT_EQ(touchstone::run::archived(*entries[1].judged), touchstone::run::archived(judged));

  std::size_t left = 0;
  (void)Judgement(file, bytes).save();
  read_judgement(file, [&](Entry&&) { ++left; });
  EXPECT_EQ(left, 1U) << "what follows the bytes of the checkpoint is cut off";
}

TEST(Judgement, ReplacesALink) {
  const run_tests::Scratch scratch;
  const std::string victim = write_file("victim", "precious");
  fs::create_symlink(victim, scratch.path / "judgement");
  (void)Judgement(scratch.path / "judgement", 0).save();
  EXPECT_EQ(run_tests::text_of(victim), "precious");
}

TEST(Judgement, IsRefusedIfDamaged) {
  const std::string file = write_file("judgement", "");
  const auto fault = [&](const std::string& text, std::uint64_t bytes) {
    std::ofstream(file) << text;
    return run_tests::message_of<std::runtime_error>([&] {
      const Judgement judgement(file, bytes);
      read_judgement(file, [](Entry&&) {});
    });
  };
  EXPECT_EQ(fault("12", 3), file + ": is shorter than its checkpoint says");
  EXPECT_EQ(fault("99999999999 0 ", 14), file + ": is damaged: it ends too early");
  EXPECT_EQ(fault("7 x 0 0 0\n", 10), file + ": is damaged: \"x\" is not a number");
  EXPECT_EQ(fault("x\n", 2), file + ": is damaged: it has no entry where one should begin");
  EXPECT_EQ(run_tests::message_of<std::runtime_error>([] { Judgement("/no/such/folder/judgement", 0); }),
            "/no/such/folder/judgement: cannot be written: No such file or directory");
}

}  // namespace
}  // namespace touchstone::judge
