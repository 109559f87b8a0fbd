// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/experiments/thesis/cell/browser/http_client.h"

#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <sstream>

namespace touchstone::cell::browser {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;

Connection::Connection(std::uint16_t port) { socket_.connect({asio::ip::make_address("127.0.0.1"), port}); }

void Connection::send(const std::string& bytes) {
  boost::system::error_code ignored;  // the server may have refused before it was all sent
  asio::write(socket_, asio::buffer(bytes), ignored);
}

Received Connection::receive() {
  beast::flat_buffer buffer;
  http::response_parser<http::string_body> parser;
  parser.body_limit(64U << 20U);
  boost::system::error_code error;
  http::read(socket_, buffer, parser, error);
  if (error) return {};
  const auto& message = parser.get();
  const auto field = [&](http::field name) { return std::string(message[name]); };
  return {message.result_int(), field(http::field::content_type), message.body(), field(http::field::allow)};
}

std::string Connection::rest() {
  std::string all;
  boost::system::error_code end;
  asio::read(socket_, asio::dynamic_buffer(all), end);
  return all;
}

Received ask(std::uint16_t port, const std::string& method, const std::string& path, const std::string& body,
             const std::string& content_type, const std::string& host) {
  http::request<http::string_body> request;
  request.method_string(method);
  request.target(path);
  request.version(11);
  request.set(http::field::host, host + ":" + std::to_string(port));
  request.set(http::field::connection, "close");
  if (!body.empty()) request.set(http::field::content_type, content_type);
  request.body() = body;
  request.prepare_payload();
  std::ostringstream bytes;
  bytes << request;
  return send_raw(port, bytes.str());
}

Received send_raw(std::uint16_t port, const std::string& bytes) {
  Connection connection(port);
  connection.send(bytes);
  return connection.receive();
}

std::string read_all(std::uint16_t port, const std::string& bytes) {
  Connection connection(port);
  connection.send(bytes);
  return connection.rest();
}

}  // namespace touchstone::cell::browser
