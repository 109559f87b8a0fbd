// SPDX-License-Identifier: Apache-2.0
#include "robust/proofs/recorded.h"

#include <fmt/format.h>

#include <cstddef>
#include <iomanip>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace touchstone::proofs {

Recording& Recording::current() {
  static Recording recording;
  return recording;
}

int Recording::add(const Node& node) {
  const auto [found, is_new] =
      numbers_.try_emplace({node.operation, node.of, node.name, node.number}, static_cast<int>(nodes_.size()));
  if (is_new) nodes_.push_back(node);
  return found->second;
}

void Recording::print(std::ostream& out, const std::vector<int>& results) const {
  std::vector<bool> is_needed(nodes_.size(), false);
  for (const int result : results) is_needed[static_cast<std::size_t>(result)] = true;
  for (std::size_t i = nodes_.size(); i-- > 0;)
    if (is_needed[i])
      for (const int of : nodes_[i].of) is_needed[static_cast<std::size_t>(of)] = true;
  const char* separator = "";
  out << "[";
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!is_needed[i]) continue;
    const Node& node = nodes_[i];
    out << std::exchange(separator, ", ") << R"({"node": )" << i << ", ";
    if (node.operation == "input") {
      out << R"("input": ")" << node.name << R"(", "error": )" << node.number << R"(, "is_length": )"
          << (node.is_length ? "true" : "false");
    } else if (node.operation == "constant") {
      out << R"("constant": )" << node.number;
    } else {
      out << R"("operation": ")" << node.operation << R"(", "of": [)";
      const char* comma = "";
      for (const int of : node.of) out << std::exchange(comma, ", ") << of;
      out << "]";
    }
    out << "}";
  }
  out << "]";
}

Recorded::Recorded(const Recording::Node& of) : node(Recording::current().add(of)) {}
Recorded::Recorded(double constant) : Recorded(Recording::Node{"constant", {}, "", constant}) {}
Recorded Recorded::of(std::string operation, std::vector<int> operands) {
  return Recorded(Recording::Node{std::move(operation), std::move(operands), "", 0});
}
Recorded Recorded::input(std::string name, double error) {
  return Recorded(Recording::Node{"input", {}, std::move(name), error});
}
Recorded Recorded::length(std::string name) { return Recorded(Recording::Node{"input", {}, std::move(name), 0, true}); }

Recorded operator+(const Recorded& a, const Recorded& b) { return Recorded::of("+", {a.node, b.node}); }
Recorded operator-(const Recorded& a, const Recorded& b) { return Recorded::of("-", {a.node, b.node}); }
Recorded operator*(const Recorded& a, const Recorded& b) { return Recorded::of("*", {a.node, b.node}); }
Recorded operator/(const Recorded& a, const Recorded& b) { return Recorded::of("/", {a.node, b.node}); }
Recorded sqrt(const Recorded& a) { return Recorded::of("sqrt", {a.node}); }
Recorded fused_sum(const Recorded& a, const Recorded& b, const Recorded& c) {
  return Recorded::of("fused +", {a.node, b.node, c.node});
}
Recorded fused_difference(const Recorded& a, const Recorded& b, const Recorded& c) {
  return Recorded::of("fused -", {a.node, b.node, c.node});
}
Recorded maximum(const Recorded& a, const Recorded& b) { return Recorded::of("maximum", {a.node, b.node}); }
Recorded magnitude(const Recorded& a) { return Recorded::of("magnitude", {a.node}); }
Recorded operator-(const Recorded& a) { return Recorded::of("negated", {a.node}); }

bool operator>(const Recorded& a, const Recorded& b) { return Recording::current().compare(a.node, b.node); }
bool operator<(const Recorded& a, const Recorded& b) { return b > a; }
bool operator==(const Recorded&, int) {
  if (!Recording::current().nothing_is_zero) throw std::logic_error("a branch depends on whether a number is 0");
  return false;
}

namespace {

DoubleWord<Recorded> with_rest(const Recorded& rounded) { return {rounded, Recorded::of("rest", {rounded.node})}; }

DoubleWord<Recorded> whole(const char* operation, const DoubleWord<Recorded>& a, const DoubleWord<Recorded>& b) {
  const int left = number_of(a), right = number_of(b);
  return words_of(Recorded::of(operation, {left, right}).node);
}

}  // namespace

DoubleWord<Recorded> two_sum(const Recorded& a, const Recorded& b) { return with_rest(a + b); }
DoubleWord<Recorded> two_difference(const Recorded& a, const Recorded& b) { return with_rest(a - b); }
DoubleWord<Recorded> two_product(const Recorded& a, const Recorded& b) { return with_rest(a * b); }
DoubleWord<Recorded> quick_two_sum(const Recorded& a, const Recorded& b) { return with_rest(a + b); }

DoubleWord<Recorded> words_of(int number) { return {Recorded::of("high", {number}), Recorded::of("low", {number})}; }
int number_of(const DoubleWord<Recorded>& a) {
  const Recording::Node low = Recording::current().nodes()[static_cast<std::size_t>(a.low.node)];
  if (low.operation == "constant") return a.high.node;  // a single word
  return low.operation == "low" ? low.of.front() : Recorded::of("exact +", {a.high.node, a.low.node}).node;
}

