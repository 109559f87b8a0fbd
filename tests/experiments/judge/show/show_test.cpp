// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include "experiments/cases/workloads/ulp.h"
#include "experiments/judge/show/case_view.h"
#include "experiments/methods/registry.h"

namespace touchstone::show {
namespace {

const Polygon kSquare({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{{1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}}});
const Polygon kTriangle({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
constexpr double kBelow = 1.1547005383792515;  // the double nearest to 2 / sqrt(3), and below it

CaseView view(const cases::Shapes& shapes) { return view_of("a<b", {"tag"}, shapes); }
std::string drawn(const CaseView& shown) { return picture_of(shown); }
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Radii, TheMarginIsCountedFromTheLeastRadiusThatTouches) {
  for (const std::int64_t off : {-3, -1, 0, 1, 5}) {
    const double radius = workloads::move_by_doubles(kBelow, off);
    const Radii radii = radii_around(cases::Shapes{Ball{{1, 1, 1}, radius}, kTriangle});
    EXPECT_EQ(radii.margin, off - 1);  // the next double is the first that touches
    EXPECT_FALSE(radii.exactly_touching);
    EXPECT_TRUE(radii.every_double);
    for (std::size_t i = 0; i < radii.offsets.size(); ++i)
      EXPECT_EQ(radii.contact[i], radii.offsets[i] >= 1 - off) << off << ' ' << radii.offsets[i];
  }
  const Radii tangent = radii_around(cases::Shapes{Ball{{0.5, 0.5, 2}, 2}, kSquare});
  EXPECT_EQ(tangent.margin, 0);
  EXPECT_TRUE(tangent.exactly_touching);
}

TEST(Radii, ShowEveryDoubleAtAChangeThatIsFarAway) {
  const Radii radii = radii_around(cases::Shapes{Ball{{0.5, 0.5, 2}, 1}, kSquare});
  EXPECT_EQ(radii.margin, -(std::int64_t{1} << 52));
  EXPECT_FALSE(radii.every_double);
  const std::int64_t change = std::int64_t{1} << 52;
  for (std::size_t i = 0; i < radii.offsets.size(); ++i) EXPECT_EQ(radii.contact[i], radii.offsets[i] >= change);
  for (const std::int64_t offset : {std::int64_t{0}, change - 1, change})
    EXPECT_NE(std::ranges::find(radii.offsets, offset), radii.offsets.end()) << offset;
}

TEST(Radii, DoNotPassZeroOrTheLargestDouble) {
  const Radii on = radii_around(cases::Shapes{Ball{{0.5, 0.5, 0}, 0}, kSquare});
  EXPECT_EQ(on.margin, 0);
  EXPECT_EQ(on.offsets.front(), 0);
  const double largest = std::numeric_limits<double>::max();
  const Radii huge = radii_around(cases::Shapes{Ball{{0.5, 0.5, 2}, largest}, kSquare});
  EXPECT_GT(huge.margin.value(), 0);
  EXPECT_EQ(huge.radius(cases::Shapes{Ball{{0.5, 0.5, 2}, largest}, kSquare}, huge.offsets.size() - 1), largest);
  EXPECT_EQ(huge.offsets.back(), 0);
}

TEST(Radii, OfAMovingBallAreThoseOfItsCapsule) {
  const cases::Shapes shapes{Motion({{0.5, 0.5, 9}, 1.0}, {0.5, 0.5, 1}), kSquare};
  const Radii radii = radii_around(shapes);
  EXPECT_EQ(radii.margin, 0);  // at the end of its way it just touches
}

TEST(Radii, WhereEvenAPointTouchesNothingChanges) {
  const cases::Shapes through{Motion({{0.5, 0.5, 9}, 1.0}, {0.5, 0.5, -9}), kSquare};
  const Radii radii = radii_around(through);
  EXPECT_TRUE(radii.every_double);
  EXPECT_EQ(std::ranges::count(radii.contact, false), 0);
  EXPECT_EQ(margin_text(view(through)), "Even a point there touches, so every ball does.");
}

TEST(CaseView, AsksMethodsAtEveryRadius) {
  CaseView shown = view({Ball{{1, 1, 1}, kBelow}, kTriangle});
  EXPECT_EQ(shown.truth.contact, false);
  const Verdict fast = verdict_of(shown, *methods::find_method("fast"));
  const Verdict filtered = verdict_of(shown, *methods::find_method("filtered"));
  ASSERT_EQ(fast.contact.size(), shown.radii.offsets.size());
  const auto own = static_cast<std::size_t>(std::ranges::find(shown.radii.offsets, 0) - shown.radii.offsets.begin());
  EXPECT_EQ(fast.contact[own], true);  // wrong
  for (std::size_t i = 0; i < filtered.contact.size(); ++i) EXPECT_EQ(filtered.contact[i], shown.radii.contact[i]);
  EXPECT_EQ(margin_text(shown), "The ball does not touch: its radius is 1 double below the least one that does.");
}

TEST(CaseView, CountsTheDoublesOfASmallMarginOnly) {
  EXPECT_TRUE(
      has(margin_text(view({Ball{{0.5, 0.5, 2}, workloads::move_by_doubles(2, 3)}, kSquare})), "3 doubles above"));
  EXPECT_TRUE(has(margin_text(view({Ball{{0.5, 0.5, 2}, 3}, kSquare})), "over a million doubles above"));
}

TEST(CaseView, SaysWhenAMethodCannotAnswer) {
  CaseView shown = view({Motion({{0.5, 0.5, 9}, 1}, {0.5, 0.5, 0}), kSquare});
  EXPECT_EQ(verdict_of(shown, *methods::find_method("thesis")).fault, "cannot answer about moving balls");
  EXPECT_TRUE(has(section_of(shown), "moving to (0.5, 0.5, 0)"));
}

// Lengths and the section are those of the case, in the polygon's plane.
TEST(FlatCase, KeepsTheShapes) {
  const CaseView shown = view({Ball{{2, 2, 3}, 0.5}, kSquare});  // above the hole
  const auto flat = flat_case(shown);
  ASSERT_TRUE(flat);
  const double unit = (flat->loops[0][1] - flat->loops[0][0]).norm() / 4;
  EXPECT_DOUBLE_EQ(flat->radius, unit / 2);
  EXPECT_DOUBLE_EQ(flat->from.z(), 3 * unit);
  const auto parts = flat->section(flat->loops);
  ASSERT_EQ(parts.size(), 2U);  // on either side of the hole
  EXPECT_DOUBLE_EQ((parts[0].second - parts[0].first).norm(), unit);
  EXPECT_DOUBLE_EQ((parts[1].first - parts[0].second).norm(), 2 * unit);
}

TEST(FlatCase, TakesVeryLargeAndVerySmallNumbers) {
  for (const double scale : {1e-320, 1e-200, 1e307}) {
    const Polygon polygon({{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}});
    EXPECT_TRUE(flat_case(view({Ball{{0, 0, scale}, scale / 2}, polygon}))) << scale;
  }
}

// A square and a wall on its edge, and another square below.
cases::MeshShapes corner(const cases::Question& question) {
  return {question, cases::PosedMesh({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {4, 0, 2}, {4, 4, 2}},
                                      {{0, 1, 2, 3}, {1, 2, 5, 4}}})};
}

TEST(Radii, OfAMeshAreThoseWithWhichAnyFaceIsTouched) {
  const Radii touching = radii_around(corner(Ball{{3, 2, 1}, 1}));  // both faces
  EXPECT_EQ(touching.margin, 0);
  EXPECT_TRUE(touching.exactly_touching);
  const Radii near_wall = radii_around(corner(Ball{{3.5, 2, 1}, 1}));
  EXPECT_EQ(near_wall.margin, std::int64_t{1} << 52);
}

TEST(FlatCase, ShowsTheOtherFacesInTheSection) {
  const CaseView shown = view_of("mesh", {}, corner(Ball{{2, 2, 1}, 1}));
  EXPECT_EQ(&shown.polygon(), &std::get<cases::MeshShapes>(shown.shapes).mesh.faces()[0]);
  auto flat = flat_case(shown);
  ASSERT_TRUE(flat);
  const double unit = (flat->loops[0][1] - flat->loops[0][0]).norm() / 4;
  ASSERT_EQ(flat->other_faces.size(), 1U);
  flat->along = (flat->loops[0][1] - flat->loops[0][0]).normalized();
  const auto parts = flat->section({flat->other_faces.data(), 1});
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_LT((parts[0].first - flat->foot() - 2 * unit * flat->along).norm(), 1e-12);
  EXPECT_LT((parts[0].second - parts[0].first - 2 * unit * Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_TRUE(has(section_of(shown), "a mesh of 2 faces, of which the picture shows the plane of face 0"));
}

TEST(Picture, MarksWhatIsWrong) {
  CaseView shown = view({Ball{{1, 1, 1}, kBelow}, kTriangle});
  shown.verdicts.push_back(verdict_of(shown, *methods::find_method("filtered")));
  const auto marks = [&] {
    const std::string text = drawn(shown);
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find(" wrong\"", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  EXPECT_EQ(marks(), 1U) << "the legend";
  shown.verdicts.push_back(verdict_of(shown, *methods::find_method("fast")));
  EXPECT_GT(marks(), 1U) << "at the radius of the ball, too";
  EXPECT_TRUE(has(drawn(shown), "one column is one double"));
}

// 1845 doubles below the contact: the columns on both sides of the change have labels of their own.
TEST(Picture, LabelsNeighboursApart) {
  const CaseView shown =
      view({Ball{{0, 0, 4}, 6.794760561472867e-09}, Polygon({{0.0078125, 0, 32768}, {0, 0, 0}, {-8000, 57, -17408}})});
  const std::string text = drawn(shown);
  EXPECT_TRUE(has(text, ">+1844<") && has(text, ">+1845<")) << text;
}

TEST(Picture, LabelsNeighboursOfAChangeThatIsFarAwayByIt) {
  const std::string text = drawn(view({Ball{{0.5, 0.5, 2}, 1}, kSquare}));
  for (const char* label : {">c-1<", ">c<", ">c+1<", "c, at +2^52, touches first", ">+2^48<"})
    EXPECT_TRUE(has(text, label)) << label;
  EXPECT_FALSE(has(text, ">+2^52.0<")) << "two columns would have this label";
}

TEST(Picture, HasNoTextThatIsTooSmallToRead) {
  const std::string text = page_of("it", drawn(view({Ball{{0.5, 0.5, 2}, 2}, kSquare})));
  EXPECT_TRUE(has(text, "svg text { font-size: 12px;"));
  EXPECT_FALSE(has(text, "font-size=\""));
}

TEST(Page, IsSelfContainedAndEscaped) {
  CaseView shown = view({Ball{{1, 1, 1}, kBelow}, kTriangle});
  shown.verdicts.push_back({"<script>", {}, "no <b>verdict</b>", {}});
  shown.verdicts.push_back(verdict_of(shown, *methods::find_method("fast")));
  const std::string page = page_of("Title & more", section_of(shown));
  EXPECT_TRUE(has(page, "<title>Title &amp; more</title>"));
  EXPECT_TRUE(has(page, "<h2>a&lt;b</h2>"));
  EXPECT_TRUE(has(page, "no &lt;b&gt;verdict"));
  EXPECT_TRUE(has(page, "class=\"wrong\">true"));
  EXPECT_TRUE(has(page, "<div class=\"scroll\"><svg")) << "a narrow screen scrolls pictures and does not shrink them";
  EXPECT_TRUE(has(page, "prefers-color-scheme: dark"));
  for (const char* forbidden : {"<script", "href", "src=", "url(", "@import"})
    EXPECT_FALSE(has(page, forbidden)) << forbidden;
}

TEST(XmlText, HasNoMarkupAndNoControlBytes) {
  EXPECT_EQ(xml_text("a<b>&\"'\n\x1b[31m"), "a&lt;b&gt;&amp;&quot;&#39;\n\\x1b[31m");
  EXPECT_EQ(xml_text("\xff"), "\\xff");
}

}  // namespace
}  // namespace touchstone::show
