// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace touchstone::filtered::proofs {

/// The straight line of operations that an expression carries out. Nodes are numbered in order, inputs among them.
struct Recording {
  struct Node {
    char operation;   ///< '+', '-', '*', or 'i' for an input
    int left, right;  ///< nodes; of an input, -1
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

}  // namespace touchstone::filtered::proofs
