// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/thesis/cell/browser/http_server.h"
#include "experiments/thesis/cell/browser/recording.h"

namespace touchstone::cell::browser {

/// The names that a request's Host header may use for this server. A foreign web page can make its own name resolve to
/// this server (DNS rebinding), and its requests then carry that name. So only names that nobody else can register are
/// accepted.
class KnownHosts {
 public:
  /// `name` is the address as the user gave it; `loopback`: only this machine can reach it.
  KnownHosts(std::string_view name, bool loopback);

  /// Returns whether a Host header names this server: `localhost`, an IPv4 address of 127.0.0.0/8 in dotted form,
  /// `[::1]`, or the name that the user gave; if other machines can reach the server, also any other literal address. A
  /// port may follow. Case and one dot at the end of a name are ignored.
  [[nodiscard]] bool names(std::string_view host) const;

 private:
  std::string name_;
  bool loopback_;
};

/// Builds the simulator of a variation.
using MakeSimulator = std::function<Simulator(const Variation&)>;

/// A preset of the cell's file, which is built when it is first asked for.
struct Variant {
  std::string name;
  MakeSimulator make;
};

/// The routes of the server. A number behind /api/... names a preset, from 1; without it, it is the served cell:
///   GET /             the page
///   GET /api/presets  the presets' names
///   GET /api/cell     cell_json
///   POST /api/varied  a variation, as read_variation takes it: cell_json of that
///   POST /api/run     a setting, as read_setting takes it: run_json
///   POST /api/area    a setting: area_json, at its angle
///   POST /api/pose    a pose, as read_pose takes it: pose_json
/// All that is posted may name a variation, which then is what is asked about; the last kKept are kept.
/// What is posted must be of Content-Type application/json. HEAD is answered as GET. All other requests get {"error":
/// reason} with status 400 for an invalid setting, 404, 405, 415 for another type, 422 for an impossible cell, and 421
/// for every request with an unknown Host.
class Routes {
 public:
  /// Requires that the simulator outlives it.
  Routes(const Simulator& simulator, KnownHosts hosts, std::vector<Variant> presets = {}, MakeSimulator make = {});
  static constexpr std::size_t kKept = 8;

  /// Answers a request. Thread-safe.
  [[nodiscard]] HttpReply answer(const HttpRequest& request) const;

 private:
  using Shared = std::shared_ptr<const Simulator>;
  [[nodiscard]] Shared simulator_of(std::size_t preset, const Variation& variation) const;
  [[nodiscard]] HttpReply answered(const std::string& what, std::size_t preset, const std::string& body) const;

  const Simulator* simulator_;
  MakeSimulator make_;
  struct Kept {
    std::size_t preset;
    Variation variation;
    std::shared_future<Shared> simulator;
  };
  mutable std::mutex mutex_;      // of what follows
  mutable std::list<Kept> kept_;  // the last ones first
  KnownHosts hosts_;
  std::string page_, presets_json_;
  std::vector<Variant> presets_;
};

}  // namespace touchstone::cell::browser
