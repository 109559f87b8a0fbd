// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <string>

namespace touchstone::cell::browser {

struct Received {
  unsigned status = 0;  ///< 0: the connection was closed without a reply
  std::string content_type, body, allow;
};

/// A connection to 127.0.0.1.
class Connection {
 public:
  explicit Connection(std::uint16_t port);
  void send(const std::string& bytes);
  Received receive();
  /// All bytes until the server closes it.
  std::string rest();

 private:
  boost::asio::io_context context_;
  boost::asio::ip::tcp::socket socket_{context_};
};

/// Asks 127.0.0.1 one question, by Boost.Beast.
[[nodiscard]] Received ask(std::uint16_t port, const std::string& method, const std::string& path,
                           const std::string& body = "", const std::string& content_type = "application/json",
                           const std::string& host = "localhost");

/// Sends these bytes, and nothing more, and reads a reply.
[[nodiscard]] Received send_raw(std::uint16_t port, const std::string& bytes);

/// Sends these bytes, and reads until the server closes.
[[nodiscard]] std::string read_all(std::uint16_t port, const std::string& bytes);

}  // namespace touchstone::cell::browser
