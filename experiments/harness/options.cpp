// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/harness/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "experiments/harness/whole_number.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::harness {
namespace {

std::string check_utf8(const std::string& name) {
  try {
    (void)nlohmann::json(name).dump();
    return {};
  } catch (const nlohmann::json::exception&) {
    return "the name of a file is not UTF-8: " + io::legible(name);
  }
}

}  // namespace

void add_names(CLI::App& command, const std::string& option, std::vector<std::string>& names,
               const std::string& about) {
  auto* added = command.add_option(option, names, about)->delimiter(',')->allow_extra_args(false);
  if (!names.empty()) added->capture_default_str();
}

void add_meshes(CLI::App& command, std::vector<std::string>& files, const std::string& about) {
  command.add_option("MESH", files, about)->required()->check(check_utf8);
}

void add_seed(CLI::App& command, std::uint64_t& seed, const std::string& about) {
  command.add_option("--seed", seed, about)->check(whole_number(0))->capture_default_str();
}

void add_threads(CLI::App& command, unsigned& threads, const std::string& about) {
  command.add_option("--threads", threads, about)->check(whole_number(1, 1024))->capture_default_str();
}

unsigned all_threads() { return std::max(1U, std::thread::hardware_concurrency()); }

void add_no_pictures(CLI::App& command, bool& no_pictures) {
  command.add_flag("--no-pictures", no_pictures, "Write the data only");
}

void add_resume(CLI::App& command, bool& resume) {
  command.add_flag("--resume", resume, "Go on where the run in that folder was stopped or killed");
}

void add_force(CLI::App& command, bool& force) {
  auto* added =
      command.add_flag("--force", force, "Write over what is there; without it, a folder must be empty or new");
  if (auto* resume = command.get_option_no_throw("--resume")) added->excludes(resume);
}

}  // namespace touchstone::harness
