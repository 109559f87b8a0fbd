// SPDX-License-Identifier: GPL-3.0-or-later
// Two runs never write the same folder, and no run overwrites the results of another.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/program/output.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::program {
namespace {

namespace fs = std::filesystem;
using run_tests::Scratch;

std::string refusal(const fs::path& folder, bool force = false) {
  return run_tests::message_of([&] { const OutputFolder held(folder, force); });
}

bool is_empty_folder(const fs::path& folder) { return fs::is_directory(folder) && fs::is_empty(folder); }

/// A child process that acts and reports it, then waits until it is killed or told to end.
class Child {
 public:
  template <class Work>
  explicit Child(const Work& work) {
    std::array<int, 2> told{}, end{};
    if (::pipe(told.data()) != 0 || ::pipe(end.data()) != 0) throw std::runtime_error("no pipe");
    process_ = ::fork();
    if (process_ == 0) {
      ::close(end[1]);
      const auto kept = work();
      char byte = 'x';
      (void)!::write(told[1], &byte, 1);
      (void)!::read(end[0], &byte, 1);  // until the parent closes it
      ::_exit(0);                       // without destructors, as where it is killed
    }
    ::close(told[1]);
    ::close(end[0]);
    end_ = end[1];
    char byte = 0;
    worked_ = ::read(told[0], &byte, 1) == 1;
    ::close(told[0]);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() { end(SIGKILL); }

  [[nodiscard]] bool worked() const { return worked_; }
  void end(int signal) {
    if (process_ < 0) return;
    ::kill(process_, signal);
    ::close(end_);
    ::waitpid(std::exchange(process_, -1), nullptr, 0);
  }

 private:
  pid_t process_ = -1;
  int end_ = -1;
  bool worked_ = false;
};

auto holding(const fs::path& folder) {
  return [folder] { return std::make_unique<OutputFolder>(folder, true); };
}

TEST(OutputFolder, IsMadeAndLeftWithoutAnythingOfItsOwn) {
  const Scratch scratch;
  const fs::path folder = scratch.path / "a" / "b";
  {
    const OutputFolder output(folder, false);
    std::ofstream(folder / "result") << "1";
  }
  fs::remove(folder / "result");
  EXPECT_TRUE(is_empty_folder(folder));
}

TEST(OutputFolder, IsRemovedOnlyIfItWasMadeAndNothingWasWritten) {
  const Scratch scratch;
  EXPECT_EQ(refusal(scratch.path / "made"), "");
  EXPECT_FALSE(fs::exists(scratch.path / "made"));
  fs::create_directory(scratch.path / "found");
  EXPECT_EQ(refusal(scratch.path / "found"), "");
  EXPECT_TRUE(is_empty_folder(scratch.path / "found"));
}

TEST(OutputFolder, IsHeldByOneProcessAtATime) {
  const Scratch scratch;
  Child first(holding(scratch.path));
  ASSERT_TRUE(first.worked());
  for (const bool force : {false, true})
    EXPECT_EQ(refusal(scratch.path, force), scratch.path.string() + ": another run writes there");
}

TEST(OutputFolder, IsFreeAgainWhenItsHolderIsKilled) {
  const Scratch scratch;
  for (const int signal : {SIGKILL, SIGTERM, SIGKILL}) {
    Child first(holding(scratch.path));
    ASSERT_TRUE(first.worked());
    ASSERT_NE(refusal(scratch.path), "");
    first.end(signal);
    EXPECT_EQ(refusal(scratch.path), "");
  }
}

// When many processes compete, exactly one gets the folder each time, even while the lock file is removed.
TEST(OutputFolder, IsNeverHeldByTwo) {
  const Scratch scratch;
  const fs::path shared = scratch.path / "shared", marks = scratch.path / "marks";
  fs::create_directory(marks);
  std::vector<pid_t> children;
  for (int child = 0; child < 4; ++child) {
    const pid_t process = ::fork();
    if (process == 0) {
      int faults = 0, held = 0;
      while (held < 50) {
        try {
          const OutputFolder folder(shared, true);
          ++held;
          faults += fs::create_directory(marks / "held") ? 0 : 1;
          faults += fs::remove(marks / "held") ? 0 : 1;
        } catch (const std::runtime_error&) {
        }
      }
      ::_exit(faults == 0 ? 0 : 1);
    }
    children.push_back(process);
  }
  for (const pid_t process : children) {
    int status = -1;
    ASSERT_EQ(::waitpid(process, &status, 0), process);
    EXPECT_EQ(status, 0);
  }
}

TEST(OutputFolder, IsHeldByAStartedProcessOnlyWhereItIsShared) {
  const Scratch scratch;
  for (const bool shared : {false, true}) {
    std::optional<OutputFolder> folder(std::in_place, scratch.path, false);
    if (shared) folder->share();
    std::array<int, 2> in{}, out{};
    ASSERT_EQ(::pipe(in.data()), 0);
    ASSERT_EQ(::pipe(out.data()), 0);
    const pid_t process = ::fork();
    if (process == 0) {
      ::dup2(in[0], STDIN_FILENO);
      ::dup2(out[1], STDOUT_FILENO);
      for (const int end : {in[0], in[1], out[0], out[1]}) ::close(end);
      ::execlp("cat", "cat", nullptr);
      ::_exit(1);
    }
    char byte = 'x';
    ASSERT_EQ(::write(in[1], &byte, 1), 1);
    ASSERT_EQ(::read(out[0], &byte, 1), 1) << "cat runs";
    // Simulates that this process was killed: its descriptor is closed, and the file stays.
    const std::string file = (scratch.path / ".lock").string();
    fs::create_hard_link(file, scratch.path / "kept");
    folder.reset();
    fs::rename(scratch.path / "kept", file);
    EXPECT_EQ(refusal(scratch.path).empty(), !shared);
    ::close(in[1]);
    ASSERT_EQ(::waitpid(process, nullptr, 0), process);
    for (const int end : {in[0], out[0], out[1]}) ::close(end);
    EXPECT_EQ(refusal(scratch.path), "");
  }
}

TEST(OutputFolder, IsRefusedWhereItIsNotEmpty) {
  const Scratch scratch;
  write_file(scratch.path / "rates.csv", "precious\n");
  EXPECT_EQ(refusal(scratch.path),
            scratch.path.string() + ": is not empty (it has rates.csv); --force overwrites what is there");
  EXPECT_EQ(refusal(scratch.path, true), "");
  EXPECT_FALSE(fs::exists(scratch.path / ".lock"));
}

TEST(OutputFolder, NamesWhatCannotBeAFolder) {
  EXPECT_EQ(refusal("/dev/null/folder"), "/dev/null/folder: cannot be made: Not a directory");
}

TEST(OutputFolder, LeavesAFileAloneThatIsNotItsLock) {
  const Scratch scratch;
  write_file(scratch.path / ".lock", "precious\n");
  for (const bool force : {false, true}) {
    EXPECT_EQ(refusal(scratch.path, force), "");
    EXPECT_EQ(run_tests::text_of(scratch.path / ".lock"), "precious\n");
  }
}

TEST(OutputFolder, DoesNotFollowALinkInPlaceOfItsLock) {
  const Scratch scratch;
  write_file(scratch.path / "victim.txt", "precious\n");
  fs::create_directory(scratch.path / "out");
  fs::create_symlink("../victim.txt", scratch.path / "out" / ".lock");
  EXPECT_NE(refusal(scratch.path / "out"), "");
  EXPECT_EQ(run_tests::text_of(scratch.path / "victim.txt"), "precious\n");
}

}  // namespace
}  // namespace touchstone::program
