// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "robust/filtered/detail/numbers/double_double.h"

namespace touchstone::proofs {

using namespace filtered::detail;

/// The operations that an expression carries out, in order, without branches. Nodes are numbered in this order, inputs
/// included.
struct Recording {
  struct Node {
    /// '+', '-', '*', '/', 's' for a root, 'd' for doubling, 'i' for an input, or 'r' for the rounding error of a node.
    /// For double-doubles 'A', 'S', 'P' for sum, difference and product, 'h' and 'l' for the high and low word, 'e' for
    /// the double-double made of two words.
    char operation;
    int left, right;  ///< nodes; -1 if unused
  };
  std::vector<Node> nodes;

  int add(char operation, int left, int right) {
    nodes.push_back({operation, left, right});
    return static_cast<int>(nodes.size()) - 1;
  }
};

/// A number type that computes nothing and records its operations: those of the templates over a scalar. The lanes of
/// doubles that answer queries (lane_vector.h) overload `dot` and `cross`, which are not recorded: they add
/// x + (y + z).
struct Recorded {
  Recording* recording;
  int node;

  Recorded(Recording* of, int number) : recording(of), node(number) {}
  /// Makes a zero: the low word of a double-double that is one word.
  Recorded(int) : recording(nullptr), node(-1) {}  // NOLINT: it is one
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

inline Recorded operator/(const Recorded& a, const Recorded& b) {
  return {a.recording, a.recording->add('/', a.node, b.node)};
}
/// Returns twice a word.
inline Recorded operator*(int, const Recorded& a) { return {a.recording, a.recording->add('d', a.node, -1)}; }
inline Recorded sqrt(const Recorded& a) { return {a.recording, a.recording->add('s', a.node, -1)}; }
/// Returns false: recorded numbers are assumed to be nonzero.
inline bool operator==(const Recorded&, int) { return false; }

/// The error-free transformations of double_double.h: a rounded operation and its exact rounding error.
inline DoubleWord<Recorded> with_rest(const Recorded& rounded) {
  return {rounded, {rounded.recording, rounded.recording->add('r', rounded.node, -1)}};
}
inline DoubleWord<Recorded> two_sum(const Recorded& a, const Recorded& b) { return with_rest(a + b); }
inline DoubleWord<Recorded> two_difference(const Recorded& a, const Recorded& b) { return with_rest(a - b); }
inline DoubleWord<Recorded> two_product(const Recorded& a, const Recorded& b) { return with_rest(a * b); }
inline DoubleWord<Recorded> quick_two_sum(const Recorded& a, const Recorded& b) { return with_rest(a + b); }

/// Returns the words of a double-double, or the double-double of two words.
inline DoubleWord<Recorded> words_of(Recording* recording, int number) {
  return {{recording, recording->add('h', number, -1)}, {recording, recording->add('l', number, -1)}};
}
inline int number_of(const DoubleWord<Recorded>& a) {
  if (a.low.node < 0) return a.high.node;
  Recording& recording = *a.high.recording;
  const Recording::Node& low = recording.nodes[static_cast<std::size_t>(a.low.node)];
  return low.operation == 'l' ? low.left : recording.add('e', a.high.node, a.low.node);
}

/// @{
/// Operations on double-doubles as a whole.
inline DoubleWord<Recorded> record_operation(char operation, const DoubleWord<Recorded>& a,
                                             const DoubleWord<Recorded>& b) {
  const int left = number_of(a), right = number_of(b);
  return words_of(a.high.recording, a.high.recording->add(operation, left, right));
}
inline DoubleWord<Recorded> operator+(const DoubleWord<Recorded>& a, const DoubleWord<Recorded>& b) {
  return record_operation('A', a, b);
}
inline DoubleWord<Recorded> operator-(const DoubleWord<Recorded>& a, const DoubleWord<Recorded>& b) {
  return record_operation('S', a, b);
}
inline DoubleWord<Recorded> operator*(const DoubleWord<Recorded>& a, const DoubleWord<Recorded>& b) {
  return record_operation('P', a, b);
}
/// @}

}  // namespace touchstone::proofs
