// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace touchstone::program {

/// Writes the text, byte for byte, to a new file beside the target, which then takes its name. Readers thus find the
/// earlier file or the complete new one, also after the machine has failed: the text is on the disk before the file
/// takes its name. A symbolic link of that name is replaced, not followed.
///
/// Throws std::runtime_error, which names the file and the reason, if it cannot be written; an earlier file is then
/// unchanged.
void write_file(const std::filesystem::path& path, const std::string& text);

/// The same for a command that writes one file. Without `force`, throws like refuse_overwrite if the file exists by
/// now.
void write_file(const std::filesystem::path& path, const std::string& text, bool force);

/// Checks the target of a command that writes one file, before the command computes its content.
///
/// Throws std::runtime_error, which names the file: without `force`, if anything of that name exists; with `force`, if
/// that is not a regular file (a folder, a device, a symbolic link).
void refuse_overwrite(const std::filesystem::path& file, bool force);

/// Creates a folder and its parents if it does not exist, so that a folder that cannot be written to is reported before
/// the work begins. Returns whether it did not exist. Throws std::runtime_error, which names the folder.
bool make_folder(const std::filesystem::path& folder);

/// The output folder of a run, locked during the lifetime of this object. Removed at its end if it made the folder and
/// nothing was written.
///
/// The lock is a lock of the operating system (flock) on the empty file `.lock` in the folder. It ends with the
/// process, however the process ends. Child processes do not hold it, unless `share` is called.
class OutputFolder {
 public:
  /// Creates the folder if it does not exist. With `force`, the run may overwrite what is there.
  ///
  /// Throws std::runtime_error, which names the folder and the reason: it cannot be created or written to; another run
  /// holds it; it is not empty, and not to be overwritten. An existing folder is then unchanged. On a file system
  /// without locks, prints a warning to stderr and continues.
  OutputFolder(std::filesystem::path folder, bool force);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  ~OutputFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// From now on, child processes also hold the lock, until all of them have ended. For children that write to the
  /// folder themselves.
  void share() const;

 private:
  void lock();
  void refuse_content() const;
  void release();
  [[noreturn]] void refuse(const std::string& why) const;

  std::filesystem::path path_, lock_file_;
  int descriptor_ = -1;
  bool made_ = false;  // by this object
};

}  // namespace touchstone::program
