// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace touchstone::cell::browser {

struct HttpRequest {
  std::string method;  ///< `GET`, `POST`, ...
  std::string path;    ///< without the query, which begins at a question mark
  std::string host;    ///< the header, with the port if given; empty if an HTTP/1.0 request has none
  std::string content_type;
  std::string body;
};

struct HttpReply {
  unsigned status = 200;
  std::string content_type, body;
  std::string allow;  ///< the allowed methods, for status 405
};

/// Returns a reply whose body is a JSON object with the reason as its `error`. U+FFFD replaces bytes of the reason that
/// are not UTF-8.
[[nodiscard]] HttpReply refusal(unsigned status, const std::string& reason, std::string allow = "");

/// A server for HTTP/1.1, built on Boost.Beast.
///
/// Replies with status 400 to input that is not HTTP and to HTTP/1.1 without exactly one Host, with 431 to a head of
/// more than 8 kB, with 413 to a body of more than `most_body` bytes, chunked or not, and with 500 if the handler
/// throws. Each of these replies is a JSON object whose `error` gives the reason. A reply to HEAD has no body, whatever
/// the handler returns. Cuts off a client that takes longer than `patience` to send a request or to receive the reply
/// and, if there are more than `most_connections`, the connection that has been idle longest. Then continues to serve.
/// If it cannot accept a connection, because the process has no free descriptor, it tries again after `kPause`.
class HttpServer {
 public:
  static constexpr std::chrono::milliseconds kPause{100};
  using Handler = std::function<HttpReply(const HttpRequest&)>;
  struct Limits {
    std::size_t most_body = std::size_t{64} * 1024;
    std::chrono::milliseconds patience = std::chrono::seconds(10);
    std::size_t most_connections = 64;
  };

  /// Starts to listen; port 0 chooses a free one. Several threads call the handler concurrently. POST has threads of
  /// its own: other methods never wait for what is posted. Throws std::runtime_error, which names the address, if the
  /// server cannot listen there.
  HttpServer(const std::string& host, std::uint16_t port, Handler handler, const Limits& limits);
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;
  ~HttpServer();

  [[nodiscard]] std::uint16_t port() const;
  /// Returns the URL of the page, for a browser on this machine.
  [[nodiscard]] std::string url() const;
  /// Returns whether only this machine can reach the server.
  [[nodiscard]] bool loopback() const;

  /// Serves until `stop` is set. Notices that within a tenth of a second, but waits for handlers that are at work.
  /// Their clients, and those whose requests wait for a thread, may get no reply.
  void run(const std::atomic<bool>& stop);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace touchstone::cell::browser
