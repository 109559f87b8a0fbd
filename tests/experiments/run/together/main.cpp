// SPDX-License-Identifier: GPL-3.0-or-later
// For same_bytes.py, under mpirun: prints what processes tell each other; with an argument, the process of that number
// throws in the middle of a sweep.
#include <fmt/core.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "experiments/run/sweep.h"

namespace {

using touchstone::run::Processes;

int tell(const Processes& processes) {
  const auto number = std::uint64_t{processes.number()};
  std::string text = fmt::format("largest {}, first {}, first {}, gathered", processes.largest(number * number),
                                 processes.of_first(number + 7), processes.of_first(std::string(number + 3, 'x')));
  for (const std::string& other : processes.gathered(std::string(1'000'000 * number, 'y')))
    text += fmt::format(" {}", other.size());
  if (processes.first()) fmt::print("{}\n", text);
  return 0;
}

/// One process is stopped, early: the sum is that of the first items nevertheless, and all agree how many.
int stop_one(const Processes& processes) {
  std::atomic<bool> stop = false;
  std::uint64_t sum = 0;
  const bool stopped = processes.number() + 1 == processes.count();
  const std::uint64_t done = touchstone::run::run_sweep(
      {1'000'000, 3, 2, processes, stop, [](std::uint64_t) {}},
      [&](std::uint64_t item, std::uint64_t& part) {
        part += item;
        if (stopped && item > 2000) stop = true;
      },
      [](std::uint64_t, std::uint64_t) {}, std::uint64_t{0}, 0, sum);
  const bool agreed = processes.largest(done) == done && processes.of_first(done) == done;
  if (processes.first())
    fmt::print("{}, {}, {}\n", done > 2000 && done < 1'000'000 ? "stopped" : "not stopped",
               sum == done * (done - 1) / 2 ? "the first items" : "other items", agreed ? "agreed" : "not agreed");
  return 0;
}

int fail_in(unsigned number, const Processes& processes) {
  const std::atomic<bool> never = false;
  std::uint64_t sum = 0;
  touchstone::run::run_sweep(
      {1000, 1, 2, processes, never, [](std::uint64_t) {}},
      [&](std::uint64_t item, std::uint64_t&) {
        if (item > 500 && processes.number() == number) throw std::runtime_error("item beyond 500");
      },
      [](std::uint64_t, std::uint64_t) {}, std::uint64_t{0}, 0, sum);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return touchstone::run::run_together([&](const Processes& processes) {
    if (argc > 1) return fail_in(static_cast<unsigned>(std::atoi(argv[1])), processes);
    tell(processes);
    return stop_one(processes);
  });
}
