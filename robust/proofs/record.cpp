// SPDX-License-Identifier: Apache-2.0
// Prints the model and, for each claim of expressions.h, the operations that its expression carries out, as JSON lines.
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/proofs/expressions.h"

namespace touchstone::proofs {

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

namespace {

/// Prints the nodes from which some results are computed, as a JSON array. print_input(node) prints what is known of an
/// input.
template <class PrintInput>
void print_nodes(const Recording& recording, const std::vector<int>& results, PrintInput print_input) {
  std::vector<bool> is_needed(recording.nodes.size(), false);
  for (const int result : results) is_needed[static_cast<std::size_t>(result)] = true;
  for (std::size_t i = recording.nodes.size(); i-- > 0;) {
    if (!is_needed[i]) continue;
    for (const int of : {recording.nodes[i].left, recording.nodes[i].right})
      if (of >= 0) is_needed[static_cast<std::size_t>(of)] = true;
  }
  const char* separator = "";
  std::cout << "[";
  for (std::size_t i = 0; i < is_needed.size(); ++i) {
    if (!is_needed[i]) continue;
    const auto& [operation, left, right] = recording.nodes[i];
    std::cout << separator << R"({"node": )" << i << ", ";
    if (operation == 'i')
      print_input(i);
    else if (operation == 'r')
      std::cout << R"("rest_of": )" << left;
    else
      std::cout << R"("operation": ")" << operation << R"(", "of": [)" << left << ", " << right << "]";
    std::cout << "}";
    separator = ", ";
  }
  std::cout << "]";
}

/// Records the expressions over inputs with known maxima and errors.
struct Printer {
  Recording recording;
  std::vector<Input> inputs;  // node i is input i
  Inputs<Recorded> recorded;

  Printer() : recorded(make_inputs<Recorded>([this](const Input& input) { return record(input); })) {}

  Recorded record(const Input& input) {
    inputs.push_back(input);
    return {&recording, recording.add('i', -1, -1)};
  }

  void print(const Claim& claim, int result) const {
    std::cout << R"({"constant": ")" << claim.constant << R"(", "instance": ")" << claim.instance << R"(", "value": )"
              << claim.value << R"(, "factor": )" << claim.factor << R"(, "squares_are_products": )"
              << claim.squares_are_products() << R"(, "nodes": )";
    print_nodes(recording, {result}, [this](std::size_t i) {
      std::cout << R"("input": ")" << inputs[i].name << R"(", "error": )" << inputs[i].error;
    });
    std::cout << "}\n";
  }
};

const char* const kNames[] = {"a_x", "a_y", "a_z", "b_x", "b_y", "b_z"};

Recorded input(Recording& recording) { return {&recording, recording.add('i', -1, -1)}; }

/// Prints an operation on two vectors of double-doubles, and the same without rounding. Both have the same inputs in
/// the same order: the two words of each double-double.
template <class Expression>
void print(const SumOfProducts& claim, const Expression& expression) {
  Recording words, exact;
  const auto word_pair = [&] {
    const Recorded high = input(words);
    return DoubleWord<Recorded>{high, input(words)};
  };
  const auto vectors_of = [](const auto& number) {
    auto x = number(), y = number(), z = number();
    return Vector3{x, y, z};
  };
  const auto a = vectors_of(word_pair), b = vectors_of(word_pair);
  const DoubleWord<Recorded> computed = expression(a, b);
  const auto exact_number = [&] { return input(exact); };
  const auto exact_a = vectors_of(exact_number), exact_b = vectors_of(exact_number);
  const Recorded exactly = expression(exact_a, exact_b);

  std::cout << R"({"constant": ")" << claim.constant << R"(", "instance": ")" << claim.instance << R"(", "value": )"
            << claim.value << R"(, "proved": )" << claim.proved << R"(, "high": )" << computed.high.node
            << R"(, "low": )" << computed.low.node << R"(, "words": )";
  print_nodes(words, {computed.high.node, computed.low.node}, [](std::size_t i) {
    std::cout << R"("input": ")" << kNames[i / 2] << R"(", "word": ")" << (i % 2 == 0 ? "high" : "low") << R"(")";
  });
  std::cout << R"(, "exact": )";
  print_nodes(exact, {exactly.node}, [](std::size_t i) { std::cout << R"("input": ")" << kNames[i] << R"(")"; });
  std::cout << "}\n";
}

const char* name(char operation) {
  switch (operation) {
    case '+': return "+";
    case '-': return "-";
    case '*': return "*";
    case '/': return "/";
    case 's': return "sqrt";
    case 'd': return "doubled";
    case 'r': return "rest";
    case 'A': return "double-double +";
    case 'S': return "double-double -";
    case 'P': return "double-double *";
    case 'h': return "high";
    case 'l': return "low";
    case 'e': return "exact +";
    default: return "input";
  }
}

/// Prints an operation on double-doubles, and on their words if it uses them. Nodes 0 and 1 are its operands.
template <class Expression>
void print(const Quotient& claim, const Expression& expression) {
  Recording recording;
  const int a = input(recording).node, b = input(recording).node;
  const int result = number_of(expression(words_of(&recording, a), words_of(&recording, b)));
  std::cout << R"({"constant": ")" << claim.constant << R"(", "instance": ")" << claim.instance << R"(", "value": )"
            << claim.value << R"(, "proved": )" << claim.proved << R"(, "result": )" << result << R"(, "numbers": [)";
  const char* separator = "";
  for (std::size_t i = 2; i < recording.nodes.size(); ++i) {
    const auto& [operation, left, right] = recording.nodes[i];
    std::cout << separator << R"({"node": )" << i << R"(, "operation": ")" << name(operation) << R"(", "of": [)"
              << left;
    if (right >= 0) std::cout << ", " << right;
    std::cout << "]}";
    separator = ", ";
  }
  std::cout << "]}\n";
}

}  // namespace
}  // namespace touchstone::proofs

int main() {
  using namespace touchstone;
  using namespace touchstone::filtered::detail;
  std::cout << std::boolalpha << std::setprecision(17) << R"({"unit": )" << bounds::kUnit
            << R"(, "double_double_unit": )" << bounds::kDoubleDoubleUnit << R"(, "float_unit": )" << bounds::kFloatUnit
            << R"(, "rounding_of_bound": )" << proofs::kRoundingOfBound << "}\n";
  proofs::Printer printer;
  proofs::for_each_claim([&](const proofs::Claim& claim, const auto& expression) {
    printer.print(claim, expression(printer.recorded).node);
  });
  proofs::for_each_sum_of_products(
      [](const proofs::SumOfProducts& claim, const auto& expression) { proofs::print(claim, expression); });
  proofs::for_each_quotient(
      [](const proofs::Quotient& claim, const auto& expression) { proofs::print(claim, expression); });
}
