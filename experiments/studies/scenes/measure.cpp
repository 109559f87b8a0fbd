// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/scenes/measure.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/cases/verdict.h"
#include "experiments/cases/workloads/meshes.h"
#include "robust/filtered/filtered.h"
#include "robust/mesh/scene_faces.h"

namespace touchstone::scenes {
namespace {

using scene::FaceId;

constexpr std::uint64_t kBalls = 4096, kMovingBalls = 16, kFaces = 256, kLines = 256;  // a block

struct FaceBlock {
  std::uint32_t object, first, last;
};

std::vector<FaceBlock> all_blocks(const std::vector<Object>& objects, const Order& order) {
  std::vector<FaceBlock> blocks;
  for (const std::uint32_t object : order.objects) {
    const auto faces = static_cast<std::uint32_t>(objects[object].numbers.size());
    for (std::uint32_t first = 0; first < faces; first += kFaces)
      blocks.push_back({object, first, std::min<std::uint32_t>(first + kFaces, faces)});
  }
  return blocks;
}

Polygon face_of(const scene::Faces& faces, std::uint32_t number) {
  if (number >= faces.triangles.size()) return faces.polygons[number - faces.triangles.size()];
  const Triangle& t = faces.triangles[number];
  return Polygon({t.a, t.b, t.c});
}

[[noreturn]] void refuse(const cases::Method& method, const char* what) {
  throw std::invalid_argument("the method " + std::string(method.name()) + " does not compute " + what);
}

/// The contribution of the faces of one block to the answers to all balls.
class BlockAnswers {
 public:
  BlockAnswers(const cases::Method& method, const Order& order, std::size_t balls)
      : method_(method), question_(order.question), answers_(balls) {}

  void ask(const Polygon& polygon, FaceId id, std::span<const NamedBall> balls) {
    const auto prepared = method_.prepare(polygon);
    for (std::size_t i = 0; i < balls.size(); ++i) {
      BallAnswer& answer = answers_[i];
      const auto* const motion = std::get_if<Motion>(&balls[i].question);
      const Ball& ball = cases::ball_of(balls[i].question);
      if (question_ == Question::Nearest) {
        meet_nearest(prepared->ask(ball, cases::QueryKind::Answer), id, answer);
      } else if (question_ == Question::All || answer.touched.empty()) {
        if (motion == nullptr) {
          meet(prepared->ask(ball, cases::QueryKind::Contact), id, answer);
        } else {
          const std::optional<cases::PartialAnswer> found = prepared->ask_moving(*motion);
          if (!found) refuse(method_, "the contact of moving balls");
          if (meet(*found, id, answer) && question_ == Question::All) answer.on_way.push_back({id, *found});
        }
      }
    }
  }
  [[nodiscard]] const std::vector<BallAnswer>& answers() const { return answers_; }

 private:
  /// Returns whether the face is touched.
  bool meet(const cases::PartialAnswer& found, FaceId id, BallAnswer& answer) const {
    if (!found.contact && !found.unsure) refuse(method_, "contact");
    if (!found.contact) ++answer.unsure;
    if (found.contact.value_or(false)) answer.touched.push_back(id);
    return found.contact.value_or(false);
  }
  void meet_nearest(const cases::PartialAnswer& found, FaceId id, BallAnswer& answer) const {
    if (!found.distance || !found.nearest || !found.point) {
      if (!found.unsure) refuse(method_, "the nearest point");
      ++answer.unsure;
    } else if (!answer.nearest || *found.distance < answer.nearest->distance) {
      const Eigen::Vector3d unknown = Eigen::Vector3d::Zero();
      answer.nearest = {id,
                        *found.nearest,
                        *found.point,
                        *found.distance,
                        found.contact_normal.value_or(unknown),
                        found.depth.value_or(0)};
    }
  }

