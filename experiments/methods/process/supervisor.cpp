// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdint>
#include <limits>
#include <system_error>

#include "experiments/methods/process/engine_process.h"

namespace touchstone::methods {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kPatience{2};  // for processes that do not end when killed
constexpr int kNotStarted = 127;              // the value that shells use

/// Sends SIGKILL to every child of this process. Returns whether waiting for the end of a child makes sense.
///
/// A process that has received SIGKILL cannot start another: nothing has to be stopped first.
bool kill_children() {
  const int file = open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  bool any = false, killed = false;
  pid_t child = 0;
  char text[4096];
  for (ssize_t count; (count = read(file, text, sizeof text)) > 0;)
    for (ssize_t i = 0; i < count; ++i) {
      if (text[i] != ' ') {
        child = 10 * child + (text[i] - '0');
        continue;
      }
      any = true;
      if (kill(child, SIGKILL) == 0) killed = true;
      child = 0;
    }
  close(file);
  return killed || !any;  // if the list is empty: it may miss a child while another ends
}

/// The process between the judge and the shell. It comes from a fork, perhaps of a process with many threads, and so
/// calls only fork and functions that a signal handler may call.
class Adopter {
 public:
  /// `control` is its end of the connection to the judge.
  explicit Adopter(int control) : control_(control) {}

  /// Runs the command with the signal mask `mask` to its end.
  [[noreturn]] void run(const char* command, int input, int output, const sigset_t& mask) {
    setpgid(0, 0);                        // signals to the group of the judge or the shell do not reach it
    prctl(PR_SET_NAME, "judge-adopter");  // `pkill touchstone` does not reach it, either
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    std::signal(SIGCHLD, SIG_DFL);  // with SIGCHLD ignored, children could not be waited for
    start(command, input, output, mask);
    if (shell_ > 0) {
      watch();
      end_all();
      send(control_, &status_, sizeof status_, MSG_NOSIGNAL);
    }
    _exit(0);
  }

 private:
  void start(const char* command, int input, int output, const sigset_t& mask) {
    const pid_t own = getpid();
    shell_ = fork();
    if (shell_ == 0) {
      setpgid(0, 0);
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (getppid() != own) _exit(kNotStarted);  // the parent has already ended
      dup2(input, STDIN_FILENO);
      dup2(output, STDOUT_FILENO);
      std::signal(SIGPIPE, SIG_DFL);  // an ignored signal stays ignored, and EngineProcess::stop_reading relies on it
      sigprocmask(SIG_SETMASK, &mask, nullptr);
      execl("/bin/sh", "sh", "-c", command, static_cast<char*>(nullptr));
      _exit(kNotStarted);
    }
    const int error = shell_ < 0 ? errno : 0;
    if (shell_ > 0) setpgid(shell_, shell_);  // in both processes: either may run first
    // Descriptors that it holds open do not end for others, such as the connections of other supervisors.
    dup2(control_, STDIN_FILENO);
    control_ = STDIN_FILENO;
    close_range(STDIN_FILENO + 1, UINT_MAX, 0);
    sigset_t child;
    sigemptyset(&child);
    sigaddset(&child, SIGCHLD);
    child_ended_ = signalfd(-1, &child, SFD_NONBLOCK | SFD_CLOEXEC);
    send(control_, &error, sizeof error, MSG_NOSIGNAL);
  }

  /// Waits until the shell or the judge has ended, or the judge requests the end.
  void watch() {
    pollfd events[]{{.fd = control_, .events = POLLIN, .revents = 0},
                    {.fd = child_ended_, .events = POLLIN, .revents = 0}};
    while (!shell_ended_ && events[0].revents == 0) {
      poll(events, 2, -1);
      (void)reap();
    }
  }

