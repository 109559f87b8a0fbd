// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/recorded/measure.h"

#include <fmt/format.h>

#include <cstdio>
#include <iterator>
#include <stdexcept>
#include <string>

#include "experiments/cases/workloads/random.h"
#include "experiments/methods/process/engine_process.h"
#include "experiments/program/input.h"
#include "experiments/program/words.h"

namespace touchstone::recorded {
namespace {

constexpr std::uint64_t kStream = 0x70696c65;
constexpr std::size_t kSide = 12;   // cells
constexpr std::size_t kAcross = 3;  // balls, of a layer's side

double rounded(double x) { return static_cast<double>(static_cast<float>(x)); }

/// Returns the pile as the program reads it.
std::string text_of(const Pile& pile, std::size_t steps) {
  std::string text = fmt::format("{}", pile.vertices.size());
  const auto out = std::back_inserter(text);
  for (const auto& v : pile.vertices) fmt::format_to(out, " {} {} {}", v.x(), v.y(), v.z());
  fmt::format_to(out, " {}", pile.triangles.size());
  for (const auto& [a, b, c] : pile.triangles) fmt::format_to(out, " {} {} {}", a, b, c);
  fmt::format_to(out, " {}", pile.balls.size());
  for (const auto& [c, r] : pile.balls) fmt::format_to(out, " {} {} {} {}", c.x(), c.y(), c.z(), r);
  return text + fmt::format(" {}\n", steps);
}

Question question_in(const std::string& line) {
  Question question{};
  int within = 0, contact = 0;
  constexpr int kNumbers = 8;
  double* const center = question.ball.center.data();
  const int read = std::sscanf(line.c_str(), "%zu %la %la %la %la %la %d %d", &question.triangle, center, center + 1,
                               center + 2, &question.ball.radius, &question.within_radius, &within, &contact);
  if (read != kNumbers) throw std::runtime_error("the pile's program printed: " + line);
  question.within = within != 0;
  question.contact = contact != 0;
  return question;
}

}  // namespace

Pile draw_pile(std::uint64_t seed, std::uint64_t index, std::size_t balls) {
  workloads::Random random(seed, index, kStream);
  Pile pile;
  const auto place = [&random](std::size_t i) {
    return static_cast<double>(i) - double{kSide} / 2 + (random.unit() - 0.5) / 2;
  };
  for (std::size_t i = 0; i <= kSide; ++i)
    for (std::size_t j = 0; j <= kSide; ++j) {
      const double x = place(i), y = place(j), bowl = (x * x + y * y) / 16;
      pile.vertices.emplace_back(rounded(x), rounded(y), rounded(bowl + random.unit() / 2));
    }
  for (std::size_t i = 0; i < kSide; ++i)
    for (std::size_t j = 0; j < kSide; ++j) {
      const std::size_t a = i * (kSide + 1) + j, b = a + kSide + 1;
      pile.triangles.push_back({a, b, b + 1});
      pile.triangles.push_back({a, b + 1, a + 1});
    }
  constexpr double kApart = 1.5;  // more than two radii
  for (std::size_t i = 0; i < balls; ++i) {
    const auto at = [&random](std::size_t n) {
      return rounded(kApart * (static_cast<double>(n) + (random.unit() - 0.5) / 8));
    };
    const double x = at(i % kAcross) - kApart, y = at(i / kAcross % kAcross) - kApart;
    const double z = at(1 + i / kAcross / kAcross);
    pile.balls.push_back({{rounded(x), rounded(y), z}, rounded(0.25 + 0.375 * random.unit())});
  }
  return pile;
}

const std::vector<Simulation>& simulations() {
  static const std::vector<Simulation> list{
#ifdef TOUCHSTONE_PILE_DOUBLE
      {"bullet", program::helper_program("touchstone_pile_double").string()},
#endif
#ifdef TOUCHSTONE_PILE_FLOAT
      {"bullet-float", program::helper_program("touchstone_pile_float").string()},
#endif
  };
  return list;
}

std::vector<Question> record(const Simulation& simulation, const Pile& pile, std::size_t steps) {
  methods::EngineProcess program("exec " + program::shell_quoted(simulation.program));
  if (!program.send(text_of(pile, steps)))
    throw std::runtime_error(fmt::format("{} does not read the pile", simulation.program));
  program.end_input();
  std::vector<Question> questions;
  while (const auto line = program.receive()) {
    questions.push_back(question_in(*line));
    if (questions.back().triangle >= pile.triangles.size())
      throw std::runtime_error("the pile's program printed: " + *line);
  }
  if (const std::string& ending = program.ending(); !ending.empty())
    throw std::runtime_error(fmt::format("{} ended with {}", simulation.program, ending));
  return questions;
}

}  // namespace touchstone::recorded
