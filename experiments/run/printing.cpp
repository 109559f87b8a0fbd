// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/printing.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "experiments/run/standard_output.h"
#include "experiments/run/table_json.h"

namespace touchstone::run {
namespace {

/// A new folder for temporary files, removed with this object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "touchstone-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::system_error(errno, std::generic_category(), name);
    path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

void Printing::print(const std::string& text, const std::filesystem::path& folder) const {
  if (json) fmt::print("{}", tables_json(folder, tables));
  if (prints_text()) fmt::print("{}", text);
  flush_standard_output();
}

void Printing::print(const std::string& text, const std::function<void(const std::filesystem::path&)>& write) const {
  if (!json) return print(text, std::filesystem::path());
  const ScratchFolder scratch;
  write(scratch.path());
  print(text, scratch.path());
}

void declare_printing(Command& command, Printing& printing) {
  command.quiet(printing.quiet);
  command.json(printing.json).excludes("--quiet");
  command.keep_tables(printing.tables);
}

}  // namespace touchstone::run