  const cases::Method& method_;
  Question question_;
  std::vector<BallAnswer> answers_;
};

/// Adds what later faces gave.
void add(BallAnswer& answer, const BallAnswer& later, Question question) {
  if (question != Question::Any || answer.touched.empty())
    answer.touched.insert(answer.touched.end(), later.touched.begin(), later.touched.end());
  answer.on_way.insert(answer.on_way.end(), later.on_way.begin(), later.on_way.end());
  if (later.nearest && (!answer.nearest || later.nearest->distance < answer.nearest->distance))
    answer.nearest = later.nearest;
  answer.unsure += later.unsure;
}

using cases::Verdict;
using scene::FaceId;

/// Returns the keys that name a face of a mesh, or those that were merged.
Verdict face(FaceId id, const Order& order, const std::vector<Object>& objects) {
  const Object& object = objects[id.object];
  const std::vector<std::uint32_t>& numbers = object.numbers[id.face];
  Verdict keys = {{"object", object.name}};
  if (order.merged)
    keys["faces"] = numbers;
  else
    keys["face"] = numbers.front();
  const auto segment = std::ranges::lower_bound(object.segments, numbers.front(), {}, &mesh::SegmentFace::face);
  if (segment != object.segments.end() && segment->face == numbers.front()) keys["corners"] = segment->corners;
  if (object.off_plane[id.face] > 0) keys["off_plane"] = object.off_plane[id.face];
  return keys;
}

/// Returns the keys that name the face, and those of its first contact.
Verdict face(const FaceOnWay& touched, const Order& order, const std::vector<Object>& objects) {
  Verdict keys = face(touched.face, order, objects);
  const Verdict first = cases::object_of(touched.first);
  for (const auto& [key, value] : first.items())
    if (key != "contact" && key != "off_plane") keys[key] = value;
  return keys;
}

/// Asks about each ball alone. None is asked for the nearest face if some move.
void ask_each(const scene::Scene& scene, const Order& order, std::span<const NamedBall> balls,
              std::span<BallAnswer> answers) {
  for (std::size_t i = 0; i < balls.size(); ++i) {
    BallAnswer& answer = answers[i];
    std::visit(
        [&](const auto& asked) {
          if (order.question == Question::All) answer.touched = scene.touched(asked, order.objects);
          if (order.question == Question::Any && scene.touches(asked, order.objects)) answer.touched.push_back({});
        },
        balls[i].question);
    if (const auto* motion = std::get_if<Motion>(&balls[i].question); motion && order.question == Question::All)
      for (const auto& [face, first] : scene.touched_in_order(*motion, order.objects))
        answer.on_way.push_back({face, cases::PartialAnswer::of(first, 0, "")});
  }
}

/// The same for balls at places, which walk through the scene together.
void ask_together(const scene::Scene& scene, const Order& order, std::span<const NamedBall> balls,
                  std::span<BallAnswer> answers) {
  std::vector<Ball> places;
  places.reserve(balls.size());
  for (const NamedBall& ball : balls) places.push_back(std::get<Ball>(ball.question));
  if (order.question == Question::Nearest) {
    const auto nearest = scene.nearest(places, order.objects);
    for (std::size_t i = 0; i < balls.size(); ++i) answers[i].nearest = nearest[i];
  } else if (order.question == Question::All) {
    auto touched = scene.touched(places, order.objects);
    for (std::size_t i = 0; i < balls.size(); ++i) answers[i].touched = std::move(touched[i]);
  } else {
    const std::unique_ptr<bool[]> touches(new bool[balls.size()]);
    scene.touches(places, {touches.get(), balls.size()}, order.objects);
    for (std::size_t i = 0; i < balls.size(); ++i)
      if (touches[i]) answers[i].touched.push_back({});
  }
}

/// Returns a line of JSON without its end.
std::string answer_line(const NamedBall& ball, const BallAnswer& answer, const Order& order,
                        const std::vector<Object>& objects) {
  Verdict line = Verdict::object();
  line["id"] = ball.id;
  line["ball"] = cases::object_of(cases::ball_of(ball.question));
  const auto* const motion = std::get_if<Motion>(&ball.question);
  if (motion != nullptr) line["motion"] = cases::object_of(*motion);
  const Question question = order.question;
  if (question == Question::Any) line["touches"] = !answer.touched.empty();
  if (question == Question::All && motion != nullptr) {
    line["touched"] = Verdict::array();
    for (const FaceOnWay& touched : answer.on_way) line["touched"].push_back(face(touched, order, objects));
  } else if (question == Question::All) {
    line["touched"] = Verdict::array();
    // The scene numbers triangles first, the mesh does not.
    std::vector<FaceId> touched = answer.touched;
    std::ranges::sort(touched, {},
                      [&](FaceId id) { return std::pair(id.object, objects[id.object].numbers[id.face]); });
    for (const FaceId id : touched) line["touched"].push_back(face(id, order, objects));
  }
  if (question == Question::Nearest) {
    line["nearest"] = nullptr;
    if (answer.nearest) {
      cases::PartialAnswer keys;
      keys.nearest = answer.nearest->feature;
      keys.point = answer.nearest->point;
      keys.distance = answer.nearest->distance;
      if (!answer.nearest->contact_normal.isZero(0)) {  // the method knows it
        keys.contact_normal = answer.nearest->contact_normal;
        keys.depth = answer.nearest->depth;
      }
      const Verdict found = cases::object_of(keys);
      Verdict nearest = face(answer.nearest->face, order, objects);
      nearest["feature"] = found["nearest"];
      for (const char* key : {"point", "distance", "contact_normal", "depth"})
        if (found.contains(key)) nearest[key] = found[key];
      line["nearest"] = nearest;
    }
  }
  return cases::to_line(line);
}

void take(Object& object, scene::Faces faces) {
  object.off_plane.resize(faces.triangles.size());
  for (const Polygon& polygon : faces.polygons)
    object.off_plane.push_back(filtered::answer(Ball{polygon.vertex(0), 0}, polygon).off_plane);
  object.faces = std::move(faces);
}

}  // namespace

Object object_of(workloads::NamedFile file, Taken taken) {
  Object object{std::move(file.name), {}, {}, {}, {}, {}, 0};
  const Mesh& mesh = file.content.mesh;
  std::vector<mesh::RejectedFace> rejected;
  if (taken == Taken::Merged) {
    mesh::MergedMesh merged = mesh::merge_faces(mesh);
    mesh::SceneFaces faces = mesh::scene_faces(mesh, merged);
    for (const std::uint32_t number : faces.merged) object.numbers.push_back(merged.faces[number].faces);
    take(object, std::move(faces.faces));
    rejected = std::move(merged.rejected);
  } else {
    const bool as_segments = taken == Taken::AsSegments;
    mesh::MeshFaces faces =
        mesh::scene_faces(mesh, as_segments ? mesh::OnBadFace::AsSegmentsOrLeaveOut : mesh::OnBadFace::LeaveOut);
    object.segments = std::move(faces.segments);
    for (const std::uint32_t number : faces.numbers) object.numbers.push_back({number});
    take(object, std::move(faces.faces));
    rejected = std::move(faces.left_out);
  }
  object.faces_rejected = rejected.size();
  for (const mesh::RejectedFace& face : std::span(rejected).first(std::min(rejected.size(), kMostSentences)))
    object.rejected.push_back(workloads::sentence_of_face(file.file, file.content, face));
  return object;
}

std::vector<BallAnswer> ask_scene(const scene::Scene& scene, const Order& order, std::span<const NamedBall> balls,
                                  const std::atomic<bool>& stop) {
  std::vector<BallAnswer> answers(balls.size());
  const bool some_move =
      std::ranges::any_of(balls, [](const NamedBall& ball) { return std::holds_alternative<Motion>(ball.question); });
  const std::uint64_t size = some_move ? kMovingBalls : kBalls, blocks = (balls.size() + size - 1) / size;
  const std::uint64_t done = run::run_blocks(
      blocks, order.threads, stop, [](std::uint64_t) {},
      [&](unsigned, std::uint64_t block) {
        const std::size_t first = block * size, count = std::min<std::size_t>(size, balls.size() - first);
        const auto asked = balls.subspan(first, count);
        const auto answered = std::span(answers).subspan(first, count);
        if (some_move)
          ask_each(scene, order, asked, answered);
        else
          ask_together(scene, order, asked, answered);
      });
  answers.resize(std::min(done * size, balls.size()));
  return answers;
}

std::uint64_t face_blocks(const std::vector<Object>& objects, const Order& order) {
  return all_blocks(objects, order).size();
}

std::vector<BallAnswer> ask_every_face(const cases::Method& method, const std::vector<Object>& objects,
                                       const Order& order, std::span<const NamedBall> balls,
                                       const std::atomic<bool>& stop, const run::Progress& progress) {
  const std::vector<FaceBlock> blocks = all_blocks(objects, order);
  std::vector<std::unique_ptr<BlockAnswers>> parts(blocks.size());
  const std::uint64_t done =
      run::run_blocks(blocks.size(), order.threads, stop, progress, [&](unsigned, std::uint64_t number) {
        const FaceBlock& block = blocks[number];
        parts[number] = std::make_unique<BlockAnswers>(method, order, balls.size());
        for (std::uint32_t face = block.first; face < block.last; ++face)
          parts[number]->ask(face_of(objects[block.object].faces, face), {block.object, face}, balls);
      });
  if (done < blocks.size()) return {};
  std::vector<BallAnswer> answers(balls.size());
  for (const auto& part : parts)
    for (std::size_t i = 0; i < balls.size(); ++i) add(answers[i], part->answers()[i], order.question);
  for (BallAnswer& answer : answers)
    std::ranges::stable_sort(answer.on_way, {},
                             [](const FaceOnWay& touched) { return touched.first.time.value_or(0); });
  return answers;
}

std::vector<std::string> answer_lines(std::span<const NamedBall> balls, std::span<const BallAnswer> answers,
                                      const Order& order, const std::vector<Object>& objects) {
  std::vector<std::string> lines(answers.size());
  const std::atomic<bool> never = false;
  run::run_blocks((lines.size() + kLines - 1) / kLines, order.threads, never, [](std::uint64_t) {},
                  [&](unsigned, std::uint64_t block) {
                    for (std::size_t i = block * kLines; i < std::min<std::size_t>((block + 1) * kLines, lines.size());
                         ++i)
                      lines[i] = answer_line(balls[i], answers[i], order, objects);
                  });
  return lines;
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
