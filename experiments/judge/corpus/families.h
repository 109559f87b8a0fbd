// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/judge/corpus/corpus_case.h"

namespace touchstone::corpus {

/// The version of the corpus, raised whenever a case is added, changes or is removed.
inline constexpr int kVersion = 9;
/// The maximal size of a file, because people read it.
inline constexpr std::size_t kMostBytes = 350'000;

/// The numbers of the cases: any doubles, or floats alone (see in_floats).
enum class Numbers { Doubles, Floats };

/// One file of the corpus, or two: one of doubles and one of floats.
struct Family {
  std::string_view name;         ///< of the file, without `.jsonl`
  std::string_view subject;      ///< what it tests
  std::string (*text)(Numbers);  ///< its lines; empty if the family has no cases in these numbers
};

/// Returns the families in the order of the page that describes them.
///
/// A text is always the same: cases are drawn as functions of (seed, index), or read from
/// experiments/judge/corpus/given. It holds the exact answers. Texts throw std::runtime_error, which names the file and
/// line, if a given case cannot be used, and std::logic_error if a text is larger than kMostBytes. (Some cases of
/// `soak` are drawn in long doubles: those of x86-64.)
[[nodiscard]] const std::vector<Family>& all_families();

/// Draws a ball, which moves or not, near a feature of a small mesh: a box of squares or of triangles, a prism over an
/// L, a terrain on a grid, or a flat grid of triangles; half of them under a pose. The radius of a ball at a place is
/// the distance, or a double beside it. One that moves is to graze the mesh, or to come down on it. Vertices, centres
/// and ends are small integers and quarters, so that ties of faces are exact where there is no pose. Nothing if a posed
/// face is rejected, or if the centre is on the mesh. A function of its arguments.
[[nodiscard]] std::optional<CorpusCase> draw_mesh_case(std::uint64_t seed, std::uint64_t index, bool moves);

/// Returns every file of the corpus by its name: `FAMILY.jsonl`, `floats/FAMILY.jsonl`, `corpus.json` (version and
/// counts) and the page README.md. The result does not depend on the number of threads. Throws the exceptions of the
/// texts of families, and std::logic_error if a file is too large or an id is not unique.
[[nodiscard]] std::map<std::string, std::string> make_corpus(unsigned threads);

}  // namespace touchstone::corpus
