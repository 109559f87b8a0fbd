// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "experiments/run/timing.h"

namespace touchstone::timing {
namespace {

/// Formats a number with about three digits.
std::string number(double value) {
  if (value >= 99.95) return fmt::format("{:.0f}", value);
  if (value >= 9.995) return fmt::format("{:.1f}", value);
  return value >= 0.0995 ? fmt::format("{:.2f}", value) : fmt::format("{:.4f}", value);
}

std::string spread(const Quartiles& q) { return fmt::format("({} - {})", number(q.lower), number(q.upper)); }

/// Returns half the distance of the quartiles, in % of the median.
std::string deviation(const Quartiles& q) { return fmt::format("+-{:.0f}%", 50 * (q.upper - q.lower) / q.median); }

std::string goal_text(const Goal& goal) { return fmt::format("{} {:.3g}", goal.at_most ? "<=" : ">=", goal.ratio); }

std::string wrong_text(const Wrong& wrong) { return fmt::format("{} of {}", wrong.count, wrong.of); }

std::string line(const std::string& name, const std::string& asked, const std::string& ns, const std::string& deviation,
                 const std::string& ratio, const std::string& goal, const std::string& wrong) {
  std::string text =
      fmt::format("  {:<20}{:>7}{:>11} {:<7}{:<36}{:<18}{}", name, asked, ns, deviation, ratio, goal, wrong);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

std::string row(const Measured& m) {
  const Quartiles ns = quartiles(m.nanoseconds);
  std::string ratio, goal;
  if (!m.ratios.empty()) {
    const Quartiles q = quartiles(m.ratios);
    ratio = fmt::format("{:>7} {} x {}", number(q.median), spread(q), m.comparison->base);
    if (too_noisy(q))
      goal = "too noisy to tell";
    else if (const auto& wanted = m.comparison->goal)
      goal = goal_text(*wanted) + (wanted->met_by(q.median) ? " met" : " MISSED");
  }
  return line(m.name, std::to_string(m.queries), number(ns.median), deviation(ns), ratio, goal,
              m.wrong ? wrong_text(*m.wrong) : "");
}

std::string title(const Result& result) {
  return result.name.empty() ? result.family : result.family + ", " + result.name;
}

}  // namespace

std::string table(const Result& result) {
  std::string text = "\n" + title(result) + (result.note.empty() ? "" : ": " + result.note) + "\n";
  text += line("", "asked", "ns/" + result.unit, "", "  ratio", "goal", "wrong");
  for (const Measured& m : result.candidates)
    if (!m.nanoseconds.empty()) text += row(m);
  return text;
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
