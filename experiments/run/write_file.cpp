// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/write_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string_view>
#include <system_error>

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

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

bool make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  const bool made = std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw std::runtime_error(folder.string() + ": cannot be made: " + (error ? error.message() : "it is not a folder"));
  return made;
}

}  // namespace touchstone::run
