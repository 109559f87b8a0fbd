// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/onset.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <cmath>
#include <exception>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "experiments/cases/workloads/random.h"
#include "experiments/methods/triangle_contacts.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"

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

}  // namespace

Onset::Onset(const std::vector<const cases::Method*>& methods) : methods_{"ericson-absolute", "ericson"} {
  for (const auto* method : methods) methods_.emplace_back(method->name());
  failures_.resize(place(std::size(kOnsetDistances), 0, kCoarsest));
  wrong_ = failures_;
}

std::optional<int> Onset::first(std::size_t distance, std::size_t method) const {
  for (int k = kCoarsest; k <= kFinest; ++k)
    if (failures(distance, method, k) > 0) return k;
  return std::nullopt;
}

void find_onset(const std::vector<const cases::Method*>& methods, std::uint64_t triangles, std::uint64_t seed,
                unsigned threads, const program::RunControl& control, Onset& onset) {
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
  program::run_sweep(triangles, threads, control, Onset(methods), onset, ask_all);
}

namespace {

struct OnsetRow {
  double distance;
  std::string_view method;
  int exponent;
  std::uint64_t failed, triangles, wrong;
  program::Rate rate;
};

const program::Table<OnsetRow>& onset_table() {
  static const program::Table<OnsetRow> table(
      "onset.csv", "a distance from the origin, method and offset",
      program::all_columns<OnsetRow>(
          {{{"origin_distance", "of the triangle, in multiples of its size", &OnsetRow::distance},
            {"method", "the method", &OnsetRow::method},
            {"offset_exponent", "of the radius: 2^this of the exact distance", &OnsetRow::exponent},
            {"failed_triangles", "triangles with a wrong answer", &OnsetRow::failed},
            {"triangles", "triangles", &OnsetRow::triangles}},
           program::rate_columns<OnsetRow>("failed triangles", &OnsetRow::rate),
           {{"wrong_answers", "wrong answers", &OnsetRow::wrong},
            {"answers", "answers, two for each triangle", [](const OnsetRow& row) { return 2 * row.triangles; }}}}));
  return table;
}

}  // namespace

void write_onset(const std::filesystem::path& folder, const Onset& onset) {
  std::vector<OnsetRow> rows;
  for (std::size_t d = 0; d < std::size(kOnsetDistances); ++d)
    for (std::size_t m = 0; m < onset.methods().size(); ++m)
      for (int k = kCoarsest; k <= kFinest; ++k)
        rows.push_back({kOnsetDistances[d], onset.methods()[m], -k, onset.failures(d, m, k), onset.triangles(),
                        onset.wrong(d, m, k), program::rate(onset.failures(d, m, k), onset.triangles())});
  onset_table().write(folder, rows);
}

program::TableDescription onset_description() { return onset_table().description(); }

std::string text(const Onset& onset) {
  std::vector<std::vector<std::string>> lines{{"method", "at the origin", "1e6 sizes away"}};
  for (std::size_t m = 0; m < onset.methods().size(); ++m) {
    auto& line = lines.emplace_back(1, onset.methods()[m]);
    for (std::size_t d = 0; d < std::size(kOnsetDistances); ++d) {
      const auto first = onset.first(d, m);
      line.push_back(first ? fmt::format("2^-{}", *first) : "-");
    }
  }
  return fmt::format(
             "The first wrong contact, by the offset of the radius from the distance to a face, of {} triangles\n",
             onset.triangles()) +
         program::aligned(lines);
}

}  // namespace touchstone::stability
