// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/browser/routes.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/asio/ip/address.hpp>
#include <boost/beast/core/string.hpp>
#include <charconv>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "experiments/thesis/cell/browser/cell_json.h"
#include "experiments/thesis/cell/browser/page.h"
#include "experiments/thesis/cell/model/cell_entry.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::cell::browser {
namespace {

/// In lower case, without the dot that may end it.
std::string plain_name(std::string_view name) {
  if (name.size() > 1 && name.ends_with('.')) name.remove_suffix(1);
  std::string plain(name);
  for (char& c : plain)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return plain;
}

/// Returns the part before the port; none if the text after the last colon is not a port.
std::optional<std::string_view> without_port(std::string_view host) {
  const std::size_t colon = host.rfind(':');
  if (colon == std::string_view::npos || host.ends_with(']')) return host;
  const std::string_view port = host.substr(colon + 1);
  if (port.empty() || port.size() > 5 || port.find_first_not_of("0123456789") != std::string_view::npos)
    return std::nullopt;
  return host.substr(0, colon);
}

/// Returns the address of `127.0.0.1` or `[::1]`; none for a name.
std::optional<boost::asio::ip::address> literal_address(std::string_view host) {
  boost::system::error_code no_address;
  boost::asio::ip::address address;
  if (host.starts_with('[') && host.ends_with(']')) {
    host = host.substr(1, host.size() - 2);
    if (host.find_first_not_of("0123456789abcdefABCDEF:.") != std::string_view::npos) return std::nullopt;
    address = boost::asio::ip::make_address_v6(std::string(host), no_address);
  } else {
    if (host.find_first_not_of("0123456789.") != std::string_view::npos) return std::nullopt;
    address = boost::asio::ip::make_address_v4(std::string(host), no_address);
  }
  return no_address ? std::nullopt : std::optional(address);
}

}  // namespace

KnownHosts::KnownHosts(std::string_view name, bool loopback)
    : name_(literal_address(name) || name.find(':') != std::string_view::npos ? "" : plain_name(name)),
      loopback_(loopback) {}

bool KnownHosts::names(std::string_view host) const {
  const std::optional<std::string_view> bare = without_port(host);
  if (!bare || bare->empty()) return false;
  if (const auto address = literal_address(*bare)) return !loopback_ || address->is_loopback();
  const std::string name = plain_name(*bare);
  return name == "localhost" || name == name_;
}

namespace {

constexpr const char* kJson = "application/json";

/// A message that does not begin with what only who started the program need know.
std::string without(const std::string& prefix, const std::string& message) {
  return message.rfind(prefix, 0) == 0 ? message.substr(prefix.size()) : message;
}

/// Parameters may follow a media type; its case does not matter.
bool is_json(std::string_view content_type) {
  std::string_view type = content_type.substr(0, content_type.find(';'));
  while (type.ends_with(' ') || type.ends_with('\t')) type.remove_suffix(1);
  return boost::beast::iequals({type.data(), type.size()}, kJson);
}

constexpr std::size_t kRadii = 20;  // of an answer about the area

struct Route {
  std::string_view name;
  bool posted;
};
constexpr std::array<Route, 6> kRoutes{
    {{"cell", false}, {"varied", true}, {"run", true}, {"area", true}, {"pose", true}}};
constexpr const char* kThere = "there are /, /api/presets, /api/cell, /api/varied, /api/run, /api/area and /api/pose";

/// The name behind /api/ and the number behind that; 0 without one, none for anything else.
std::optional<std::pair<std::string, std::size_t>> parts_of(std::string_view path) {
  constexpr std::string_view kApi = "/api/";
  if (!path.starts_with(kApi)) return std::nullopt;
  path.remove_prefix(kApi.size());
  const std::size_t slash = path.find('/');
  std::size_t number = 0;
  if (slash != std::string_view::npos) {
    const std::string_view digits = path.substr(slash + 1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size() || number == 0) return std::nullopt;
  }
  return std::pair(std::string(path.substr(0, slash)), number);
}

}  // namespace

