// SPDX-License-Identifier: Apache-2.0
// Prints, as JSON lines, the model and what the filters compute: for each claim of expressions.h the operations of its
// expression; for each filter of triangles, and for signs in double-doubles, all operations from the inputs on, and the
// signs that are taken to be certain; and the operations of each error-free transformation.
#include <iostream>
#include <stdexcept>
#include <string>

#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/proofs/expressions.h"
#include "robust/proofs/lane_functions.h"
#include "robust/proofs/recorded.h"

namespace touchstone::proofs {

#if defined(TOUCHSTONE_HAS_AVX2)
void print_avx2();
#endif

namespace {

/// Prints the claims of the list over single numbers, doubles and double-doubles alike.
void print_claims() {
  Recording::current().begin();
  const auto inputs =
      make_inputs<Recorded>([](const Input& input) { return Recorded::input(input.name, input.error); });
  for_each_claim([&](const Claim& claim, const auto& expression) {
    for (const Over over : claim.over)
      if (over == Over::Doubles || over == Over::DoubleDoubles) print_claim(std::cout, claim, over, expression(inputs));
  });
}

/// A ball and an edge as the sign ladder sees them, with what EdgeOperands requires of their numbers.
struct RecordedOperands {
  RecordedFunction function;
  Recorded m_center = Recorded::input("m_center"), m_edge = Recorded::input("m_edge");
  Recorded m_normal = Recorded::input("m_normal"), m_velocity = Recorded::input("m_velocity");
  Recorded r = Recorded::length("radius");

  explicit RecordedOperands(std::string_view name) : function(name, "baseline", "double-doubles") {
    function.known({r}, m_center, 0, "", kWhy);
  }
  Vector3<Recorded> vector(const std::string& name, const Recorded& maximum, double error = 1) {
    const Vector3<Recorded> v{Recorded::input(name + "_x", error), Recorded::input(name + "_y", error),
                              Recorded::input(name + "_z", error)};
    function.known({v.x, v.y, v.z}, maximum, error, "", kWhy);
    return v;
  }

 private:
  static constexpr std::string_view kWhy = "what callers ensure";
};

/// The view of an edge by which expression<kind> computes.
struct RecordedView {
  Vector3<Recorded> w, e, n;
  Recorded r;
  int k;

