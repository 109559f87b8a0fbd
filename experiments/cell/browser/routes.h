// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "experiments/cell/browser/http_server.h"
#include "experiments/cell/browser/known_hosts.h"
#include "experiments/cell/browser/recording.h"

namespace touchstone::cell::browser {

/// The routes of the server:
///   GET /          the page
///   GET /api/cell  cell_json
///   POST /api/run  a setting, as read_setting takes it: run_json; Content-Type must be application/json
/// HEAD is answered as GET. All other requests get {"error": reason} with status 400 for an invalid setting, 404, 405,
/// 415 for another type, 422 for an impossible cell, and 421 for every request with an unknown Host.
class Routes {
 public:
  /// Requires that the simulator outlives it.
  Routes(const Simulator& simulator, KnownHosts hosts);

  /// Answers a request. Thread-safe.
  [[nodiscard]] HttpReply answer(const HttpRequest& request) const;

 private:
  [[nodiscard]] HttpReply run(const HttpRequest& request) const;

  const Simulator* simulator_;
  KnownHosts hosts_;
  std::string page_, cell_;
};

}  // namespace touchstone::cell::browser
