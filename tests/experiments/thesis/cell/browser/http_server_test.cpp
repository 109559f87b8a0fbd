// SPDX-License-Identifier: GPL-3.0-or-later
// The HTTP server refuses what it must, and continues.
#include "experiments/thesis/cell/browser/http_server.h"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <deque>
#include <future>
#include <latch>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/experiments/support/message_of.h"
#include "tests/experiments/thesis/cell/browser/http_client.h"
#include "tests/experiments/thesis/cell/browser/serving.h"

namespace touchstone::cell::browser {
namespace {

std::atomic<bool> no_descriptors = false;  // for connections: see accept
std::atomic<int> refused_connections = 0;

HttpReply echo(const HttpRequest& r) {
  if (r.path == "/throws") throw std::runtime_error("no such thing");
  return {200, "text/plain", r.method + " " + r.path + " " + r.host + " " + r.body, ""};
}

std::string error_of(const Received& received) { return nlohmann::json::parse(received.body).at("error"); }

class Server : public testing::Test {
 protected:
  void still_serves() const { EXPECT_EQ(ask(serving.port(), "GET", "/after").body, "GET /after " + host() + " "); }
  [[nodiscard]] std::string host() const { return "localhost:" + std::to_string(serving.port()); }
  const Serving serving{echo, {.most_body = 1000, .patience = std::chrono::milliseconds(300)}};
};

TEST_F(Server, HandsOverMethodPathHostAndBody) {
  EXPECT_EQ(ask(serving.port(), "POST", "/a/b?c=d", "text").body, "POST /a/b " + host() + " text");
  EXPECT_EQ(ask(serving.port(), "BREW", "/").body, "BREW / " + host() + " ");
  EXPECT_EQ(send_raw(serving.port(), "GET / HTTP/1.0\r\n\r\n").body, "GET /  ");
}

// Two programs on the way could differ about who is meant.
TEST_F(Server, RefusesAllButOneHost) {
  for (const char* hosts :
       {"", "Host: localhost\r\nHost: localhost\r\n", "Host: localhost\r\nX: y\r\nhost: evil\r\n"}) {
    const Received refused = send_raw(serving.port(), std::string("GET / HTTP/1.1\r\n") + hosts + "\r\n");
    EXPECT_EQ(refused.status, 400U) << hosts;
    EXPECT_EQ(error_of(refused).rfind("a request of HTTP/1.1 has one Host, this one has ", 0), 0U) << hosts;
  }
  still_serves();
}

TEST(Refusal, IsWrittenWhateverItsReason) {
  EXPECT_EQ(refusal(400, "\xff, \xe9\x41").body, "{\"error\":\"\xef\xbf\xbd, \xef\xbf\xbd\x41\"}");
}

// On the same connection, a body after the first reply would be taken for the second one.
TEST_F(Server, SendsNoBodyToHead) {
  const std::string bytes = read_all(serving.port(),
                                     "HEAD / HTTP/1.1\r\nHost: localhost\r\n\r\n"
                                     "GET /second HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  const std::size_t end = bytes.find("\r\n\r\n");
  EXPECT_EQ(bytes.rfind("HTTP/1.1 200 OK\r\n", 0), 0U) << bytes;
  EXPECT_EQ(bytes.compare(end + 4, 17, "HTTP/1.1 200 OK\r\n"), 0) << bytes;
}

TEST_F(Server, RefusesABodyOfOneByteTooMany) {
  EXPECT_EQ(ask(serving.port(), "POST", "/", std::string(1000, 'x')).status, 200U);
  const Received refused = ask(serving.port(), "POST", "/", std::string(1001, 'x'));
  EXPECT_EQ(refused.status, 413U);
  EXPECT_EQ(error_of(refused), "a request's body may have 1000 bytes");
  still_serves();
}

// What is not announced counts too.
TEST_F(Server, RefusesTooMuchInChunks) {
  std::string request = "POST / HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n";
  for (int i = 0; i < 11; ++i) request += "64\r\n" + std::string(100, 'x') + "\r\n";
  EXPECT_EQ(send_raw(serving.port(), request + "0\r\n\r\n").status, 413U);
  still_serves();
}

// The reply must come through although most of the body is never read.
TEST_F(Server, AnswersWhoSendsMegabytes) {
  EXPECT_EQ(ask(serving.port(), "POST", "/", std::string(8U << 20U, 'x')).status, 413U);
  still_serves();
}

TEST_F(Server, RefusesWhatIsNotHttp) {
  for (const char* bytes : {"\x16\x03\x01 hello\r\n\r\n", "GET\r\n\r\n", "GET / HTTP/9.9\r\n\r\n",
                            "GET / HTTP/1.1\r\nContent-Length: many\r\n\r\n", "POST / HTTP/1.1\r\nNo colon\r\n\r\n"}) {
    const Received refused = send_raw(serving.port(), bytes);
    EXPECT_EQ(refused.status, 400U) << bytes;
    EXPECT_EQ(error_of(refused).rfind("this is not HTTP: ", 0), 0U) << bytes;
  }
  still_serves();
}

TEST_F(Server, RefusesALongHead) {
  const Received refused =
      send_raw(serving.port(), "GET / HTTP/1.1\r\nHost: localhost\r\nX: " + std::string(9000, 'x') + "\r\n\r\n");
  EXPECT_EQ(refused.status, 431U);
  std::string many = "GET / HTTP/1.1\r\nHost: localhost\r\n";
  for (int i = 0; i < 1000; ++i) many += "X: 123456\r\n";
  EXPECT_EQ(send_raw(serving.port(), many + "\r\n").status, 431U);
  still_serves();
}

TEST_F(Server, TellsWhatItsHandlerThrows) {
  const Received received = ask(serving.port(), "GET", "/throws");
  EXPECT_EQ(received.status, 500U);
  EXPECT_EQ(error_of(received), "no such thing");
  still_serves();
}

// Reading ends when the server closes: it does not wait for the rest for ever.
TEST_F(Server, CutsOffWhoNeverEnds) {
  EXPECT_EQ(send_raw(serving.port(), "GET / HTTP/1.1\r\nHost: lo").status, 0U);
  EXPECT_EQ(send_raw(serving.port(), "POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 10\r\n\r\nabc").status, 0U);
  still_serves();
}

TEST_F(Server, ServesManyAtOnce) {
  std::vector<std::thread> clients;
  std::vector<std::string> bodies(48);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    clients.emplace_back([&, i] { bodies[i] = ask(serving.port(), "POST", "/", std::to_string(i)).body; });
  for (std::thread& client : clients) client.join();
  for (std::size_t i = 0; i < bodies.size(); ++i) EXPECT_EQ(bodies[i], "POST / " + host() + " " + std::to_string(i));
}

// Patience is far longer than the test: who comes later does not wait for it.
TEST(FullServer, TakesTheOneThatHasBeenIdleLongestForANewOne) {
  const Serving serving(echo, {.patience = std::chrono::minutes(10), .most_connections = 8});
  std::deque<Connection> idle;
  for (int i = 0; i < 8; ++i) idle.emplace_back(serving.port());
  EXPECT_EQ(ask(serving.port(), "GET", "/").status, 200U);
  EXPECT_EQ(idle.front().rest(), "");
  idle.back().send("GET /last HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_EQ(idle.back().receive().status, 200U);
}

// A request that is being answered is not idle.
TEST(FullServer, AnswersWhatItWorksOn) {
  std::promise<void> at_work, go_on;
  const Serving serving(
      [&](const HttpRequest& request) {
        if (request.path == "/slow") at_work.set_value(), go_on.get_future().wait();
        return echo(request);
      },
      {.patience = std::chrono::minutes(10), .most_connections = 4});
  auto slow = std::async(std::launch::async, [&] { return ask(serving.port(), "GET", "/slow").status; });
  at_work.get_future().wait();
  std::deque<Connection> idle;
  for (int i = 0; i < 8; ++i) idle.emplace_back(serving.port());
  EXPECT_EQ(idle[4].rest(), "");
  go_on.set_value();
  EXPECT_EQ(slow.get(), 200U);
}

// More are posted than there are threads for them.
TEST(BusyServer, AnswersAtOnceWhoOnlyLooks) {
  std::promise<void> go_on;
  const std::shared_future<void> gone_on = go_on.get_future().share();
  std::latch at_work(4);
  std::atomic<int> begun = 0;
  const Serving serving(
      [&](const HttpRequest& request) {
        if (request.method == "POST") {
          if (++begun <= 4) at_work.count_down();
          gone_on.wait();
        }
        return echo(request);
      },
      {.patience = std::chrono::minutes(10)});
  std::vector<std::future<unsigned>> posted;
  for (int i = 0; i < 8; ++i)
    posted.push_back(std::async(std::launch::async, [&] { return ask(serving.port(), "POST", "/slow").status; }));
  at_work.wait();
  EXPECT_EQ(ask(serving.port(), "GET", "/").status, 200U);
  go_on.set_value();
  for (auto& each : posted) EXPECT_EQ(each.get(), 200U);
}

// It tries again, but only after a pause, and continues as soon as there are descriptors.
TEST(ServerWithoutDescriptors, DoesNotTryInALoop) {
  const auto begin = std::chrono::steady_clock::now();
  no_descriptors = true;
  const Serving serving(echo);
  for (int seen = 0; seen < 3; seen = refused_connections) refused_connections.wait(seen);
  const int refused = refused_connections;
  EXPECT_LE(refused, (std::chrono::steady_clock::now() - begin) / HttpServer::kPause + 1);
  no_descriptors = false;
  EXPECT_EQ(ask(serving.port(), "GET", "/").status, 200U);
}

// What a user is told to open must lead to the server, which 0.0.0.0 does not everywhere.
TEST(Url, LeadsToTheServer) {
  const auto url = [](const char* host) { return HttpServer(host, 0, echo, {}).url(); };
  EXPECT_EQ(url("127.0.0.1").rfind("http://127.0.0.1:", 0), 0U);
  EXPECT_EQ(url("0.0.0.0").rfind("http://127.0.0.1:", 0), 0U);
}

TEST_F(Server, NamesTheAddressThatItCannotListenAt) {
  const std::string said =
      run_tests::message_of([&] { const HttpServer second("127.0.0.1", serving.port(), echo, {}); });
  EXPECT_TRUE(said.starts_with("cannot listen at 127.0.0.1, port ")) << said;
  EXPECT_THROW(HttpServer("no.such.host.invalid", 0, echo, {}), std::runtime_error);
}

TEST_F(Server, KnowsWhetherOnlyThisMachineReachesIt) {
  EXPECT_TRUE(HttpServer("127.0.0.1", 0, echo, {}).loopback());
  EXPECT_FALSE(HttpServer("0.0.0.0", 0, echo, {}).loopback());
}

}  // namespace

/// Stands for that of the C library, which it calls.
extern "C" int accept(int socket, sockaddr* address, socklen_t* length) {
  if (no_descriptors) {
    ++refused_connections;
    refused_connections.notify_all();
    errno = EMFILE;
    return -1;
  }
  static const auto accept_of_the_library = reinterpret_cast<decltype(&accept)>(dlsym(RTLD_NEXT, "accept"));
  return accept_of_the_library(socket, address, length);
}

}  // namespace touchstone::cell::browser
