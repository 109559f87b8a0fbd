// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace touchstone {

/// Why an input is no ball or no polygon, in the order in which the reasons are looked for: where several apply, the
/// first is given.
enum class RejectionCode {
  MalformedCase,    ///< not of the form of a case: a missing key, a wrong type, a point without three numbers
  NotFinite,        ///< a number beyond the finite doubles
  NegativeRadius,   ///< r < 0
  TooFewVertices,   ///< a loop of fewer than three vertices
  RepeatedVertex,   ///< two equal neighbours in a loop
  ZeroNormal,       ///< the Newell normal of the outer loop is exactly zero
  LoopMeetsItself,  ///< crossing, touching, spike, or an edge that becomes a point, in the dropped-axis projection
  LoopsMeet,        ///< two loops share a point
  HoleOutside,      ///< a hole that does not lie inside the outer loop
};

/// The code as it is written in verdicts, such as `zero-normal`.
[[nodiscard]] std::string_view word(RejectionCode code);

/// A code and a sentence that names the loop and the vertex or edge.
struct Rejection {
  RejectionCode code;   ///< the first reason that applies
  std::string message;  ///< the sentence, without the name of a case
};

/// Thrown where a shape is built from an input that the contract rejects.
class Rejected : public std::invalid_argument {
 public:
  /// `what()` is the rejection's sentence.
  explicit Rejected(Rejection rejection)
      : std::invalid_argument(rejection.message), rejection_(std::move(rejection)) {}
  /// Why.
  [[nodiscard]] const Rejection& rejection() const { return rejection_; }

 private:
  Rejection rejection_;
};

}  // namespace touchstone
