// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cases/comparison.h"
#include "experiments/cases/method.h"
#include "experiments/cases/workloads/workload.h"
#include "experiments/program/sweep.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::cases {

/// The threshold across which a ball is moved.
enum class Threshold {
  Face,        ///< moves the radius across the distance to the polygon, whose nearest feature is the face
  Edge,        ///< the same, nearest feature an edge
  Vertex,      ///< the same, nearest feature a vertex
  Tangent,     ///< the same, for a distance that is exactly a double; any nearest feature
  FootEdge,    ///< moves the centre along an axis so that its foot crosses an edge; ample radius
  FootVertex,  ///< the same, the foot passing a vertex
};

[[nodiscard]] std::string_view to_string(Threshold threshold);
/// Returns whether the radius is moved (otherwise the centre).
[[nodiscard]] bool moves_radius(Threshold threshold);
/// Returns the decision that changes there: the final answer if the radius is moved, the foot if the centre is.
[[nodiscard]] Test test_at(Threshold threshold);

/// A stratum of the samples: each is sampled separately.
struct Stratum {
  workloads::Family family;
  workloads::Placement placement;
  Threshold threshold;
};

/// Returns all strata: of exactly planar loops first. Exactly tangent balls exist only on the lattice.
[[nodiscard]] const std::vector<Stratum>& all_strata();
[[nodiscard]] const std::vector<Threshold>& all_thresholds();

/// Returns the offsets by which balls are moved, ascending: 0 and powers of two from 2^-8 to 2^32, to either side, in
/// u x size. u is 2^-53, the share by which a rounding errs; the size of a polygon is its largest extent along an axis.
[[nodiscard]] const std::vector<double>& all_offsets();
/// Returns u x size.
[[nodiscard]] double rounding_unit(const Polygon& polygon);

/// The properties of polygons besides their stratum.
struct Shape {
  std::size_t vertices = 24;   ///< as close to this number as the family allows
  std::size_t holes = 0;       ///< of each polygon; samples without room for them are missing
  double origin_distance = 0;  ///< of each polygon from the origin, in multiples of its size

  friend bool operator==(const Shape&, const Shape&) = default;
};

/// The coordinates of a sample: it is a function of them alone.
struct SamplePlace {
  std::size_t stratum;
  Shape shape;
  std::uint64_t seed;
  std::uint64_t n;
};

/// Returns the name of a sample, which holds all that is needed to draw it again.
[[nodiscard]] std::string id(const SamplePlace& place);

/// A polygon, balls around a threshold, and what is right about each ball.
///
/// Of a SamplePlace: one ball for each offset that doubles can express, whose own spacing there is at most half of it,
/// and whose radius is not negative.
/// Radius: offset 0 is the double nearest to the exact distance; positive offsets are larger radii.
/// Foot: offset 0 is the last centre whose foot is not outside; at the next double, the foot is outside.
///
/// `truths` are the contract's, which lifts vertices; `as_given` those of TruthAsGiven.
struct Crossing {
  Polygon polygon;
  std::vector<Ball> balls;
  std::vector<PartialAnswer> truths;    ///< for each ball: plane, foot, edges_hit, contact
  std::vector<PartialAnswer> as_given;  ///< the same; empty if no vertex is lifted
  std::vector<std::size_t> offsets;     ///< for each ball: the place of its offset in all_offsets()
  std::size_t stratum = 0;
  std::uint64_t n = 0;

  /// Returns the place of offset 0 among the balls.
  [[nodiscard]] std::size_t middle() const;
  [[nodiscard]] const PartialAnswer& given(std::size_t ball) const {
    return as_given.empty() ? truths[ball] : as_given[ball];
  }
};

/// Draws the sample at that place. `truth` must be a correct method (`exact` or `filtered`; both give the same bits).
/// Returns nothing if no such sample was found.
[[nodiscard]] std::optional<Crossing> draw_crossing(const SamplePlace& place, const Method& truth);

/// The settings of a study of random crossings.
struct CrossingSettings {
  std::vector<const Method*> methods;
  std::vector<workloads::Family> families;
  /// Per stratum; up to program::kMostSamples, indices of samples and of their redraws do not collide.
  std::uint64_t samples = 1;
  std::uint64_t seed = 1;
  unsigned threads = 1;
  Shape shape = {};
  std::vector<workloads::Placement> placements = workloads::all_placements();

