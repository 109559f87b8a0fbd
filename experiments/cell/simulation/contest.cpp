// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/simulation/contest.h"

#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "experiments/cases/comparison.h"
#include "geometry/bvh/box.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"
#include "robust/scene/detail/lifted_box.h"

namespace touchstone::cell {
namespace {

/// A face as every method has prepared it.
struct Contested {
  std::string owner;
  std::size_t number;
  Polygon polygon;
  touchstone::Box box;
  std::vector<std::unique_ptr<cases::PreparedMethod>> prepared;  // one a method, when it is first asked
};

std::vector<Contested> contested(const scene::Faces& faces, const std::vector<std::string>& owners) {
  std::vector<Contested> all;
  const auto add = [&](const Polygon& polygon) {
    const touchstone::Box box = scene::lifted_box(polygon, filtered::PreparedPolygon(polygon));
    all.push_back({owners.size() == 1 ? owners.front() : owners[all.size()], all.size(), polygon, box, {}});
  };
  for (const Triangle& t : faces.triangles) add(Polygon({t.a, t.b, t.c}));
  for (const Polygon& polygon : faces.polygons) add(polygon);
  return all;
}

/// Rounded outwards by more than the sums are rounded: a ball that touches what is in the box meets it.
bool meets(const Ball& ball, const touchstone::Box& box) {
  const Eigen::Array3d reach = ball.radius + 1e-12 * (ball.center.array().abs() + ball.radius);
  return (ball.center.array() - reach <= box.high.array()).all() &&
         (ball.center.array() + reach >= box.low.array()).all();
}

class Jury {
 public:
  Jury(const std::vector<const cases::Method*>& methods, bool every_face) : every_face_(every_face) {
    for (const cases::Method* method : methods) result.scores.push_back({method});
  }

  void hear(std::size_t stop, const Ball& sphere, std::vector<Contested>& faces) {
    for (Contested& face : faces) {
      ++result.pairs;
      const bool met = meets(sphere, face.box);
      if (met) ++result.met;
      if (met || every_face_) hear(stop, sphere, face, met);
    }
  }

  Contest result;

 private:
  void hear(std::size_t stop, const Ball& sphere, Contested& face, bool met) {
    cases::PartialAnswer truth;
    truth.contact = met && exact::contact(sphere, face.polygon);
    face.prepared.resize(result.scores.size());
    std::vector<std::string> wrong;
    for (std::size_t i = 0; i < result.scores.size(); ++i) {
      Score& score = result.scores[i];
      if (!met && score.method->slow()) continue;
      if (!face.prepared[i]) face.prepared[i] = score.method->prepare(face.polygon);
      const auto answer = face.prepared[i]->ask(sphere, cases::QueryKind::Contact);
      ++score.asked;
      const auto outcome = cases::compare(cases::Test::Contact, answer, truth, true);
      if (!outcome) ++score.unsure;
      if (!outcome || *outcome == cases::Outcome::Right) continue;
      ++(*outcome == cases::Outcome::WronglyIn ? score.wrong_hits : score.wrong_misses);
      if (last_wrong_stop_.insert({i, stop}).second) ++score.stops;
      wrong.emplace_back(score.method->name());
    }
    if (!wrong.empty())
      result.disagreements.push_back({stop, face.owner, face.number, sphere, face.polygon, std::move(wrong)});
  }

  bool every_face_;
  std::set<std::pair<std::size_t, std::size_t>> last_wrong_stop_;  // method, stop
};

}  // namespace

Contest hold_contest(const Workcell& workcell, const Process& process, const std::vector<const cases::Method*>& methods,
                     bool every_face) {
  const Obstacles& obstacles = workcell.obstacles();
  std::vector<Contested> standing = contested(obstacles.faces, obstacles.owners);
  std::vector<std::vector<Contested>> material;
  for (const Place place : {Place::Storage, Place::Machine})
    material.push_back(contested(workcell.at(place).faces, {"material"}));

  Jury jury(methods, every_face);
  auto custody = process.custody.begin();
  for (std::size_t i = 0; i < process.stops.size(); ++i) {
    const Stop& stop = process.stops[i];
    while (custody + 1 != process.custody.end() && (custody + 1)->stop < i) ++custody;
    jury.hear(i, stop.sphere, standing);
    for (const Place place : {Place::Storage, Place::Machine})
      if (custody->place == place || stop.target == place)
        jury.hear(i, stop.sphere, material[static_cast<std::size_t>(place)]);
  }
  return std::move(jury.result);
}

}  // namespace touchstone::cell
