// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/output_folder.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <set>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "experiments/run/run_record.h"
#include "experiments/run/write_file.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::run {
namespace {

constexpr const char* kLock = ".lock";
constexpr std::string_view kHolder = "process ";  // the beginning of its text

std::string reason(int error) { return std::generic_category().message(error); }

/// Returns the text that the holder of the lock wrote.
std::string holder(int descriptor) {
  std::array<char, 1000> text{};
  const ssize_t length = ::pread(descriptor, text.data(), text.size(), 0);
  return length > 0 ? ": " + io::legible({text.data(), static_cast<std::size_t>(length)}) : "";
}

/// Returns whether the file is empty or was written by a holder that has ended, and has only this name.
bool is_lock(int descriptor) {
  struct stat file {};
  std::array<char, kHolder.size()> begin{};
  const ssize_t length = ::pread(descriptor, begin.data(), begin.size(), 0);
  return ::fstat(descriptor, &file) == 0 && S_ISREG(file.st_mode) && file.st_nlink <= 1 &&
         (length == 0 || std::string_view(begin.data(), begin.size()) == kHolder);
}

bool is_same_file(int descriptor, const std::filesystem::path& path) {
  struct stat opened {
  }, named{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

std::string host() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "an unknown machine";
}

}  // namespace

OutputFolder::OutputFolder(std::filesystem::path folder, const std::string& command, Existing existing)
    : path_(std::move(folder)), lock_file_(path_ / kLock) {
  made_ = make_folder(path_);
  lock();
  try {
    refuse_content(existing);
    remove_unfinished();
  } catch (...) {
    release();
    throw;
  }
  sign(command);
}

OutputFolder::~OutputFolder() { release(); }

void OutputFolder::lock() {
  // The holder removes the file, so the locked file may have lost its name meanwhile.
  do {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = ::open(lock_file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0) refuse("cannot be written to: " + reason(errno));
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) continue;
    const int error = errno;
    if (error == EWOULDBLOCK) {
      const std::string who = holder(descriptor_);
      ::close(std::exchange(descriptor_, -1));
      refuse("another run writes there" + who);
    }
    fmt::print(stderr, "touchstone: {}: cannot be locked, so let no other run write there: {}\n", path_.string(),
               reason(error));
  } while (!is_same_file(descriptor_, lock_file_));
  if (!is_lock(descriptor_)) {
    ::close(std::exchange(descriptor_, -1));
    refuse(std::string("has a file ") + kLock + " that is not a lock of this program");
  }
}

void OutputFolder::sign(const std::string& command) {
  const std::string text = fmt::format("{}{} on {} since {}: {}", kHolder, ::getpid(), host(), utc_now(), command);
  // If this fails, other runs cannot name the holder; a full disk is reported by the first result.
  if (::ftruncate(descriptor_, 0) == 0) (void)!::pwrite(descriptor_, text.data(), text.size(), 0);
}

void OutputFolder::refuse_content(Existing existing) const {
  if (existing.force) return;
  std::error_code error;
  const bool has_checkpoint = std::filesystem::exists(path_ / "checkpoint.json", error);
  if (existing.resume && has_checkpoint) return;
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_)) {
    const std::string name = entry.path().filename().string();
    if (!is_unfinished(name)) names.insert(name);
  }
  names.erase(kLock);
  if (names.empty()) return;
  const std::string name = io::legible(*names.begin());
  if (existing.resume) refuse("has no checkpoint.json to continue from, but " + name);
  refuse(fmt::format("is not empty (it has {}); --force overwrites what is there{}", name,
                     has_checkpoint ? ", --resume continues its run" : ""));
}

void OutputFolder::remove_unfinished() const {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    if (is_unfinished(entry.path().filename().string())) std::filesystem::remove(entry.path(), error);
}

void OutputFolder::share() const {
  if (descriptor_ >= 0) ::fcntl(descriptor_, F_SETFD, 0);
}

void OutputFolder::release() {
  if (descriptor_ < 0) return;
  ::unlink(lock_file_.c_str());
  ::close(std::exchange(descriptor_, -1));
  if (made_) ::rmdir(path_.c_str());  // which fails if there is anything in it
}

void OutputFolder::refuse(const std::string& why) const { throw std::runtime_error(path_.string() + ": " + why); }

}  // namespace touchstone::run
