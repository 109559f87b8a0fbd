// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/judge/corpus/corpus_case.h"
#include "experiments/workloads/adversarial/case.h"
#include "experiments/workloads/workload.h"

namespace touchstone::corpus {

/// Cases that are drawn one after the other.
struct Stream {
  /// Case number `index`; none where it is not of this stream.
  std::function<std::optional<CorpusCase>(std::uint64_t index)> draw;
  std::size_t count;            ///< so many of them are wanted
  std::uint64_t most = 20'000;  ///< indices to look at, at most
};

/// Case `index` of a workload, seed 1.
[[nodiscard]] Stream workload_stream(const workloads::Workload& workload, std::size_t count);
/// The cases of one family of `soak`, seed 1.
[[nodiscard]] Stream soak_stream(adversarial::Family family, std::size_t count);

/// Is the case, whose answer is given, of the family's kind?
using Kind = std::function<bool(const CorpusCase&, const cases::Verdict& truth)>;

/// The first cases of each stream that are of that kind and about which a witness is wrong, a line each. Long lines are
/// passed over: cases are to be read.
[[nodiscard]] std::string drawn_text(const std::vector<Stream>& streams, const Kind& kind);

}  // namespace touchstone::corpus
