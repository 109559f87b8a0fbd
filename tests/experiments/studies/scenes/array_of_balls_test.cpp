// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/scenes/array_of_balls.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "tests/experiments/support/message_of.h"

namespace touchstone::scenes {
namespace {

/// A file of NPY: its header, padded as NumPy does, and numbers.
template <class Number>
std::string npy(const std::string& header, const std::vector<Number>& numbers) {
  std::string text = header + std::string(117 - header.size(), ' ') + '\n';
  std::string bytes = std::string("\x93NUMPY\1\0", 8) + std::string("\x76\0", 2) + text;
  const auto* const data = reinterpret_cast<const char*>(numbers.data());
  return bytes.append(data, numbers.size() * sizeof(Number));
}

std::string header_of(const std::string& type, const std::string& shape, const std::string& fortran = "False") {
  return "{'descr': '" + type + "', 'fortran_order': " + fortran + ", 'shape': " + shape + ", }";
}

std::vector<NamedBall> read(const std::string& content) {
  std::istringstream stream(content);
  EXPECT_TRUE(begins_as_array(stream));
  return read_array_of_balls(stream, "balls.npy");
}

TEST(ArrayOfBalls, HasABallARow) {
  const std::vector<double> numbers{0.5, 0.5, 2, 1, 9, 9, 9, 0.5};
  for (const std::string& content :
       {npy(header_of("<f8", "(2, 4)"), numbers),
        npy(header_of("<f4", "(2, 4)"), std::vector<float>(numbers.begin(), numbers.end()))}) {
    const std::vector<NamedBall> balls = read(content);
    ASSERT_EQ(balls.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(balls[i].id, std::to_string(i));
      const Ball& ball = std::get<Ball>(balls[i].question);
      EXPECT_EQ(ball.center, Eigen::Vector3d(numbers[4 * i], numbers[4 * i + 1], numbers[4 * i + 2]));
      EXPECT_EQ(ball.radius, numbers[4 * i + 3]);
    }
  }
  EXPECT_TRUE(read(npy(header_of("<f8", "(0, 4)"), std::vector<double>{})).empty());
}

TEST(ArrayOfBalls, HasTheEndsOfWays) {
  const auto balls = read(npy(header_of("<f8", "(1, 7)"), std::vector<double>{0.5, 0.25, 6, 0.5, 1, 2, 0.75}));
  ASSERT_EQ(balls.size(), 1U);
  const auto& motion = std::get<Motion>(balls[0].question);
  EXPECT_EQ(motion.ball.center, Eigen::Vector3d(0.5, 0.25, 6));
  EXPECT_EQ(motion.ball.radius, 0.5);
  EXPECT_EQ(motion.to, Eigen::Vector3d(1, 2, 0.75));
}

TEST(ArrayOfBalls, IsRefusedWithTheRowOrThePartOfItsHeader) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto fault = [](const std::string& content) {
    return run_tests::after_file("balls.npy", run_tests::message_of([&] { (void)read(content); }));
  };
  const std::string two = header_of("<f8", "(2, 4)");
  EXPECT_TRUE(fault(npy(two, std::vector<double>{0, 0, 0, 1, 0, kNan, 0, 1})).starts_with("row 1: "));
  EXPECT_TRUE(fault(npy(two, std::vector<double>{0, 0, 0, -1, 0, 0, 0, 1})).starts_with("row 0: "));
  EXPECT_EQ(fault(npy(two, std::vector<double>{0, 0, 0, 1, 0, 0, 0})),
            "row 1: the file ends, but the array has 2 rows");
  EXPECT_EQ(fault(npy(two, std::vector<double>(9, 1))), "the file continues after the array");
  EXPECT_EQ(fault(npy(header_of("<f8", "(99999999999999999999, 4)"), std::vector<double>{})),
            "the shape of the array is not (n, 4), for x y z r, or (n, 7), with the end of a way");
  for (const std::string shape : {"(2, 3)", "(8,)", "(2, 4, 1)", "(47, 2)", "()"})
    EXPECT_EQ(fault(npy(header_of("<f8", shape), std::vector<double>(8, 1))),
              "the shape of the array is not (n, 4), for x y z r, or (n, 7), with the end of a way");
  for (const std::string type : {">f8", "<i8", "|O"})
    EXPECT_EQ(fault(npy(header_of(type, "(2, 4)"), std::vector<double>(8, 1))),
              "the numbers of the array are not doubles or floats, little-endian: save array.astype('<f8')");
  EXPECT_EQ(fault(npy(header_of("<f8", "(2, 4)", "True"), std::vector<double>(8, 1))),
            "the array is not stored row by row: save numpy.ascontiguousarray(array)");
  EXPECT_EQ(fault(npy("{}", std::vector<double>(8, 1))),
            "the array's header does not name the type of its numbers as numpy.save does");
  EXPECT_EQ(fault(std::string("\x93NUMPY\1\0\x01\x10", 10) + std::string(4097, ' ')), "the array's header is too long");
  EXPECT_EQ(fault(std::string("\x93NUMPY\xC8\0", 8) + "x"), "version 200 of NPY is not known");
  EXPECT_EQ(fault("\x93NUM"), "the file ends within the array's header");
  EXPECT_EQ(fault(std::string("\x93NUMPY\7\0", 8) + "x"), "version 7 of NPY is not known");
  EXPECT_EQ(fault(std::string("\x93NUMPY\2\0\0\0\0\1", 12)), "the array's header is too long");
  EXPECT_EQ(fault("\x93nothing"), "this is not a file of NPY, though its first byte is that of one");
}

}  // namespace
}  // namespace touchstone::scenes
