// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/near_edge/study.h"

#include <algorithm>

namespace touchstone::near_edge {
namespace {

/// One thread's part.
struct Part {
  Counts counts;
  std::uint64_t missing = 0;
};

class Study {
 public:
  explicit Study(const Settings& settings) : settings_(settings) {
    for (const auto* method : settings.methods) knows_boundary_.push_back(judge::knows_boundary(*method));
  }

  /// Sample n of every stratum of the selected families.
  void ask_all(std::uint64_t n, Part& part) const {
    for (std::size_t stratum = 0; stratum < all_strata().size(); ++stratum) {
      const auto& families = settings_.families;
      if (std::find(families.begin(), families.end(), all_strata()[stratum].family) == families.end()) continue;
      if (const auto crossing = draw_crossing(stratum, settings_.seed, n))
        ask(stratum, *crossing, part.counts);
      else
        ++part.missing;
    }
  }

 private:
  void ask(std::size_t stratum, const Crossing& crossing, Counts& counts) const {
    for (std::size_t m = 0; m < settings_.methods.size(); ++m) {
      const auto prepared = settings_.methods[m]->prepare(crossing.polygon);
      for (const Test test : kTests) {
        std::vector<bool> failed;
        for (std::size_t i = 0; i < crossing.balls.size(); ++i) {
          const auto answer = prepared->ask(crossing.balls[i], question(test));
          const auto verdict = compare(test, answer, crossing.truths[i], knows_boundary_[m]);
          if (!verdict) break;  // the method has no such test
          failed.push_back(verdict != Outcome::Right);
        }
        if (failed.size() == crossing.balls.size()) counts.add(stratum, test, m, failed);
      }
    }
  }

  const Settings& settings_;
  std::vector<bool> knows_boundary_;
};

}  // namespace

Result run_study(const Settings& settings, const std::atomic<bool>& stop, const run::Progress& progress) {
  const Study study(settings);
  std::vector<Part> parts(settings.threads, Part{Counts(settings.methods.size())});
  const std::uint64_t done = run::run_blocks(settings.samples, settings.threads, stop, progress,
                                        [&](unsigned thread, std::uint64_t n) { study.ask_all(n, parts[thread]); });
  Result result{Counts(settings.methods.size()), done, 0};
  for (const Part& part : parts) {
    result.counts += part.counts;
    result.missing += part.missing;
  }
  return result;
}

}  // namespace touchstone::near_edge
