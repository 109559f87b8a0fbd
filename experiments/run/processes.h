// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace touchstone::run {

/// The processes that work together: those that `mpirun` started, or this one alone.
///
/// All processes must call every function except the first three, by one thread each, in the same order.
class Processes {
 public:
  /// This process alone.
  Processes() = default;
  Processes(unsigned number, unsigned count) : number_(number), count_(count) {}

  [[nodiscard]] unsigned number() const { return number_; }
  [[nodiscard]] unsigned count() const { return count_; }
  /// Returns whether this is the first process, which reads and writes files, prints and shows progress.
  [[nodiscard]] bool first() const { return number_ == 0; }

  /// Returns the largest value of all processes.
  [[nodiscard]] std::uint64_t largest(std::uint64_t value) const;
  /// Returns the value of the first process.
  [[nodiscard]] std::uint64_t of_first(std::uint64_t value) const;
  [[nodiscard]] std::string of_first(std::string text) const;
  /// Returns, at the first process, the texts of the other processes in the order of their numbers; at the others,
  /// nothing.
  ///
  /// Texts are at most 2^31 - 1 bytes long. Throws std::length_error.
  [[nodiscard]] std::vector<std::string> gathered(const std::string& text) const;

 private:
  unsigned number_ = 0, count_ = 1;
};

/// Runs the work with all processes that `mpirun` (or another launcher of MPI programs) started, and returns its
/// result. A single process, or a build without MPI, only calls `work`: no daemon, no message, no time spent.
///
/// If one of several processes throws, the exception is reported on standard error and all processes end with exit
/// status 2. Requires that each process calls this once.
int run_together(const std::function<int(const Processes&)>& work);

/// Runs work that ignores other processes, and returns its result. If `mpirun` started several, reports an error as
/// above: each process would do all of the work and write the same files.
int run_alone(const std::function<int()>& work);

}  // namespace touchstone::run
