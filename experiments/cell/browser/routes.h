// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "experiments/cell/browser/http_server.h"
#include "experiments/cell/browser/known_hosts.h"
#include "experiments/cell/browser/recording.h"

namespace touchstone::cell::browser {

/// A cell that the page can show: the one that is served, or a preset of its file, which is built when it is first
/// asked for.
struct Variant {
  std::string name;
  std::function<Simulator()> make;
};

/// The routes of the server. A number behind /api/... names a preset, from 1; without it, it is the served cell:
///   GET /             the page
///   GET /api/presets  the presets' names
///   GET /api/cell     cell_json
///   GET /api/covers   covers_json
///   POST /api/run     a setting, as read_setting takes it: run_json
///   POST /api/area    a setting: area_json, at its angle
///   POST /api/pose    a pose, as read_pose takes it: pose_json
/// What is posted must be of Content-Type application/json. HEAD is answered as GET. All other requests get {"error":
/// reason} with status 400 for an invalid setting, 404, 405, 415 for another type, 422 for an impossible cell, and 421
/// for every request with an unknown Host.
class Routes {
 public:
  /// Requires that the simulator outlives it.
  Routes(const Simulator& simulator, KnownHosts hosts, std::vector<Variant> presets = {});

  /// Answers a request. Thread-safe.
  [[nodiscard]] HttpReply answer(const HttpRequest& request) const;

 private:
  struct Preset {
    Variant variant;
    std::once_flag once;
    std::unique_ptr<const Simulator> simulator;
  };
  [[nodiscard]] const Simulator& simulator_of(std::size_t preset) const;
  [[nodiscard]] HttpReply answered(const std::string& what, std::size_t preset, const std::string& body) const;

  const Simulator* simulator_;
  KnownHosts hosts_;
  std::string page_, presets_json_;
  std::vector<std::unique_ptr<Preset>> presets_;
};

}  // namespace touchstone::cell::browser
