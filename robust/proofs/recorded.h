// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/proofs/expressions.h"

/// Numbers that compute nothing and record their operations, over which the filters run for the proofs.
namespace touchstone::proofs {

/// The operations that were carried out, each once, in order, without branches. Nodes are numbered in this order,
/// inputs included.
class Recording {
 public:
  struct Node {
    std::string operation;  ///< "input" and "constant" have no operands; the others as the functions below
    std::vector<int> of;
    std::string name;        ///< of an input
    double number = 0;       ///< a constant, or the error of an input in units of its maximum
    bool is_length = false;  ///< of an input: it is not negative
  };

  /// Returns the recording to which all operations are added.
  static Recording& current();
  /// Forgets all nodes.
  void begin() { *this = {}; }
  /// Returns the node of this operation, a new one if it was not carried out yet.
  int add(const Node& node);
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// Notes that a decision depends on the sign of a number.
  void decide(int node) { decided_.push_back(node); }
  /// Notes that a decision depends on whether one number exceeds another. Returns whether it is the true comparison.
  bool compare(int greater, int less) {
    compared_.push_back({greater, less});
    return compared_.size() == true_comparison;
  }
  std::size_t true_comparison = 0;  ///< Counted from 1; all others are false.
  [[nodiscard]] const std::vector<int>& decided() const { return decided_; }
  [[nodiscard]] const std::vector<std::array<int, 2>>& compared() const { return compared_; }
  /// Whether numbers are assumed not to be 0 where they are compared with it; else that is refused.
  bool nothing_is_zero = false;
  /// Prints the nodes from which some results are computed, as a JSON array.
  void print(std::ostream& out, const std::vector<int>& results) const;

 private:
  std::vector<Node> nodes_;
  std::map<std::tuple<std::string, std::vector<int>, std::string, double>, int> numbers_;
  std::vector<int> decided_;
  std::vector<std::array<int, 2>> compared_;
};

struct Recorded {
  int node;

  Recorded(double constant = 0);  // NOLINT: it is one
  static Recorded of(std::string operation, std::vector<int> operands);
  static Recorded input(std::string name, double error = 0);
  /// Returns an input that is not negative.
  static Recorded length(std::string name);

 private:
  explicit Recorded(const Recording::Node& of);
};

/// @{
/// A rounded operation, and a b + c and a b - c rounded once.
Recorded operator+(const Recorded& a, const Recorded& b);
Recorded operator-(const Recorded& a, const Recorded& b);
Recorded operator*(const Recorded& a, const Recorded& b);
Recorded operator/(const Recorded& a, const Recorded& b);
template <std::same_as<int> Two>
Recorded operator*(Two, const Recorded& a) {  ///< twice a, exact
  return Recorded::of("doubled", {a.node});
}
Recorded sqrt(const Recorded& a);
Recorded fused_sum(const Recorded& a, const Recorded& b, const Recorded& c);
Recorded fused_difference(const Recorded& a, const Recorded& b, const Recorded& c);
/// @}
/// @{
/// Not rounded.
Recorded maximum(const Recorded& a, const Recorded& b);
Recorded magnitude(const Recorded& a);
Recorded operator-(const Recorded& a);
/// @}
/// @{
/// A comparison, which is recorded, or refused if it is with 0. Returns false, except for the recording's true one.
bool operator>(const Recorded& a, const Recorded& b);
bool operator<(const Recorded& a, const Recorded& b);
bool operator==(const Recorded& a, int zero);
/// @}

/// @{
/// What the error-free transformations of double_double.h need of words.
inline Recorded multiplied(double factor, const Recorded& a) { return Recorded(factor) * a; }
inline Recorded fused_multiply_subtract(const Recorded& a, const Recorded& b, const Recorded& c) {
  return fused_difference(a, b, c);
}
/// @}

/// The error-free transformations of double_double.h: a rounded operation and its exact rounding error.
DoubleWord<Recorded> two_sum(const Recorded& a, const Recorded& b);
DoubleWord<Recorded> two_difference(const Recorded& a, const Recorded& b);
DoubleWord<Recorded> two_product(const Recorded& a, const Recorded& b);
DoubleWord<Recorded> quick_two_sum(const Recorded& a, const Recorded& b);

/// Returns the words of a double-double, or the double-double of two words.
DoubleWord<Recorded> words_of(int number);
int number_of(const DoubleWord<Recorded>& a);
/// @{
/// Operations on double-doubles as a whole.
DoubleWord<Recorded> operator+(const DoubleWord<Recorded>& a, const DoubleWord<Recorded>& b);
DoubleWord<Recorded> operator-(const DoubleWord<Recorded>& a, const DoubleWord<Recorded>& b);
DoubleWord<Recorded> operator*(const DoubleWord<Recorded>& a, const DoubleWord<Recorded>& b);
/// @}

/// Returns itself: the number stands for a double-double and its leading double alike.
inline Recorded leading(const Recorded& a) { return a; }

/// A function that takes signs to be certain, as recorded.
class RecordedFunction {
 public:
  /// Forgets what was recorded before.
  RecordedFunction(std::string_view name, std::string_view target, std::string_view arithmetic);
  /// Says that the maximum bounds the numbers, each known to `error` units of it: for the reason `why`, or by a claim
  /// of its own about the `constant`.
  void known(const std::vector<Recorded>& numbers, const Recorded& maximum, double error, std::string_view constant,
             std::string_view why = "");
  /// Says that inputs have units of their own, so that only products of the same ones may be added.
  void has_own_units() { head_ += R"(, "own_units": true)"; }
  /// Adds a sign that is taken to be certain where one of these is negative: a bound less a value, and their sum.
  void use(std::string_view name, const Recorded& positive, const Recorded& negative);
  /// Says that nothing depends on a sign, though it is computed.
  void ignore(const Recorded& sign) { ignored_.push_back(sign.node); }
  /// Adds the sign of an estimate, by the comparisons on which it depends.
  void use(std::string_view name, const filtered::detail::Estimate<Recorded>& estimate);
  void print(std::ostream& out) const;

  /// Prints a filter in doubles rounded to nearest: a function of that many inputs that returns 1 or -1 if a sign is
  /// certain, else 0. After a comparison that is true, it may do nothing but return.
  static void print_filter(std::ostream& out, std::string_view name, std::size_t inputs,
                           const std::function<int(const std::vector<Recorded>&)>& filter);

 private:
  std::string known_, uses_, head_;
  std::vector<int> ignored_;
};

/// Prints the model of bounds.h and its unit in round to nearest.
void print_model(std::ostream& out);
/// Prints a claim of the list, whose expression has this result.
void print_claim(std::ostream& out, const Claim& claim, Over over, const Recorded& result);

}  // namespace touchstone::proofs
