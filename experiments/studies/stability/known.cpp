// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/known.h"

#include <Eigen/Geometry>
#include <cmath>
#include <exception>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/triangle_queries.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/methods/ericson.h"
#include "experiments/studies/stability/stress.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "robust/filtered/detail/signs/signs.h"

namespace touchstone::stability {
namespace {

using workloads::Random;

Eigen::Vector3d random_point(Random& random) {
  const double x = 2 * random.unit() - 1, y = 2 * random.unit() - 1;
  return {x, y, 2 * random.unit() - 1};
}

struct Above {
  Triangle triangle;
  Eigen::Vector3d center;
  double distance;  ///< the double nearest to that of the centre to the triangle, whose face is nearest

  [[nodiscard]] Polygon polygon() const { return Polygon({triangle.a, triangle.b, triangle.c}); }
};

std::optional<Above> draw_once(Random& random, double origin_distance) {
  Eigen::Vector3d a = random_point(random), b = random_point(random), c = random_point(random);
  const double size = (a.cwiseMax(b).cwiseMax(c) - a.cwiseMin(b).cwiseMin(c)).maxCoeff();
  const Eigen::Vector3d away = random_point(random);
  const Eigen::Vector3d origin = origin_distance * size / away.norm() * away;
  a += origin;
  b += origin;
  c += origin;
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double share = random.unit(), other = (1 - share) * random.unit();
  Above above{{a, b, c}, a + share * (b - a) + other * (c - a) + (0.25 + random.unit()) / normal.norm() * normal, 0};
  if (exact::validate(above.polygon())) return std::nullopt;
  const Answer answer = exact::answer({above.center, 0}, above.polygon());
  if (answer.nearest.kind != Feature::Kind::Face) return std::nullopt;
  above.distance = answer.distance;
  return above;
}

/// The closest point of the triangle's plane as coordinates, and whether it is within the ball. Where the face is
/// nearest, that is the closest point of the triangle.
bool absolute_contact(const Ball& ball, const Triangle& t) {
  const Eigen::Vector3d ab = t.b - t.a, ac = t.c - t.a, ap = ball.center - t.a, bp = ball.center - t.b,
                        cp = ball.center - t.c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
  const double opposite_a = d3 * d6 - d5 * d4, opposite_b = d5 * d2 - d1 * d6, opposite_c = d1 * d4 - d3 * d2;
  const double scale = 1 / (opposite_a + opposite_b + opposite_c);
  const Eigen::Vector3d closest = t.a + opposite_b * scale * ab + opposite_c * scale * ac;
  return (ball.center - closest).squaredNorm() <= ball.radius * ball.radius;
}

Above draw_above(std::uint64_t seed, std::uint64_t index, std::size_t distance) {
  constexpr std::uint64_t kStream = std::uint64_t{1} << 51;
  Random random(seed, index, kStream + distance);
  while (true)
    if (auto above = draw_once(random, kOnsetDistances[distance])) return *std::move(above);
}

/// contact(ball) for each offset, above and below; what throws is wrong.
template <class Contact>
void ask(const Above& above, std::size_t distance, std::size_t method, Onset& onset, const Contact& contact) {
  const auto wrong = [&](double offset) {
    try {
      return contact(Ball{above.center, above.distance * (1 + offset)}) != (offset > 0);
    } catch (const std::exception&) {
      return true;
    }
  };
  for (int k = kCoarsest; k <= kFinest; ++k) {
    const double offset = std::ldexp(1.0, -k);
    onset.add_wrong(distance, method, k, (wrong(offset) ? 1U : 0U) + (wrong(-offset) ? 1U : 0U));
  }
}

/// Returns nothing if the method throws.
std::unique_ptr<cases::PreparedMethod> prepare(const cases::Method& method, const Polygon& polygon) {
  try {
    return method.prepare(polygon);
  } catch (const std::exception&) {
    return nullptr;
  }
}

std::vector<std::string> names_of(const std::vector<const cases::Method*>& methods) {
  std::vector<std::string> names{"ericson-absolute", "ericson"};
  for (const auto* method : methods) names.emplace_back(method->name());
  return names;
}

}  // namespace

Onset::Onset(std::vector<std::string> methods)
    : methods_(std::move(methods)), failures_(place(std::size(kOnsetDistances), 0, kCoarsest)), wrong_(failures_) {}

int Onset::first(std::size_t distance, std::size_t method, double share) const {
  for (int k = kCoarsest; k <= kFinest; ++k) {
    const std::uint64_t failed = failures(distance, method, k);
    if (failed > 0 && static_cast<double>(failed) >= share * static_cast<double>(triangles_)) return k;
  }
  return 0;
}

Onset no_onset(const std::vector<const cases::Method*>& methods) { return Onset(names_of(methods)); }

void find_onset(const std::vector<const cases::Method*>& methods, std::uint64_t triangles, std::uint64_t seed,
                unsigned threads, const run::RunControl& control, Onset& onset) {
  const auto ask_all = [&](std::uint64_t index, Onset& part) {
    for (std::size_t distance = 0; distance < std::size(kOnsetDistances); ++distance) {
      const Above above = draw_above(seed, index, distance);
      ask(above, distance, 0, part, [&](const Ball& ball) { return absolute_contact(ball, above.triangle); });
      ask(above, distance, 1, part, [&](const Ball& ball) { return methods::ericson_contact(ball, above.triangle); });
      for (std::size_t m = 0; m < methods.size(); ++m) {
        const auto prepared = prepare(*methods[m], above.polygon());
        ask(above, distance, m + 2, part, [&](const Ball& ball) {
          if (!prepared) throw std::runtime_error("not prepared");
          return prepared->ask(ball, cases::QueryKind::Contact).contact.value();
        });
      }
    }
    part.add_triangle();
  };
  run::run_sweep(triangles, threads, control, no_onset(methods), onset, ask_all);
}

namespace {

using filtered::detail::Vector3;
using workloads::Random;
namespace signs = filtered::detail::signs;

/// A double that remembers whether it is a product: a sum with a product is one fused multiply-add, as a compiler that
/// contracts makes it, with the product on the right where both are.
struct Fused {
  double value;
  bool product = false;
  double left = 0, right = 0;

