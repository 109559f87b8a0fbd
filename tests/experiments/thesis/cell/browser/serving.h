// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <utility>

#include "experiments/thesis/cell/browser/http_server.h"

namespace touchstone::cell::browser {

/// A server at a free port of this machine, in a thread, for as long as it lives.
class Serving {
 public:
  explicit Serving(HttpServer::Handler handler, HttpServer::Limits limits = {})
      : server_("127.0.0.1", 0, std::move(handler), limits), thread_([this] { server_.run(stop_); }) {}
  Serving(const Serving&) = delete;
  Serving& operator=(const Serving&) = delete;
  ~Serving() {
    stop_ = true;
    thread_.join();
  }

  [[nodiscard]] std::uint16_t port() const { return server_.port(); }

 private:
  std::atomic<bool> stop_ = false;
  HttpServer server_;
  std::thread thread_;
};

}  // namespace touchstone::cell::browser
