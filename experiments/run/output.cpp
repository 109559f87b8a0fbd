// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/output.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <set>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "experiments/run/run_record.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::run {
namespace {

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

constexpr std::string_view kUnfinished = ".new-";

/// Returns whether the text is the number of a process.
bool is_process(std::string_view text) {
  return !text.empty() && text.size() < 10 && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Removes what killed processes left of this file.
void remove_leftovers(const std::filesystem::path& file) {
  const std::string beginning = file.filename().string() + std::string(kUnfinished);
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder_of(file), error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(beginning)) continue;
    const std::string process = name.substr(beginning.size());
    if (is_process(process) && ::kill(std::stoi(process), 0) != 0 && errno == ESRCH)
      std::filesystem::remove(entry.path(), error);
  }
}

/// A temporary file that is deleted unless it takes its final name.
class NewFile {
 public:
  explicit NewFile(const std::filesystem::path& final_name)
      // The process number separates the temporary files of two processes that write the same file.
      : final_name_(final_name), name_(final_name.string() + fmt::format("{}{}", kUnfinished, ::getpid())) {
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
  }
  void take_name() {
    save_text();
    if (std::rename(name_.c_str(), final_name_.c_str()) != 0) cannot_write();
    kept_ = true;
    save_names();
  }
  /// The same if no file has the final name; otherwise throws like refuse_overwrite.
  void take_free_name() {
    save_text();
    if (::link(name_.c_str(), final_name_.c_str()) == 0) return save_names();  // the destructor removes the other name
    if (errno != EEXIST && errno != EPERM && errno != EOPNOTSUPP) cannot_write();
    refuse_overwrite(final_name_, false);
    take_name();  // the file system has no links
  }

 private:
  /// Puts the text on the disk. Some file systems report a full disk only now.
  void save_text() const {
    if (::fsync(descriptor_) != 0) cannot_write();
  }
  /// Puts the names of the folder on the disk, if the folder may be read and its file system can do that.
  void save_names() const {
    const int folder = ::open(folder_of(final_name_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;
    const bool failed = ::fsync(folder) != 0 && errno != EINVAL;
    const int reason = errno;
    ::close(folder);
    errno = reason;
    if (failed) cannot_write();
  }
  [[noreturn]] void cannot_write() const {
    throw std::runtime_error(final_name_.string() + ": cannot be written: " + std::generic_category().message(errno));
  }

  const std::filesystem::path& final_name_;
  std::string name_;
  int descriptor_ = -1;
  bool kept_ = false;
};

}  // namespace

void write_file(const std::filesystem::path& path, const std::string& text, bool force) {
  remove_leftovers(path);
  if (force) return write_file(path, text);
  NewFile file(path);
  file.write(text);
  file.take_free_name();
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

bool is_unfinished(std::string_view name) {
  const std::size_t end = name.rfind(kUnfinished);
  return end != std::string_view::npos && end > 0 && is_process(name.substr(end + kUnfinished.size()));
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
