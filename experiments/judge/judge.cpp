// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/judge.h"

#include <fmt/core.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <fstream>
#include <functional>
#include <iostream>
#include <mutex>
#include <thread>

#include "experiments/judge/case.h"
#include "experiments/judge/engine.h"
#include "experiments/judge/verdict.h"

namespace touchstone::judge {
namespace {

/// A line of input: a case, or why there is none.
struct Line {
  std::string text;
  std::optional<Case> read;
  std::string complaint;  ///< a line that is not JSON, a file that cannot be read
};

/// Calls `take` with every line of the order's input.
void read_lines(const Order& order, const std::function<void(Line&&)>& take) {
  const auto read = [&](std::istream& stream, const std::string& name) {
    std::string text;
    for (std::size_t number = 1; std::getline(stream, text); ++number) {
      if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
      Line line{.text = text, .read = {}, .complaint = {}};
      try {
        line.read = read_case(text);
      } catch (const NotJson& error) {
        line.complaint = fmt::format("{}: line {}: not JSON: {}", name, number, error.what());
      }
      take(std::move(line));
    }
    if (stream.bad()) take({.text = {}, .read = {}, .complaint = fmt::format("{}: cannot be read to its end", name)});
  };
  if (order.files.empty()) read(std::cin, "standard input");
  for (const std::string& file : order.files) {
    std::ifstream stream(file);
    if (!stream) {
      take({.text = {}, .read = {}, .complaint = fmt::format("{}: cannot be read", file)});
      continue;
    }
    read(stream, file);
  }
}

class Bench {
 public:
  explicit Bench(const Order& order) : order_(order) {}

  void complain(const std::string& sentence) { fmt::print(order_.complaints, "{}\n", sentence); }

  void worsen(Status status) { status_ = std::max(status_, status); }

  /// The verdicts of the order's own methods, or of a rejection.
  void give_own(const Case& question) {
    if (const auto* rejection = std::get_if<Rejection>(&question.content)) {
      const bool rejection_expected = question.expected && question.expected->contains("error");
      const auto give_rejection = [&](std::string_view method) {
        const Verdict verdict = verdict_of(question.id, method, *rejection);
        print(verdict);
        if (rejection_expected) compare(question, verdict);
      };
      for (const auto* method : order_.methods) give_rejection(method->name());
      if (!order_.engine.empty()) give_rejection(order_.engine);
      if (!rejection_expected) {
        complain(fmt::format("case {}: rejected: {}: {}", name(question), word(rejection->code), rejection->message));
        worsen(InputRejected);
      }
      return;
    }
    const auto& [ball, polygon] = std::get<Shapes>(question.content);
    for (const auto* method : order_.methods) {
      const methods::PartialAnswer answer = method->prepare(polygon)->ask(ball, methods::Question::Answer);
      Verdict verdict = verdict_of(*question.id, method->name(), answer);
      if (order_.explain) explain(verdict, answer, ball.radius);
      print(verdict);
      compare(question, verdict);
    }
  }

  /// The verdict of the engine on a case that is not rejected.
  void give_reply(const Case& question, const std::string& reply) {
    Verdict verdict = Verdict::object();
    verdict["id"] = *question.id;
    verdict["method"] = order_.engine;
    const auto parsed = nlohmann::ordered_json::parse(reply, nullptr, false);
    if (!parsed.is_object() || !parsed.contains("id") || parsed["id"] != *question.id) {
      complain(fmt::format("case {}: method {}: not a verdict on this case: {}", *question.id, order_.engine, reply));
      worsen(ExpectationNotMet);
    } else {
      for (const auto& [key, value] : parsed.items())
        if (is_answer_key(key) || key == "error" || key == "message") verdict[key] = value;
    }
    print(verdict);
    compare(question, verdict);
  }

  [[nodiscard]] Status status() const { return status_; }

 private:
  static std::string name(const Case& question) { return question.id.value_or("without id"); }

  void print(const Verdict& verdict) {
    const std::string line = to_line(verdict);
    std::fwrite(line.data(), 1, line.size(), order_.verdicts);
    std::fflush(order_.verdicts);
  }

  /// Holds a verdict against what the case expects.
  void compare(const Case& question, const Verdict& verdict) {
    if (!question.expected) return;
    for (const std::string& difference : differences(*question.expected, verdict)) {
      complain(fmt::format("case {}: method {}: {}", name(question), verdict["method"].get<std::string>(), difference));
      worsen(ExpectationNotMet);
    }
  }

  const Order& order_;
  Status status_ = AllMet;
};

/// Cases that were sent to an engine, in order, until their replies are in.
class Waiting {
 public:
  void push(Line&& line) {
    const std::lock_guard lock(mutex_);
    lines_.push_back(std::move(line));
    changed_.notify_one();
  }
  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_one();
  }
  std::optional<Line> pop() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return closed_ || !lines_.empty(); });
    if (lines_.empty()) return std::nullopt;
    Line line = std::move(lines_.front());
    lines_.pop_front();
    return line;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Line> lines_;
  bool closed_ = false;
};

/// False if the line is a complaint, which is then made.
bool is_case(const Line& line, Bench& bench) {
  if (line.read) return true;
  bench.complain(line.complaint);
  bench.worsen(InputRejected);
  return false;
}

Status judge_with_engine(const Order& order) {
  Bench bench(order);
  Engine engine(order.engine);
  Waiting waiting;
  std::thread sender([&] {
    read_lines(order, [&](Line&& line) {
      const bool asked = line.read && std::holds_alternative<Shapes>(line.read->content);
      const std::string text = asked ? line.text + '\n' : std::string();
      waiting.push(std::move(line));
      if (asked) engine.send(text);  // a program that has gone away is noticed where its reply is missing
    });
    engine.end_input();
    waiting.close();
  });
  std::size_t missing = 0;
  while (const auto line = waiting.pop()) {
    if (!is_case(*line, bench)) continue;
    bench.give_own(*line->read);
    if (std::holds_alternative<Rejection>(line->read->content)) continue;
    if (const auto reply = engine.receive())
      bench.give_reply(*line->read, *reply);
    else
      ++missing;
  }
  sender.join();
  const std::string ending = engine.wait();
  if (missing > 0 || !ending.empty()) {
    bench.complain(fmt::format("engine {}: {}{} case(s) without a verdict", order.engine,
                               ending.empty() ? "" : "ended with " + ending + "; ", missing));
    bench.worsen(ExpectationNotMet);
  }
  return bench.status();
}

}  // namespace

Status judge(const Order& order) {
  if (!order.engine.empty()) return judge_with_engine(order);
  Bench bench(order);
  read_lines(order, [&](Line&& line) {
    if (is_case(line, bench)) bench.give_own(*line.read);
  });
  return bench.status();
}

}  // namespace touchstone::judge
