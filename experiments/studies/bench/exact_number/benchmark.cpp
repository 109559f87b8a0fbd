// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of a whole exact answer over one number type, on distinct queries, and a hash of the answers, which must not
// depend on the number type.
#include <benchmark/benchmark.h>

#include <bit>
#include <vector>

#include "experiments/workloads/workload.h"
#include "robust/exact/exact.h"

namespace {

using namespace touchstone;

std::vector<workloads::Sample> samples(workloads::Placement placement) {
  std::vector<workloads::Sample> list;
  for (const auto ball :
       {workloads::BallPlace::Anywhere, workloads::BallPlace::NearFace, workloads::BallPlace::NearEdge})
    for (std::uint64_t i = 0; i < 100; ++i)
      list.push_back(workloads::sample({.placement = placement, .ball = ball, .vertices = 24}, 1, i));
  return list;
}

void whole_answer(benchmark::State& state, workloads::Placement placement) {
  const auto list = samples(placement);
  std::uint64_t hash = 0;
  for (auto _ : state) {
    hash = 0;
    for (const auto& [id, ball, polygon, tags] : list) {
      const Answer answer = exact::answer(ball, polygon);
      for (const double value : {answer.distance, answer.point.x(), answer.point.y(), answer.point.z()})
        hash = hash * 1'099'511'628'211u + std::bit_cast<std::uint64_t>(value);
      hash = hash * 31 + static_cast<std::uint64_t>(answer.relation) + 7 * answer.edges_hit.size();
    }
  }
  state.counters["per_answer"] = benchmark::Counter(
      static_cast<double>(list.size()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.SetLabel("answers " + std::to_string(hash % 1'000'000));
}

}  // namespace

BENCHMARK_CAPTURE(whole_answer, planar, workloads::Placement::LatticeFrame);
BENCHMARK_CAPTURE(whole_answer, off_plane, workloads::Placement::Rotated);
BENCHMARK_MAIN();
