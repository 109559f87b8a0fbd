// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace touchstone::harness {

/// What a run may do in a folder that is not empty: nothing, unless one of these is set.
struct Existing {
  bool force = false;   ///< write over what is there
  bool resume = false;  ///< go on from the checkpoint that is there
};

/// The folder that a run writes, locked for as long as this lives.
///
/// The lock is one of the operating system (flock) on the file `.lock` in the folder, which says who holds it. It ends
/// with the process, however that ends; processes that this one starts have no part in it, except by `share`. Where
/// several processes work together, the first one, which writes, holds it.
class OutputFolder {
 public:
  /// Makes the folder if it is not there. `command`: the run, as it is told to others.
  ///
  /// Throws std::runtime_error, which names the folder and says why: it cannot be made or written to; another run holds
  /// it; it has a file `.lock` that is none; it is not empty, and `existing` does not allow that. A folder that was
  /// there is then as it was. On a file system that has no locks, stderr says so, and the run goes on.
  OutputFolder(std::filesystem::path folder, const std::string& command, Existing existing);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  ~OutputFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// From now on, processes that this one starts hold the lock too, until all of them have ended: for those that write
  /// to the folder themselves.
  void share() const;

 private:
  void lock();
  void sign(const std::string& command);
  void refuse_content(Existing existing) const;
  void release();
  [[noreturn]] void refuse(const std::string& why) const;

  std::filesystem::path path_, lock_file_;
  int descriptor_ = -1;
};

}  // namespace touchstone::harness
