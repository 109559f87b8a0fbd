// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <memory>

#include "geometry/shapes/segment.h"
#include "robust/exact/motion.h"
#include "robust/filtered/motion.h"
#include "robust/filtered/triangle_set.h"
#include "tests/robust/every_state/public_function.h"

namespace touchstone::every_state_tests {
namespace {

/// What `ask` says about the input's ball and polygon, which was prepared in the default state.
template <class Prepared, class Ask>
auto prepared(const Ask& ask) {
  return [ask](const Input& in) {
    static thread_local std::uint64_t of = ~std::uint64_t{0};
    static thread_local std::unique_ptr<const Prepared> polygon;
    if (of != in.index) {
      const Environment usual(FE_TONEAREST, Environment::kKeep);
      polygon = std::make_unique<const Prepared>(in.polygon);
      of = in.index;
    }
    return ask(in.ball, *polygon);
  };
}

/// The preparation is asked about in the default state, however it was made.
template <class Prepared>
auto preparation() {
  return [](const Input& in) {
    return [polygon = std::make_shared<Prepared>(in.polygon), ball = in.ball] { return answer(ball, *polygon); };
  };
}

/// The same with counts of stages.
template <class Ask>
auto counted(const Ask& ask) {
  return with_counts([ask](const Input& in, filtered::StageCounts& counts) {
    return prepared<filtered::PreparedPolygon>(
        [&](const Ball& ball, const filtered::PreparedPolygon& polygon) { return ask(ball, polygon, counts); })(in);
  });
}

/// What `ask` says about the input's ball and polygon, as they are.
template <class Ask>
auto unprepared(const Ask& ask) {
  return [ask](const Input& in) { return ask(in.ball, in.polygon); };
}

/// The input's ball, on its way to the input's point.
Motion motion_in(const Input& in) { return {in.ball, in.point}; }

/// What `ask` says about the input's ball, moved to the input's point, and the prepared polygon.
template <class Prepared, class Ask>
auto prepared_moving(const Ask& ask) {
  return [ask](const Input& in) {
    return prepared<Prepared>([&](const Ball& ball, const Prepared& polygon) {
      const Motion motion{ball, in.point};
      return ask(motion, polygon);
    })(in);
  };
}

/// The same with counts of stages.
template <class Ask>
auto counted_moving(const Ask& ask) {
  return with_counts([ask](const Input& in, filtered::StageCounts& counts) {
    return prepared_moving<filtered::PreparedPolygon>(
        [&](const Motion& motion, const filtered::PreparedPolygon& polygon) { return ask(motion, polygon, counts); })(
        in);
  });
}

std::array<Triangle, 3> three_orders(const Triangle& t) { return {{t, {t.b, t.c, t.a}, {t.c, t.b, t.a}}}; }

/// The input's triangle, or one of its edges as a degenerate triangle.
Triangle flattened(const Input& in) {
  return in.index % 2 == 0 ? in.triangle : Triangle(Segment{in.triangle.a, in.triangle.b});
}

using Exact = exact::PreparedPolygon;
using Filtered = filtered::PreparedPolygon;

std::vector<PublicFunction> exact_functions() {
  return {
      gives("exact::PreparedPolygon::PreparedPolygon", preparation<Exact>()),
      gives("exact::contact", prepared<Exact>([](auto& b, auto& p) { return exact::contact(b, p); })),
      gives("exact::relation", prepared<Exact>([](auto& b, auto& p) { return exact::relation(b, p); })),
      gives("exact::plane_side", prepared<Exact>([](auto& b, auto& p) { return exact::plane_side(b, p); })),
      gives("exact::foot", prepared<Exact>([](auto& b, auto& p) { return exact::foot(b, p); })),
      gives("exact::edges_hit", prepared<Exact>([](auto& b, auto& p) { return exact::edges_hit(b, p); })),
      gives("exact::answer", prepared<Exact>([](auto& b, auto& p) { return exact::answer(b, p); })),
      gives("exact::contact", unprepared([](auto& b, auto& p) { return exact::contact(b, p); })),
      gives("exact::relation", unprepared([](auto& b, auto& p) { return exact::relation(b, p); })),
      gives("exact::plane_side", unprepared([](auto& b, auto& p) { return exact::plane_side(b, p); })),
      gives("exact::foot", unprepared([](auto& b, auto& p) { return exact::foot(b, p); })),
      gives("exact::edges_hit", unprepared([](auto& b, auto& p) { return exact::edges_hit(b, p); })),
      gives("exact::answer", unprepared([](auto& b, auto& p) { return exact::answer(b, p); })),
      gives("exact::compare_distances", prepared<Exact>([](const Ball& ball, const Exact& polygon) {
              return exact::compare_distances(ball, polygon, polygon);
            })),
      gives("exact::contact", prepared_moving<Exact>([](auto& m, auto& p) { return exact::contact(m, p); })),
      gives("exact::first_contact",
            prepared_moving<Exact>([](auto& m, auto& p) { return exact::first_contact(m, p); })),
      gives("exact::contact", [](const Input& in) { return exact::contact(motion_in(in), in.polygon); }),
      gives("exact::first_contact", [](const Input& in) { return exact::first_contact(motion_in(in), in.polygon); }),
      gives("exact::PreparedPolygon::PreparedPolygon",
            [](const Input& in) {
              return [triangle = std::make_shared<Exact>(flattened(in)), ball = in.ball] {
                return answer(ball, *triangle);
              };
            }),
      gives("exact::contact", [](const Input& in) { return exact::contact(in.ball, flattened(in)); }),
      gives("exact::relation", [](const Input& in) { return exact::relation(in.ball, flattened(in)); }),
      gives("exact::closest", [](const Input& in) { return exact::closest(in.point, flattened(in)); }),
      gives("exact::contact", [](const Input& in) { return exact::contact(motion_in(in), flattened(in)); }),
      gives("exact::first_contact", [](const Input& in) { return exact::first_contact(motion_in(in), flattened(in)); }),
      gives("exact::compare_times",
            prepared_moving<Exact>([](auto& m, auto& p) { return exact::compare_times(m, p, p); })),
  };
}

filtered::TriangleSet set_of(const Triangle& t) {
  std::array<Triangle, 3> triangles = three_orders(t);
  triangles[2] = Segment{t.a, t.b};
  return filtered::TriangleSet(triangles, Degenerate::AsSegments);
}
template <class... Counts>
std::array<bool, 3> touched(const Ball& ball, const filtered::TriangleSet& set, Counts&... counts) {
  std::array<bool, 3> touches{};
  filtered::contact(ball, set, touches, counts...);
  return touches;
}

std::vector<PublicFunction> set_functions() {
  return {
      gives("filtered::TriangleSet::TriangleSet",
            [](const Input& in) {
              return [set = std::make_shared<filtered::TriangleSet>(set_of(in.triangle)), ball = in.ball] {
                return touched(ball, *set);
              };
            }),
      gives(
          "filtered::TriangleSet::triangles",
          [](const Input& in) {
            const filtered::TriangleSet set = set_of(in.triangle);
            return std::vector<Triangle>(set.triangles().begin(), set.triangles().end());
          },
          false),
      gives("filtered::contact", [](const Input& in) { return touched(in.ball, set_of(in.triangle)); }),
      gives("filtered::contact", with_counts([](const Input& in, filtered::StageCounts& n) {
              return touched(in.ball, set_of(in.triangle), n);
            })),
      gives("filtered::any_contact",
            [](const Input& in) { return filtered::any_contact(in.ball, set_of(in.triangle)); }),
      gives("filtered::any_contact", with_counts([](const Input& in, filtered::StageCounts& n) {
              return filtered::any_contact(in.ball, set_of(in.triangle), n);
            })),
      gives("filtered::triangles_hit",
            [](const Input& in) { return filtered::triangles_hit(in.ball, set_of(in.triangle)); }),
      gives("filtered::triangles_hit", with_counts([](const Input& in, filtered::StageCounts& n) {
              return filtered::triangles_hit(in.ball, set_of(in.triangle), n);
            })),
  };
}

std::vector<PublicFunction> filtered_functions() {
  return {
      gives("filtered::PreparedPolygon::PreparedPolygon", preparation<Filtered>()),
      gives("filtered::contact", prepared<Filtered>([](auto& b, auto& p) { return filtered::contact(b, p); })),
      gives("filtered::relation", prepared<Filtered>([](auto& b, auto& p) { return filtered::relation(b, p); })),
      gives("filtered::plane_side", prepared<Filtered>([](auto& b, auto& p) { return filtered::plane_side(b, p); })),
      gives("filtered::foot", prepared<Filtered>([](auto& b, auto& p) { return filtered::foot(b, p); })),
      gives("filtered::edges_hit", prepared<Filtered>([](auto& b, auto& p) { return filtered::edges_hit(b, p); })),
      gives("filtered::answer", prepared<Filtered>([](auto& b, auto& p) { return filtered::answer(b, p); })),
      gives("filtered::contact", counted([](auto& b, auto& p, auto& n) { return filtered::contact(b, p, n); })),
      gives("filtered::relation", counted([](auto& b, auto& p, auto& n) { return filtered::relation(b, p, n); })),
      gives("filtered::plane_side", counted([](auto& b, auto& p, auto& n) { return filtered::plane_side(b, p, n); })),
      gives("filtered::foot", counted([](auto& b, auto& p, auto& n) { return filtered::foot(b, p, n); })),
      gives("filtered::edges_hit", counted([](auto& b, auto& p, auto& n) { return filtered::edges_hit(b, p, n); })),
      gives("filtered::answer", counted([](auto& b, auto& p, auto& n) { return filtered::answer(b, p, n); })),
      gives("filtered::contact", unprepared([](auto& b, auto& p) { return filtered::contact(b, p); })),
      gives("filtered::relation", unprepared([](auto& b, auto& p) { return filtered::relation(b, p); })),
      gives("filtered::plane_side", unprepared([](auto& b, auto& p) { return filtered::plane_side(b, p); })),
      gives("filtered::foot", unprepared([](auto& b, auto& p) { return filtered::foot(b, p); })),
      gives("filtered::edges_hit", unprepared([](auto& b, auto& p) { return filtered::edges_hit(b, p); })),
      gives("filtered::answer", unprepared([](auto& b, auto& p) { return filtered::answer(b, p); })),
      gives("filtered::contact", [](const Input& in) { return filtered::contact(in.ball, flattened(in)); }),
      gives("filtered::contact", with_counts([](const Input& in, filtered::StageCounts& n) {
              return filtered::contact(in.ball, in.triangle, n);
            })),
      gives("filtered::contact", prepared_moving<Filtered>([](auto& m, auto& p) { return filtered::contact(m, p); })),
      gives("filtered::contact", counted_moving([](auto& m, auto& p, auto& n) { return filtered::contact(m, p, n); })),
      gives("filtered::contact", [](const Input& in) { return filtered::contact(motion_in(in), in.polygon); }),
      gives("filtered::contact", [](const Input& in) { return filtered::contact(motion_in(in), in.triangle); }),
      gives("filtered::contact", with_counts([](const Input& in, filtered::StageCounts& n) {
              return filtered::contact(motion_in(in), in.triangle, n);
            })),
      gives("filtered::contact",  // many motions
            prepared_moving<Filtered>([](const Motion& motion, const Filtered& polygon) {
              const Motion motions[] = {motion, {motion.ball, motion.ball.center}, {{motion.to, 0}, motion.to}};
              std::array<bool, 3> touches{};
              filtered::contact(motions, polygon, touches);
              return touches;
            })),
      gives("filtered::contact",  // a motion and many triangles
            [](const Input& in) {
              std::array<bool, 3> touches{};
              filtered::contact(motion_in(in), three_orders(in.triangle), touches);
              return touches;
            }),
      gives("filtered::first_contact",
            prepared_moving<Filtered>([](auto& m, auto& p) { return filtered::first_contact(m, p); })),
      gives("filtered::first_contact",
            counted_moving([](auto& m, auto& p, auto& n) { return filtered::first_contact(m, p, n); })),
      gives("filtered::first_contact",
            [](const Input& in) { return filtered::first_contact(motion_in(in), in.polygon); }),
      gives("filtered::first_contact",
            [](const Input& in) { return filtered::first_contact(motion_in(in), flattened(in)); }),
      gives("filtered::first_contact", with_counts([](const Input& in, filtered::StageCounts& n) {
              return filtered::first_contact(motion_in(in), in.triangle, n);
            })),
      gives("filtered::compare_times",
            prepared_moving<Filtered>([](auto& m, auto& p) { return filtered::compare_times(m, p, p); })),
      gives("filtered::compare_times",
            [](const Input& in) {
              const Triangle other{in.triangle.b, in.triangle.c, in.triangle.a};
              return filtered::compare_times(motion_in(in), in.triangle, other);
            }),
      gives("filtered::relation", [](const Input& in) { return filtered::relation(in.ball, flattened(in)); }),
      gives("filtered::closest", [](const Input& in) { return filtered::closest(in.point, flattened(in)); }),
      gives("filtered::closest", with_counts([](const Input& in, filtered::StageCounts& n) {
              return filtered::closest(in.point, in.triangle, n);
            })),
      gives("filtered::contact",  // many balls
            prepared<Filtered>([](const Ball& ball, const Filtered& polygon) {
              const Ball balls[] = {ball, {ball.center, 0}, {ball.center, -0.0}};
              std::array<bool, 3> touches{};
              filtered::contact(balls, polygon, touches);
              return touches;
            })),
      gives("filtered::contact",  // many triangles
            [](const Input& in) {
              std::array<bool, 3> touches{};
              filtered::contact(in.ball, three_orders(in.triangle), touches);
              return touches;
            }),
  };
}

}  // namespace

std::vector<PublicFunction> contact_functions() {
  std::vector<PublicFunction> all = exact_functions();
  for (const auto& more : {filtered_functions(), set_functions()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace touchstone::every_state_tests