  /// Returns whether crossings of this stratum are drawn.
  [[nodiscard]] bool has(const Stratum& stratum) const;
};

/// Visits sample n of every stratum of the settings. Returns the number of those that were not found.
std::uint64_t draw_crossings(const CrossingSettings& settings, std::uint64_t n, const Method& truth,
                             const std::function<void(Crossing&)>& visit);

/// How a method understands polygons, as it shows in the simplest cases; see the functions of these names.
struct Understanding {
  bool knows_boundary, lifts_vertices;
};

/// An answer compared with both truths; each is nothing if the method is undecided.
struct Outcomes {
  std::optional<Outcome> contract, as_given;
};

/// A method that is asked about a crossing.
class Asked {
 public:
  /// `whole`: asks for whole answers only, as of a program behind a pipe, whose every answer has all of its keys.
  Asked(const Method& method, Understanding understanding, const Crossing& crossing, bool whole);

  [[nodiscard]] PartialAnswer answer(std::size_t ball, QueryKind kind) const {
    return whole_.empty() ? prepared_->ask(crossing_.balls[ball], kind) : whole_[ball];
  }
  /// Calls count(ball, outcomes) for each ball about which the method answers this test.
  template <class Count>
  void compare(Test test, const Count& count) const {
    for (std::size_t ball = 0; ball < crossing_.balls.size(); ++ball) {
      const PartialAnswer said = answer(ball, query_kind(test));
      const Outcomes outcomes{cases::compare(test, said, crossing_.truths[ball], understanding_.knows_boundary),
                              cases::compare(test, said, crossing_.given(ball), understanding_.knows_boundary)};
      if (outcomes.contract || said.unsure) count(ball, outcomes);
    }
  }
  /// Returns whether the contract's question is the method's own: it lifts vertices. Otherwise that is the polygon as
  /// given.
  [[nodiscard]] bool lifts() const { return understanding_.lifts_vertices; }

 private:
  const Crossing& crossing_;
  Understanding understanding_;
  std::unique_ptr<PreparedMethod> prepared_;
  std::vector<PartialAnswer> whole_;
};

/// The settings of a walk.
struct Walk {
  const std::vector<const Method*>& methods;
  std::uint64_t samples;
  unsigned threads;
  std::uint64_t slow_stride = 1;  ///< slow methods are asked about the first of so many samples only
  bool whole = false;             ///< see Asked
  std::uint64_t block = 1;        ///< samples that a thread takes at once
};

/// The walk of every study of crossings. For each sample n of the part, source(n, sum, visit) calls visit(crossing) for
/// its crossings, and for each crossing and method m count(sum, crossing, m, asked) counts what the method says.
///
/// Requires sums that may be added in any order. Threads do not change the sum.
template <class Sum, class Source, class Count>
void walk(const Walk& of, const program::RunControl& control, const Sum& zero, Sum& sum, const Source& source,
          const Count& count) {
  std::vector<Understanding> understandings;
  for (const Method* method : of.methods) understandings.push_back({knows_boundary(*method), lifts_vertices(*method)});
  const auto ask_all = [&](std::uint64_t n, Sum& part) {
    source(n, part, [&](const auto& crossing) {
      for (std::size_t m = 0; m < of.methods.size(); ++m)
        if (!of.methods[m]->slow() || n % of.slow_stride == 0)
          count(part, crossing, m, Asked(*of.methods[m], understandings[m], crossing, of.whole));
    });
  };
  program::run_sweep(of.samples, of.threads, control, zero, sum, ask_all, of.block);
}

/// The point where a foot leaves the polygon: not outside at `last`, outside one double further.
struct FootCrossing {
  Ball last;
  std::int64_t outward;  ///< 1 or -1: the direction of doubles in which the foot leaves
};

/// Searches for a crossing within `reach` doubles of a ball whose centre moves along an axis: first at powers of two on
/// both sides, then by bisection. Returns nothing if the foot does not change at the powers of two, or if the
/// coordinate is almost zero.
[[nodiscard]] std::optional<FootCrossing> find_foot_crossing(const Ball& ball, int axis, std::int64_t reach,
                                                             const std::function<bool(const Ball&)>& is_outside);

}  // namespace touchstone::cases
