// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/program.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <string_view>

#include "experiments/program/json.h"
#include "experiments/program/printing.h"
#include "experiments/program/run_record.h"
#include "experiments/program/terminal.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::program {
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

/// What an exception that ended a command says, legible and without a library's tags.
std::string complaint(const std::exception& error) {
  if (const auto* json = dynamic_cast<const nlohmann::json::exception*>(&error)) return json_fault(*json);
  return io::all_legible(message_of(error));
}

}  // namespace

int main_of(const std::string& about, const std::function<std::vector<Command>()>& commands, int argc, char** argv) {
  if (!occupy_standard_streams()) return 2;
  std::set_terminate(end_out_of_memory);
  try {
    const int status = run_program({about, version_text()}, commands(), argc, argv);
    flush_standard_output();
    return status;
  } catch (const std::bad_alloc&) {
    std::fputs(kOutOfMemory.data(), stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s %s\n", coloured("touchstone:", Colour::Red, stderr).c_str(), complaint(error).c_str());
  }
  return 2;
}

}  // namespace touchstone::program