DoubleWord<Recorded> operator+(const DoubleWord<Recorded>& a, const DoubleWord<Recorded>& b) {
  return whole("double-double +", a, b);
}
DoubleWord<Recorded> operator-(const DoubleWord<Recorded>& a, const DoubleWord<Recorded>& b) {
  return whole("double-double -", a, b);
}
DoubleWord<Recorded> operator*(const DoubleWord<Recorded>& a, const DoubleWord<Recorded>& b) {
  return whole("double-double *", a, b);
}

RecordedFunction::RecordedFunction(std::string_view name, std::string_view target, std::string_view arithmetic)
    : head_(fmt::format(R"("function": "{}", "target": "{}", "arithmetic": "{}")", name, target, arithmetic)) {
  Recording::current().begin();
}
void RecordedFunction::known(const std::vector<Recorded>& numbers, const Recorded& maximum, double error,
                             std::string_view constant, std::string_view why) {
  std::vector<int> bounds;
  for (const Recorded& number : numbers) bounds.push_back(number.node);
  known_ += fmt::format(R"({}{{"maximum": {}, "error": {}, "constant": "{}", "why": "{}", "bounds": [{}]}})",
                        known_.empty() ? "" : ", ", maximum.node, error, constant, why, fmt::join(bounds, ", "));
}
void RecordedFunction::use(std::string_view name, const Recorded& positive, const Recorded& negative) {
  uses_ += fmt::format(R"({}{{"name": "{}", "positive": {}, "negative": {}}})", uses_.empty() ? "" : ", ", name,
                       positive.node, negative.node);
}
void RecordedFunction::use(std::string_view name, const filtered::detail::Estimate<Recorded>& estimate) {
  const std::size_t before = Recording::current().compared().size();
  (void)estimate.sign();
  const auto& compared = Recording::current().compared();
  if (compared.size() != before + 2) throw std::logic_error("the sign of an estimate depends on two comparisons");
  uses_ += fmt::format(R"({}{{"name": "{}", "greater": [{}], "less": [{}]}})", uses_.empty() ? "" : ", ", name,
                       fmt::join(compared[before], ", "), fmt::join(compared[before + 1], ", "));
}
void RecordedFunction::print(std::ostream& out) const {
  std::vector<int> all(Recording::current().nodes().size());
  std::iota(all.begin(), all.end(), 0);
  out << fmt::format(R"({{{}, "known": [{}], "uses": [{}], "ignored": [{}], "decided": [{}], "recorded": )", head_,
                     known_, uses_, fmt::join(ignored_, ", "), fmt::join(Recording::current().decided(), ", "));
  Recording::current().print(out, all);
  out << "}\n";
}

void print_model(std::ostream& out) {
  out << std::boolalpha << std::setprecision(17) << R"({"unit": )" << bounds::kUnit << R"(, "nearest_unit": )"
      << 0x1p-53 << R"(, "double_double_unit": )" << bounds::kDoubleDoubleUnit << R"(, "float_unit": )"
      << bounds::kFloatUnit << R"(, "smallest": )" << bounds::kSmallest << R"(, "largest": )" << bounds::kLargest
      << R"(, "tiny": )" << bounds::kTiny << R"(, "rounding_of_bound": )" << kRoundingOfBound << "}\n";
}

void RecordedFunction::print_filter(std::ostream& out, std::string_view name, std::size_t inputs,
                                    const std::function<int(const std::vector<Recorded>&)>& filter) {
  RecordedFunction function(name, "", "doubles to nearest");
  Recording& recording = Recording::current();
  const auto returned = [&](std::size_t true_comparison) {
    recording.begin();
    recording.true_comparison = true_comparison;
    std::vector<Recorded> numbers;
    while (numbers.size() < inputs) numbers.push_back(Recorded::input(fmt::format("input {}", numbers.size())));
    return filter(numbers);
  };
  std::vector<std::string> compared;
  for (std::size_t i = 1; returned(0) == 0 && i <= recording.compared().size(); ++i) {
    const int sign = returned(i);
    if (recording.compared().size() != i) throw std::logic_error("a filter continues after a comparison that is true");
    compared.push_back(fmt::format("[{}, {}]", fmt::join(recording.compared().back(), ", "), sign));
  }
  if (returned(0) != 0) throw std::logic_error("a filter returns a sign without a comparison");
  function.uses_ = fmt::format(R"({{"name": "sign", "compared": [{}]}})", fmt::join(compared, ", "));
  function.print(out);
}

void print_claim(std::ostream& out, const Claim& claim, Over over, const Recorded& result) {
  const char* arithmetic = over == Over::DoubleDoubles ? "double-doubles"
                           : over == Over::FloatLanes  ? "floats"
                                                       : "doubles";
  out << R"({"constant": ")" << claim.constant << R"(", "instance": ")" << claim.instance << R"(", "value": )"
      << claim.value << R"(, "factor": )" << claim.factor << R"(, "squares_are_products": )"
      << claim.squares_are_products() << R"(, "arithmetic": ")" << arithmetic << R"(", "nodes": )";
  Recording::current().print(out, {result.node});
  out << "}\n";
}

}  // namespace touchstone::proofs
