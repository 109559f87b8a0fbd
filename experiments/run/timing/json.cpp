// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "experiments/run/timing/output.h"

namespace touchstone::timing {
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
