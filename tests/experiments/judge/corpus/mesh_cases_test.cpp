// SPDX-License-Identifier: GPL-3.0-or-later
// Cases of meshes: drawn, rounded to floats, derived twice, shrunk.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "experiments/cases/comparison.h"
#include "experiments/cases/verdict.h"
#include "experiments/judge/corpus/corpus.h"
#include "experiments/methods/registry.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"

namespace touchstone::corpus {
namespace {

using cases::MeshShapes;
using cases::PartialAnswer;

constexpr std::uint64_t kSeed = 5;
const std::atomic<bool> kNever = false;

const MeshShapes& mesh_case(const CorpusCase& drawn) { return std::get<MeshShapes>(drawn.shapes); }

/// Calls f with the first `count` cases that can be drawn, of balls at a place and moving.
template <class F>
void each_drawn(std::uint64_t count, const F& f) {
  for (const bool moves : {false, true})
    for (std::uint64_t i = 0; i < count; ++i)
      if (const auto drawn = draw_mesh_case(kSeed, i, moves)) f(*drawn);
}

TEST(MeshCases, AnswersAreThoseOfEveryFaceByItself) {
  std::size_t cases = 0;
  each_drawn(60, [&](const CorpusCase& drawn) {
    const auto& [question, mesh] = mesh_case(drawn);
    const PartialAnswer answer = exact_answer(drawn.shapes);
    const bool moves = std::holds_alternative<Motion>(question);
    std::vector<std::size_t> touched;
    for (std::size_t face = 0; face < mesh.faces().size(); ++face) {
      const PartialAnswer alone = exact_answer(cases::Shapes{question, mesh.faces()[face]});
      if (*alone.contact) touched.push_back(face);
      // Rounding keeps the order.
      EXPECT_LE(moves ? *answer.time : *answer.distance, moves ? *alone.time : *alone.distance) << drawn.id;
      if (face != answer.face) continue;
      for (const cases::Key& key : cases::kKeys) {
        const bool both = has(answer, key) && has(alone, key);
        EXPECT_TRUE(!both || same_value(key, answer, alone)) << drawn.id << key.name;
      }
    }
    EXPECT_EQ(answer.touched, touched) << drawn.id;
    EXPECT_EQ(answer.contact, !touched.empty()) << drawn.id;
    EXPECT_EQ(answer.face.has_value(), !moves || answer.contact == true) << drawn.id;
    ++cases;
  });
  EXPECT_GT(cases, 80U);
}

TEST(MeshCases, AScenesAnswersAreExact) {
  const auto* filtered = methods::find_method("filtered");
  each_drawn(300, [&](const CorpusCase& drawn) {
    const auto found = filtered->prepare(mesh_case(drawn).mesh)->answer(mesh_case(drawn).question).value();
    EXPECT_TRUE(cases::differences(cases::stated(exact_answer(drawn.shapes)), found).empty()) << drawn.id;
  });
}

TEST(MeshCases, InFloatsAreThePosedVerticesAndARadiusWithinAFloatOfTheThreshold) {
  std::size_t at_threshold = 0;
  each_drawn(60, [&](const CorpusCase& drawn) {
    const auto found = in_floats(drawn);
    if (!found) return;
    EXPECT_TRUE(is_in_floats(found->shapes)) << drawn.id;
    const auto& [question, mesh] = mesh_case(*found);
    EXPECT_EQ(mesh.pose(), Pose());
    const auto& before = mesh_case(drawn).mesh.faces();
    for (std::size_t face = 0; face < before.size(); ++face)
      for (std::size_t i = 0; i < before[face].vertex_count(); ++i)
        EXPECT_EQ(mesh.faces()[face].vertex(i), before[face].vertex(i).cast<float>().cast<double>()) << drawn.id;
    const auto touches = [&, &question = question, &mesh = mesh](float radius) {
      const auto resized = cases::with_radius(question, static_cast<double>(radius));
      return *exact_answer(MeshShapes{resized, mesh}).contact;
    };
    const auto radius = static_cast<float>(cases::ball_of(question).radius);
    const float most = std::numeric_limits<float>::max();
    const auto two_off = [](float from, float to) { return std::nextafter(std::nextafter(from, to), to); };
    at_threshold += !touches(two_off(radius, 0)) && touches(two_off(radius, most)) ? 1 : 0;
  });
  EXPECT_GT(at_threshold, 40U);
}

TEST(MeshCases, ShrinkToFewFacesThatFailInTheSameWay) {
  const auto& fast = *methods::find_method("fast");
  std::size_t shrunk = 0;
  each_drawn(14, [&](const CorpusCase& drawn) {
    const auto wrong = wrong_answer(fast, drawn.shapes, exact_answer(drawn.shapes));
    if (!any_decisive(wrong.keys)) return;
    const SameFailure failure(fast, drawn.shapes);
    const cases::AnyShapes small = shrink(failure, drawn.shapes, kNever);
    EXPECT_LT(size_of(small), size_of(drawn.shapes)) << drawn.id;
    const MeshShapes& left = std::get<MeshShapes>(small);
    EXPECT_LT(left.mesh.faces().size(), mesh_case(drawn).mesh.faces().size()) << drawn.id;
    std::vector<bool> used(left.mesh.mesh().vertices.size());
    for (const auto& face : left.mesh.mesh().faces)
      for (const std::uint32_t vertex : face) used[vertex] = true;
    EXPECT_EQ(std::ranges::count(used, false), 0) << drawn.id << " keeps vertices that no face uses";
    EXPECT_TRUE(failure.holds(small)) << drawn.id;
    EXPECT_EQ(cases::case_line("", shrink(SameFailure(fast, small), small, kNever), {}),
              cases::case_line("", small, {}))
        << drawn.id;
    ++shrunk;
  });
  EXPECT_GT(shrunk, 2U);
}

}  // namespace
}  // namespace touchstone::corpus
