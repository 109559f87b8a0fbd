// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robust/filtered/filtered.h"

namespace touchstone::filtered_tests {

/// The names of the questions about a ball that `filtered` answers otherwise than expected.
template <class Polygon>
std::string wrong_answers(const Ball& ball, const Polygon& polygon, const Answer& expected) {
  std::string wrong;
  const auto expect = [&wrong](bool right, const char* question) {
    if (!right) wrong += std::string(" ") + question;
  };
  expect(filtered::answer(ball, polygon) == expected, "answer");
  expect(filtered::contact(ball, polygon) == expected.contact(), "contact");
  expect(filtered::relation(ball, polygon) == expected.relation, "relation");
  expect(filtered::plane_side(ball, polygon) == expected.plane, "plane_side");
  expect(filtered::foot(ball, polygon) == expected.foot, "foot");
  expect(filtered::edges_hit(ball, polygon) == expected.edges_hit, "edges_hit");
  return wrong;
}

}  // namespace touchstone::filtered_tests
