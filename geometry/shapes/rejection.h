// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace touchstone {

/// Why an input is not a ball or not a polygon. Reasons are checked in this order; the first that applies is reported.
enum class RejectionCode {
  MalformedCase,   ///< the input does not have the form of a case: missing key, wrong type, point without three numbers
  NotFinite,       ///< a number is not a finite double
  NegativeRadius,  ///< r < 0
  TooFewVertices,  ///< a loop has fewer than three vertices
  RepeatedVertex,  ///< two neighbouring vertices of a loop are equal
  ZeroNormal,      ///< the Newell normal of the outer loop is exactly zero
  LoopMeetsItself,  ///< in the dropped-axis projection a loop crosses or overlaps itself, or has an edge of length 0
  LoopsMeet,        ///< in the same projection two loops cross or overlap
  HoleOutside,      ///< a hole does not lie inside the outer loop
};

/// Returns the code as written in verdicts, such as `zero-normal`.
[[nodiscard]] std::string_view to_string(RejectionCode code);

/// A code, and a message that names the loop and the vertex or edge.
struct Rejection {
  RejectionCode code;   ///< the first reason that applies
  std::string message;  ///< without the name of the case
};

/// The exception thrown by functions that build a shape from an input that the contract rejects.
class Rejected : public std::invalid_argument {
 public:
  /// Makes the rejection's message the text of `what()`.
  explicit Rejected(Rejection rejection) : std::invalid_argument(rejection.message), rejection_(std::move(rejection)) {}
  /// Returns the reason.
  [[nodiscard]] const Rejection& rejection() const { return rejection_; }

 private:
  Rejection rejection_;
};

}  // namespace touchstone
