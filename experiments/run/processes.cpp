// SPDX-License-Identifier: GPL-3.0-or-later
// All calls of MPI.
#include "experiments/run/processes.h"

#include <stdexcept>

#ifdef TOUCHSTONE_MPI
#include <fmt/core.h>
#include <mpi.h>

#include <climits>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "geometry/io/detail/legible.h"

namespace touchstone::run {
namespace {

constexpr int kTexts = 1;  // the only kind of message

/// MPI_Init without a launcher would start a daemon. Open MPI documents the first variable; PMIx and PMI launchers
/// (srun, MPICH's mpiexec) set the others.
bool launched() {
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
    if (std::getenv(variable) != nullptr) return true;
  return false;
}

Processes all_processes() {
  int number = 0, count = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &number);
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return {static_cast<unsigned>(number), static_cast<unsigned>(count)};
}

[[noreturn]] void end_all(const Processes& processes, const char* message) {
  fmt::print(stderr, "touchstone: process {} of {}: {}\n", processes.number(), processes.count(),
             io::all_legible(message));
  std::fflush(stdout);
  std::fflush(stderr);
  constexpr int kFailed = 2;
  MPI_Abort(MPI_COMM_WORLD, kFailed);
  std::abort();
}

int length_of(const std::string& text) {
  if (text.size() > INT_MAX) throw std::length_error("more than 2^31 - 1 bytes from one process to another");
  return static_cast<int>(text.size());
}

std::string received_from(unsigned sender) {
  MPI_Status status;
  int length = 0;
  MPI_Probe(static_cast<int>(sender), kTexts, MPI_COMM_WORLD, &status);
  MPI_Get_count(&status, MPI_CHAR, &length);
  std::string text(static_cast<std::size_t>(length), '\0');
  MPI_Recv(text.data(), length, MPI_CHAR, static_cast<int>(sender), kTexts, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return text;
}

}  // namespace

std::uint64_t Processes::largest(std::uint64_t value) const {
  if (count_ > 1) MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_UINT64_T, MPI_MAX, MPI_COMM_WORLD);
  return value;
}

std::uint64_t Processes::of_first(std::uint64_t value) const {
  if (count_ > 1) MPI_Bcast(&value, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  return value;
}

std::string Processes::of_first(std::string text) const {
  if (count_ == 1) return text;
  const int length = length_of(text);
  text.resize(of_first(static_cast<std::uint64_t>(length)));
  MPI_Bcast(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
  return text;
}

std::vector<std::string> Processes::gathered(const std::string& text) const {
  std::vector<std::string> texts;
  if (first()) {
    for (unsigned sender = 1; sender < count_; ++sender) texts.push_back(received_from(sender));
  } else {
    MPI_Send(text.data(), length_of(text), MPI_CHAR, 0, kTexts, MPI_COMM_WORLD);
  }
  return texts;
}

int run_together(const std::function<int(const Processes&)>& work) {
  if (!launched()) return work(Processes());
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  const Processes processes = all_processes();
  if (processes.count() == 1) {  // the caller handles its errors
    MPI_Finalize();
    return work(processes);
  }
  try {
    if (provided < MPI_THREAD_FUNNELED) throw std::runtime_error("this MPI allows no threads");
    const int status = work(processes);
    MPI_Finalize();
    return status;
  } catch (const std::exception& error) {
    end_all(processes, error.what());
  }
}

}  // namespace touchstone::run

#else

namespace touchstone::run {

std::uint64_t Processes::largest(std::uint64_t value) const { return value; }
std::uint64_t Processes::of_first(std::uint64_t value) const { return value; }
std::string Processes::of_first(std::string text) const { return text; }
std::vector<std::string> Processes::gathered(const std::string&) const { return {}; }
int run_together(const std::function<int(const Processes&)>& work) { return work(Processes()); }

}  // namespace touchstone::run

#endif

namespace touchstone::run {

int run_alone(const std::function<int()>& work) {
  return run_together([&work](const Processes& processes) {
    if (processes.count() > 1) throw std::runtime_error("this command works in one process only");
    return work();
  });
}

}  // namespace touchstone::run
