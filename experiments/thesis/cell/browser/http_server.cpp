// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/browser/http_server.h"

#include <fmt/core.h>

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/strand.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "experiments/thesis/cell/browser/connection_slots.h"

namespace touchstone::cell::browser {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using boost::system::error_code;
using Tcp = asio::ip::tcp;

}  // namespace

/// The state that the sessions of a server share.
struct SharedBySessions {
  HttpServer::Handler handler;
  HttpServer::Limits limits;
  ConnectionSlots slots;
  asio::thread_pool::executor_type workers;

  SharedBySessions(HttpServer::Handler given, const HttpServer::Limits& most, asio::thread_pool& pool)
      : handler(std::move(given)), limits(most), slots(most.most_connections), workers(pool.get_executor()) {}
};

namespace {

constexpr std::uint32_t kMostHead = 8 * 1024;
constexpr int kThreads = 4;
constexpr std::size_t kMostDrained = std::size_t{16} * 1024 * 1024;

std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

/// Returns the reply to a request that could not be read; none if no client waits for a reply.
std::optional<HttpReply> reply_to(const error_code& error, const HttpServer::Limits& limits) {
  if (error == http::error::body_limit)
    return refusal(413, fmt::format("a request's body may have {} bytes", limits.most_body));
  if (error == http::error::header_limit)
    return refusal(431, fmt::format("a request's head may have {} bytes", kMostHead));
  if (error == http::error::end_of_stream || error.category() != make_error_code(http::error::bad_method).category())
    return std::nullopt;
  return refusal(400, "this is not HTTP: " + error.message());
}

/// One connection: requests one after the other. Keeps itself alive while something is under way.
class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(Tcp::socket socket, std::shared_ptr<SharedBySessions> shared)
      : stream_(std::move(socket)), shared_(std::move(shared)) {}
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session() {
    if (slot_) shared_->slots.close(*slot_);
  }

  void start() {
    slot_ = shared_->slots.open([session = weak_from_this()] {
      const auto self = session.lock();
      if (self) asio::post(self->stream_.get_executor(), [self] { self->stream_.close(); });
    });
    if (slot_) read();
  }

 private:
  void read() {
    parser_.emplace();
    head_ = false;
    parser_->header_limit(kMostHead);
    parser_->body_limit(shared_->limits.most_body);
    stream_.expires_after(shared_->limits.patience);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](error_code error, std::size_t) { self->take(error); });
  }

  void take(const error_code& error) {
    if (error) {
      if (auto reply = reply_to(error, shared_->limits)) write(*std::move(reply), 11, false);
      return;
    }
    if (!shared_->slots.begin_work(*slot_)) return;
    const auto& message = parser_->get();
    head_ = message.method() == http::verb::head;
    // More than one, or none, would let two programs on the way differ about who is meant (RFC 9112, 3.2).
    const std::size_t hosts = message.count(http::field::host);
    if (hosts > 1 || (hosts == 0 && message.version() >= 11))
      return write(refusal(400, fmt::format("a request of HTTP/1.1 has one Host, this one has {}", hosts)),
                   message.version(), false);
    const std::string_view target = view(message.target());
    HttpRequest request{.method = std::string(view(message.method_string())),
                        .path = std::string(target.substr(0, target.find('?'))),
                        .host = std::string(view(message[http::field::host])),
                        .content_type = std::string(view(message[http::field::content_type])),
                        .body = message.body()};
    const auto reply = [self = shared_from_this(), version = message.version(), keep_alive = message.keep_alive()](
                           HttpReply answer) { self->write(std::move(answer), version, keep_alive); };
    if (message.method() != http::verb::post) return reply(answer(request));
    asio::post(shared_->workers, [this, reply, request = std::move(request)] {
      asio::post(stream_.get_executor(), [reply, answer = answer(request)]() mutable { reply(std::move(answer)); });
    });
  }

  [[nodiscard]] HttpReply answer(const HttpRequest& request) const {
    try {
      return shared_->handler(request);
    } catch (const std::exception& error) {
      return refusal(500, error.what());
    }
  }

  void write(HttpReply reply, unsigned version, bool keep_alive) {
    reply_.emplace(static_cast<http::status>(reply.status), version);
    reply_->set(http::field::content_type, reply.content_type);
    reply_->set(http::field::cache_control, "no-store");
    reply_->set("X-Content-Type-Options", "nosniff");
    if (!reply.allow.empty()) reply_->set(http::field::allow, reply.allow);
    reply_->body() = std::move(reply.body);
    reply_->keep_alive(keep_alive);
    reply_->prepare_payload();
    if (head_) reply_->body().clear();  // its length is told, but it is not sent
    shared_->slots.begin_waiting(*slot_);
    stream_.expires_after(shared_->limits.patience);
    http::async_write(stream_, *reply_, [self = shared_from_this(), keep_alive](error_code error, std::size_t) {
      if (error) return;
      if (keep_alive) return self->read();
      error_code ignored;
      self->stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
      self->drain();
    });
  }

  /// Takes what is still being sent, for a while: closed at once, the reply would be lost with it.
  void drain() {
    stream_.async_read_some(asio::buffer(drained_), [self = shared_from_this()](error_code error, std::size_t count) {
      if (error || (self->drained_count_ += count) > kMostDrained) return;
      self->drain();
    });
  }

  beast::tcp_stream stream_;
  std::shared_ptr<SharedBySessions> shared_;
  std::optional<ConnectionSlots::Number> slot_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  std::optional<http::response<http::string_body>> reply_;
  bool head_ = false;
  std::array<char, 4096> drained_{};
  std::size_t drained_count_ = 0;
};

}  // namespace

