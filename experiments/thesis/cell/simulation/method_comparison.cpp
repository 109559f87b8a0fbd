// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/method_comparison.h"

#include <cmath>
#include <map>
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
struct PreparedFace {
  std::string owner;
  std::size_t number;
  Polygon polygon;
  filtered::PreparedPolygon certified;
  touchstone::Box box;
  std::vector<std::unique_ptr<cases::PreparedMethod>> prepared;  // one a method, when it is first asked
};

std::vector<PreparedFace> prepared(const scene::Faces& faces, const std::vector<std::string>& owners) {
  std::vector<PreparedFace> all;
  for (const Polygon& polygon : polygons_of(faces)) {
    filtered::PreparedPolygon certified(polygon);
    const touchstone::Box box = scene::detail::lifted_box(polygon, certified);
    const std::string& owner = owners.size() == 1 ? owners.front() : owners[all.size()];
    all.push_back({owner, all.size(), polygon, std::move(certified), box, {}});
  }
  return all;
}

/// Rounded outwards by more than the sums are rounded: a ball that touches what is in the box meets it.
bool meets(const Ball& ball, const touchstone::Box& box) {
  const Eigen::Array3d reach = ball.radius + 1e-12 * (ball.center.array().abs() + ball.radius);
  return (ball.center.array() - reach <= box.high.array()).all() &&
         (ball.center.array() + reach >= box.low.array()).all();
}

class Comparer {
 public:
  Comparer(const std::vector<const cases::Method*>& methods, bool every_face, bool nearness)
      : every_face_(every_face), nearness_(nearness) {
    for (const cases::Method* method : methods) result.scores.push_back({method});
  }

  void compare(std::size_t stop, const Ball& sphere, std::vector<PreparedFace>& faces) {
    for (PreparedFace& face : faces) {
      ++result.pairs;
      const bool met = meets(sphere, face.box);
      if (met) ++result.met;
      if (met || every_face_) compare(stop, sphere, face, met);
    }
  }

  MethodComparison result;

 private:
  void count_nearness(const Ball& sphere, const PreparedFace& face) {
    const double size = (face.box.high.array() - face.box.low.array()).maxCoeff();
    const double share = std::abs(filtered::answer(sphere, face.certified).distance - sphere.radius) / size;
    for (std::size_t k = 0; k <= kNearest && share <= std::ldexp(1, -static_cast<int>(k)); ++k) ++result.near[k];
  }

  void compare(std::size_t stop, const Ball& sphere, PreparedFace& face, bool met) {
    ++result.questions;
    if (nearness_) count_nearness(sphere, face);
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

  bool every_face_, nearness_;
  std::set<std::pair<std::size_t, std::size_t>> last_wrong_stop_;  // method, stop
};

}  // namespace

MethodComparison compare_methods(const Workcell& workcell, const Process& process,
                                 const std::vector<const cases::Method*>& methods, bool every_face, bool nearness) {
  const Obstacles& obstacles = workcell.obstacles();
  std::vector<PreparedFace> standing = prepared(obstacles.faces, obstacles.owners);
  std::map<Lying, std::vector<PreparedFace>> material;
  const auto faces = [&](const Lying& lies) -> std::vector<PreparedFace>& {
    auto& its = material[lies];
    if (its.empty()) its = prepared(lies->faces, {"material"});
    return its;
  };

  Comparer comparer(methods, every_face, nearness);
  auto transfer = process.transfers.begin();
  for (std::size_t i = 0; i < process.stops.size(); ++i) {
    const Stop& stop = process.stops[i];
    while (transfer + 1 != process.transfers.end() && (transfer + 1)->stop < i) ++transfer;
    comparer.compare(i, stop.sphere, standing);
    for (const StationSlot slot : {StationSlot::Storage, StationSlot::Machine})
      if (transfer->slot == slot || stop.target == slot)
        comparer.compare(i, stop.sphere, faces(transfer->slot == slot ? transfer->lies : workcell.at(slot).copy));
  }
  return std::move(comparer.result);
}

}  // namespace touchstone::cell
