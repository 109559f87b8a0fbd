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
  std::string path;    ///< without what begins at a question mark
  std::string host;    ///< the header, with the port if it has one; empty if HTTP/1.0 has none
  std::string content_type;
  std::string body;
};

struct HttpReply {
  unsigned status = 200;
  std::string content_type, body;
  std::string allow;  ///< methods, of 405
};

/// A reply whose body is a JSON object: its `error` is the reason; U+FFFD stands for what is not UTF-8 of it.
[[nodiscard]] HttpReply refusal(unsigned status, const std::string& reason, std::string allow = "");

/// Answers requests of HTTP/1.1, by Boost.Beast.
///
/// What is no HTTP is answered by 400, as is HTTP/1.1 without one Host, a head of more than 8 kB by 431, a body of more
/// than `most_body` bytes by 413, chunked or not, and what the handler throws by 500, each with a JSON object whose
/// `error` says why. A reply to HEAD has no body, whatever the handler gives. Who takes longer than `patience` to send
/// a request or to take the reply is cut off; of more than `most_connections`, the one that has been idle longest is.
/// Then it goes on serving.
class HttpServer {
 public:
  using Handler = std::function<HttpReply(const HttpRequest&)>;
  struct Limits {
    std::size_t most_body = std::size_t{64} * 1024;
    std::chrono::milliseconds patience = std::chrono::seconds(10);
    std::size_t most_connections = 64;
  };

  /// Listens; port 0 stands for a free one. The handler is called by several threads at once. Throws
  /// std::runtime_error, which names the address, where that cannot be listened at.
  HttpServer(const std::string& host, std::uint16_t port, Handler handler, const Limits& limits);
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;
  ~HttpServer();

  [[nodiscard]] std::uint16_t port() const;
  /// Of the page, for a browser of this machine.
  [[nodiscard]] std::string url() const;
  /// Only this machine can reach it.
  [[nodiscard]] bool loopback() const;

  /// Serves until `stop` is set; that is seen within a tenth of a second, but requests at work are answered first.
  void run(const std::atomic<bool>& stop);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace touchstone::cell::browser
