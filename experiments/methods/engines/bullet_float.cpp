// SPDX-License-Identifier: GPL-3.0-or-later
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <system_error>

#include "experiments/methods/engines/engines.h"
#include "experiments/methods/engines/triangle_method.h"

namespace touchstone::methods {
namespace {

[[noreturn]] void fail(int error) {
  throw std::system_error(error, std::generic_category(), "bullet-float: " TOUCHSTONE_BULLET_FLOAT);
}

/// The program of bullet_float_program.cpp, shared by all threads. A query consists of the number of triangles (32
/// bits), the ball and the triangles (doubles), in the byte order of this machine; the answer is y or n.
class Program {
 public:
  Program() {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail(errno);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    char name[] = TOUCHSTONE_BULLET_FLOAT;
    char* const arguments[]{name, nullptr};
    const int error = posix_spawn(&process_, name, &actions, nullptr, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    socket_ = ends[0];
    if (error != 0) {
      close(socket_);
      fail(error);
    }
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() {
    close(socket_);  // ends its input
    waitpid(process_, nullptr, 0);
  }

  bool ask(const std::vector<char>& query) {
    const std::lock_guard lock(mutex_);
    for (std::size_t sent = 0; sent < query.size();) {
      const ssize_t some = ::send(socket_, query.data() + sent, query.size() - sent, MSG_NOSIGNAL);
      if (some < 0 && errno != EINTR) fail(errno);
      if (some > 0) sent += static_cast<std::size_t>(some);
    }
    char reply = 0;
    ssize_t received = 0;
    do {
      received = read(socket_, &reply, 1);
    } while (received < 0 && errno == EINTR);
    if (received != 1) fail(received < 0 ? errno : EPIPE);
    return reply == 'y';
  }

 private:
  std::mutex mutex_;
  pid_t process_ = -1;
  int socket_ = -1;
};

class Triangles : public TriangleSet {
 public:
  explicit Triangles(const std::vector<Triangle>& triangles) {
    append(static_cast<std::uint32_t>(triangles.size()));
    for (std::size_t i = 0; i < 4; ++i) append(0.0);  // placeholder for the ball
    for (const Triangle& t : triangles)
      for (const Eigen::Vector3d& v : {t.a, t.b, t.c})
        for (const double x : v) append(x);
  }

  [[nodiscard]] std::optional<bool> contact(const Ball& ball) const override {
    static Program program;
    const double sphere[]{ball.center.x(), ball.center.y(), ball.center.z(), ball.radius};
    std::vector<char> query = query_;
    std::memcpy(query.data() + sizeof(std::uint32_t), sphere, sizeof sphere);
    return program.ask(query);
  }

 private:
  template <class Number>
  void append(Number number) {
    const char* bytes = reinterpret_cast<const char*>(&number);
    query_.insert(query_.end(), bytes, bytes + sizeof number);
  }

  std::vector<char> query_;
};

}  // namespace

void add_bullet_float(MethodList& list) {
  list.push_back(triangle_set_method(
      "bullet-float", "Bullet's sphere against triangle, its float build, which runs as a program of its own",
      [](std::vector<Triangle> triangles) -> std::unique_ptr<TriangleSet> {
        return std::make_unique<Triangles>(triangles);
      }));
}

}  // namespace touchstone::methods
