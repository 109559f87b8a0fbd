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

/// The threshold across which a ball is moved, one double after the other.
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

/// Returns all strata. Exactly tangent balls exist only on the lattice.
[[nodiscard]] const std::vector<Stratum>& all_strata();
[[nodiscard]] const std::vector<Threshold>& all_thresholds();

/// Returns the offsets by which balls are moved, in doubles, ascending: every integer from -8 to 8, then powers of 4 up
/// to 2^32.
[[nodiscard]] const std::vector<std::int64_t>& all_offsets();

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

/// A polygon, balls around a threshold, and what is right about each ball. Of a SamplePlace: one ball for each offset.
///
/// Radius: offset 0 is the double nearest to the exact distance; positive offsets are larger radii.
/// Foot: offset 0 is the last centre whose foot is not outside; for offset 1, the next double, the foot is outside.
struct Crossing {
  Polygon polygon;
  std::vector<Ball> balls;
  std::vector<PartialAnswer> truths;  ///< for each ball: plane, foot, edges_hit, contact
  std::size_t stratum = 0;
  std::uint64_t n = 0;

  /// Returns the place of offset 0 among the balls.
  [[nodiscard]] std::size_t middle() const { return balls.size() / 2; }
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
};

/// Visits sample n of every stratum of the families. Returns the number of those that were not found.
std::uint64_t draw_crossings(const CrossingSettings& settings, std::uint64_t n, const Method& truth,
                             const std::function<void(Crossing&)>& visit);

/// A method that is asked about a crossing.
class Asked {
 public:
  /// `whole`: asks for whole answers only, as of a program behind a pipe, whose every answer has all of its keys.
  Asked(const Method& method, bool knows_boundary, const Crossing& crossing, bool whole);

  [[nodiscard]] PartialAnswer answer(std::size_t ball, QueryKind kind) const {
    return whole_.empty() ? prepared_->ask(crossing_.balls[ball], kind) : whole_[ball];
  }
  /// Calls count(ball, outcome) for each ball about which the method answers this test; nothing: it is undecided.
  template <class Count>
  void compare(Test test, const Count& count) const {
    for (std::size_t ball = 0; ball < crossing_.balls.size(); ++ball) {
      const PartialAnswer said = answer(ball, query_kind(test));
      const auto outcome = cases::compare(test, said, crossing_.truths[ball], knows_boundary_);
      if (outcome || said.unsure) count(ball, outcome);
    }
  }

 private:
  const Crossing& crossing_;
  bool knows_boundary_;
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
  std::vector<bool> know_boundary;
  for (const Method* method : of.methods) know_boundary.push_back(knows_boundary(*method));
  const auto ask_all = [&](std::uint64_t n, Sum& part) {
    source(n, part, [&](const auto& crossing) {
      for (std::size_t m = 0; m < of.methods.size(); ++m)
        if (!of.methods[m]->slow() || n % of.slow_stride == 0)
          count(part, crossing, m, Asked(*of.methods[m], know_boundary[m], crossing, of.whole));
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
