// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/process/engine_process.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <limits>
#include <string_view>
#include <system_error>
#include <utility>

#include "experiments/cases/verdict.h"
#include "experiments/methods/process/engine.h"
#include "experiments/run/json.h"
#include "experiments/run/stop_signal.h"
#include "geometry/io/detail/legible.h"

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

std::atomic<bool> is_writing = false, is_interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "used within a signal handler");

[[noreturn]] void leave() {
  constexpr std::string_view message = "touchstone: interrupted\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message.data(), message.size());
  _exit(run::kInterrupted);
}

extern "C" void interrupt_judge(int) {
  run::handle_end_signals(SIG_DFL);
  is_interrupted = true;
  if (!is_writing) leave();
}

constexpr const char* kWell = "ended";

/// A line that an engine printed, read by the rules for cases.
struct Reply {
  std::optional<std::string> id;              ///< of its case; nothing if the key is missing or duplicate
  std::optional<cases::StatedAnswer> answer;  ///< nothing if the line is not a verdict
  std::string echo;                           ///< the beginning of the line, printable, preceded by its fault if known
};

Reply read_reply(const std::string& line) {
  Reply reply{.id = {}, .answer = {}, .echo = io::legible(line)};
  try {
    const run::StrictJson read = run::read_strict_json(line);
    if (!read.value.is_object()) return reply;
    const auto id = read.value.find("id");
    if (id != read.value.end() && id->is_string() && !read.ambiguous.contains("id")) reply.id = id->get<std::string>();
    if (read.duplicate_key)
      reply.echo = "duplicate key \"" + io::legible(*read.duplicate_key) + "\" in one object: " + reply.echo;
    else if (reply.id && !read.too_deep)
      reply.answer = cases::stated_in(read.value);
  } catch (const run::NotJson&) {
    // The reply echoes the line.
  }
  return reply;
}

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

KillEngineOnSignal::KillEngineOnSignal() { run::handle_end_signals(interrupt_judge); }

KillEngineOnSignal::~KillEngineOnSignal() { run::handle_end_signals(SIG_DFL); }

DeferSignals::DeferSignals() { is_writing = true; }

DeferSignals::~DeferSignals() {
  is_writing = false;
  if (is_interrupted) leave();
}

SupervisedEngine::SupervisedEngine(std::string command, std::chrono::milliseconds time_limit)
    : command_(std::move(command)), time_limit_(time_limit) {}

SupervisedEngine::Result SupervisedEngine::ask(const std::string& id, const std::string& line) {
  Result result;
  const auto text = reply_to(line, result.reason, result.ended_before);
  if (!text) return result;
  Reply reply = read_reply(*text);
  if (reply.id == id && reply.answer) {
    result.answer = std::move(reply.answer);
  } else {
    result.reason = "not a verdict on this case: " + reply.echo;
    stop();  // an engine that is out of step would remain so for every later case
  }
  return result;
}

/// Returns the line that it prints for a case, or nothing and a reason.
std::optional<std::string> SupervisedEngine::reply_to(const std::string& line, std::string& reason,
                                                      std::string& ended_before) {
  for (;;) {
    const bool fresh = !engine_;
    if (fresh) engine_.emplace(command_);
    const auto deadline = in_time();
    bool late = false;
    std::optional<std::string> reply;
    const bool sent = engine_->send_by(deadline, line + '\n', late);
    if (sent) reply = engine_->receive_by(deadline, late);
    has_printed_ |= reply.has_value();
    if (reply) return reply;
    if (late) {
      reason = fmt::format("no verdict within {:g} s", 1e-3 * static_cast<double>(time_limit_.count()));
      stop();
      return std::nullopt;
    }
    if (engine_->too_long()) {
      reason = EngineProcess::kTooLong;
      stop();
      return std::nullopt;
    }
    engine_->end_input();
    const std::string ending = ending_of(*engine_);
    const bool unread = !sent || engine_->left_unread();
    engine_.reset();
    if (fresh || !unread) {
      reason = ending + " without a verdict";
      return std::nullopt;
    }
    if (ending != kWell) ended_before = ending;
  }
}

bool SupervisedEngine::has_surplus() {
  const bool surplus = engine_ && engine_->has_unread();
  if (surplus) stop();
  return surplus;
}

/// Ends it; the next case restarts it.
void SupervisedEngine::stop() {
  if (engine_) engine_->kill();
  engine_.reset();
}

std::string SupervisedEngine::end() {
  if (!engine_) return {};
  engine_->end_input();
  bool late = false;
  const bool surplus = engine_->receive_by(in_time(), late) || engine_->too_long();
  if (late) {
    stop();
    return "does not end with its input";
  }
  const std::string ending = ending_of(*engine_);
  engine_.reset();
  if (surplus) return "printed more lines than there were cases";
  return ending == kWell ? "" : ending;
}

EngineProcess::Deadline SupervisedEngine::in_time() const { return std::chrono::steady_clock::now() + time_limit_; }

/// Returns how an engine ended that has closed its output or will not be read any more; it has the time limit to end.
std::string SupervisedEngine::ending_of(EngineProcess& engine) const {
  engine.stop_reading();
  const auto ending = engine.wait_within(time_limit_);
  if (!ending) {
    engine.kill();
    return "closed its output and did not end";
  }
  if (!has_printed_) require_started(command_, *ending);
  return ending->empty() ? kWell : "ended with " + *ending;
}

}  // namespace touchstone::methods
