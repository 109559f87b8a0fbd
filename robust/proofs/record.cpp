// SPDX-License-Identifier: Apache-2.0
// Prints the model and, for each claim of expressions.h, the operations that its expression carries out, as JSON lines.
#include <iomanip>
#include <iostream>
#include <vector>

#include "robust/proofs/expressions.h"
#include "robust/proofs/recording.h"

namespace touchstone::filtered::proofs {
namespace {

struct Printer {
  Recording recording;
  std::vector<Input> inputs;  // node i is input i
  Inputs<Recorded> recorded;

  Printer() : recorded(make_inputs<Recorded>([this](const Input& input) { return record(input); })) {}

  Recorded record(const Input& input) {
    inputs.push_back(input);
    return {&recording, recording.add('i', -1, -1)};
  }

  /// The nodes that the result is made of.
  std::vector<bool> needed(int result) const {
    std::vector<bool> is_needed(recording.nodes.size(), false);
    is_needed[static_cast<std::size_t>(result)] = true;
    for (std::size_t i = recording.nodes.size(); i-- > inputs.size();) {
      if (!is_needed[i]) continue;
      is_needed[static_cast<std::size_t>(recording.nodes[i].left)] = true;
      is_needed[static_cast<std::size_t>(recording.nodes[i].right)] = true;
    }
    return is_needed;
  }

  void print(const Claim& claim, int result) const {
    std::cout << R"({"constant": ")" << claim.constant << R"(", "instance": ")" << claim.instance << R"(", "value": )"
              << claim.value << R"(, "factor": )" << claim.factor << R"(, "squares_are_products": )"
              << claim.squares_are_products() << R"(, "nodes": [)";
    const std::vector<bool> is_needed = needed(result);
    const char* separator = "";
    for (std::size_t i = 0; i < is_needed.size(); ++i) {
      if (!is_needed[i]) continue;
      std::cout << separator << R"({"node": )" << i;
      if (i < inputs.size())
        std::cout << R"(, "input": ")" << inputs[i].name << R"(", "error": )" << inputs[i].error << "}";
      else
        std::cout << R"(, "operation": ")" << recording.nodes[i].operation << R"(", "of": [)" << recording.nodes[i].left
                  << ", " << recording.nodes[i].right << "]}";
      separator = ", ";
    }
    std::cout << "]}\n";
  }
};

}  // namespace
}  // namespace touchstone::filtered::proofs

int main() {
  using namespace touchstone::filtered;
  std::cout << std::boolalpha << std::setprecision(17) << R"({"unit": )" << bounds::kUnit
            << R"(, "double_double_unit": )" << bounds::kDoubleDoubleUnit << R"(, "rounding_of_bound": )"
            << proofs::kRoundingOfBound << "}\n";
  proofs::Printer printer;
  proofs::for_each_claim([&](const proofs::Claim& claim, const auto& expression) {
    printer.print(claim, expression(printer.recorded).node);
  });
}
