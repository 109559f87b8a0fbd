// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/process/engine.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/cases/key.h"
#include "experiments/cases/method.h"
#include "experiments/cases/verdict.h"
#include "experiments/methods/process/engine_process.h"
#include "experiments/program/json.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::methods {
namespace {

constexpr std::string_view kLettersAndDigits = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";

bool is_name(std::string_view text) {
  return !text.empty() && kLettersAndDigits.find(text.front()) != std::string_view::npos &&
         std::ranges::all_of(text, [](char c) {
           return c == '.' || c == '_' || c == '-' || kLettersAndDigits.find(c) != std::string_view::npos;
         });
}

/// Returns the place of the `=` before the name, or npos if the text has no name.
std::size_t name_sign(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || !is_name(std::string_view(text).substr(sign + 1))) return std::string::npos;
  const std::size_t space = text.find_last_of(" \t\n", sign);
  const bool is_option = text[space == std::string::npos ? 0 : space + 1] == '-';
  return is_option ? std::string::npos : sign;
}

constexpr std::size_t kMostOfCase = 2000;  // bytes of a case in a message

/// The processes of a program: as many as were queried at the same time.
class Processes {
 public:
  Processes(std::string name, std::string command, std::chrono::milliseconds time_limit)
      : name_(std::move(name)), command_(std::move(command)), time_limit_(time_limit) {}

  /// `shapes`: the keys `ball`, `motion` and `polygon` or `mesh` of the case.
  [[nodiscard]] cases::PartialAnswer ask(const std::string& shapes) {
    const std::string id = std::to_string(++asked_);
    const std::string line = fmt::format(R"({{"id":"{}",{}}})", id, shapes);
    auto engine = take();
    auto result = engine->ask(id, line);
    if (result.reason.empty()) result.reason = fault(result);
    if (result.reason.empty() && engine->has_surplus()) result.reason = "printed more than a line";
    give_back(std::move(engine));
    if (!result.reason.empty())
      throw std::runtime_error(
          fmt::format("{}: {}; the case: {}", name_, result.reason, io::legible(line, kMostOfCase)));
    cases::PartialAnswer answer = std::move(result.answer->values);
    answer.stage = name_;
    return answer;
  }

 private:
  /// Returns the fault of a verdict, or an empty text.
  [[nodiscard]] static std::string fault(const SupervisedEngine::Result& result) {
    if (!result.ended_before.empty()) return result.ended_before + " before the case";
    const auto& [values, texts] = *result.answer;
    for (const auto& [name, text] : texts) {
      const auto key = cases::find_key(name);
      const bool given = key && (has(values, *key) || (is_null(values, *key) && text == "null"));
      if (name == "error" || (key && !given)) return fmt::format("{}: {}", name, io::legible(text));
    }
    return {};
  }

  [[nodiscard]] std::unique_ptr<SupervisedEngine> take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return std::make_unique<SupervisedEngine>(command_, time_limit_);
    auto engine = std::move(idle_.back());
    idle_.pop_back();
    return engine;
  }

  void give_back(std::unique_ptr<SupervisedEngine> engine) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(engine));
  }

  std::string name_, command_;
  std::chrono::milliseconds time_limit_;
  std::atomic<std::uint64_t> asked_ = 0;
  std::mutex mutex_;
  std::vector<std::unique_ptr<SupervisedEngine>> idle_;
};

/// Returns a member of a case as JSON.
std::string text_of(const cases::Json& member) {
  std::string line = cases::to_line(member);
  line.pop_back();
  return line;
}

class PreparedEngine : public cases::PreparedMethod {
 public:
  PreparedEngine(Processes& processes, const Polygon& polygon)
      : processes_(processes), target_("\"polygon\":" + text_of(cases::object_of(polygon))) {}
  PreparedEngine(Processes& processes, const cases::PosedMesh& mesh)
      : processes_(processes), target_("\"mesh\":" + text_of(cases::object_of(mesh.mesh()))) {
    if (!(mesh.pose() == Pose())) target_ += ",\"pose\":" + text_of(cases::object_of(mesh.pose()));
  }

  [[nodiscard]] cases::PartialAnswer ask(const Ball& ball, cases::QueryKind) const override {
    return processes_.ask(fmt::format(R"("ball":{},{})", text_of(cases::object_of(ball)), target_));
  }
  [[nodiscard]] std::optional<cases::PartialAnswer> ask_moving(const Motion& motion) const override {
    return processes_.ask(fmt::format(R"("ball":{},"motion":{},{})", text_of(cases::object_of(motion.ball)),
                                      text_of(cases::object_of(motion)), target_));
  }

 private:
  Processes& processes_;
  std::string target_;  ///< the key of the polygon or of the mesh
};

}  // namespace

Engine engine_of(const std::string& text) {
  const std::size_t sign = name_sign(text);
  Engine engine{.name = sign == std::string::npos ? text : text.substr(sign + 1), .command = text.substr(0, sign)};
  if (engine.command.find_first_not_of(" \t\n") == std::string::npos)
    throw std::invalid_argument("the command is empty");
  if (!program::is_utf8(text)) throw std::invalid_argument("the command is not UTF-8");
  return engine;
}

void require_started(const std::string& command, const std::string& ending) {
  const auto refuse = [&](const char* reason) {
    throw EngineNotStarted("engine " + command + ": cannot be started: " + ending + ", " + reason);
  };
  if (ending == "exit status 126") refuse("the command is not a program that may be run");
  if (ending == "exit status 127") refuse("the command was not found");
}

std::unique_ptr<cases::Method> external_method(std::string name, std::string summary, std::string command,
                                               std::chrono::milliseconds time_limit) {
  const auto processes = std::make_shared<Processes>(name, std::move(command), time_limit);
  return std::make_unique<cases::Method>(
      std::move(name), std::move(summary),
      [processes](const Polygon& polygon) { return std::make_unique<PreparedEngine>(*processes, polygon); },
      cases::Method::Kind::Pipe,
      [processes](const cases::PosedMesh& mesh) { return std::make_unique<PreparedEngine>(*processes, mesh); });
}

}  // namespace touchstone::methods
