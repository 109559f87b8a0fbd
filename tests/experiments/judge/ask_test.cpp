// SPDX-License-Identifier: GPL-3.0-or-later
// A question on the command line: its shapes as people write them, and its answer in words.
#include "experiments/judge/ask.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "experiments/commands.h"
#include "geometry/shapes/rejection.h"
#include "tests/experiments/judge/run_judge.h"
#include "tests/experiments/support/message_of.h"

namespace touchstone::judge {
namespace {

const Polygon kHoled({{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, {{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}});

TEST(PolygonText, IsLoopsOrWkt) {
  EXPECT_EQ(polygon_of("0 0 1, 4 0 1,0 4 1 ; 1 1 1,\t2 1 1, 1 2 1\n"), kHoled);
  EXPECT_EQ(polygon_of("POLYGON Z ((0 0 1,4 0 1,0 4 1,0 0 1), (1 1 1,2 1 1,1 2 1,1 1 1))"), kHoled);
  EXPECT_EQ(polygon_of("polygon((0 0 1,4 0 1,0 4 1,0 0 1),(1 1 1,2 1 1,1 2 1,1 1 1))\n"), kHoled);
  EXPECT_EQ(polygon_of("0 0, 4e0 0, 0 0x1p2"), Polygon({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}})) << "z is 0";
}

std::string fault(const std::string& text) {
  return run_tests::message_of<std::runtime_error>([&] { (void)polygon_of(text); });
}

TEST(PolygonText, NamesTheLoopAndThePointOfAFault) {
  EXPECT_EQ(fault("0 0, 1 0, 1 x"), "the outer loop: point 2: \"x\" is not a number");
  EXPECT_EQ(fault("0 0, 1 0, 1 1; 0 0 0 0"), "hole 0: point 0: \"0 0 0 0\" has 4 numbers, not two or three");
  EXPECT_EQ(fault("0 0, 1 0, 1 1e999"), "the outer loop: point 2: \"1e999\" is not finite");
  EXPECT_EQ(fault("POLYGON ((0 0, 1 0, 1 1))"), "the outer loop: does not end with its first point");
  EXPECT_EQ(fault("MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)))"),
            "\"MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)))\": is neither loops, nor a POLYGON of WKT, nor a file");
  EXPECT_EQ(fault("inf 0 0, 1 0 0, 0 1 0"), "the outer loop: point 0: \"inf\" is not finite");
  EXPECT_EQ(fault("NaN 0 0, 1 0 0, 0 1 0"), "the outer loop: point 0: \"NaN\" is not finite");
  EXPECT_NE(fault("infix 0 0, 1 0 0, 0 1 0").find("is neither loops"), std::string::npos);
  for (const char* text : {"", ",", "POLYGON", "POLYGON ()", "POLYGON 0 0, 1 0, 0 1", "POLYGON ((0 0, 1 0, 1 1, 0 0)",
                           "POLYGON ((0 0, 1 0, 1 1, 0 0) x (0 0))", "POLYGON ((0 0, 1 0, 1 1, 0 0),)"})
    EXPECT_NE(fault(text), "") << text;
  EXPECT_THROW((void)polygon_of("0 0, 1 1, 1 0, 0 2"), Rejected);
  EXPECT_THROW((void)polygon_of("0 0, 1 1"), Rejected);
}

std::string asked(const std::vector<std::string>& words) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(commands::ask_command()(words), 0);
  std::fflush(stdout);
  return testing::internal::GetCapturedStdout();
}

const std::vector<std::string> kAlmost{"--ball", "1,1,1,1.1547005383792515", "--polygon", "1 0 0, 0 1 0, 0 0 1"};

TEST(Ask, SaysInWordsWhereMethodsDiffer) {
  const std::string text = asked(kAlmost);
  EXPECT_NE(text.find("The ball does not touch: its radius is 1 double below the least one that does.\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("  nearest         face\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  contact         yes, exactly no\n"), std::string::npos) << text;
  EXPECT_NE(text.find("; off by 6.7e-17\n"), std::string::npos) << text;
  std::vector<std::string> certified = kAlmost;
  certified.insert(certified.end(), {"--methods", "filtered"});
  EXPECT_NE(asked(certified).find("\nfiltered\n  the same\n"), std::string::npos);
}

TEST(Ask, PrintsTheQuestionAsACaseThatTheJudgeTakes) {
  std::vector<std::string> words = kAlmost;
  words.emplace_back("--print");
  const Result result = run(asked(words));
  EXPECT_EQ(result.status, AllMet) << result.complaints;
  EXPECT_EQ(nlohmann::json::parse(result.verdicts)["relation"], "separate");
}

// Editors that write a mark before the text, of UTF-8 or UTF-16 in either order, are named as the reason.
TEST(Ask, NamesTheFileThatBeginsWithAByteOrderMark) {
  for (const std::string mark : {"\xEF\xBB\xBF", "\xFE\xFF", "\xFF\xFE"}) {
    const std::string file = write_file("marked.txt", mark + "0 0, 1 0, 0 1");
    EXPECT_EQ(run_tests::message_of<std::exception>([&] {
                (void)commands::ask_command()({"--ball", "0,0,0,1", "--polygon", file});
              }),
              "--polygon " + file + ": line 1: begins with a byte order mark; write it in UTF-8 without one");
  }
}

TEST(Ask, TakesFilesAndMovingBalls) {
  const std::string file = write_file("holed.wkt", "POLYGON Z ((0 0 1,4 0 1,0 4 1,0 0 1),(1 1 1,2 1 1,1 2 1,1 1 1))\n");
  const std::string text = asked({"--ball", "1.25,1.25,0,0.25", "--to", "0.5,0.5,0.875", "--polygon", file});
  EXPECT_NE(text.find("  first           way\n"), std::string::npos) << text;
  std::string loops;  // longer than a name of a file may be
  for (int i = 0; i < 400; ++i) loops += (i == 0 ? "" : ", ") + std::to_string(i) + " " + std::to_string(i * i);
  EXPECT_NE(asked({"--ball", "0,0,1,1", "--polygon", loops}).find("vertex 0"), std::string::npos);
}

TEST(Ask, NamesTheFacesOfAMesh) {
  // The scene numbers the triangles before the quadrilateral.
  const std::string mesh = write_file("three.obj",
                                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 5\nv 1 0 5\nv 1 1 5\nv 0 1 5\n"
                                      "f 5 6 7 8\nf 1 2 3\nf 2 4 3\n");
  const std::string text = asked({"--ball", "0.75,0.75,0.5,0.5", "--mesh", mesh});
  EXPECT_NE(text.find("The ball touches 1 of 3 faces: 2.\nFace 2 is nearest. About this face:\n\nThe ball touches"),
            std::string::npos)
      << text;
  EXPECT_NE(asked({"--ball", "9,9,9,1", "--mesh", mesh}).find("The ball touches 0 of 3 faces.\n"), std::string::npos);
  EXPECT_NE(asked({"--ball", "0.2,0.2,2,1", "--to", "0.2,0.2,0", "--mesh", mesh}).find("Face 1 is first."),
            std::string::npos);
  EXPECT_NE(asked({"--ball", "0.5,0.5,6,1", "--mesh", mesh}).find("Face 0 is nearest."), std::string::npos);
}

TEST(Ask, RefusesWhatIsNoQuestion) {
  const auto refused = [](const std::vector<std::string>& words) {
    return run_tests::message_of<std::exception>([&] { (void)commands::ask_command()(words); });
  };
  EXPECT_EQ(refused({"--ball", "0,0,0", "--polygon", "0 0, 1 0, 0 1"}), "--ball: \"0,0,0\": has 3 numbers, not 4");
  EXPECT_EQ(refused({"--ball", "0,0,0,-1", "--polygon", "0 0, 1 0, 0 1"}),
            "--ball: rejected: negative-radius: the radius is below 0");
  EXPECT_EQ(refused({"--ball", "0,0,0,1", "--to", "0,0", "--polygon", "0 0, 1 0, 0 1"}),
            "--to: \"0,0\": has 2 numbers, not 3");
  EXPECT_EQ(refused({"--ball", "0,0,0,1", "--polygon", "0 0, 1 1, 2 2"}),
            "--polygon: rejected: zero-normal: the outer loop: its Newell normal is zero");
  EXPECT_NE(refused({"--ball", "0,0,0,1", "--mesh", "/no/such.obj"}).find("--mesh: "), std::string::npos);
  const std::string file = write_file("faulty.txt", "0 0, 1 0, 0 x");
  EXPECT_EQ(refused({"--ball", "0,0,0,1", "--polygon", file}),
            "--polygon " + file + ": the outer loop: point 2: \"x\" is not a number");
  EXPECT_NE(refused({"--ball", "0,0,0,1", "--polygon", "no-such-file.txt"}).find("is neither loops"),
            std::string::npos);
  EXPECT_NE(refused({"--ball", "0,0,0,1", "--to", "", "--polygon", "0 0, 1 0, 0 1"}).find("--to: "), std::string::npos);
  EXPECT_NE(refused({"--ball", "0,0,0,1", "--print", "--show", "x.html", "--polygon", "0 0, 1 0, 0 1"}), "");
}

}  // namespace
}  // namespace touchstone::judge
