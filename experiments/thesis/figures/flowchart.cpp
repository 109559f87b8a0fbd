// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/flowchart.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "experiments/cases/method.h"
#include "experiments/methods/registry.h"

namespace touchstone::figures {
namespace {

using cases::PreparedMethod;
using cases::QueryKind;

std::unique_ptr<PreparedMethod> prepare(std::string_view name, const Polygon& polygon) {
  return methods::find_method(name)->prepare(polygon);
}

End end_of(const PreparedMethod& method, const Ball& ball) {
  const PlaneSide side = method.ask(ball, QueryKind::PlaneSide).plane.value();
  if (side == PlaneSide::InFront) return End::InFront;
  if (side == PlaneSide::Behind) return End::Behind;
  if (method.ask(ball, QueryKind::Foot).foot.value() != PointLocation::Outside) return End::Inside;
  return method.ask(ball, QueryKind::EdgesHit).edges_hit.value().empty() ? End::Neither : End::Edge;
}

End turned(End end) {
  if (end == End::InFront) return End::Behind;
  if (end == End::Behind) return End::InFront;
  return end;
}

bool in_box(const Ball& ball, const Box& box) {
  const auto& c = ball.center;
  const Box reach = box.enlarged(ball.radius, ball.radius);
  return c.x() >= reach.left && c.x() <= reach.right && c.y() >= reach.bottom && c.y() <= reach.top &&
         std::abs(c.z()) <= ball.radius;
}

}  // namespace

std::string_view to_string(End end) {
  constexpr std::array<std::string_view, kEnds.size()> words{"in front", "behind", "inside: collision",
                                                             "edge: collision", "no collision"};
  return words[static_cast<std::size_t>(end)];
}

Ends& Ends::operator+=(const Ends& other) {
  for (std::size_t i = 0; i < counts.size(); ++i)
    for (std::size_t j = 0; j < counts[i].size(); ++j) counts[i][j] += other.counts[i][j];
  return *this;
}

namespace {

template <class Selected>
std::uint64_t sum(const Ends& ends, const Selected& selected) {
  std::uint64_t sum = 0;
  for (const End method : kEnds)
    for (const End exact : kEnds)
      if (selected(method, exact))
        sum += ends.counts[static_cast<std::size_t>(method)][static_cast<std::size_t>(exact)];
  return sum;
}

}  // namespace

std::uint64_t Ends::samples() const {
  return sum(*this, [](End, End) { return true; });
}
std::uint64_t Ends::at(End method) const {
  return sum(*this, [=](End its, End) { return its == method; });
}
std::uint64_t Ends::exactly_at(End exact) const {
  return sum(*this, [=](End, End its) { return its == exact; });
}
std::uint64_t Ends::elsewhere() const {
  return sum(*this, [](End method, End exact) { return method != exact; });
}
std::uint64_t Ends::true_hits() const {
  return sum(*this, [](End method, End exact) { return is_hit(method) && is_hit(exact); });
}
std::uint64_t Ends::false_hits() const {
  return sum(*this, [](End method, End exact) { return is_hit(method) && !is_hit(exact); });
}
std::uint64_t Ends::misses() const {
  return sum(*this, [](End method, End exact) { return !is_hit(method) && is_hit(exact); });
}

Flowchart measure_flowchart(const Outline& outline, double radius, std::uint64_t balls, std::uint64_t seed,
                            std::uint64_t stream) {
  Flowchart flowchart{&outline, radius};
  const Polygon polygon = outline.polygon();
  const Box inner = bounds(outline);
  const double r = radius * std::max(inner.width(), inner.height());
  const Box box = inner.enlarged(3 * r, 3 * r);
  const auto truth = prepare("filtered", polygon);
  const Ball far{{inner.left, inner.bottom, 2 * r}, r};
  std::array<std::unique_ptr<PreparedMethod>, kMethods.size()> prepared;
  std::array<bool, kMethods.size()> swapped{};
  for (std::size_t m = 0; m < kMethods.size(); ++m) {
    prepared[m] = prepare(kMethods[m], polygon);
    swapped[m] = end_of(*prepared[m], far) != end_of(*truth, far);
  }
  for (std::uint64_t i = 0; i < balls; ++i) {
    workloads::Random random(seed, i, stream);
    Ball ball{box.point(random), r};
    ball.center.z() = 1.5 * r * (2 * random.unit() - 1);
    const End exact = end_of(*truth, ball);
    for (std::size_t m = 0; m < kMethods.size(); ++m) {
      const End end = end_of(*prepared[m], ball);
      flowchart.methods[m].add(end, swapped[m] ? turned(exact) : exact);
      if (m == 0 && is_hit(end) && !is_hit(exact) && !in_box(ball, inner)) ++flowchart.culled;
    }
  }
  return flowchart;
}

}  // namespace touchstone::figures
