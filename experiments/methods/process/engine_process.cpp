// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/process/engine_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <limits>
#include <system_error>
#include <utility>

namespace touchstone::methods {
namespace {

/// Returns the time until the deadline, rounded up; 0 if it has passed.
int milliseconds_until(EngineProcess::Deadline deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now()).count();
  return static_cast<int>(std::clamp<std::int64_t>(left, 0, std::numeric_limits<int>::max()));
}

/// Closes two descriptors that were not released; -1 means released.
struct Ends {
  int* descriptors;
  ~Ends() {
    for (int i = 0; i < 2; ++i)
      if (descriptors[i] >= 0) close(descriptors[i]);
  }
};

}  // namespace

// The input is a socket, not a pipe: writing to a program that has ended then fails for this call only (MSG_NOSIGNAL)
// and does not send a signal to the whole process.
EngineProcess::EngineProcess(const std::string& command) : input_(-1), output_(-1) {
  int input[2], output[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, input) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot reach the engine");
  const Ends inputs{input};
  if (pipe2(output, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "cannot reach the engine");
  const Ends outputs{output};
  supervisor_.emplace(command, input[1], output[1]);
  input_ = std::exchange(input[0], -1);
  output_ = std::exchange(output[0], -1);
}

EngineProcess::~EngineProcess() {
  stop_reading();
  supervisor_.reset();
  close(input_);
}

bool EngineProcess::send(const std::string& line) {
  for (std::size_t sent = 0; sent < line.size();) {
    const ssize_t written = ::send(input_, line.data() + sent, line.size() - sent, MSG_NOSIGNAL);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    sent += static_cast<std::size_t>(written);
  }
  return true;
}

bool EngineProcess::send_by(Deadline deadline, const std::string& line, bool& late) {
  late = false;
  for (std::size_t sent = 0; sent < line.size();) {
    const ssize_t written = ::send(input_, line.data() + sent, line.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (written >= 0) {
      sent += static_cast<std::size_t>(written);
    } else if (errno == EAGAIN) {
      pollfd input{.fd = input_, .events = POLLOUT, .revents = 0};
      late = poll(&input, 1, milliseconds_until(deadline)) == 0;
      if (late) return false;
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

void EngineProcess::end_input() { shutdown(input_, SHUT_WR); }

/// Takes the first line of the unread bytes, of which the first `searched` contain no line end. Drops a line that is
/// too long.
std::optional<std::string> EngineProcess::take_line(std::size_t& searched) {
  const std::size_t found = unread_.find('\n', received_ + searched);
  const std::size_t end = std::min(found, unread_.size());
  searched = end - received_;
  if (searched > kLongestLine) {
    too_long_ = true;
    stop_reading();
    received_ = unread_.size();
    searched = 0;
  }
  if (too_long_ || found == std::string::npos) return std::nullopt;
  std::string line = unread_.substr(received_, searched);
  received_ = end + 1;
  return line;
}

std::optional<std::string> EngineProcess::receive() {
  std::size_t searched = 0;
  do {
    if (auto line = take_line(searched)) return line;
  } while (read_some());
  std::string rest = unread_.substr(received_);
  received_ = unread_.size();
  if (rest.empty()) return std::nullopt;
  return rest;
}

std::optional<std::string> EngineProcess::receive_by(Deadline deadline, bool& late) {
  late = false;
  for (std::size_t searched = 0;;) {
    if (auto line = take_line(searched)) return line;
    const int left = milliseconds_until(deadline);
    if (output_ >= 0 && (left == 0 || !has_news(left))) {
      late = true;
      return std::nullopt;
    }
    if (!read_some()) return receive();  // the rest, without a line end
  }
}

bool EngineProcess::has_unread() {
  if (received_ == unread_.size() && has_news(0)) read_some();
  return received_ < unread_.size();
}

/// Waits no longer than `milliseconds` (-1: forever) for output, or for the end of the program, even if other processes
/// hold the pipe open. Returns whether either occurred.
bool EngineProcess::has_news(int milliseconds) const {
  if (output_ < 0) return false;
  pollfd news[]{{.fd = output_, .events = POLLIN, .revents = 0},
                {.fd = supervisor_->ended(), .events = POLLIN, .revents = 0}};
  return wait_for_events(news, milliseconds);
}

// Closing a socket with unread input resets the connection.
bool EngineProcess::left_unread() const {
  char byte;
  return recv(input_, &byte, 1, MSG_DONTWAIT) < 0 && errno == ECONNRESET;
}

void EngineProcess::stop_reading() {
  if (output_ >= 0) close(output_);
  output_ = -1;
}

/// Waits for output. Returns false if there will be no more.
bool EngineProcess::read_some() {
  while (output_ >= 0 && !has_news(-1)) {
  }
  if (output_ < 0) return false;
  // The output before its end has arrived; other processes that hold the pipe or the socket are not waited for.
  if (supervisor_->ended_within(std::chrono::milliseconds(0))) {
    fcntl(output_, F_SETFL, O_NONBLOCK);
    end_input();
  }
  std::array<char, 65536> bytes;
  ssize_t count = 0;
  while ((count = read(output_, bytes.data(), bytes.size())) < 0 && errno == EINTR) {
  }
  if (count <= 0) {
    stop_reading();
    return false;
  }
  unread_.erase(0, received_);
  received_ = 0;
  unread_.append(bytes.data(), static_cast<std::size_t>(count));
  return true;
}

const std::string& EngineProcess::ending() {
  if (!ending_) ending_ = supervisor_->wait();
  return *ending_;
}

std::optional<std::string> EngineProcess::wait_within(std::chrono::milliseconds time) {
  if (!supervisor_->ended_within(time)) return std::nullopt;
  return ending();
}

}  // namespace touchstone::methods
