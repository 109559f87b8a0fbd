// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/judgement.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "experiments/run/input.h"
#include "experiments/run/state.h"

namespace touchstone::judge {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw std::runtime_error(file.string() + ": " + why);
}

[[noreturn]] void cannot_write(const std::filesystem::path& file) {
  refuse(file, "cannot be written: " + std::generic_category().message(errno));
}

}  // namespace

Judgement::Judgement(std::filesystem::path file, std::uint64_t bytes) : file_(std::move(file)) {
  std::error_code error;
  if (bytes == 0) {
    std::filesystem::remove(file_, error);  // a symbolic link is replaced, not followed
  } else {
    const bool is_ours = std::filesystem::symlink_status(file_, error).type() == std::filesystem::file_type::regular;
    if (!is_ours || std::filesystem::file_size(file_) < bytes) refuse(file_, "is shorter than its checkpoint says");
    std::filesystem::resize_file(file_, bytes);
  }
  stream_.open(file_, std::ios::binary | std::ios::app);
  if (!stream_) cannot_write(file_);
}

void Judgement::add(const Entry& entry) {
  const std::string text = run::archived(entry);
  stream_ << text.size() << ' ' << text << '\n';
}

std::uint64_t Judgement::save() {
  const int descriptor = stream_.flush() ? ::open(file_.c_str(), O_WRONLY | O_CLOEXEC) : -1;
  if (descriptor < 0) cannot_write(file_);
  const bool saved = ::fsync(descriptor) == 0;
  ::close(descriptor);
  if (!saved) cannot_write(file_);
  return std::filesystem::file_size(file_);
}

void read_judgement(const std::filesystem::path& file, const std::function<void(Entry&&)>& take) {
  std::ifstream stream = run::open_file(file);
  const std::uint64_t all = std::filesystem::file_size(file);
  std::string text;
  for (std::size_t size = 0; stream >> size;) {
    stream.get();
    Entry entry;
    try {
      text.resize(std::min(size, all));
      if (size > all || !stream.read(text.data(), static_cast<std::streamsize>(size)))
        throw run::DamagedArchive("it ends too early");
      run::restore(text, entry);
    } catch (const run::DamagedArchive& error) {
      refuse(file, std::string("is damaged: ") + error.what());
    }
    take(std::move(entry));
  }
  if (!stream.eof()) refuse(file, "is damaged: it has no entry where one should begin");
}

}  // namespace touchstone::judge