HttpReply refusal(unsigned status, const std::string& reason, std::string allow) {
  const nlohmann::json body{{"error", reason}};
  return {status, "application/json", body.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
          std::move(allow)};
}

struct HttpServer::State {
  asio::io_context context;
  Tcp::acceptor acceptor{context};
  asio::steady_timer clock{context}, pause{context};
  std::shared_ptr<SharedBySessions> shared;
  asio::thread_pool workers{kThreads};

  void accept() {
    acceptor.async_accept(asio::make_strand(context), [this](error_code error, Tcp::socket socket) {
      if (!error) {
        std::make_shared<Session>(std::move(socket), shared)->start();
        return accept();
      }
      // Without a free descriptor, for instance, the next try would fail at once, too.
      pause.expires_after(HttpServer::kPause);
      pause.async_wait([this](error_code) { accept(); });
    });
  }

  void watch(const std::atomic<bool>& stop) {
    if (stop) return context.stop();
    clock.expires_after(std::chrono::milliseconds(100));
    clock.async_wait([this, &stop](error_code) { watch(stop); });
  }
};

HttpServer::HttpServer(const std::string& host, std::uint16_t port, Handler handler, const Limits& limits)
    : state_(std::make_unique<State>()) {
  state_->shared = std::make_shared<SharedBySessions>(std::move(handler), limits, state_->workers);
  try {
    const auto found = Tcp::resolver(state_->context).resolve(host, std::to_string(port));
    const Tcp::endpoint endpoint = found.begin()->endpoint();
    state_->acceptor.open(endpoint.protocol());
    state_->acceptor.set_option(asio::socket_base::reuse_address(true));
    state_->acceptor.bind(endpoint);
    state_->acceptor.listen();
  } catch (const boost::system::system_error& error) {
    throw std::runtime_error(fmt::format("cannot listen at {}, port {}: {}", host, port, error.code().message()));
  }
}

HttpServer::~HttpServer() = default;

std::uint16_t HttpServer::port() const { return state_->acceptor.local_endpoint().port(); }

std::string HttpServer::url() const {
  asio::ip::address address = state_->acceptor.local_endpoint().address();
  // Every address of this machine is meant: one that leads here.
  if (address.is_unspecified())
    address = address.is_v4() ? asio::ip::address(asio::ip::address_v4::loopback()) : asio::ip::address_v6::loopback();
  const std::string host = address.is_v6() ? "[" + address.to_string() + "]" : address.to_string();
  return fmt::format("http://{}:{}/", host, port());
}

bool HttpServer::loopback() const { return state_->acceptor.local_endpoint().address().is_loopback(); }

void HttpServer::run(const std::atomic<bool>& stop) {
  state_->accept();
  state_->watch(stop);
  std::vector<std::jthread> threads;
  for (int i = 1; i < kThreads; ++i) threads.emplace_back([this] { state_->context.run(); });
  state_->context.run();
  state_->workers.stop();
  state_->workers.join();
}

}  // namespace touchstone::cell::browser
