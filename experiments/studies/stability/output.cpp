// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/output.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "experiments/harness/write_file.h"
#include "experiments/statistics/clopper_pearson.h"

namespace touchstone::stability {
namespace {

/// Three columns.
std::string rate_and_limits(std::uint64_t failed, std::uint64_t trials) {
  const auto limits = statistics::clopper_pearson(failed, trials);
  const double rate = trials == 0 ? 0 : static_cast<double>(failed) / static_cast<double>(trials);
  return fmt::format("{:.6g},{:.6g},{:.6g}", rate, limits.lower, limits.upper);
}

/// Four columns.
std::string quantiles(const statistics::Distribution& d) {
  return fmt::format("{:.4g},{:.4g},{:.4g}", d.quantile(0.5), d.quantile(0.99), d.largest());
}

/// Two columns: the level as tables name it, and as a number.
std::string level_text(Axis axis, std::size_t level) {
  return fmt::format("{},{:.6g}", levels(axis)[level].name, levels(axis)[level].value);
}

/// Three columns: the level before the first with a failure (the last one, if there is none), its samples, none of
/// which failed, and the upper limit of their rate; nothing where the first level has failures.
std::string before_text(const Settings& settings, const Summary& summary, const Summary::Cell& cell) {
  const auto [axis, nearness, test, method, unused] = cell;
  const auto first = summary.first_level(settings, axis, nearness, test, method, 0);
  std::size_t level = first.value_or(levels(settings.axes[axis]).size());
  while (level-- > 0)
    if (const Tally* tally = summary.at(axis, nearness, test, method, level))
      return fmt::format("{},{},{:.6g}", levels(settings.axes[axis])[level].name, tally->samples,
                         statistics::clopper_pearson(0, tally->samples).upper);
  return ",,";
}

/// Two columns: a level and the rate there, or nothing.
std::string first_text(const Settings& settings, const Summary& summary, const Summary::Cell& cell, double share) {
  const auto [axis, nearness, test, method, unused] = cell;
  const auto level = summary.first_level(settings, axis, nearness, test, method, share);
  if (!level) return ",";
  const Tally& tally = *summary.at(axis, nearness, test, method, *level);
  return fmt::format("{},{:.6g}", levels(settings.axes[axis])[*level].name, tally.rate());
}

}  // namespace

void write_failures(const std::filesystem::path& folder, const Settings& settings, const Summary& summary) {
  std::string text =
      "axis,level,value,nearness,test,method,failed_samples,samples,rate,lower,upper,wrong_answers,answers\n";
  std::string first =
      "axis,nearness,test,method,first_failure,rate_there,first_above_half,rate_there_above_half,level_before,"
      "samples_before,upper_before,failed_samples,samples,rate,lower,upper\n";
  for (std::size_t a = 0; a < settings.axes.size(); ++a)
    for (const Nearness nearness : kNearnesses)
      for (const Test test : kCountedTests)
        for (std::size_t m = 0; m < settings.methods.size(); ++m) {
          const std::string_view name = settings.methods[m]->name();
          Tally all;
          for (std::size_t level = 0; level < levels(settings.axes[a]).size(); ++level) {
            const Tally* tally = summary.at(a, nearness, test, m, level);
            if (tally == nullptr) continue;
            all += *tally;
            text +=
                fmt::format("{},{},{},{},{},{},{},{},{},{}\n", word(settings.axes[a]),
                            level_text(settings.axes[a], level), word(nearness), word(test), name, tally->failed,
                            tally->samples, rate_and_limits(tally->failed, tally->samples), tally->wrong, tally->balls);
          }
          if (all.samples == 0) continue;
          const Summary::Cell cell{a, nearness, test, m, 0};
          first += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", word(settings.axes[a]), word(nearness), word(test),
                               name, first_text(settings, summary, cell, 0), first_text(settings, summary, cell, 0.5),
                               before_text(settings, summary, cell), all.failed, all.samples,
                               rate_and_limits(all.failed, all.samples));
        }
  harness::write_file(folder / "failures.csv", text);
  harness::write_file(folder / "first-failure.csv", first);
}

void write_errors(const std::filesystem::path& folder, const Settings& settings, const Summary& summary) {
  std::string text =
      "axis,level,value,quantity,method,numbers,not_finite,relative_median,relative_99,relative_max,ulps_median,"
      "ulps_99,ulps_max\n";
  for (const auto& [cell, errors] : summary.errors) {
    const auto& [axis, quantity, method, level] = cell;
    text += fmt::format("{},{},{},{},{},{},{},{}\n", word(settings.axes[axis]), level_text(settings.axes[axis], level),
                        word(quantity), settings.methods[method]->name(), errors.relative.count(),
                        errors.relative.infinite(), quantiles(errors.relative), quantiles(errors.ulps));
  }
  harness::write_file(folder / "errors.csv", text);
}

