// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/engine.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>

namespace touchstone::judge {

// The input is a socket, not a pipe: writing to a program that has gone away is then an error for this call alone
// (MSG_NOSIGNAL) and no signal for the whole process.
Engine::Engine(const std::string& command) : process_(-1), input_(-1), output_(nullptr) {
  int input[2], output[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, input) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot reach the engine");
  if (pipe2(output, O_CLOEXEC) != 0) {
    close(input[0]);
    close(input[1]);
    throw std::system_error(errno, std::generic_category(), "cannot reach the engine");
  }
  process_ = fork();
  if (process_ == 0) {
    dup2(input[1], STDIN_FILENO);
    dup2(output[1], STDOUT_FILENO);
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  const int error = errno;
  close(input[1]);
  close(output[1]);
  input_ = input[0];
  output_ = fdopen(output[0], "r");
  if (process_ < 0) throw std::system_error(error, std::generic_category(), "cannot start the engine");
}

Engine::~Engine() {
  end_input();
  (void)wait();
  close(input_);
  std::fclose(output_);
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

void Engine::end_input() { shutdown(input_, SHUT_WR); }

std::optional<std::string> Engine::receive() {
  char* line = nullptr;
  std::size_t capacity = 0;
  const ssize_t length = getline(&line, &capacity, output_);
  std::optional<std::string> result;
  if (length >= 0) {
    result.emplace(line, static_cast<std::size_t>(length));
    if (result->ends_with('\n')) result->pop_back();
  }
  std::free(line);
  return result;
}

std::string Engine::wait() {
  if (process_ < 0) return {};
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {}
  process_ = -1;
  if (WIFSIGNALED(status)) return "signal " + std::to_string(WTERMSIG(status));
  if (WEXITSTATUS(status) != 0) return "exit status " + std::to_string(WEXITSTATUS(status));
  return {};
}

}  // namespace touchstone::judge
