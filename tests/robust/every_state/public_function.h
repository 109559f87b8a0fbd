// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfenv>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/robust/every_state/bytes.h"
#include "tests/robust/every_state/input.h"
#include "tests/robust/support/environment.h"

namespace touchstone::every_state_tests {

using contact_tests::Environment;
using contact_tests::State;

/// The result of a call, or the message of the exception that it threw.
struct Outcome {
  std::string text;
  bool negative_zero;  ///< does the result hold one?
  bool left_as_found;  ///< rounding mode, flush-to-zero setting and INVALID, OVERFLOW and DIVBYZERO flags
};

/// A public function, called for an input in a state. public_functions.py holds these names against the headers.
struct PublicFunction {
  std::string name;
  std::function<Outcome(const Input&, const State&)> call;
  bool rounds;  ///< the doubles of its result are results, and no copies of the input
};

/// The function of this name; `ask` calls it and returns what is to be the same in every state. Whatever `ask` returns
/// is looked at in the default state: a callable is called then.
template <class Ask>
PublicFunction gives(std::string name, Ask ask, bool rounds = true) {
  return {std::move(name),
          [ask](const Input& input, const State& state) {
            Outcome outcome{{}, false, true};
            const auto called = [&] {
              const Environment changed(state);
              std::feraiseexcept(FE_DIVBYZERO);
              struct Left {
                Outcome& outcome;
                const Environment& changed;
                ~Left() { outcome.left_as_found = changed.left_as_found(FE_DIVBYZERO); }
              };
              const Left left{outcome, changed};
              return ask(input);
            };
            try {
              Bytes bytes;
              if constexpr (std::is_invocable_v<decltype(called())>)
                bytes.add(called()());
              else
                bytes.add(called());
              outcome.text = bytes.text();
              outcome.negative_zero = bytes.negative_zero();
            } catch (const std::exception& error) {
              outcome.text = error.what();
            }
            return outcome;
          },
          rounds};
}

/// As gives(), for a function whose result has numbers of the input in it, zeros of either sign among them.
template <class Ask>
PublicFunction hands_on(std::string name, Ask ask) {
  return gives(std::move(name), std::move(ask), false);
}

/// Calls `ask` with counts of stages, which may depend on the state.
template <class Ask>
auto with_counts(const Ask& ask) {
  return [ask](const Input& in) {
    filtered::StageCounts counts;
    return ask(in, counts);
  };
}

/// @{
/// The functions of shapes and meshes, of exact and filtered answers, and of scenes.
[[nodiscard]] std::vector<PublicFunction> shape_functions();
[[nodiscard]] std::vector<PublicFunction> contact_functions();
[[nodiscard]] std::vector<PublicFunction> scene_functions();
/// @}

}  // namespace touchstone::every_state_tests
