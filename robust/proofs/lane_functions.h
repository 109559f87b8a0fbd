// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "robust/filtered/detail/motion/capsule.h"
#include "robust/filtered/detail/triangle/triangle_filter.h"
#include "robust/proofs/expressions.h"
#include "robust/proofs/recorded.h"

/// Functions that decide in lanes, recorded as the translation unit's target computes them: by record.cpp and
/// record_avx2.cpp.

namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// A register of one recorded number. Its sign is not known: decisions that depend on it are noted.
template <>
struct Register<proofs::Recorded> {
  using Type = proofs::Recorded;
  static Type all(Type value) { return value; }
  static Type maximum(Type a, Type b) { return proofs::maximum(a, b); }
  static Type magnitude(Type a) { return proofs::magnitude(a); }
  static Type both(Type a, Type b) { return proofs::Recorded::of("both", {a.node, b.node}); }
  static Type either(Type a, Type b) { return proofs::Recorded::of("either", {a.node, b.node}); }
  static int signs(Type a) {
    proofs::Recording::current().decide(a.node);
    return 0;
  }
};

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

namespace touchstone::proofs {

using RecordedPack = Lanes<Recorded, kLanes>;

// The lane that follows, or precedes, on the triangle.
inline RecordedPack next_of_three(const RecordedPack& a) { return {{a.parts[1], a.parts[2], a.parts[0], a.parts[1]}}; }
inline RecordedPack previous_of_three(const RecordedPack& a) {
  return {{a.parts[2], a.parts[0], a.parts[1], a.parts[2]}};
}

inline namespace TOUCHSTONE_TARGET {

/// A function that decides in lanes, of which those of a triangle matter.
class LaneFunction {
 public:
  LaneFunction(std::string_view name, std::string_view target) : function_(name, target, "doubles") {}

  /// Returns lanes of inputs, whose error is this many units of their maximum.
  static RecordedPack inputs(const std::string& name, double error = 0) {
    return RecordedPack::each([&](int lane) { return Recorded::input(name + std::to_string(lane), error); });
  }
  static Vector3<RecordedPack> vectors(const std::string& name, double error = 0) {
    return {inputs(name + "_x", error), inputs(name + "_y", error), inputs(name + "_z", error)};
  }
  /// Returns a point in all lanes, and a radius.
  static Vector3<RecordedPack> point(const std::string& name) {
    const auto all = [&](const char* axis) { return RecordedPack::all(Recorded::input(name + axis)); };
    return {all("_x"), all("_y"), all("_z")};
  }
  static RecordedPack radius() { return RecordedPack::all(Recorded::length("radius")); }
  /// Returns radii, each in a unit of its lane.
  static RecordedPack radii() {
    return RecordedPack::each([](int lane) { return Recorded::length("radius" + std::to_string(lane)); });
  }
  void has_own_units() { function_.has_own_units(); }

  void known(const std::vector<RecordedPack>& numbers, const RecordedPack& maximum, double error,
             std::string_view constant, std::string_view why = "") {
    for (int lane = 0; lane < kLanesOfTriangle; ++lane) {
      std::vector<Recorded> its;
      for (const RecordedPack& of : numbers) its.push_back(of.parts[lane]);
      function_.known(its, maximum.parts[lane], error, constant, why);
    }
  }
  void use(std::string_view name, const LaneSigns<RecordedPack>& signs) {
    for (int lane = 0; lane < kLanesOfTriangle; ++lane)
      function_.use(name, signs.positive.parts[lane], signs.negative.parts[lane]);
    function_.ignore(signs.positive.parts[kLanesOfTriangle]), function_.ignore(signs.negative.parts[kLanesOfTriangle]);
  }
  void print() const { function_.print(std::cout); }

 private:
  static constexpr int kLanesOfTriangle = 3;

  RecordedFunction function_;
};

/// Adds what the signs of a triangle, and of a ball seen from it, rest on.
inline void use(LaneFunction& uses, const TriangleLanes<RecordedPack>& triangle) {
  uses.known({triangle.normal.x, triangle.normal.y, triangle.normal.z}, triangle.m_normal, bounds::kNormal, "kNormal");
}
template <bool scaled>
void use(LaneFunction& uses, const BallAtTriangle<RecordedPack, scaled>& ball, const std::string& of = "") {
  uses.use(of + "vertex_out", ball.vertex_out);
  uses.use(of + "after_start", ball.after_start);
  uses.use(of + "after_end", ball.after_end);
  uses.use(of + "line_out", ball.line_out);
  uses.use(of + "side_in", ball.side_in);
  uses.use(of + "plane_out", ball.plane_out);
  (void)ball.certainly_touches(), (void)ball.certainly_misses(), (void)ball.lone_sign();
}

/// Prints the claims of the list that are about lanes. All lanes do the same.
inline void print_claims_of_lanes() {
  Recording::current().begin();
  const auto inputs = make_inputs<RecordedPack>(
      [](const Input& input) { return RecordedPack::all(Recorded::input(input.name, input.error)); });
  for_each_claim([&](const Claim& claim, const auto& expression) {
    for (const Over over : claim.over)
      if (over == Over::Lanes || over == Over::FloatLanes)
        print_claim(std::cout, claim, over, expression(inputs).parts[0]);
  });
}

/// Prints the operations of an error-free transformation, as its template compiles for this target.
template <class Transformation>
void print_transformation(std::string_view name, std::string_view target, const Transformation& transformation) {
  Recording& recording = Recording::current();
  recording.begin();
  const Recorded a = Recorded::input("a"), b = Recorded::input("b");
  const DoubleWord<Recorded> result = transformation(a, b);
  std::cout << R"({"transformation": ")" << name << R"(", "target": ")" << target << R"(", "high": )"
            << result.high.node << R"(, "low": )" << result.low.node << R"(, "nodes": )";
  recording.print(std::cout, {result.high.node, result.low.node});
  std::cout << "}\n";
}
inline void print_transformations(std::string_view target) {
  using Words = const Recorded&;
  print_transformation("two_sum", target, [](Words a, Words b) { return filtered::detail::two_sum<Recorded>(a, b); });
  print_transformation("two_difference", target,
                       [](Words a, Words b) { return filtered::detail::two_difference<Recorded>(a, b); });
  print_transformation("quick_two_sum", target,
                       [](Words a, Words b) { return filtered::detail::quick_two_sum<Recorded>(a, b); });
  print_transformation("two_product", target,
                       [](Words a, Words b) { return filtered::detail::two_product<Recorded>(a, b); });
}

/// Records what computes and combines the signs of triangles in lanes.
inline void print_functions_in_lanes(std::string_view target) {
  {
    LaneFunction uses("triangle_filter", target);
    const auto vertex = uses.vectors("vertex");
    const TriangleLanes<RecordedPack> triangle = triangle_lanes(vertex);
    const BallAtTriangle<RecordedPack> ball(triangle, difference(uses.point("centre"), vertex), uses.radius());
    use(uses, triangle), use(uses, ball);
    uses.print();
  }
  {  // Differences are inputs: each in a unit of its own, rounded before.
    LaneFunction uses("scaled_filter", target);
    const auto edge = uses.vectors("edge", 1),
               previous = Vector3<RecordedPack>{previous_of_three(edge.x), previous_of_three(edge.y),
                                                previous_of_three(edge.z)};
    const TriangleLanes<RecordedPack> triangle(edge, signs::normal(previous, edge));
    uses.has_own_units();
    const BallAtTriangle<RecordedPack, true> ball(triangle, uses.vectors("to_center", 1), uses.radii());
    use(uses, triangle), use(uses, ball);
    uses.print();
  }
  {
    LaneFunction uses("capsule_filter", target);
    const auto vertex = uses.vectors("vertex"), center = uses.point("centre"), to = uses.point("to");
    const RecordedPack radius = uses.radius();
    const TriangleLanes<RecordedPack> triangle = triangle_lanes(vertex);
    const CapsuleEnds<RecordedPack> ends(triangle, vertex, center, to, radius);
    const auto velocity = difference(to, center);
    const CapsuleSide<RecordedPack> side(triangle, ends, velocity, radius);
    use(uses, triangle), use(uses, ends.start, "start."), use(uses, ends.end, "end.");
    const auto &start = ends.start.to_center, &end = ends.end.to_center;
    // What the function has to compute for this maximum.
    const RecordedPack beyond = not_too_small(maximum(largest_component(end), radius)) +
                                not_too_small(largest_component(velocity)),
                       twice = beyond + beyond;
    uses.known({start.x, start.y, start.z, radius, end.x + velocity.x, end.y + velocity.y, end.z + velocity.z}, twice,
               1, "", "the triangle inequality; the sum of two differences");
    const auto lanes = BallAtTriangle<RecordedPack>::lanes;
    for (const RecordedPack& of : {ends.stays(), ends.crosses(), side.vertex_hit(), side.vertex_missed(),
                                   side.edge_hit(), side.edge_missed(ends.start.line_out)})
      (void)lanes(of);
    uses.use("starts_front", ends.starts_front), uses.use("ends_front", ends.ends_front);
    uses.use("approaches", side.approaches), uses.use("departs", side.departs);
    uses.use("vertex_out", side.vertex_out), uses.use("apart", side.apart), uses.use("lines_out", side.lines_out);
    uses.use("after_start", side.after_start), uses.use("after_end", side.after_end);
    uses.use("starts_past", side.starts_past), uses.use("ends_past", side.ends_past);
    uses.use("ahead_out", side.ahead_out);
    uses.print();
  }
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::proofs
