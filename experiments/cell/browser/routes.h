// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "experiments/cell/browser/http_server.h"
#include "experiments/cell/browser/known_hosts.h"
#include "experiments/cell/browser/recording.h"

namespace touchstone::cell::browser {

/// What is answered to whom:
///   GET /          the page
///   GET /api/cell  cell_json
///   POST /api/run  a setting, as read_setting takes it: run_json; Content-Type must be application/json
/// HEAD is answered as GET. Otherwise {"error": reason}: 400 for what is no setting, 404, 405, 415 for another type,
/// 422 for a cell that cannot be, and 421 for a Host that is not known, whatever is asked.
class Routes {
 public:
  /// Requires that the simulator outlives it.
  Routes(const Simulator& simulator, KnownHosts hosts);

  /// Safe from several threads.
  [[nodiscard]] HttpReply answer(const HttpRequest& request) const;

 private:
  [[nodiscard]] HttpReply run(const HttpRequest& request) const;

  const Simulator* simulator_;
  KnownHosts hosts_;
  std::string page_, cell_;
};

}  // namespace touchstone::cell::browser