  /// Kills children until none is left: this process adopts the children of a child that has ended.
  void end_all() {
    const auto deadline = Clock::now() + kPatience;
    if (!shell_ended_) kill(-shell_, SIGKILL);
    while (reap() && kill_children() && Clock::now() < deadline) {
      pollfd event{.fd = child_ended_, .events = POLLIN, .revents = 0};
      poll(&event, 1, 10);
    }
  }

  /// Reaps each child that has ended. Returns whether others are left.
  bool reap() {
    signalfd_siginfo news;
    while (read(child_ended_, &news, sizeof news) > 0) {
    }
    for (;;) {
      siginfo_t end;
      end.si_pid = 0;
      if (waitid(P_ALL, 0, &end, WEXITED | WNOHANG | WNOWAIT) < 0) return false;
      if (end.si_pid == 0) return true;
      const bool is_shell = end.si_pid == shell_ && !shell_ended_;
      if (is_shell) kill(-shell_, SIGKILL);  // the group id stays reserved until the shell is reaped
      waitpid(end.si_pid, is_shell ? &status_ : nullptr, 0);
      shell_ended_ |= is_shell;
    }
  }

  int control_, child_ended_ = -1;
  pid_t shell_ = -1;
  int status_ = SIGKILL;  ///< if the shell does not end
  bool shell_ended_ = false;
};

/// Waits for a number from the other end. Returns false if that was closed before.
bool receive(int control, int& number) {
  ssize_t count = 0;
  while ((count = recv(control, &number, sizeof number, MSG_WAITALL)) < 0 && errno == EINTR) {
  }
  return count == sizeof number;
}

}  // namespace

Supervisor::Supervisor(const std::string& command, int input, int output) {
  const auto fail = [](int error) {
    throw std::system_error(error, std::generic_category(), "cannot start the engine");
  };
  int control[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, control) != 0) fail(errno);
  sigset_t all, mask;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &mask);  // the new process starts with all signals blocked
  process_ = fork();
  if (process_ == 0) Adopter(control[1]).run(command.c_str(), input, output, mask);
  int error = errno;
  pthread_sigmask(SIG_SETMASK, &mask, nullptr);
  close(control[1]);
  control_ = control[0];
  if (process_ > 0) wake();
  if (process_ > 0 && !receive(control_, error)) error = ECHILD;
  if (process_ > 0 && error == 0) return;
  close(control_);
  if (process_ > 0) waitpid(process_, nullptr, 0);
  fail(error);
}

Supervisor::~Supervisor() {
  kill();
  (void)wait();
}

void Supervisor::kill() {
  killed_ = true;
  shutdown(control_, SHUT_WR);
  if (process_ > 0) ::kill(process_, SIGCONT);  // the command may have stopped it
}

bool Supervisor::ended_within(std::chrono::milliseconds time) const {
  pollfd event{.fd = control_, .events = POLLIN, .revents = 0};
  return control_ < 0 || wait_for_events({&event, 1}, Clock::now() + time);
}

void Supervisor::wake() const {
  while (!ended_within(std::chrono::milliseconds(100))) ::kill(process_, SIGCONT);
}

std::string Supervisor::wait() {
  if (process_ < 0) return {};
  if (killed_) wake();
  int status = 0, own = 0;
  const bool told = receive(control_, status);
  close(control_);
  control_ = -1;
  while (waitpid(process_, &own, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (!told) status = own;  // it was killed, and the shell with it
  if (WIFSIGNALED(status)) return "signal " + std::to_string(WTERMSIG(status));
  if (WEXITSTATUS(status) != 0) return "exit status " + std::to_string(WEXITSTATUS(status));
  return {};
}

bool wait_for_events(std::span<pollfd> events, Deadline deadline) {
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    const auto wait = std::clamp<std::int64_t>(left, 0, std::numeric_limits<int>::max());
    const int found = poll(events.data(), events.size(), static_cast<int>(wait));
    if (found > 0) return true;
    if (found == 0 ? Clock::now() >= deadline : errno != EINTR) return false;
  }
}

}  // namespace touchstone::methods
