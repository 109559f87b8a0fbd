// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "experiments/cases/verdict.h"
#include "experiments/cases/workloads/meshes.h"
#include "experiments/judge/ask.h"
#include "experiments/program/command.h"
#include "experiments/program/input.h"
#include "experiments/program/sweep.h"
#include "geometry/io/detail/legible.h"
#include "geometry/io/detail/text_number.h"
#include "robust/filtered/filtered.h"
#include "robust/mesh/scene_faces.h"

namespace touchstone::judge {
namespace {

using cases::Json;
using cases::PartialAnswer;

/// Returns the ball of a line, of which the comment is cut off. Throws std::invalid_argument.
cases::Question question_of(std::string_view text) {
  constexpr const char* kBlanks = " \t\r";
  std::array<double, 7> numbers{};
  std::size_t count = 0;
  for (std::size_t begin = 0; (begin = text.find_first_not_of(kBlanks, begin)) != std::string_view::npos; ++count) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, begin), text.size());
    const std::string_view field = text.substr(begin, end - begin);
    const auto value = io::nearest_double(field);
    if (!value) throw std::invalid_argument(fmt::format("'{}' is not a number", io::legible(field, 40)));
    if (count < numbers.size()) numbers[count] = *value;
    begin = end;
  }
  if (count != 4 && count != 7)
    throw std::invalid_argument(fmt::format("expected four numbers, x y z r, or seven, found {}", count));
  const auto& [x, y, z, radius, to_x, to_y, to_z] = numbers;
  const Ball ball{{x, y, z}, radius};
  const cases::Question question = count == 4 ? cases::Question(ball) : Motion{ball, {to_x, to_y, to_z}};
  const auto fault = std::visit([](const auto& asked) { return find_fault(asked); }, question);
  if (fault) throw std::invalid_argument(fault->message);
  return question;
}

std::vector<ListedBall> read_balls(std::istream& stream, const std::string& name) {
  std::vector<ListedBall> balls;
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      balls.push_back({number, question_of(line)});
    } catch (const std::invalid_argument& fault) {
      throw std::runtime_error(fmt::format("{}: line {}: {}", name, number, fault.what()));
    }
  }
  if (stream.bad()) throw std::runtime_error(name + ": cannot be read to its end");
  return balls;
}

/// Returns the keys that name a face of the mesh, and those of the answer about it.
Json face(const AskedMesh& mesh, scene::FaceId id, const PartialAnswer& answer = {}) {
  Json keys = {{"object", mesh.scene.name(id.object)}, {"face", mesh.numbers[id.face]}};
  if (mesh.off_plane[id.face] > 0) keys["off_plane"] = mesh.off_plane[id.face];
  keys.update(cases::object_of(answer));
  return keys;
}

Json nearest_face(const AskedMesh& mesh, const scene::NearestFace& nearest) {
  PartialAnswer answer;
  answer.feature = nearest.feature;
  answer.point = nearest.point;
  answer.distance = nearest.distance;
  answer.contact_normal = nearest.contact_normal;
  answer.depth = nearest.depth;
  return face(mesh, nearest.face, answer);
}

Json touched_faces(const AskedMesh& mesh, std::vector<scene::FaceId> touched) {
  // The scene numbers triangles first, the mesh does not.
  std::ranges::sort(touched, {}, [&](scene::FaceId id) { return mesh.numbers[id.face]; });
  Json faces = Json::array();
  for (const scene::FaceId id : touched) faces.push_back(face(mesh, id));
  return faces;
}

Json touched_faces(const AskedMesh& mesh, const std::vector<scene::FirstFace>& touched) {
  Json faces = Json::array();
  for (const auto& [id, first] : touched) {
    PartialAnswer answer = PartialAnswer::of(first, 0, "");
    answer.contact.reset();    // it is one of those that are touched
    answer.off_plane.reset();  // the face has it
    faces.push_back(face(mesh, id, answer));
  }
  return faces;
}

}  // namespace

AskedMesh read_asked_mesh(const std::string& file) {
  ReadMesh read = workloads::read_with_warnings(file, OnFault::Refuse);
  mesh::MeshFaces found = mesh::scene_faces(read.mesh, mesh::OnBadFace::LeaveOut);
  if (!found.left_out.empty())
    throw std::runtime_error(workloads::sentence_of_face(file, read, found.left_out.front()));
  AskedMesh asked{std::move(read.mesh), {}, std::move(found.numbers), {}};
  asked.off_plane.resize(found.faces.triangles.size());
  for (const Polygon& polygon : found.faces.polygons)
    asked.off_plane.push_back(filtered::answer(Ball{polygon.vertex(0), 0}, polygon).off_plane);
  asked.scene.add(io::all_legible(workloads::short_names({file}).front()), std::move(found.faces));
  return asked;
}

std::vector<ListedBall> read_balls(const std::string& file) {
  if (file == "-") {
    program::announce_standard_input("balls");
    return read_balls(std::cin, "standard input");
  }
  std::ifstream stream = program::open_file(file);
  return read_balls(stream, file);
}

std::string answers_about(const AskedMesh& mesh, std::span<const ListedBall> balls, bool nearest) {
  std::vector<Ball> places;
  std::vector<Motion> motions;
  std::vector<std::size_t> numbers;  // of each ball among those at places or those that move
  for (const ListedBall& ball : balls) {
    const auto* motion = std::get_if<Motion>(&ball.question);
    numbers.push_back(motion != nullptr ? motions.size() : places.size());
    if (motion != nullptr)
      motions.push_back(*motion);
    else
      places.push_back(std::get<Ball>(ball.question));
  }
  const scene::Scene& scene = mesh.scene;
  using OfAll = std::vector<std::vector<scene::FaceId>>;
  const auto nearest_of_all = nearest ? scene.nearest(places) : std::vector<std::optional<scene::NearestFace>>();
  const OfAll touched = nearest ? OfAll() : scene.touched(places);
  const auto touched_on_ways = scene.touched_in_order(motions);

  std::vector<std::string> lines(balls.size());
  const auto write = [&](std::size_t i) {
    const cases::Question& question = balls[i].question;
    Json line{{"id", std::to_string(balls[i].line)}, {"ball", cases::object_of(cases::ball_of(question))}};
    if (const auto* motion = std::get_if<Motion>(&question)) {
      line["motion"] = cases::object_of(*motion);
      line["touched"] = touched_faces(mesh, touched_on_ways[numbers[i]]);
    } else if (nearest) {
      line["nearest"] = nearest_face(mesh, *nearest_of_all[numbers[i]]);
    } else {
      line["touched"] = touched_faces(mesh, touched[numbers[i]]);
    }
    lines[i] = cases::to_line(line);
  };
  constexpr std::size_t kLines = 256;  // about two milliseconds
  const std::atomic<bool> never = false;
  program::run_blocks((lines.size() + kLines - 1) / kLines, program::all_threads(), never, [](std::uint64_t) {},
                      [&](unsigned, std::uint64_t block) {
                        for (std::size_t i = block * kLines; i < std::min((block + 1) * kLines, lines.size()); ++i)
                          write(i);
                      });
  return fmt::format("{}", fmt::join(lines, ""));
}

}  // namespace touchstone::judge
