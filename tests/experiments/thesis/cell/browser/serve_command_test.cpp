// SPDX-License-Identifier: GPL-3.0-or-later
// `touchstone cell serve` before it serves.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/commands.h"
#include "experiments/program/output.h"
#include "experiments/program/program.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/thesis/cell/browser/aristo.h"
#include "tests/experiments/thesis/cell/browser/http_client.h"
#include "tests/experiments/thesis/cell/browser/serving.h"

namespace touchstone::cell::browser {
namespace {

run_tests::Ran serve(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "serve");
  return run_tests::run_captured(commands::cell_command, std::move(arguments));
}

TEST(ServeCommand, NamesTheKeyOfABadCellFile) {
  const run_tests::Scratch scratch;
  const std::string file = scratch.path / "bad.json";
  program::write_file(file, R"({"nam": "x"})");
  const run_tests::Ran ran = serve({file});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.err.rfind(file + ": nam: is an unknown key", 0), 0U) << ran.err;
  EXPECT_NE(serve({aristo().file.string(), "--set", "storage.height=-1"}).err.find("storage.height: "),
            std::string::npos);
}

TEST(ServeCommand, NamesThePortThatIsTaken) {
  const Serving other([](const HttpRequest&) { return HttpReply{}; });
  const std::string port = std::to_string(other.port());
  const run_tests::Ran ran = serve({aristo().file.string(), "--port", port});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.err.rfind("cannot listen at 127.0.0.1, port " + port, 0), 0U) << ran.err;
}

/// `cell serve` in a process of its own.
class ServingProcess {
 public:
  ServingProcess() {
    int pipe[2];
    if (::pipe(pipe) != 0) throw std::runtime_error("no pipe");
    process_ = ::fork();
    if (process_ == 0) {
      for (const int signal : program::kEndSignals) std::signal(signal, SIG_DFL);
      ::dup2(pipe[1], STDOUT_FILENO);
      ::_exit(commands::cell_command()({"serve", aristo().file.string(), "--port", "0"}));
    }
    ::close(pipe[1]);
    std::string said;
    for (char c = 0; ::read(pipe[0], &c, 1) == 1 && c != '\n';) said += c;
    ::close(pipe[0]);
    port_ = static_cast<std::uint16_t>(std::stoi(said.substr(said.rfind(':') + 1)));
  }

  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// Sends the signal. Returns the status with which the process ends, as waitpid has it.
  [[nodiscard]] int end(int signal) const {
    int status = 0;
    if (::kill(process_, signal) != 0 || ::waitpid(process_, &status, 0) != process_)
      throw std::runtime_error("no process");
    return status;
  }

 private:
  pid_t process_;
  std::uint16_t port_ = 0;
};

TEST(ServeCommand, AbandonsARunWhereASignalEndsIt) {
  const ServingProcess serving;
  Connection client(serving.port());
  const std::string setting = R"({"step": 0.05, "drive": "cgal-epeck"})";  // takes long
  client.send("POST /api/run HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: " +
              std::to_string(setting.size()) + "\r\n\r\n" + setting);
  EXPECT_EQ(ask(serving.port(), "GET", "/api/cell").status, 200U);  // the run has begun
  const auto begin = std::chrono::steady_clock::now();
  const int status = serving.end(SIGINT);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;
}

TEST(ServeCommand, NamesAMethodThatThereIsNot) {
  EXPECT_NE(serve({aristo().file.string(), "--methods", "guess"}).err.find("guess"), std::string::npos);
}

}  // namespace
}  // namespace touchstone::cell::browser
