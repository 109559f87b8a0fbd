// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>

#include "experiments/program/program.h"

namespace touchstone::program {
namespace {

/// Returns how a new process ends in which the function runs: its exit status, or minus the signal. The process ignores
/// no signal at first, however the tests were started.
int end_of(const std::function<int()>& function) {
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int signal : kEndSignals) std::signal(signal, SIG_DFL);
    ::_exit(function());
  }
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

TEST(StopSignal, IsRequestedByTheFirstSignalAndEndsTheProcessAtTheSecond) {
  for (const int signal : kEndSignals) {
    EXPECT_EQ(end_of([signal] {
                const StopSignal stop;
                if (stop.requested()) return 1;
                ::raise(signal);
                return stop.requested() ? 0 : 2;
              }),
              0);
    EXPECT_EQ(end_of([signal] {
                const StopSignal stop;
                ::raise(signal);
                ::raise(signal);
                return 0;
              }),
              -signal);
  }
}

TEST(StopSignal, EndsTheProcessAsUsualBehindItsLife) {
  for (const int signal : kEndSignals)
    EXPECT_EQ(end_of([signal] {
                { const StopSignal stop; }
                ::raise(signal);
                return 0;
              }),
              -signal);
}

// As under nohup, or in the background of a shell.
TEST(StopSignal, LeavesAnIgnoredSignalIgnored) {
  for (const int ignored : kEndSignals)
    EXPECT_EQ(end_of([ignored] {
                std::signal(ignored, SIG_IGN);
                {
                  const StopSignal stop;
                  ::raise(ignored);
                  if (stop.requested()) return 1;
                  const int other = ignored == SIGTERM ? SIGHUP : SIGTERM;
                  ::raise(other);
                  if (!stop.requested()) return 2;
                  ::raise(ignored);
                }
                ::raise(ignored);
                return 0;
              }),
              0);
}

}  // namespace
}  // namespace touchstone::program
