// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "experiments/cases/method.h"

namespace touchstone::methods {

/// The time that an external method has for each verdict.
inline constexpr std::chrono::milliseconds kExternalTimeLimit{60'000};

/// Returns the method of an external program: a command that a shell runs, which reads cases (JSON Lines, with `id`,
/// `ball` and `polygon`) and prints verdicts, one case after the other, as `touchstone judge --time-limit` asks an
/// engine (see SupervisedEngine). It gives the keys that the verdict has.
///
/// Each query that runs at the same time has a process of its own. If the program gives no verdict, or one that does
/// not have the form of the contract, a query throws std::runtime_error, which names the method, the reason and the
/// case; the program is restarted for the next query. `summary` is one line.
[[nodiscard]] std::unique_ptr<cases::Method> external_method(std::string name, std::string summary, std::string command,
                                                             std::chrono::milliseconds time_limit = kExternalTimeLimit);

}  // namespace touchstone::methods
