// SPDX-License-Identifier: GPL-3.0-or-later
// What the page calls. Numbers pass through one buffer of doubles, so that nothing is printed and read again.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/contact/fast.h"
#include "geometry/contact/thesis.h"
#include "geometry/shapes/motion.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"
#include "robust/exact/validate.h"
#include "robust/filtered/filtered.h"
#include "robust/filtered/motion.h"

#define EXPORT(name) __attribute__((export_name(name))) extern "C"

namespace {

using namespace touchstone;

enum class Method { Fast, Thesis, Filtered, Exact };
enum class Question { Contact, Foot };

/// A polygon as each method wants it.
struct Prepared {
  explicit Prepared(const Polygon& loops) : polygon(loops), fast(loops), thesis(loops), filtered(loops), exact(loops) {}

  Polygon polygon;
  fast::PreparedPolygon<double> fast;
  thesis::PreparedPolygon<double> thesis;
  filtered::PreparedPolygon filtered;
  exact::PreparedPolygon exact;
};

std::vector<double> numbers;
std::vector<std::uint8_t> colours;
std::string words;
std::optional<Prepared> prepared;

Eigen::Vector3d point(std::size_t at) { return {numbers[at], numbers[at + 1], numbers[at + 2]}; }
Ball ball() { return {point(0), numbers[3]}; }
Motion motion() { return {ball(), point(4)}; }

/// Writes an answer; -1 stands for what a method does not compute.
class Writer {
 public:
  void add(double number) { numbers[at_++] = number; }
  template <class Enumeration>
  void add_one_of(Enumeration value) {
    add(static_cast<double>(value));
  }
  void add(const Eigen::Vector3d& p) {
    for (int axis = 0; axis < 3; ++axis) add(p[axis]);
  }
  void add(const Feature& feature) {
    add_one_of(feature.kind);
    add(static_cast<double>(feature.index));
  }
  void add(const std::vector<std::size_t>& edges) {
    add(static_cast<double>(edges.size()));
    for (const std::size_t edge : edges) add(static_cast<double>(edge));
  }

 private:
  std::size_t at_ = 0;
};

void write(const Answer& answer, int stage) {
  Writer to;
  to.add_one_of(answer.plane);
  to.add(answer.plane_tangent);
  to.add_one_of(answer.foot);
  to.add_one_of(answer.relation);
  to.add(answer.contact());
  to.add(answer.nearest);
  to.add(answer.point);
  to.add(answer.distance);
  to.add(answer.contact_normal);
  to.add(answer.depth);
  to.add(answer.off_plane);
  to.add(stage);
  to.add(answer.edges_hit);
}

void write_thesis(const Ball& asked, const thesis::PreparedPolygon<double>& polygon) {
  Writer to;
  to.add_one_of(thesis::plane_side(asked, polygon));
  to.add(-1);  // whether the plane is tangent
  to.add_one_of(thesis::foot(asked, polygon));
  to.add(-1);  // the relation
  to.add(thesis::contact(asked, polygon));
  // Nearest feature, point, distance, contact normal, depth, off_plane, stage.
  for (int unknown = 0; unknown < 12; ++unknown) to.add(-1);
  to.add(thesis::edges_hit(asked, polygon));
}

/// Returns what a pixel shows of one question: the certified answer, and who differs from it.
std::uint8_t colour(const Ball& asked, Question question) {
  const auto differing = [](auto certified, auto fast, auto thesis) {
    return static_cast<std::uint8_t>((fast != certified ? 4 : 0) | (thesis != certified ? 8 : 0));
  };
  if (question == Question::Foot) {
    const PointLocation certified = filtered::foot(asked, prepared->filtered);
    return static_cast<std::uint8_t>(
        static_cast<int>(certified) |
        differing(certified, fast::foot(asked, prepared->fast), thesis::foot(asked, prepared->thesis)));
  }
  const bool certified = filtered::contact(asked, prepared->filtered);
  return static_cast<std::uint8_t>((certified ? 0 : 2) | differing(certified, fast::contact(asked, prepared->fast),
                                                                   thesis::contact(asked, prepared->thesis)));
}

}  // namespace

/// Returns room for that many numbers.
EXPORT("room") double* room(int count) {
  numbers.resize(static_cast<std::size_t>(count));
  return numbers.data();
}

/// Returns why the last polygon, ball or motion was refused, `code: reason`, or an empty text.
EXPORT("refusal") const char* refusal() { return words.c_str(); }

/// Takes the polygon: the numbers of vertices of its loops, then their coordinates. Returns whether it is valid.
EXPORT("take_polygon") int take_polygon(int loops) {
  words.clear();
  prepared.reset();
  std::size_t at = static_cast<std::size_t>(loops);
  std::vector<Loop> read;
  for (std::size_t i = 0; i < static_cast<std::size_t>(loops); ++i) {
    Loop loop;
    for (int left = static_cast<int>(numbers[i]); left > 0; --left, at += 3) loop.push_back(point(at));
    read.push_back(std::move(loop));
  }
  try {
    const Polygon polygon(read.front(), {read.begin() + 1, read.end()});
    if (auto fault = exact::validate(polygon)) throw Rejected(std::move(*fault));
    prepared.emplace(polygon);
  } catch (const Rejected& rejected) {
    words = std::string(to_string(rejected.rejection().code)) + ": " + rejected.rejection().message;
  }
  return words.empty() ? 1 : 0;
}

/// Takes nothing: the ball in the buffer (centre, radius) is valid, or with `moves` its motion (ball, end), or not.
EXPORT("check_ball") int check_ball(int moves) {
  words.clear();
  if (const auto fault = moves != 0 ? find_fault(motion()) : find_fault(ball()))
    words = std::string(to_string(fault->code)) + ": " + fault->message;
  return words.empty() ? 1 : 0;
}

/// Answers about the ball in the buffer, by the method, into the buffer.
EXPORT("answer") void answer(int method) {
  const Ball asked = ball();
  switch (static_cast<Method>(method)) {
    case Method::Fast: return write(fast::answer(asked, prepared->fast), -1);
    case Method::Thesis: return write_thesis(asked, prepared->thesis);
    case Method::Filtered: {
      filtered::StageCounts counts;
      const Answer certified = filtered::answer(asked, prepared->filtered, counts);
      return write(certified, static_cast<int>(counts.last()));
    }
    case Method::Exact: return write(exact::answer(asked, prepared->exact), -1);
  }
}

/// Answers about the motion in the buffer (ball, end): `exact`, or else `filtered`.
EXPORT("first_contact") void first_contact(int by_exact) {
  const Motion asked = motion();
  const FirstContact first =
      by_exact != 0 ? exact::first_contact(asked, prepared->exact) : filtered::first_contact(asked, prepared->filtered);
  Writer to;
  to.add_one_of(first.kind);
  to.add(first.time);
  to.add(first.momentary);
  to.add(first.feature);
  to.add(first.point);
  to.add(first.contact_normal);
  to.add(first.depth);
}

/// Returns the colours of `count` balls of one radius: the buffer holds the radius, then the centres.
EXPORT("paint") const std::uint8_t* paint(int count, int question) {
  colours.resize(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < colours.size(); ++i)
    colours[i] = colour({point(1 + 3 * i), numbers[0]}, static_cast<Question>(question));
  return colours.data();
}
