// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace touchstone::run {

/// The permissions of a run in a folder that is not empty. Without any, the run is refused.
struct Existing {
  bool force = false;   ///< overwrite existing files
  bool resume = false;  ///< continue from the existing checkpoint
};

/// The output folder of a run, locked during the lifetime of this object. Removed at its end if it made the folder and
/// nothing was written.
///
/// The lock is a lock of the operating system (flock) on the file `.lock` in the folder; the file names the holder. The
/// lock ends with the process, however the process ends. Child processes do not hold it, unless `share` is called.
/// Files that a killed run did not finish (see is_unfinished) are removed, and a folder that has nothing else is empty.
class OutputFolder {
 public:
  /// Creates the folder if it does not exist. `command`: the description of this run for other runs.
  ///
  /// Throws std::runtime_error, which names the folder and the reason: it cannot be created or written to; another run
  /// holds it; it has a file `.lock` that is not a lock; it is not empty, and `existing` does not allow that. An
  /// existing folder is then unchanged. On a file system without locks, prints a warning to stderr and continues.
  OutputFolder(std::filesystem::path folder, const std::string& command, Existing existing);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  ~OutputFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// From now on, child processes also hold the lock, until all of them have ended. For children that write to the
  /// folder themselves.
  void share() const;

 private:
  void lock();
  void sign(const std::string& command);
  void refuse_content(Existing existing) const;
  void remove_unfinished() const;
  void release();
  [[noreturn]] void refuse(const std::string& why) const;

  std::filesystem::path path_, lock_file_;
  int descriptor_ = -1;
  bool made_ = false;  // by this object
};

}  // namespace touchstone::run
