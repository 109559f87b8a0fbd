// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "robust/filtered/numbers/double_double.h"

namespace touchstone::filtered::proofs {

/// The straight line of operations that an expression carries out. Nodes are numbered in order, inputs among them.
struct Recording {
  struct Node {
    char operation;   ///< '+', '-', '*', 'i' for an input, or 'r' for what the rounding of a node has left out
    int left, right;  ///< nodes; -1 for none
  };
  std::vector<Node> nodes;

  int add(char operation, int left, int right) {
    nodes.push_back({operation, left, right});
    return static_cast<int>(nodes.size()) - 1;
  }
};

/// A number type that computes nothing and writes down what is asked of it.
struct Recorded {
  Recording* recording;
  int node;
};

inline Recorded operator+(const Recorded& a, const Recorded& b) {
  return {a.recording, a.recording->add('+', a.node, b.node)};
}
inline Recorded operator-(const Recorded& a, const Recorded& b) {
  return {a.recording, a.recording->add('-', a.node, b.node)};
}
inline Recorded operator*(const Recorded& a, const Recorded& b) {
  return {a.recording, a.recording->add('*', a.node, b.node)};
}

/// The error-free transformations of double_double.h: a rounded operation and the rest, which has no error.
inline DoubleWord<Recorded> with_rest(const Recorded& rounded) {
  return {rounded, {rounded.recording, rounded.recording->add('r', rounded.node, -1)}};
}
inline DoubleWord<Recorded> two_sum(const Recorded& a, const Recorded& b) { return with_rest(a + b); }
inline DoubleWord<Recorded> two_difference(const Recorded& a, const Recorded& b) { return with_rest(a - b); }
inline DoubleWord<Recorded> two_product(const Recorded& a, const Recorded& b) { return with_rest(a * b); }

}  // namespace touchstone::filtered::proofs
