// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace CLI {
class App;
}

/// Options that several studies have. Help shows what a variable holds when its option is added.
namespace touchstone::harness {

/// Names, separated by commas: one argument, so that what stands behind it is another's.
void add_names(CLI::App& command, const std::string& option, std::vector<std::string>& names, const std::string& about);

/// MESH: files, one at least. Names are data of JSON, so that one that is not UTF-8 is refused.
void add_meshes(CLI::App& command, std::vector<std::string>& files, const std::string& about);

/// --seed: any whole number without a sign.
void add_seed(CLI::App& command, std::uint64_t& seed,
              const std::string& about = "Any number; the same gives the same bytes");

/// --threads: from 1 to 1024.
void add_threads(CLI::App& command, unsigned& threads, const std::string& about = "They do not change the results");

/// As many threads as the machine runs at once.
[[nodiscard]] unsigned all_threads();

/// --no-pictures.
void add_no_pictures(CLI::App& command, bool& no_pictures);

/// --resume.
void add_resume(CLI::App& command, bool& resume);

/// --force, beside --resume if the command has that already, but not with it.
void add_force(CLI::App& command, bool& force);

}  // namespace touchstone::harness
