// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/output.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "geometry/io/detail/legible.h"

namespace touchstone::program {
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

/// A temporary file that is deleted unless it takes its final name.
class NewFile {
 public:
  explicit NewFile(const std::filesystem::path& final_name)
      // The process number separates the temporary files of two processes that write the same file.
      : final_name_(final_name), name_(fmt::format("{}.new-{}", final_name.string(), ::getpid())) {
    ::unlink(name_.c_str());  // left by a killed process of this number
    descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0) cannot_write();
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!kept_) ::unlink(name_.c_str());
  }

  void write(const std::string& text) const {
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t some = ::write(descriptor_, text.data() + done, text.size() - done);
      if (some < 0 && errno != EINTR) cannot_write();
      if (some > 0) done += static_cast<std::size_t>(some);
    }
    if (::fsync(descriptor_) != 0) cannot_write();  // some file systems report a full disk only now
  }
  void take_name() {
    if (std::rename(name_.c_str(), final_name_.c_str()) != 0) cannot_write();
    kept_ = true;
  }

 private:
  [[noreturn]] void cannot_write() const {
    throw std::runtime_error(final_name_.string() + ": cannot be written: " + reason(errno));
  }

  const std::filesystem::path& final_name_;
  std::string name_;
  int descriptor_ = -1;
  bool kept_ = false;
};

}  // namespace

void write_file(const std::filesystem::path& path, const std::string& text, bool force) {
  if (!force) refuse_overwrite(path, false);
  write_file(path, text);
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  // Replacing a link harms nothing; replacing /dev/null would.
  std::error_code error;
  if (std::filesystem::is_other(std::filesystem::symlink_status(path, error)))
    throw std::runtime_error(path.string() + ": cannot be written: it is not a regular file");
  NewFile file(path);
  file.write(text);
  file.take_name();
}

void refuse_overwrite(const std::filesystem::path& file, bool force) {
  std::error_code error;
  const auto type = std::filesystem::symlink_status(file, error).type();
  // A file whose status cannot be read cannot be written, either; writing will report the reason.
  if (type == std::filesystem::file_type::not_found || type == std::filesystem::file_type::none) return;
  if (type != std::filesystem::file_type::regular)
    throw std::runtime_error(file.string() + ": exists already, and is not a regular file");
  if (!force) throw std::runtime_error(file.string() + ": exists already; --force overwrites it");
}

bool make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  const bool made = std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw std::runtime_error(folder.string() + ": cannot be made: " + (error ? error.message() : "it is not a folder"));
  return made;
}

namespace {

constexpr const char* kLock = ".lock";

/// Returns the status of the open file if it has that name, still.
std::optional<struct stat> status_of(int descriptor, const std::filesystem::path& path) {
  struct stat opened {
  }, named{};
  if (::fstat(descriptor, &opened) != 0 || ::stat(path.c_str(), &named) != 0) return std::nullopt;
  return opened.st_dev == named.st_dev && opened.st_ino == named.st_ino ? std::optional(opened) : std::nullopt;
}

}  // namespace

OutputFolder::OutputFolder(std::filesystem::path folder, bool force)
    : path_(std::move(folder)), lock_file_(path_ / kLock) {
  made_ = make_folder(path_);
  lock();
  try {
    if (!force) refuse_content();
  } catch (...) {
    release();
    throw;
  }
}

OutputFolder::~OutputFolder() { release(); }

void OutputFolder::lock() {
  for (;;) {
    descriptor_ = ::open(lock_file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0) refuse("cannot be written to: " + reason(errno));
    const int error = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    if (error == 0 && status_of(descriptor_, lock_file_)) return;
    if (error != 0 && error != EWOULDBLOCK) {
      fmt::print(stderr, "touchstone: {}: cannot be locked, so let no other run write there: {}\n", path_.string(),
                 reason(error));
      return;
    }
    ::close(std::exchange(descriptor_, -1));
    if (error == EWOULDBLOCK) refuse("another run writes there");
    // The holder has removed the file meanwhile.
  }
}

void OutputFolder::refuse_content() const {
  std::string first;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    if (const std::string name = entry.path().filename().string(); name != kLock && (first.empty() || name < first))
      first = name;
  if (!first.empty())
    refuse(fmt::format("is not empty (it has {}); --force overwrites what is there", io::legible(first)));
}

void OutputFolder::share() const {
  if (descriptor_ >= 0) ::fcntl(descriptor_, F_SETFD, 0);
}

void OutputFolder::release() {
  if (descriptor_ < 0) return;
  const auto status = status_of(descriptor_, lock_file_);
  if (status && S_ISREG(status->st_mode) && status->st_size == 0) ::unlink(lock_file_.c_str());  // else it is not ours
  ::close(std::exchange(descriptor_, -1));
  if (made_) ::rmdir(path_.c_str());  // which fails if there is anything in it
}

void OutputFolder::refuse(const std::string& why) const { throw std::runtime_error(path_.string() + ": " + why); }

}  // namespace touchstone::program
