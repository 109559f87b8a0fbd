// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/engine.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <limits>
#include <system_error>

#include "experiments/judge/interruption.h"

extern "C" {  // which the header of glibc 2.36 forgets
#include <sys/pidfd.h>
}

namespace touchstone::judge {
namespace {

/// Rounded up; 0 where it is past.
int milliseconds_until(Engine::Deadline deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now()).count();
  return static_cast<int>(std::clamp<std::int64_t>(left, 0, std::numeric_limits<int>::max()));
}

}  // namespace

// The input is a socket, not a pipe: writing to a program that has gone away is then an error for this call alone
// (MSG_NOSIGNAL) and no signal for the whole process.
Engine::Engine(const std::string& command) : process_(-1), input_(-1), output_(-1) {
  int input[2], output[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, input) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot reach the engine");
  if (pipe2(output, O_CLOEXEC) != 0) {
    close(input[0]);
    close(input[1]);
    throw std::system_error(errno, std::generic_category(), "cannot reach the engine");
  }
  const pid_t judge = getpid();
  process_ = fork();
  if (process_ == 0) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != judge) _exit(127);  // it ended before
    dup2(input[1], STDIN_FILENO);
    dup2(output[1], STDOUT_FILENO);
    std::signal(SIGPIPE, SIG_DFL);  // an ignored signal stays ignored, and stop_reading relies on it
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  const int error = errno;
  close(input[1]);
  close(output[1]);
  input_ = input[0];
  output_ = output[0];
  if (process_ > 0) {
    setpgid(process_, process_);  // here too: whichever of both comes first
    set_engine_group(process_);
  }
  if (process_ < 0) {
    close(input_);
    close(output_);
    throw std::system_error(error, std::generic_category(), "cannot start the engine");
  }
}

Engine::~Engine() {
  stop_reading();
  kill();
  (void)wait();
  close(input_);
}

bool Engine::send(const std::string& line) {
  for (std::size_t sent = 0; sent < line.size();) {
    const ssize_t written = ::send(input_, line.data() + sent, line.size() - sent, MSG_NOSIGNAL);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    sent += static_cast<std::size_t>(written);
  }
  return true;
}

bool Engine::send_by(Deadline deadline, const std::string& line, bool& late) {
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

void Engine::end_input() { shutdown(input_, SHUT_WR); }

/// The first line of what is unread, whose first bytes, so many, have no end of a line. Drops one that is too long.
std::optional<std::string> Engine::take_line(std::size_t& searched) {
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

std::optional<std::string> Engine::receive() {
  std::size_t searched = 0;
  do {
    if (auto line = take_line(searched)) return line;
  } while (read_some());
  std::string rest = unread_.substr(received_);
  received_ = unread_.size();
  if (rest.empty()) return std::nullopt;
  return rest;
}

std::optional<std::string> Engine::receive_by(Deadline deadline, bool& late) {
  late = false;
  for (std::size_t searched = 0;;) {
    if (auto line = take_line(searched)) return line;
    const int left = milliseconds_until(deadline);
    if (output_ >= 0 && (left == 0 || !has_more_within(std::chrono::milliseconds(left)))) {
      late = true;
      return std::nullopt;
    }
    if (!read_some()) return receive();  // what is left without the end of a line
  }
}

bool Engine::drop_unread() {
  while (has_more_within(std::chrono::milliseconds(0)) && read_some()) {
  }
  const bool any = received_ < unread_.size();
  received_ = unread_.size();
  return any;
}

bool Engine::has_more_within(std::chrono::milliseconds time) const {
  pollfd output{.fd = output_, .events = POLLIN, .revents = 0};
  return output_ >= 0 && poll(&output, 1, static_cast<int>(time.count())) > 0;
}

bool Engine::read_ahead(std::size_t most) {
  while (unread_.size() - received_ < most && has_more_within(std::chrono::milliseconds(0)) && read_some()) {
  }
  return output_ >= 0 && unread_.size() - received_ >= most;
}

// A socket is reset by who closes it with something unread in it.
bool Engine::left_unread() const {
  char byte;
  return recv(input_, &byte, 1, MSG_DONTWAIT) < 0 && errno == ECONNRESET;
}

void Engine::kill() {
  if (process_ >= 0) ::kill(-process_, SIGKILL);
}

void Engine::stop_reading() {
  if (output_ >= 0) close(output_);
  output_ = -1;
}

/// Waits for some of its output; false if there will be none.
bool Engine::read_some() {
  if (output_ < 0) return false;
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

std::optional<std::string> Engine::wait_within(std::chrono::milliseconds time) {
  const int process = process_ < 0 ? -1 : pidfd_open(process_, 0);
  if (process >= 0) {
    pollfd ended{.fd = process, .events = POLLIN, .revents = 0};
    const bool in_time = poll(&ended, 1, static_cast<int>(time.count())) > 0;
    close(process);
    if (!in_time) return std::nullopt;
  }
  return wait();
}

std::string Engine::wait() {
  if (process_ < 0) return {};
  siginfo_t end;
  while (waitid(P_PID, static_cast<id_t>(process_), &end, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
  }
  kill();  // what it has started; the group is its own until its status is taken
  set_engine_group(0);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (WIFSIGNALED(status)) return "signal " + std::to_string(WTERMSIG(status));
  if (WEXITSTATUS(status) != 0) return "exit status " + std::to_string(WEXITSTATUS(status));
  return {};
}

}  // namespace touchstone::judge
