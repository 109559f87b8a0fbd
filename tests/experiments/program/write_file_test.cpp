// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/program/output.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/scratch.h"

namespace {

std::vector<std::string> synced;  // the names under which what was put on the disk lay then

}  // namespace

/// In place of the system's.
extern "C" int fsync(int descriptor) {
  synced.push_back(std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor)).string());
  return 0;
}

namespace touchstone::program {
namespace {

namespace fs = std::filesystem;
using run_tests::message_of;
using run_tests::Scratch;
using run_tests::text_of;

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  return names;
}

TEST(WriteFile, ReplacesAFileAndLeavesNothingBeside) {
  const Scratch scratch;
  write_file(scratch.path / "a.csv", "a long text\n");
  write_file(scratch.path / "a.csv", std::string("\0\n", 2));
  EXPECT_EQ(text_of(scratch.path / "a.csv"), std::string("\0\n", 2));
  EXPECT_EQ(names_in(scratch.path), std::vector<std::string>{"a.csv"});
}

TEST(WriteFile, ReplacesASymbolicLinkInPlaceOfFollowingIt) {
  const Scratch scratch;
  write_file(scratch.path / "victim.txt", "precious\n");
  fs::create_symlink("victim.txt", scratch.path / "rates.csv");
  write_file(scratch.path / "rates.csv", "new\n");
  EXPECT_EQ(text_of(scratch.path / "victim.txt"), "precious\n");
  EXPECT_EQ(text_of(scratch.path / "rates.csv"), "new\n");
  EXPECT_FALSE(fs::is_symlink(scratch.path / "rates.csv"));
}

TEST(WriteFile, LeavesDevicesAndPipesWhereTheyAre) {
  const Scratch scratch;
  const fs::path pipe = scratch.path / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(message_of([&] { write_file(pipe, ""); }), pipe.string() + ": cannot be written: it is not a regular file");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(WriteFile, SaysWhyItCannotWrite) {
  const Scratch scratch;
  EXPECT_EQ(message_of([&] { write_file(scratch.path / "no" / "a", ""); }),
            (scratch.path / "no" / "a").string() + ": cannot be written: No such file or directory");
  fs::create_directory(scratch.path / "folder");
  EXPECT_EQ(message_of([&] { write_file(scratch.path / "folder", ""); }),
            (scratch.path / "folder").string() + ": cannot be written: Is a directory");
  EXPECT_EQ(names_in(scratch.path), std::vector<std::string>{"folder"});
}

// A limit on the size of files simulates a full disk: both allow only a part to be written.
TEST(WriteFile, KeepsTheEarlierFileWhereTheNewOneDoesNotFit) {
  const Scratch scratch;
  const fs::path file = scratch.path / "checkpoint.json";
  write_file(file, "earlier\n");
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{100, 100};
    ::setrlimit(RLIMIT_FSIZE, &small);
    const bool told = message_of([&] { write_file(file, std::string(1000, 'x')); }) ==
                      file.string() + ": cannot be written: File too large";
    ::_exit(told ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(text_of(file), "earlier\n");
  EXPECT_EQ(names_in(scratch.path), std::vector<std::string>{"checkpoint.json"});
}

TEST(WriteFile, PutsTheTextOnTheDiskBeforeTheFileTakesItsName) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.csv";
  synced.clear();
  write_file(file, "first\n");
  EXPECT_EQ(synced, std::vector<std::string>{file.string() + ".new-" + std::to_string(::getpid())});
}

TEST(RefuseOverwrite, AllowsWhatIsNotThere) {
  const Scratch scratch;
  EXPECT_EQ(message_of([&] { refuse_overwrite(scratch.path / "new.json", false); }), "");
  EXPECT_EQ(message_of([&] { refuse_overwrite(scratch.path / "no" / "new.json", false); }), "");
}

TEST(RefuseOverwrite, AllowsARegularFileWithForceOnly) {
  const Scratch scratch;
  const fs::path file = scratch.path / "base.json";
  write_file(file, "{}\n");
  EXPECT_EQ(message_of([&] { refuse_overwrite(file, false); }),
            file.string() + ": exists already; --force overwrites it");
  EXPECT_EQ(message_of([&] { refuse_overwrite(file, true); }), "");
}

// A file that appeared while the text was computed is detected, too.
TEST(WriteFile, WritesOverWhatIsThereByNowOnlyWithForce) {
  const Scratch scratch;
  const fs::path file = scratch.path / "base.json";
  write_file(file, "first\n", false);
  EXPECT_EQ(message_of([&] { write_file(file, "second\n", false); }),
            file.string() + ": exists already; --force overwrites it");
  EXPECT_EQ(text_of(file), "first\n");
  write_file(file, "third\n", true);
  EXPECT_EQ(text_of(file), "third\n");
  EXPECT_EQ(names_in(scratch.path), std::vector<std::string>{"base.json"});
}

TEST(RefuseOverwrite, RefusesAllElseWithForceToo) {
  const Scratch scratch;
  fs::create_symlink("nowhere", scratch.path / "dangling");
  fs::create_symlink("/dev/null", scratch.path / "device");
  for (const fs::path& what : {scratch.path / "dangling", scratch.path / "device", scratch.path, fs::path("/dev/null")})
    for (const bool force : {false, true})
      EXPECT_EQ(message_of([&] { refuse_overwrite(what, force); }),
                what.string() + ": exists already, and is not a regular file");
}

}  // namespace
}  // namespace touchstone::program
