// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/scenes/balls.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/run/input.h"
#include "experiments/run/json.h"
#include "experiments/studies/scenes/array_of_balls.h"
#include "geometry/io/detail/legible.h"
#include "geometry/io/detail/text_number.h"

namespace touchstone::scenes {
namespace {

using Eigen::Vector3d;
using workloads::Random;

constexpr const char* kBlanks = " \t\r";

/// The reason why a line is not a ball.
struct Fault {
  std::string reason;
};

double number(const nlohmann::json& value, const char* what) {
  if (!value.is_number()) throw Fault{fmt::format("{} is not a number", what)};
  return value.get<double>();
}

const nlohmann::json& member(const nlohmann::json& object, const char* key, const char* owner) {
  const auto found = object.find(key);
  if (found == object.end()) throw Fault{fmt::format("{} has no key \"{}\"", owner, key)};
  return *found;
}

Vector3d point(const nlohmann::json& value, const std::string& what) {
  if (!value.is_array() || value.size() != 3) throw Fault{what + " is not a point of three numbers"};
  const auto coordinate = [&](std::size_t axis) { return number(value[axis], ("a coordinate of " + what).c_str()); };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

NamedBall from_json(const std::string& text, std::string id) {
  const run::StrictJson strict = run::read_strict_json(text);
  if (!strict.value.is_object()) throw Fault{"the line is not an object"};
  for (const char* key : {"id", "ball", "motion"})
    if (strict.duplicate_key == key || strict.ambiguous.contains(key))
      throw Fault{fmt::format("\"{}\" is, or has, a duplicate key", key)};
  if (const auto given = strict.value.find("id"); given != strict.value.end()) {
    if (!given->is_string()) throw Fault{"id is not a string"};
    id = given->get<std::string>();
  }
  const nlohmann::json& ball = member(strict.value, "ball", "the line");
  if (!ball.is_object()) throw Fault{"ball is not an object"};
  const Ball start{point(member(ball, "center", "ball"), "ball.center"),
                   number(member(ball, "radius", "ball"), "ball.radius")};
  const auto motion = strict.value.find("motion");
  if (motion == strict.value.end()) return {std::move(id), start};
  if (!motion->is_object()) throw Fault{"motion is not an object"};
  return {std::move(id), Motion{start, point(member(*motion, "to", "motion"), "motion.to")}};
}

NamedBall from_text(std::string_view text, std::string id) {
  double numbers[7];
  std::size_t count = 0;
  for (std::size_t begin = 0; (begin = text.find_first_not_of(kBlanks, begin)) != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, begin), text.size());
    const std::string_view field = text.substr(begin, end - begin);
    const auto value = io::nearest_double(field);
    if (!value) throw Fault{fmt::format("'{}' is not a number", io::legible(field, 40))};
    if (count < 7) numbers[count] = *value;
    ++count;
    begin = end;
  }
  if (count != 4 && count != 7) throw Fault{fmt::format("expected four numbers, x y z r, or seven, found {}", count)};
  return ball_of(std::span(numbers).first(count), std::move(id));
}

std::vector<NamedBall> read_balls(std::istream& stream, const std::string& name) {
  if (begins_as_array(stream)) return read_array_of_balls(stream, name);
  std::vector<NamedBall> balls;
  std::string line;
  for (std::size_t lines = 1; std::getline(stream, line); ++lines) {
    const std::size_t first = line.find_first_not_of(kBlanks);
    if (first == std::string::npos || line[first] == '#') continue;
    try {
      NamedBall read = line[first] == '{'
                           ? from_json(line, std::to_string(lines))
                           : from_text(std::string_view(line).substr(0, line.find('#')), std::to_string(lines));
      const auto fault = std::visit([](const auto& asked) { return find_fault(asked); }, read.question);
      if (fault) throw Fault{fault->message};
      balls.push_back(std::move(read));
    } catch (const Fault& fault) {
      throw std::runtime_error(fmt::format("{}: line {}: {}", name, lines, fault.reason));
    } catch (const run::NotJson& error) {
      throw std::runtime_error(fmt::format("{}: line {}: not JSON: {}", name, lines, error.what()));
    }
  }
  if (stream.bad()) throw std::runtime_error(name + ": cannot be read to its end");
  return balls;
}

/// A mean, without overflow except by rounding.
Vector3d between(const Vector3d& a, const Vector3d& b, double share) { return (1 - share) * a + share * b; }

Vector3d in_cube(Random& random) { return {2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1}; }

}  // namespace

NamedBall ball_of(std::span<const double> numbers, std::string id) {
  const Ball ball{{numbers[0], numbers[1], numbers[2]}, numbers[3]};
  if (numbers.size() == 4) return {std::move(id), ball};
  return {std::move(id), Motion{ball, {numbers[4], numbers[5], numbers[6]}}};
}

std::vector<NamedBall> read_balls(const std::string& file) {
  if (file == "-") {
    run::announce_standard_input("balls");
    return read_balls(std::cin, "standard input");
  }
  std::ifstream stream = run::open_file(file);
  return read_balls(stream, file);
}

RandomBalls::RandomBalls(const std::vector<scene::Faces>& objects) {
  for (const scene::Faces& faces : objects) {
    corners_.insert(corners_.end(), faces.triangles.begin(), faces.triangles.end());
    for (const Polygon& polygon : faces.polygons)
      corners_.push_back({polygon.vertex(0), polygon.vertex(1), polygon.vertex(2)});
  }
  box_ = box(corners_);
}

NamedBall RandomBalls::draw(std::uint64_t seed, std::uint64_t index) const {
  const Ball ball = index % 2 == 0 ? near_a_face(seed, index) : anywhere(seed, index);
  return {fmt::format("random-{}-{}", seed, index), ball};
}

Ball RandomBalls::near_a_face(std::uint64_t seed, std::uint64_t index) const {
  Random random(seed, index, 80);
  const auto last = static_cast<std::int64_t>(corners_.size()) - 1;
  const Triangle& t = corners_[static_cast<std::size_t>(random.integer(0, last))];
  const double share = random.unit(), other = random.unit();
  const Vector3d point = between(between(t.a, t.b, share), t.c, other);
  const double size = workloads::finite(std::max((t.b - t.a).cwiseAbs().maxCoeff(), (t.c - t.a).cwiseAbs().maxCoeff()));
  const Vector3d direction = in_cube(random);
  const Vector3d offset = std::ldexp(size, -static_cast<int>(random.integer(0, 6))) * direction;
  return {workloads::finite(point + offset), workloads::finite(2 * random.unit() * offset.cwiseAbs().maxCoeff())};
}

Ball RandomBalls::anywhere(std::uint64_t seed, std::uint64_t index) const {
  Random random(seed, index, 81);
  const Vector3d half = box_.high / 2 - box_.low / 2;
  const Vector3d reach = workloads::finite(1.25 * half);
  const Vector3d center = between(box_.low, box_.high, 0.5) + reach.cwiseProduct(in_cube(random));
  const int exponent = -static_cast<int>(random.integer(0, 7));
  return {workloads::finite(center), std::ldexp(half.maxCoeff() * random.unit(), exponent)};
}

}  // namespace touchstone::scenes
