// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/ranges.h>
#include <sys/utsname.h>

#include <cstdio>
#include <ctime>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <thread>
#include <utility>

#include "experiments/program/built_with.h"
#include "experiments/program/command_run.h"
#include "experiments/program/output.h"
#include "touchstone_commit.h"

namespace touchstone::program {
namespace {

#ifdef __clang__
constexpr const char* kCompiler = "clang++ " __clang_version__;
#else
constexpr const char* kCompiler = "g++ " __VERSION__;
#endif

/// Returns the commit of the sources of this build; null if git or a commit was missing. `+`: the sources had changes.
nlohmann::ordered_json commit() {
  constexpr std::string_view commit = TOUCHSTONE_COMMIT;
  return commit.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(commit);
}

/// Returns the optional third-party libraries of this build.
std::vector<std::string> engines() { return TOUCHSTONE_LIBRARIES; }

/// Returns the name of the first processor with family, model and stepping, since virtual machines often shorten the
/// name. Empty if /proc/cpuinfo does not say them.
std::string processor() {
  std::map<std::string, std::string> said;
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line) && !line.empty();)
    if (const auto colon = line.find(": "); colon != std::string::npos)
      said[line.substr(0, line.find_last_not_of("\t ", colon - 1) + 1)] = line.substr(colon + 2);
  if (said["model name"].empty()) return "";
  return fmt::format("{} ({} family {}, model {}, stepping {})", said["model name"], said["vendor_id"],
                     said["cpu family"], said["model"], said["stepping"]);
}

/// Returns the current time as `2026-11-23T03:19:51Z`.
std::string utc_now() {
  const std::time_t time = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&time, &utc);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc)};
}

}  // namespace

std::string version_text() {
  constexpr std::string_view commit = TOUCHSTONE_COMMIT;
  const auto found = engines();
  return fmt::format("touchstone {}\ncommit: {}\ncompiler: {}\nengines: {}", TOUCHSTONE_VERSION,
                     commit.empty() ? "unknown" : commit, kCompiler,
                     found.empty() ? "none" : fmt::format("{}", fmt::join(found, ", ")));
}

void write_run_record(const std::filesystem::path& folder, const Run& run) {
  utsname machine{};
  uname(&machine);
  nlohmann::ordered_json record = {
      {"command", run.command},
      {"seed", run.seed},
      {"samples_asked", run.samples_asked},
      {"samples_done", run.samples_done},
      {"samples_missing", run.samples_missing},
      {"parts", run.parts},
      {"threads", run.threads},
      {"seconds", run.seconds},
      {"date", utc_now()},
      {"commit", commit()},
      {"compiler", kCompiler},
      {"flags", TOUCHSTONE_COMPILE_FLAGS},
      {"engines", engines()},
      {"processor", processor()},
      {"cores", std::thread::hardware_concurrency()},
      {"machine", std::string(machine.sysname) + " " + machine.release + " " + machine.machine},
  };
  if (!run.part.empty()) record["part"] = run.part;
  if (run.interrupted) record["interrupted"] = *run.interrupted;
  const auto path = folder / "run.json";
  write_file(path, record.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace touchstone::program
