// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/corpus/drawing.h"

#include <fmt/core.h>

namespace touchstone::corpus {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr std::size_t kLongestLine = 2'400;

std::string command_of(const workloads::Workload& w, std::uint64_t index) {
  std::string command =
      fmt::format("touchstone cases --family {} --placement {} --ball {} --vertices {} --holes {}", to_string(w.family),
                  to_string(w.placement), to_string(w.ball), w.vertices, w.holes);
  if (w.doubles != 0) command += fmt::format(" --ulps {}", w.doubles);
  if (w.way != workloads::Way::Static) command += fmt::format(" --way {}", to_string(w.way));
  if (w.origin_distance != 0) command += fmt::format(" --origin-distance {}", w.origin_distance);
  return command + fmt::format(" --seed {} --first {} --samples 1", kSeed, index);
}

}  // namespace

Stream workload_stream(const workloads::Workload& workload, std::size_t count) {
  return {.draw =
              [workload](std::uint64_t index) {
                workloads::Sample sample = workloads::sample(workload, kSeed, index);
                return CorpusCase{std::move(sample.id),
                                  {sample.question(), std::move(sample.polygon)},
                                  std::move(sample.tags),
                                  command_of(workload, index)};
              },
          .count = count};
}

Stream soak_stream(workloads::adversarial::Family family, std::size_t count) {
  return {.draw = [family](std::uint64_t index) -> std::optional<CorpusCase> {
            workloads::adversarial::Case drawn = workloads::adversarial::draw_case(kSeed, index);
            if (drawn.family != family) return std::nullopt;
            return CorpusCase{workloads::adversarial::name_of_case(kSeed, index),
                              {drawn.ball, std::move(drawn.polygon)},
                              {std::string(to_string(family))},
                              fmt::format("touchstone soak --seed {} --from {} --samples 1 --print", kSeed, index)};
          },
          .count = count};
}

std::string drawn_text(const std::vector<Stream>& streams, const Kind& kind) {
  std::string text;
  for (const Stream& stream : streams) {
    std::size_t found = 0;
    for (std::uint64_t index = 0; found < stream.count && index < stream.most; ++index) {
      const auto drawn = stream.draw(index);
      if (!drawn) continue;
      const cases::PartialAnswer truth = exact_answer(drawn->shapes);
      if (!kind(*drawn, truth) || failing_witnesses(drawn->shapes, truth).empty()) continue;
      const std::string line = line_of(*drawn, truth);
      if (line.size() > kLongestLine) continue;
      text += line;
      ++found;
    }
  }
  return text;
}

}  // namespace touchstone::corpus
