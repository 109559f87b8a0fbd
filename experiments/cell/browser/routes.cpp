// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/browser/routes.h"

#include <utility>

#include "experiments/cell/browser/cell_json.h"
#include "experiments/cell/browser/page.h"
#include "experiments/cell/model/cell_entry.h"

namespace touchstone::cell::browser {
namespace {

constexpr const char* kJson = "application/json";

/// A message that does not begin with what only who started the program need know.
std::string without(const std::string& prefix, const std::string& message) {
  return message.rfind(prefix, 0) == 0 ? message.substr(prefix.size()) : message;
}

}  // namespace

Routes::Routes(const Simulator& simulator, KnownHosts hosts)
    : simulator_(&simulator), hosts_(std::move(hosts)), page_(live_page()), cell_(cell_json(simulator).dump()) {}

HttpReply Routes::answer(const HttpRequest& request) const {
  if (!hosts_.names(request.host))
    return refusal(421, "this server answers to localhost or its address, not to \"" + request.host + "\"");
  const bool page = request.path == "/", cell = request.path == "/api/cell", run = request.path == "/api/run";
  if (!page && !cell && !run)
    return refusal(404, "there are /, /api/cell and /api/run, not " + request.path);
  const std::string wanted = run ? "POST" : "GET";
  if (request.method != wanted)
    return refusal(405, request.path + " takes " + wanted + ", not " + request.method, wanted);
  if (page) return {200, "text/html; charset=utf-8", page_, ""};
  if (cell) return {200, kJson, cell_, ""};
  return this->run(request);
}

HttpReply Routes::run(const HttpRequest& request) const {
  if (request.content_type.rfind(kJson, 0) != 0) return refusal(415, std::string("the Content-Type must be ") + kJson);
  try {
    const Setting setting = read_setting(request.body, simulator_->cell());
    return {200, kJson, run_json(simulator_->run(setting)).dump(), ""};
  } catch (const BadSetting& error) {
    return refusal(400, error.what());
  } catch (const BadCell& error) {
    return refusal(422, without(simulator_->cell().file.string() + ": ", error.what()));
  }
}

}  // namespace touchstone::cell::browser