Routes::Routes(const Simulator& simulator, KnownHosts hosts, std::vector<Variant> presets, MakeSimulator make)
    : simulator_(&simulator),
      make_(std::move(make)),
      hosts_(std::move(hosts)),
      page_(live_page()),
      presets_(std::move(presets)) {
  nlohmann::json names = nlohmann::json::array();
  for (const Variant& preset : presets_) names.push_back(preset.name);
  presets_json_ = names.dump();
}

// The first request builds it; others for the same wait.
Routes::Shared Routes::simulator_of(std::size_t preset, const Variation& variation) const {
  const MakeSimulator& make = preset == 0 ? make_ : presets_[preset - 1].make;
  if (preset == 0 && (variation == Variation{} || !make)) return {simulator_, [](const Simulator*) {}};
  std::promise<Shared> promise;
  std::shared_future<Shared> simulator;
  {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find_if(
        kept_, [&](const Kept& kept) { return kept.preset == preset && kept.variation == variation; });
    if (found != kept_.end()) {
      kept_.splice(kept_.begin(), kept_, found);
      simulator = found->simulator;
    } else {
      kept_.push_front({preset, variation, promise.get_future().share()});
      if (kept_.size() > kKept) kept_.pop_back();
    }
  }
  if (simulator.valid()) return simulator.get();
  try {
    auto made = std::make_shared<const Simulator>(make(variation));
    promise.set_value(made);
    return made;
  } catch (...) {
    promise.set_exception(std::current_exception());
    const std::lock_guard lock(mutex_);
    std::erase_if(kept_, [&](const Kept& kept) { return kept.preset == preset && kept.variation == variation; });
    throw;
  }
}

HttpReply Routes::answer(const HttpRequest& request) const {
  if (!hosts_.names(request.host))
    return refusal(421,
                   "this server answers to localhost or its address, not to \"" + io::legible(request.host) + "\"");
  const bool page = request.path == "/", presets = request.path == "/api/presets";
  const auto parts = parts_of(request.path);
  const auto route = parts ? std::ranges::find(kRoutes, parts->first, &Route::name) : kRoutes.end();
  if (!page && !presets && (route == kRoutes.end() || parts->second > presets_.size()))
    return refusal(404, fmt::format("{}, not {}", kThere, io::legible(request.path)));
  const bool posted = !page && !presets && route->posted;
  const std::string wanted = posted ? "POST" : "GET, HEAD";
  if (posted ? request.method != "POST" : request.method != "GET" && request.method != "HEAD")
    return refusal(405, request.path + " takes " + wanted + ", not " + io::legible(request.method), wanted);
  if (page) return {200, "text/html; charset=utf-8", page_, ""};
  if (presets) return {200, kJson, presets_json_, ""};
  if (posted && !is_json(request.content_type)) return refusal(415, fmt::format("the Content-Type must be {}", kJson));
  return answered(parts->first, parts->second, request.body);
}

HttpReply Routes::answered(const std::string& what, std::size_t preset, const std::string& body) const {
  try {
    const Shared shared = simulator_of(preset, body.empty() ? Variation{} : read_variation(body));
    const Simulator& simulator = *shared;
    const Cell& cell = simulator.cell();
    if (what == "cell" || what == "varied") return {200, kJson, cell_json(simulator), ""};
    if (what == "run") return {200, kJson, run_json(simulator.run(read_setting(body, cell))), ""};
    if (what == "area") return {200, kJson, area_json(simulator.area(read_setting(body, cell), kRadii)), ""};
    const PoseRequest pose = read_pose(body, cell, simulator.joints());
    return {200, kJson, pose_json(simulator.pose(pose.setting, pose.commanded)), ""};
  } catch (const BadSetting& error) {
    return refusal(400, error.what());
  } catch (const BadCell& error) {
    return refusal(422, without(io::all_legible(simulator_->cell().file.string()) + ": ", error.what()));
  }
}

}  // namespace touchstone::cell::browser
