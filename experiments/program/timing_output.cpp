// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "experiments/program/table.h"
#include "experiments/program/timing.h"

namespace touchstone::timing {
namespace {

/// Formats a number with about three digits.
std::string number(double value) {
  if (value >= 99.95) return fmt::format("{:.0f}", value);
  if (value >= 9.995) return fmt::format("{:.1f}", value);
  return value >= 0.0995 ? fmt::format("{:.2f}", value) : fmt::format("{:.4f}", value);
}

std::string goal_text(const Goal& goal) { return fmt::format("{} {:.3g}", goal.at_most ? "<=" : ">=", goal.ratio); }

/// Returns the fields of a row of `table`.
std::vector<std::string> fields(const Measured& m) {
  const Quartiles ns = quartiles(m.nanoseconds);
  const std::string deviation = fmt::format("+-{:.0f}%", 50 * (ns.upper - ns.lower) / ns.median);
  const std::string wrong = m.wrong ? fmt::format("{} of {}", m.wrong->count, m.wrong->of) : "";
  if (m.ratios.empty()) return {m.name, std::to_string(m.queries), number(ns.median), deviation, "", "", "", "", wrong};
  const Quartiles q = quartiles(m.ratios);
  std::string goal = too_noisy(q) ? "too noisy to tell" : "";
  if (const auto& wanted = m.comparison->goal; wanted && goal.empty())
    goal = goal_text(*wanted) + (wanted->met_by(q.median) ? " met" : " MISSED");
  return {m.name,
          std::to_string(m.queries),
          number(ns.median),
          deviation,
          number(q.median),
          fmt::format("({} - {})", number(q.lower), number(q.upper)),
          "x " + m.comparison->base,
          goal,
          wrong};
}

std::string title(const Result& result) {
  return result.name.empty() ? result.family : result.family + ", " + result.name;
}

}  // namespace

std::string table(const Result& result) {
  std::vector<std::vector<std::string>> lines{{"", "asked", "ns/" + result.unit, "", "ratio", "", "", "goal", "wrong"}};
  for (const Measured& m : result.candidates)
    if (!m.nanoseconds.empty()) lines.push_back(fields(m));
  return "\n" + title(result) + (result.note.empty() ? "" : ": " + result.note) + "\n" + program::aligned(lines);
}

std::string goals(const std::vector<Result>& results) {
  std::string missed, unclear;
  std::size_t met = 0, all = 0;
  for (const Result& result : results)
    for (const Measured& m : result.candidates) {
      if (m.ratios.empty() || !m.comparison->goal) continue;
      const Quartiles ratio = quartiles(m.ratios);
      const double median = ratio.median;
      ++all;
      if (too_noisy(ratio))
        unclear += fmt::format("  {}: {}\n", title(result), m.name);
      else if (m.comparison->goal->met_by(median))
        ++met;
      else
        missed += fmt::format("  {}: {} is {} x {}, not {}\n", title(result), m.name, number(median),
                              m.comparison->base, goal_text(*m.comparison->goal));
    }
  return fmt::format("{} of {} goals met{}{}\n", met, all, missed.empty() ? "" : "; missed:\n" + missed,
                     unclear.empty() ? "" : "; too noisy to tell:\n" + unclear);
}

std::string legend() {
  return R"(
The candidates take turns in every repetition. Each answers the first queries ("asked": their number) of the same
distinct queries: all of them, or as many as fit into 50 ms. Times and ratios: medians of the repetitions, +- half the
distance of the quartiles or (quartiles); a ratio is one of times in the same repetition. Wrong: answers that differ
from those of exact, not timed; for "answer" the decisions count, not the numbers. A ratio whose quartiles differ by
more than a factor of 1.5 is too noisy to tell anything.
)";
}

namespace {

using Json = nlohmann::ordered_json;

Json summary(const std::vector<double>& values) {
  const Quartiles q = quartiles(values);
  return {{"median", q.median},   {"lower_quartile", q.lower}, {"upper_quartile", q.upper},
          {"minimum", q.minimum}, {"maximum", q.maximum},      {"repetitions", values}};
}

Json candidate(const Measured& m) {
  Json json = {{"name", m.name}, {"asked", m.queries}, {"nanoseconds", summary(m.nanoseconds)}};
  if (m.wrong) json["wrong"] = {{"count", m.wrong->count}, {"of", m.wrong->of}};
  if (m.ratios.empty()) return json;
  json["ratio"] = summary(m.ratios);
  json["ratio"]["to"] = m.comparison->base;
  const Quartiles ratio = quartiles(m.ratios);
  if (too_noisy(ratio)) json["ratio"]["too_noisy"] = true;
  if (const auto& goal = m.comparison->goal)
    json["goal"] = {{goal->at_most ? "at_most" : "at_least", goal->ratio},
                    {"met", too_noisy(ratio) ? Json() : Json(goal->met_by(ratio.median))}};
  return json;
}

}  // namespace

Json json(const std::vector<Result>& results) {
  Json list = Json::array();
  for (const Result& result : results) {
    Json benchmark = {{"family", result.family},
                      {"name", result.name},
                      {"note", result.note},
                      {"unit", result.unit},
                      {"contestants", Json::array()}};
    for (const Measured& m : result.candidates)
      if (!m.nanoseconds.empty()) benchmark["contestants"].push_back(candidate(m));
    for (const Share& part : result.shares) benchmark["shares"][part.name] = part.share;
    list.push_back(std::move(benchmark));
  }
  return list;
}

Json processor_features() {
  Json compiled = Json::array(), present = Json::array();
#ifdef __SSE4_2__
  compiled.push_back("sse4.2");
#endif
#ifdef __AVX__
  compiled.push_back("avx");
#endif
#ifdef __AVX2__
  compiled.push_back("avx2");
#endif
#ifdef __FMA__
  compiled.push_back("fma");
#endif
#ifdef __AVX512F__
  compiled.push_back("avx512f");
#endif
#ifdef __x86_64__
  if (__builtin_cpu_supports("sse4.2")) present.push_back("sse4.2");
  if (__builtin_cpu_supports("avx")) present.push_back("avx");
  if (__builtin_cpu_supports("avx2")) present.push_back("avx2");
  if (__builtin_cpu_supports("fma")) present.push_back("fma");
  if (__builtin_cpu_supports("avx512f")) present.push_back("avx512f");
#endif
  return {{"compiled_for", compiled}, {"present", present}};
}

}  // namespace touchstone::timing