  [[nodiscard]] const Vector3<Recorded>& to_center() const { return w; }
  [[nodiscard]] const Vector3<Recorded>& edge() const { return e; }
  [[nodiscard]] const Vector3<Recorded>& normal() const { return n; }
  [[nodiscard]] const Recorded& radius() const { return r; }
  [[nodiscard]] int axis() const { return k; }
};

/// Records the signs that double-doubles decide.
void print_functions() {
  {
    RecordedOperands in("exact_sign");
    const RecordedView view{in.vector("to_center", in.m_center), in.vector("edge", in.m_edge),
                            in.vector("normal", in.m_normal, bounds::kNormal), in.r, 0};
    const MaximaOf<Recorded> maxima{in.m_center, in.m_edge, in.m_normal};
    in.function.use("Vertex", estimate<SignKind::Vertex>(view, maxima));
    in.function.use("Along", estimate<SignKind::Along>(view, maxima));
    in.function.use("Beyond", estimate<SignKind::Beyond>(view, maxima));
    in.function.use("Line", estimate<SignKind::Line>(view, maxima));
    in.function.use("Front", estimate<SignKind::Front>(view, maxima));
    in.function.use("Plane", estimate<SignKind::Plane>(view, maxima));
    in.function.use("Side", estimate<SignKind::Side>(view, maxima));
    for (const int axis : {0, 1, 2}) {
      RecordedView along = view;
      along.k = axis;
      in.function.use(std::string("Above ") + "xyz"[axis], estimate<SignKind::Above>(along, maxima));
    }
    in.function.print(std::cout);
  }
  {
    RecordedOperands in("CapsuleInDoubles");
    const auto start = in.vector("to_center", in.m_center), end = in.vector("to_end", in.m_center);
    const auto next = in.vector("from_next", in.m_center), edge = in.vector("edge", in.m_edge);
    const auto velocity = in.vector("velocity", in.m_velocity);
    const CapsuleVertex<Recorded, Recorded> vertex{start, end, velocity, in.r, in.m_center * in.m_velocity};
    in.function.use("vertex.approaches", vertex.approaches()), in.function.use("vertex.departs", vertex.departs());
    in.function.use("vertex.out", vertex.out());
    const CapsuleEdge<Recorded, Recorded> side{start, next,        end,       edge,         velocity,
                                               in.r,  in.m_center, in.m_edge, in.m_velocity};
    in.function.use("edge.after_start", side.after_start()), in.function.use("edge.after_end", side.after_end());
    in.function.use("edge.starts_past", side.starts_past()), in.function.use("edge.ends_past", side.ends_past());
    in.function.use("edge.out", side.out());
    in.function.print(std::cout);
  }
}

template <class Claim>
void print_head(const Claim& claim) {
  std::cout << R"({"constant": ")" << claim.constant << R"(", "instance": ")" << claim.instance << R"(", "value": )"
            << claim.value << R"(, "proved": )" << claim.proved;
}

/// Prints an operation on two vectors of double-doubles, and the same without rounding. Both have the same inputs.
template <class Expression>
void print(const SumOfProducts& claim, const Expression& expression) {
  const auto vector_of = [](const std::string& name, const auto& number) {
    return Vector3{number(name + "_x"), number(name + "_y"), number(name + "_z")};
  };
  const auto words = [](const std::string& name) {
    const Recorded high = Recorded::input(name + " high");
    return DoubleWord<Recorded>{high, Recorded::input(name + " low")};
  };
  Recording& recording = Recording::current();
  recording.begin();
  const auto a = vector_of("a", words), b = vector_of("b", words);
  const DoubleWord<Recorded> computed = expression(a, b);
  print_head(claim);
  std::cout << R"(, "high": )" << computed.high.node << R"(, "low": )" << computed.low.node << R"(, "words": )";
  recording.print(std::cout, {computed.high.node, computed.low.node});
  recording.begin();
  const auto exact = [](const std::string& name) { return Recorded::input(name); };
  const auto exact_a = vector_of("a", exact), exact_b = vector_of("b", exact);
  const Recorded exactly = expression(exact_a, exact_b);
  std::cout << R"(, "exact": )";
  recording.print(std::cout, {exactly.node});
  std::cout << "}\n";
}

/// Prints an operation on double-doubles, and on their words if it uses them.
template <class Expression>
void print(const Quotient& claim, const Expression& expression) {
  Recording& recording = Recording::current();
  recording.begin();
  recording.nothing_is_zero = true;  // a root asks
  const int a = Recorded::input("a").node, b = Recorded::input("b").node;
  const int result = number_of(expression(words_of(a), words_of(b)));
  print_head(claim);
  std::cout << R"(, "result": )" << result << R"(, "numbers": )";
  recording.print(std::cout, {result});
  std::cout << "}\n";
}

}  // namespace
}  // namespace touchstone::proofs

int main() try {
  using namespace touchstone;
  proofs::print_model(std::cout);
  proofs::print_claims();
  proofs::print_functions();
  proofs::for_each_sum_of_products(
      [](const proofs::SumOfProducts& claim, const auto& expression) { proofs::print(claim, expression); });
  proofs::for_each_quotient(
      [](const proofs::Quotient& claim, const auto& expression) { proofs::print(claim, expression); });
  proofs::print_claims_of_lanes();
  proofs::print_functions_in_lanes("baseline");
  proofs::print_transformations("baseline");
#if defined(TOUCHSTONE_HAS_AVX2)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    std::cerr << "This processor has no AVX2: what its instructions compute cannot be recorded here.\n";
    return 1;
  }
  proofs::print_avx2();
#endif
} catch (const std::logic_error& refused) {
  std::cerr << refused.what() << '\n';
  return 1;
}
