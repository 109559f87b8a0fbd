// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "experiments/commands.h"
#include "experiments/harness/json/json_fault.h"
#include "experiments/harness/standard_output.h"
#include "geometry/io/detail/legible.h"

namespace {

/// Opens the standard streams that are closed, lest a file or socket take their place: for the wrong direction, so that
/// reading and writing them stay errors. False if that cannot be done.
bool occupy_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const bool is_open = fcntl(stream, F_GETFD) >= 0;
    if (!is_open && open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) != stream) return false;
  }
  return true;
}

constexpr std::string_view kOutOfMemory = "touchstone: out of memory\n";
const std::terminate_handler usual_end = std::get_terminate();

/// Where memory ends within a destructor or a thread, so that main does not learn of it. (Destructors of the JSON
/// library allocate.)
[[noreturn]] void end_out_of_memory() {
  try {
    if (const auto error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kOutOfMemory.data(), kOutOfMemory.size());
    _exit(2);
  } catch (...) {
    usual_end();
  }
  usual_end();
  std::abort();
}

/// A complaint about the command line, which it may quote.
std::string legible_complaint(const CLI::App* app, const CLI::Error& error) {
  const std::string sentence = touchstone::io::all_legible(error.what());
  return CLI::FailureMessage::simple(app, CLI::Error(error.get_name(), sentence, error.get_exit_code()));
}

int run(int argc, char** argv) {
  CLI::App app("touchstone: does a ball touch a polygon, where, and how sure is the answer?");
  app.require_subcommand(1);
  app.failure_message(legible_complaint);
  int status = 0;
  touchstone::commands::add_judge(app, status);
  touchstone::commands::add_methods(app);
  touchstone::commands::add_near_edge(app, status);
  touchstone::commands::add_meshes(app, status);
  touchstone::commands::add_merging(app, status);
  touchstone::commands::add_cases(app);
  touchstone::commands::add_bench(app, status);
  touchstone::commands::add_bench_scenes(app, status);
  touchstone::commands::add_soak(app, status);
  touchstone::commands::add_tradeoff(app, status);
  touchstone::commands::add_stability(app, status);
  touchstone::commands::add_scenes(app, status);
  touchstone::commands::add_cell(app, status);
  touchstone::commands::add_regress(app, status);
  touchstone::commands::add_corpus(app, status);
  touchstone::commands::add_thesis(app, status);
  CLI11_PARSE(app, argc, argv);
  return status;
}

/// What an exception that ended a command says, legible and without a library's tags.
std::string complaint(const std::exception& error) {
  if (const auto* json = dynamic_cast<const nlohmann::json::exception*>(&error))
    return touchstone::harness::json_fault(*json);
  return touchstone::io::all_legible(touchstone::harness::message_of(error));
}

}  // namespace

int main(int argc, char** argv) {
  if (!occupy_standard_streams()) return 2;
  std::set_terminate(end_out_of_memory);
  try {
    const int status = run(argc, argv);
    touchstone::harness::flush_standard_output();
    return status;
  } catch (const std::bad_alloc&) {
    std::fputs(kOutOfMemory.data(), stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "touchstone: %s\n", complaint(error).c_str());
  }
  return 2;
}