  friend Fused operator*(const Fused& a, const Fused& b) { return {a.value * b.value, true, a.value, b.value}; }
  friend Fused operator+(const Fused& a, const Fused& b) {
    if (b.product) return {std::fma(b.left, b.right, a.value)};
    if (a.product) return {std::fma(a.left, a.right, b.value)};
    return {a.value + b.value};
  }
  friend Fused operator-(const Fused& a, const Fused& b) {
    if (b.product) return {std::fma(-b.left, b.right, a.value)};
    if (a.product) return {std::fma(a.left, a.right, -b.value)};
    return {a.value - b.value};
  }
};

int sign_of(double value) { return (value > 0) - (value < 0); }
int sign_of(const Fused& value) { return sign_of(value.value); }
int sign_of(const Rational& value) { return sgn(value.value); }

/// The differences that an expression is about, as the doubles that they are.
struct Operands {
  Eigen::Vector3d from, edge, normal;
  double radius;
};

/// The sign of expression(from, edge, normal, radius) over a number type.
template <class Number, class Expression>
int sign_over(const Operands& operands, const Expression& expression) {
  const auto vector = [](const Eigen::Vector3d& v) { return Vector3<Number>{{v.x()}, {v.y()}, {v.z()}}; };
  return sign_of(
      expression(vector(operands.from), vector(operands.edge), vector(operands.normal), Number{operands.radius}));
}

template <class Expression>
void count(const Operands& operands, const Expression& expression, ContractionCount& counts) {
  const auto number = [&](auto zero) { return sign_over<decltype(zero)>(operands, expression); };
  const int plain = number(double{}), fused = number(Fused{0}), exact = number(Rational{});
  ++counts.trials;
  counts.plain_wrong += plain != exact ? 1 : 0;
  counts.fused_wrong += fused != exact ? 1 : 0;
  counts.differ += plain != fused ? 1 : 0;
}

constexpr auto kOrientation = [](const auto& from, const auto& edge, const auto&, const auto&) {
  return edge.x * from.y - edge.y * from.x;
};
constexpr auto kSide = [](const auto& from, const auto& edge, const auto& normal, const auto&) {
  return signs::side(normal, edge, from);
};
constexpr auto kLine = [](const auto& from, const auto& edge, const auto&, const auto& radius) {
  return signs::line(from, edge, radius);
};
constexpr auto kPlane = [](const auto& from, const auto&, const auto& normal, const auto& radius) {
  return signs::plane(normal, from, radius);
};

Operands collinear(Random& random) {
  const Eigen::Vector3d edge = random_point(random);
  const Eigen::Vector3d from = std::ldexp(1.0, static_cast<int>(random.integer(-3, 3))) * edge;
  return {from, edge, random_point(random), 1};
}

/// Differences of integers below 2^21, and a normal of integers below 2^44: all exact.
Operands touching(Random& random) {
  const auto [ball, t] = workloads::draw_lattice_tangent(random);
  const Eigen::Vector3d u = t.b - t.a, v = t.c - t.a;
  return {ball.center - t.a,
          u,
          {u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(), u.x() * v.y() - u.y() * v.x()},
          ball.radius};
}

}  // namespace

std::vector<ContractionCount> count_contractions(std::uint64_t trials, std::uint64_t seed) {
  constexpr std::string_view zero = "exactly zero", beside = "one double beside";
  std::vector<ContractionCount> counts{{"orientation", zero}, {"orientation", beside}, {"side", zero},
                                       {"side", beside},      {"line", zero},          {"line", beside},
                                       {"plane", zero},       {"plane", beside}};
  constexpr std::uint64_t kStream = std::uint64_t{1} << 52;
  for (std::uint64_t i = 0; i < trials; ++i) {
    Random random(seed, i, kStream);
    Operands operands = collinear(random);
    count(operands, kOrientation, counts[0]);
    count(operands, kSide, counts[2]);
    double& moved = operands.from[static_cast<int>(random.integer(0, 1))];
    moved = workloads::move_by_doubles(moved, random.coin() ? 1 : -1);
    count(operands, kOrientation, counts[1]);
    count(operands, kSide, counts[3]);
  }
  const auto touching_count = [&](std::uint64_t stream, const auto& expression, ContractionCount& at,
                                  ContractionCount& next_to) {
    for (std::uint64_t i = 0; at.trials < trials; ++i) {
      Random random(seed, i, kStream + stream);
      Operands operands = touching(random);
      if (sign_over<Rational>(operands, expression) != 0) continue;  // another feature is touched
      count(operands, expression, at);
      operands.radius = workloads::move_by_doubles(operands.radius, random.coin() ? 1 : -1);
      count(operands, expression, next_to);
    }
  };
  touching_count(1, kLine, counts[4], counts[5]);
  touching_count(2, kPlane, counts[6], counts[7]);
  return counts;
}

namespace {

using run::path;

struct OnsetRow {
  double distance;
  std::string_view method;
  int exponent;
  std::uint64_t failed, triangles, wrong;
  run::Rate rate;
};

const run::Table<OnsetRow>& onset_table() {
  static const run::Table<OnsetRow> table(
      "onset.csv", "a distance from the origin, method and offset",
      run::all_columns<OnsetRow>(
          {{{"origin_distance", "of the triangle, in multiples of its size", &OnsetRow::distance},
            {"method", "the method", &OnsetRow::method},
            {"offset_exponent", "of the radius: 2^this of the exact distance", &OnsetRow::exponent},
            {"failed_triangles", "triangles with a wrong answer", &OnsetRow::failed},
            {"triangles", "triangles", &OnsetRow::triangles}},
           run::rate_columns<OnsetRow>("failed triangles", &OnsetRow::rate),
           {{"wrong_answers", "wrong answers", &OnsetRow::wrong},
            {"answers", "answers, two for each triangle", [](const OnsetRow& row) { return 2 * row.triangles; }}}}));
  return table;
}

struct ContractionRow {
  ContractionCount count;
  run::Rate plain, fused;
};

const run::Table<ContractionRow>& contraction_table() {
  using Row = ContractionRow;
  static const run::Table<Row> table(
      "contraction.csv", "a sign and a family of exact values",
      run::all_columns<Row>(
          {{{"sign", "the expression whose sign is computed", path(&Row::count, &ContractionCount::sign)},
            {"family", "its exact value", path(&Row::count, &ContractionCount::family)},
            {"trials", "trials", path(&Row::count, &ContractionCount::trials)},
            {"plain_wrong", "wrong signs without contraction", path(&Row::count, &ContractionCount::plain_wrong)}},
           run::rate_columns<Row>("wrong signs without contraction", &Row::plain, "plain_"),
           {{"fused_wrong", "wrong signs with fused multiply-adds", path(&Row::count, &ContractionCount::fused_wrong)}},
           run::rate_columns<Row>("wrong signs with fused multiply-adds", &Row::fused, "fused_"),
           {{"signs_differ", "trials in which the two differ", path(&Row::count, &ContractionCount::differ)}}}));
  return table;
}

}  // namespace

void write_known(const std::filesystem::path& folder, const Known& known) {
  const Onset& onset = known.onset;
  std::vector<OnsetRow> onsets;
  for (std::size_t d = 0; d < std::size(kOnsetDistances); ++d)
    for (std::size_t m = 0; m < onset.methods().size(); ++m)
      for (int k = kCoarsest; k <= kFinest; ++k)
        onsets.push_back({kOnsetDistances[d], onset.methods()[m], -k, onset.failures(d, m, k), onset.triangles(),
                          onset.wrong(d, m, k), run::rate(onset.failures(d, m, k), onset.triangles())});
  onset_table().write(folder, onsets);

  std::vector<ContractionRow> contractions;
  for (const ContractionCount& c : known.contractions)
    contractions.push_back({c, run::rate(c.plain_wrong, c.trials), run::rate(c.fused_wrong, c.trials)});
  contraction_table().write(folder, contractions);
}

std::vector<run::TableDescription> known_tables() {
  return {onset_table().description(), contraction_table().description()};
}

}  // namespace touchstone::stability
