// SPDX-License-Identifier: GPL-3.0-or-later
// Cases of whole meshes: how they are read, what their answers mean, and who is asked how.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "experiments/cases/case.h"
#include "experiments/cases/comparison.h"
#include "experiments/cases/verdict.h"
#include "experiments/methods/registry.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::cases {
namespace {

constexpr auto kRidge = R"("mesh":{"vertices":[[0,0,0],[2,0,0],[2,2,0],[0,2,0],[0,1,1],[2,1,1]],)"
                        R"("faces":[[0,1,5,4],[4,5,2,3]]})";

std::string line(const std::string& members) {
  return R"({"id":"a","ball":{"center":[1,1,3],"radius":2},)" + members + "}";
}

MeshShapes read(const std::string& members, const std::filesystem::path& folder = {}) {
  return std::get<MeshShapes>(read_case(line(members), folder).content);
}

std::string complaint(const std::string& members) {
  const auto content = read_case(line(members)).content;
  const auto* rejection = std::get_if<Rejection>(&content);
  return rejection ? std::string(to_string(rejection->code)) + ": " + rejection->message : "accepted";
}

PartialAnswer asked(const char* method, const MeshShapes& shapes) {
  return methods::find_method(method)->prepare(shapes.mesh)->answer(shapes.question).value();
}

TEST(MeshCase, HasTheFacesOfItsMeshUnderItsPose) {
  const std::string pose = R"(,"pose":{"rotation":[[0,-1,0],[1,0,0],[0,0,1]],"translation":[10,0,0.1]})";
  const MeshShapes plain = read(kRidge), turned = read(kRidge + pose);
  ASSERT_EQ(plain.mesh.faces().size(), 2U);
  EXPECT_EQ(plain.mesh.faces()[1].vertex(2), Eigen::Vector3d(2, 2, 0));
  EXPECT_EQ(turned.mesh.faces()[1].vertex(2), Eigen::Vector3d(8, 2, 0.1));
  EXPECT_EQ(turned.mesh.faces()[1].vertex(0), Eigen::Vector3d(9, 0, 1.1));
  EXPECT_EQ(read(std::string(kRidge) + R"(,"pose":{})").mesh.faces()[0], plain.mesh.faces()[0]);
}

TEST(MeshCase, IsReadAsItIsWritten) {
  for (const char* pose : {"", R"(,"pose":{"rotation":[[0.1,-1,0],[1,0.3,0],[0,0,1]],"translation":[10,0,0.1]})"}) {
    const Case first = read_case(line(std::string(kRidge) + pose));
    const std::string written = case_line("a", first.shapes(), {});
    EXPECT_EQ(case_line("a", read_case(written).shapes(), {}), written);
    EXPECT_EQ(std::get<MeshShapes>(read_case(written).content).mesh.faces(),
              std::get<MeshShapes>(first.content).mesh.faces());
  }
}

TEST(MeshCase, TakesTheMeshOfAFileBesideTheFileOfCases) {
  const run_tests::Scratch scratch;
  std::ofstream(scratch.path / "it.obj") << "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n";
  const std::string text = line(R"("mesh":{"file":"it.obj"})");
  const Case found = read_case(text, scratch.path);
  EXPECT_EQ(std::get<MeshShapes>(found.content).mesh.faces()[0].vertex(1), Eigen::Vector3d(4, 0, 0));
  EXPECT_TRUE(found.rewritten) << "an engine need not read the file";
  EXPECT_FALSE(read_case(line(kRidge)).rewritten);
  std::ofstream(scratch.path / "cases.jsonl") << text << "\n";
  const auto one = LineReader({(scratch.path / "cases.jsonl").string()}).next_case();
  EXPECT_TRUE(std::holds_alternative<MeshShapes>(one->read->content));
  EXPECT_EQ(complaint(R"("mesh":{"file":"gone.obj"})"),
            "malformed-case: mesh.file: gone.obj: cannot be opened: No such file or directory");
}

TEST(MeshCase, IsRefusedWithWhatIsWrong) {
  const auto mesh = [](const std::string& vertices, const std::string& faces) {
    return R"("mesh":{"vertices":)" + vertices + R"(,"faces":)" + faces + "}";
  };
  const std::string three = "[[0,0,0],[4,0,0],[0,4,0]]";
  const std::pair<std::string, std::string> all[] = {
      {R"("mesh":7)", "malformed-case: mesh is not an object"},
      {std::string(kRidge) + R"(,"polygon":{"outer":[[0,0,0],[1,0,0],[1,1,0]]})",
       "malformed-case: the case has both a polygon and a mesh"},
      {R"("pose":{},"polygon":{"outer":[[0,0,0],[1,0,0],[1,1,0]]})",
       "malformed-case: the case has a pose, but no mesh"},
      {R"("mesh":{"file":7})", "malformed-case: mesh.file is not a string"},
      {R"("mesh":{"file":"a.obj","faces":[]})", "malformed-case: mesh has a file, and vertices or faces"},
      {R"("mesh":{"file":"a.obj\u0000.obj"})", "malformed-case: mesh.file has a NUL character"},
      {R"("mesh":{"vertices":[]})", "malformed-case: mesh has no key \"faces\""},
      {mesh("[[0,0]]", "[]"), "malformed-case: mesh.vertices[0] is not a point of three numbers"},
      {mesh(three, "[]"), "malformed-case: mesh.faces is not an array of faces"},
      {mesh(three, "[[0,1,2],7]"), "malformed-case: mesh.faces[1] is not an array of vertex numbers"},
      {mesh(three, "[[0,1,2],[0,1,-1]]"), "malformed-case: mesh.faces[1] is not an array of vertex numbers"},
      {mesh(three, "[[0,1,3]]"), "malformed-case: mesh.faces[0]: vertex 3 is out of range: there are 3"},
      {mesh(three, "[[0,1]]"),
       "too-few-vertices: face 0 of the mesh: the outer loop has 2 vertices; a loop needs at least 3"},
      {mesh("[[0,0,0],[1,1,1],[2,2,2]]", "[[0,1,2]]"),
       "zero-normal: face 0 of the mesh: the outer loop: its Newell normal is zero"},
      {mesh("[[0,0,0],[4,0,0],[0,4,0],[1e400,0,0]]", "[[0,1,2]]"), "not-finite: vertex 3 of the mesh is not finite"},
      {kRidge + std::string(R"(,"pose":{"rotation":[[1,0,0],[0,1,0]]})"),
       "malformed-case: pose.rotation is not an array of three rows"},
      {kRidge + std::string(R"(,"pose":{"rotation":[[1,0,0],[0,1,0],[0,1]]})"),
       "malformed-case: pose.rotation[2] is not a point of three numbers"},
      {kRidge + std::string(R"(,"pose":{"translation":[1e400,0,0]})"), "not-finite: the pose is not finite"},
      {kRidge + std::string(R"(,"pose":{"rotation":[[1,0,0],[1,0,0],[1,0,0]]})"),
       "repeated-vertex: face 0 of the mesh: the outer loop: vertex 1 equals its neighbour, vertex 2"},
  };
  for (const auto& [members, sentence] : all) EXPECT_EQ(complaint(members), sentence) << members;
  // A negative radius precedes every fault of a face except numbers that are not finite.
  const std::string negative = R"({"id":"a","ball":{"center":[1,1,3],"radius":-1},)" + mesh(three, "[[0,1]]") + "}";
  EXPECT_EQ(std::get<Rejection>(read_case(negative).content).code, RejectionCode::NegativeRadius);
}

TEST(MeshCase, NamesTheFirstOfEqualFacesTrianglesBeforeOthers) {
  const std::string vertices = R"("mesh":{"vertices":[[0,0,0],[2,0,0],[2,2,0],[0,2,0],[0,1,1],[2,1,1],[1,3,0]],)";
  const MeshShapes squares = read(vertices + R"("faces":[[4,5,2,3],[0,1,5,4]]})");
  EXPECT_EQ(exact_answer(squares).face, 0U);
  const MeshShapes with_triangle = read(vertices + R"("faces":[[4,5,2,3],[0,1,5,4],[5,4,6]]})");
  for (const char* method : {"exact", "filtered", "fast"}) {
    const PartialAnswer answer = asked(method, with_triangle);
    EXPECT_EQ(answer.face, 2U) << method;
    EXPECT_EQ(answer.touched, (std::vector<std::size_t>{0, 1, 2})) << method;
    EXPECT_EQ(answer.nearest, (Feature{Feature::Kind::Edge, 0})) << method;
  }
}

TEST(MeshCase, AnswersOfAMeshHaveNoKeyOfASinglePolygon) {
  const PartialAnswer answer = exact_answer(read(kRidge));
  EXPECT_FALSE(answer.plane || answer.plane_tangent || answer.foot || answer.edges_hit || answer.off_plane);
  EXPECT_EQ(answer.relation, Relation::Touching);
  EXPECT_EQ(answer.distance, 2);
}

TEST(MeshCase, AMovingBallThatTouchesNothingHasNoFace) {
  const MeshShapes passes = read(std::string(kRidge) + R"(,"motion":{"to":[1,1,3.5]},"x":0)");
  ASSERT_EQ(exact_answer(passes).first, FirstContactKind::Start);
  const MeshShapes misses{Motion({{9, 9, 9}, 1}, {9, 9, 8}), passes.mesh};
  for (const char* method : {"exact", "filtered"}) {
    const StatedAnswer answer = stated(asked(method, misses));
    EXPECT_EQ(answer.texts.at("face"), "null") << method;
    EXPECT_EQ(answer.texts.at("touched"), "[]") << method;
    EXPECT_EQ(answer.texts.at("time"), "null") << method;
  }
  EXPECT_FALSE(stated(exact_answer(Shapes{misses.question, passes.mesh.faces()[0]})).texts.contains("face"))
      << "a polygon has no face";
}

TEST(MeshCase, MethodsNameTheFacesThatAreNearAndTouched) {
  // Two squares: to an engine for triangles, 2 and 3 are those of face 1.
  const MeshShapes shapes{Ball{{3, 1, 0.5}, 1},
                          PosedMesh({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {4.5, 0, 0}, {4.5, 2, 0}},
                                     {{0, 1, 2, 3}, {1, 4, 5, 2}}})};
  EXPECT_EQ(exact_answer(shapes).touched, std::vector<std::size_t>{1});
  for (const char* method : {"fast", "fcl", "bullet", "embree-fast"}) {
    if (methods::find_method(method) == nullptr) continue;  // built without it
    const PartialAnswer answer = asked(method, shapes);
    EXPECT_EQ(answer.touched, std::vector<std::size_t>{1}) << method;
    if (answer.face) {
      EXPECT_EQ(answer.face, 1U) << method;
    }
  }
}

}  // namespace
}  // namespace touchstone::cases