void write_bounds(const std::filesystem::path& folder, const Settings& settings, const Summary& summary) {
  std::string text =
      "stage,quantity,axis,level,value,observations,exceeded,exceeded_polygons,polygons,rate,lower,upper,median,"
      "quantile_99,max\n";
  const auto add = [&](std::size_t quantity, const std::string& where, const BoundSummary& bound) {
    const BoundedQuantity& about = bounded_quantities()[quantity];
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", word(about.stage), about.name, where, bound.tightness.count(),
                        bound.exceeded, bound.failed, bound.polygons, rate_and_limits(bound.failed, bound.polygons),
                        quantiles(bound.tightness));
  };
  for (const auto& [quantity, bound] : summary.all_bounds) add(quantity, "all,,", bound);
  for (const auto& [cell, bound] : summary.bounds) {
    const auto& [quantity, axis, level] = cell;
    add(quantity, fmt::format("{},{}", word(settings.axes[axis]), level_text(settings.axes[axis], level)), bound);
  }
  harness::write_file(folder / "tightness.csv", text);

  std::string points = "stage,quantity,constant,axis,level,condition,relative_error\n";
  for (const auto& [block, list] : summary.points) {
    const Axis axis = settings.axes[block % settings.axes.size()];
    for (const ConditionPoint& p : list) {
      const BoundedQuantity& about = bounded_quantities()[p.quantity];
      points += fmt::format("{},{},{:.6g},{},{},{:.3e},{:.3e}\n", word(about.stage), about.name, about.constant,
                            word(axis), levels(axis)[p.level].name, p.condition, p.relative_error);
    }
  }
  harness::write_file(folder / "conditions.csv", points);
}

void write_worst(const std::filesystem::path& folder, const Summary& summary) {
  std::vector<const WorstCase*> cases;
  for (const auto& methods : summary.worst)
    for (const auto& worst : methods)
      if (worst) cases.push_back(&*worst);
  std::ranges::stable_sort(cases, [](const WorstCase* a, const WorstCase* b) {
    return a->rank != b->rank ? a->rank > b->rank : a->error > b->error;
  });
  std::string text;
  for (const WorstCase* worst : cases) text += worst->line;
  harness::write_file(folder / "worst.jsonl", text);
}

void write_known(const std::filesystem::path& folder, const Known& known) {
  const Onset& onset = known.onset;
  std::string text =
      "origin_distance,method,offset_exponent,failed_triangles,triangles,rate,lower,upper,wrong_answers,answers\n";
  for (std::size_t d = 0; d < std::size(kOnsetDistances); ++d)
    for (std::size_t m = 0; m < onset.methods().size(); ++m)
      for (int k = kCoarsest; k <= kFinest; ++k)
        text += fmt::format("{},{},{},{},{},{},{},{}\n", kOnsetDistances[d], onset.methods()[m], -k,
                            onset.failures(d, m, k), onset.triangles(),
                            rate_and_limits(onset.failures(d, m, k), onset.triangles()), onset.wrong(d, m, k),
                            2 * onset.triangles());
  harness::write_file(folder / "onset.csv", text);

  text =
      "sign,family,trials,plain_wrong,plain_rate,plain_lower,plain_upper,fused_wrong,fused_rate,fused_lower,"
      "fused_upper,signs_differ\n";
  for (const ContractionCount& c : known.contractions)
    text += fmt::format("{},{},{},{},{},{},{},{}\n", c.sign, c.family, c.trials, c.plain_wrong,
                        rate_and_limits(c.plain_wrong, c.trials), c.fused_wrong,
                        rate_and_limits(c.fused_wrong, c.trials), c.differ);
  harness::write_file(folder / "contraction.csv", text);

  text = "outline,points,rightly_inside,wrongly_inside,missed,share,lower,upper\n";
  for (const auto& area : known.areas) {
    const auto limits = area.limits();
    text += fmt::format("{},{},{},{},{},{:.6g},{:.6g},{:.6g}\n", area.outline->name, area.points, area.right,
                        area.wrong, area.missed, area.share(), limits.lower, limits.upper);
  }
  harness::write_file(folder / "areas.csv", text);
}

}  // namespace touchstone::stability
