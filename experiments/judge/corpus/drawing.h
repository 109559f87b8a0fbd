// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/workloads/adversarial/case.h"
#include "experiments/cases/workloads/workload.h"
#include "experiments/judge/corpus/corpus_case.h"

namespace touchstone::corpus {

/// A sequence of cases to draw.
struct Stream {
  /// Draws case number `index`; nothing if it does not belong to this stream.
  std::function<std::optional<CorpusCase>(std::uint64_t index)> draw;
  std::size_t count;            ///< the number of cases wanted
  std::uint64_t most = 20'000;  ///< the maximal number of indices to try
};

/// Returns the cases of a workload, seed 1.
[[nodiscard]] Stream workload_stream(const workloads::Workload& workload, std::size_t count);
/// Returns the cases of one family of `soak`, seed 1.
[[nodiscard]] Stream soak_stream(workloads::adversarial::Family family, std::size_t count);

/// A predicate: whether the case, given its answer, is of the kind of the family.
using Kind = std::function<bool(const CorpusCase&, const cases::PartialAnswer& truth)>;

/// Returns, one per line, the first cases of each stream that are of that kind and that a witness gets wrong. Skips
/// long lines, because people read the cases.
[[nodiscard]] std::string drawn_text(const std::vector<Stream>& streams, const Kind& kind);

}  // namespace touchstone::corpus
