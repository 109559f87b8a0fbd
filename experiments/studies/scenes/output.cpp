// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/scenes/output.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "experiments/cases/verdict.h"

namespace touchstone::scenes {
namespace {

using cases::Verdict;
using scene::FaceId;

Verdict face(FaceId id, const std::vector<Object>& objects) {
  const Object& object = objects[id.object];
  return {{"object", object.name}, {"face", object.numbers[id.face]}};
}

}  // namespace

std::string answer_line(const NamedBall& ball, const BallAnswer& answer, Question question,
                        const std::vector<Object>& objects) {
  const auto point = [](const Eigen::Vector3d& p) { return Verdict{p.x(), p.y(), p.z()}; };
  Verdict line = Verdict::object();
  line["id"] = ball.id;
  line["ball"] = {{"center", point(ball.ball.center)}, {"radius", ball.ball.radius}};
  if (question == Question::Any) line["touches"] = !answer.touched.empty();
  if (question == Question::All) {
    line["touched"] = Verdict::array();
    // The scene numbers triangles first, the mesh does not.
    std::vector<FaceId> touched = answer.touched;
    std::ranges::sort(touched, {},
                      [&](FaceId id) { return std::pair(id.object, objects[id.object].numbers[id.face]); });
    for (const FaceId id : touched) line["touched"].push_back(face(id, objects));
  }
  if (question == Question::Nearest) {
    line["nearest"] = nullptr;
    if (answer.nearest) {
      cases::PartialAnswer keys;
      keys.nearest = answer.nearest->feature;
      keys.point = answer.nearest->point;
      keys.distance = answer.nearest->distance;
      const Verdict found = cases::object_of(keys);
      Verdict nearest = face(answer.nearest->face, objects);
      nearest["feature"] = found["nearest"];
      nearest["point"] = found["point"];
      nearest["distance"] = found["distance"];
      line["nearest"] = nearest;
    }
  }
  return cases::to_line(line);
}

void Differences::add(const BallAnswer& given, const BallAnswer& truth, Question question) {
  ++balls;
  unsure += given.unsure > 0 ? 1 : 0;
  bool differs = false;
  switch (question) {
    case Question::Any: differs = given.touched.empty() != truth.touched.empty(); break;
    case Question::All: differs = given.touched != truth.touched; break;
    case Question::Nearest: {
      const bool both = given.nearest && truth.nearest;
      const bool other = !both || given.nearest->distance != truth.nearest->distance;  // compared as rounded
      differs = both ? other && given.nearest->face != truth.nearest->face : given.nearest || truth.nearest;
      distances += both && other ? 1 : 0;
      break;
    }
  }
  answers += differs ? 1 : 0;
}

}  // namespace touchstone::scenes
