// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace touchstone::harness {

/// The processes that work together: those that `mpirun` started, or this one alone.
///
/// Every function but the first three must be called by all of them, by one thread each, in the same order.
class Processes {
 public:
  /// This one alone.
  Processes() = default;
  Processes(unsigned number, unsigned count) : number_(number), count_(count) {}

  [[nodiscard]] unsigned number() const { return number_; }
  [[nodiscard]] unsigned count() const { return count_; }
  /// The one that reads and writes files, prints and shows progress.
  [[nodiscard]] bool first() const { return number_ == 0; }

  /// The largest of all values.
  [[nodiscard]] std::uint64_t largest(std::uint64_t value) const;
  /// The first process's value.
  [[nodiscard]] std::uint64_t of_first(std::uint64_t value) const;
  [[nodiscard]] std::string of_first(std::string text) const;
  /// At the first process, what the others gave, in the order of their numbers; nothing at the others.
  ///
  /// Texts are at most 2^31 - 1 bytes long. Throws std::length_error.
  [[nodiscard]] std::vector<std::string> gathered(const std::string& text) const;

 private:
  unsigned number_ = 0, count_ = 1;
};

/// Runs the work with all processes that `mpirun` (or another launcher of MPI programs) started, and returns what it
/// returns. Alone, and in builds without MPI, it is only called: no daemon, no message, no time spent.
///
/// An exception in one of several processes is told on standard error and ends all of them with exit status 2. Requires
/// that it is called once a process.
int run_together(const std::function<int(const Processes&)>& work);

/// Runs work that knows of no other processes and returns what it returns. Where `mpirun` started several it is an
/// error, told as above: each would do all of the work and write the same files.
int run_alone(const std::function<int()>& work);

}  // namespace touchstone::harness
