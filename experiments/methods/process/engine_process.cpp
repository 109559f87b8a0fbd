// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/process/engine_process.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <utility>

#include "experiments/cases/verdict.h"
#include "experiments/methods/process/engine.h"
#include "experiments/program/json.h"
#include "experiments/program/program.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::methods {
namespace {

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
  _exit(program::kInterrupted);
}

extern "C" void interrupt_judge(int) {
  program::handle_end_signals(SIG_DFL);
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
    const program::StrictJson read = program::read_strict_json(line);
    if (!read.value.is_object()) return reply;
    const auto id = read.value.find("id");
    if (id != read.value.end() && id->is_string() && !read.ambiguous.contains("id")) reply.id = id->get<std::string>();
    if (read.duplicate_key)
      reply.echo = "duplicate key \"" + io::legible(*read.duplicate_key) + "\" in one object: " + reply.echo;
    else if (reply.id && !read.too_deep)
      reply.answer = cases::stated_in(read.value);
  } catch (const program::NotJson&) {
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

bool EngineProcess::send(const std::string& line, Deadline deadline) {
  late_ = false;
  for (std::size_t sent = 0; sent < line.size();) {
    const ssize_t written = ::send(input_, line.data() + sent, line.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (written >= 0) {
      sent += static_cast<std::size_t>(written);
    } else if (errno == EAGAIN) {
      pollfd input{.fd = input_, .events = POLLOUT, .revents = 0};
      late_ = !wait_for_events({&input, 1}, deadline);
      if (late_) return false;
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

std::optional<std::string> EngineProcess::receive(Deadline deadline) {
  late_ = false;
  for (std::size_t searched = 0;;) {
    if (auto line = take_line(searched)) return line;
    late_ = output_ >= 0 && (std::chrono::steady_clock::now() >= deadline || !has_news(deadline));
    if (late_) return std::nullopt;
    if (!read_some()) break;
  }
  std::string rest = unread_.substr(received_);
  received_ = unread_.size();
  return rest.empty() ? std::nullopt : std::optional(std::move(rest));
}

bool EngineProcess::has_unread() {
  if (received_ == unread_.size() && has_news(Deadline())) read_some();
  return received_ < unread_.size();
}

/// Waits until the deadline for output, or for the end of the program, even if other processes hold the pipe open.
/// Returns whether either occurred.
bool EngineProcess::has_news(Deadline deadline) const {
  if (output_ < 0) return false;
  pollfd news[]{{.fd = output_, .events = POLLIN, .revents = 0},
                {.fd = supervisor_->ended(), .events = POLLIN, .revents = 0}};
  return wait_for_events(news, deadline);
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

/// Reads the output that has_news found. Returns false if there will be no more.
bool EngineProcess::read_some() {
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

KillEngineOnSignal::KillEngineOnSignal() { program::handle_end_signals(interrupt_judge); }

KillEngineOnSignal::~KillEngineOnSignal() { program::handle_end_signals(SIG_DFL); }

DeferSignals::DeferSignals() { is_writing = true; }

DeferSignals::~DeferSignals() {
  is_writing = false;
  if (is_interrupted) leave();
}

SupervisedEngine::Result SupervisedEngine::ask(const std::string& id, const std::string& line) {
  Result result;
  for (;;) {
    const bool fresh = !engine_;
    if (fresh) engine_.emplace(command_);
    const Deadline deadline = in_time();
    const bool sent = engine_->send(line + '\n', deadline);
    const std::optional<std::string> printed = sent ? engine_->receive(deadline) : std::nullopt;
    has_printed_ |= printed.has_value();
    if (printed) {
      Reply reply = read_reply(*printed);
      if (reply.id == id && reply.answer) {
        result.answer = std::move(reply.answer);
        return result;
      }
      result.reason = "not a verdict on this case: " + reply.echo;  // it would remain out of step for every later case
    } else if (engine_->late()) {
      result.reason = fmt::format("no verdict within {:g} s", 1e-3 * static_cast<double>(time_limit_.count()));
    } else if (engine_->too_long()) {
      result.reason = EngineProcess::kTooLong;
    }
    if (!result.reason.empty()) {
      engine_.reset();
      return result;
    }
    engine_->end_input();
    const std::string ending = end_of_process();
    const bool unread = !sent || engine_->left_unread();
    engine_.reset();
    if (fresh || !unread) {
      result.reason = ending + " without a verdict";
      return result;
    }
    if (ending != kWell) result.ended_before = ending;
  }
}

bool SupervisedEngine::has_surplus() {
  const bool surplus = engine_ && engine_->has_unread();
  if (surplus) engine_.reset();
  return surplus;
}

std::string SupervisedEngine::end() {
  if (!engine_) return {};
  engine_->end_input();
  const bool surplus = engine_->receive(in_time()) || engine_->too_long(), late = engine_->late();
  const std::string ending = late ? "" : end_of_process();
  engine_.reset();
  if (late) return "does not end with its input";
  if (surplus) return "printed more lines than there were cases";
  return ending == kWell ? "" : ending;
}

/// Returns how the process ended that has closed its input or output; it has the time limit to end.
std::string SupervisedEngine::end_of_process() {
  engine_->stop_reading();
  const auto ending = engine_->wait_within(time_limit_);
  if (!ending) return "closed its input or output and went on";
  if (!has_printed_) require_started(command_, *ending);
  return ending->empty() ? kWell : "ended with " + *ending;
}

}  // namespace touchstone::methods
