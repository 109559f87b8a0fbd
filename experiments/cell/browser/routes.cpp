// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/browser/routes.h"

#include <fmt/core.h>

#include <boost/beast/core/string.hpp>
#include <string_view>
#include <utility>

#include "experiments/cell/browser/cell_json.h"
#include "experiments/cell/browser/page.h"
#include "experiments/cell/model/cell_entry.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::cell::browser {
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

}  // namespace

Routes::Routes(const Simulator& simulator, KnownHosts hosts)
    : simulator_(&simulator), hosts_(std::move(hosts)), page_(live_page()), cell_(cell_json(simulator)) {}

HttpReply Routes::answer(const HttpRequest& request) const {
  if (!hosts_.names(request.host))
    return refusal(421,
                   "this server answers to localhost or its address, not to \"" + io::legible(request.host) + "\"");
  const bool page = request.path == "/", cell = request.path == "/api/cell", run = request.path == "/api/run";
  if (!page && !cell && !run)
    return refusal(404, "there are /, /api/cell and /api/run, not " + io::legible(request.path));
  const std::string wanted = run ? "POST" : "GET, HEAD";
  if (run ? request.method != "POST" : request.method != "GET" && request.method != "HEAD")
    return refusal(405, request.path + " takes " + wanted + ", not " + io::legible(request.method), wanted);
  if (page) return {200, "text/html; charset=utf-8", page_, ""};
  if (cell) return {200, kJson, cell_, ""};
  return this->run(request);
}

HttpReply Routes::run(const HttpRequest& request) const {
  if (!is_json(request.content_type)) return refusal(415, fmt::format("the Content-Type must be {}", kJson));
  try {
    const Setting setting = read_setting(request.body, simulator_->cell());
    return {200, kJson, run_json(simulator_->run(setting)), ""};
  } catch (const BadSetting& error) {
    return refusal(400, error.what());
  } catch (const BadCell& error) {
    return refusal(422, without(io::all_legible(simulator_->cell().file.string()) + ": ", error.what()));
  }
}

}  // namespace touchstone::cell::browser
