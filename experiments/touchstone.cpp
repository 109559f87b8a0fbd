// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/commands.h"
#include "experiments/run/json.h"
#include "experiments/run/printing.h"
#include "experiments/run/run_record.h"
#include "experiments/run/terminal.h"
#include "experiments/thesis/convex/convex.h"
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

constexpr const char* kAbout = "Does a ball touch a polygon, where, and how sure is the answer?";
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

/// What an exception that ended a command says, legible and without a library's tags.
std::string complaint(const std::exception& error) {
  if (const auto* json = dynamic_cast<const nlohmann::json::exception*>(&error))
    return touchstone::run::json_fault(*json);
  return touchstone::io::all_legible(touchstone::run::message_of(error));
}

}  // namespace

int main(int argc, char** argv) {
  if (!occupy_standard_streams()) return 2;
  std::set_terminate(end_out_of_memory);
  try {
    using namespace touchstone::commands;
    touchstone::convex::add_methods();
    std::vector<touchstone::run::Command> commands;
    const auto add = [&](const std::string& heading, std::vector<touchstone::run::Command> some) {
      for (auto& command : some) command.heading(heading);
      commands.insert(commands.end(), some.begin(), some.end());
    };
    add("Ask and judge", {judge_command(), show_command(), scenes_command(), cases_command(), methods_command(),
                          regress_command(), corpus_command()});
    add("Studies", study_commands());
    add("The cell and the thesis", {cell_command(), thesis_command()});
    add("Studies", parts_commands(commands));
    add("Tools", {columns_command(commands)});
    add("Tools", help_commands(kAbout, "Tools", commands));
    const int status = touchstone::run::run_program({kAbout, touchstone::run::version_text()}, commands, argc, argv);
    touchstone::run::flush_standard_output();
    return status;
  } catch (const std::bad_alloc&) {
    std::fputs(kOutOfMemory.data(), stderr);
  } catch (const std::exception& error) {
    using namespace touchstone::run;
    std::fprintf(stderr, "%s %s\n", coloured("touchstone:", Colour::Red, stderr).c_str(), complaint(error).c_str());
  }
  return 2;
}
