// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "experiments/cases/case.h"
#include "experiments/cases/margin.h"
#include "experiments/cases/method.h"
#include "experiments/judge/judgement.h"
#include "experiments/judge/known_failures.h"
#include "experiments/methods/process/engine.h"

namespace touchstone::judge {

/// A task for the judge: inputs, methods, and output streams.
struct Order {
  std::vector<std::string> files;             ///< JSON Lines; empty: standard input
  std::vector<const cases::Method*> methods;  ///< answer each case, in this order
  std::vector<methods::Engine> engines;       ///< commands that read cases and print verdicts; answer last
  std::chrono::milliseconds time_limit = methods::kTimeLimit;  ///< for each verdict of an engine
  std::vector<cases::Key> keys{};                              ///< only these are compared; empty: all
  std::optional<cases::Margin> beyond{};                       ///< an answer that is off by no more is not wrong
  /// Failures that are neither complaints nor change the status; notes what occurs. A repeated id is then wrong input.
  KnownFailures* known = nullptr;
  bool new_ones_pass = false;  ///< failures that `known` notes do not change the status, either
  bool keeps_wrong = true;     ///< Judged has the case and the verdict if a value is wrong
  bool explain = false;
  bool at_rest = false;    ///< leave out the cases of moving balls
  bool triangles = false;  ///< leave out the cases of other polygons, and of meshes with other faces
  bool prints_verdicts = true, prints_differences = true;
  cases::LineRange lines{};                             ///< only these are judged
  std::function<void(const Judged&)> judged{};          ///< receives each valid case for each method
  std::function<void(std::uint64_t bytes)> progress{};  ///< receives the number of bytes of input that are judged
  std::function<void()> before_complaint{};             ///< called before each line on `complaints`
  std::FILE* verdicts = stdout;
  std::FILE* complaints = stderr;
};

/// Judges every case and prints one line for each case and method, in input order, as soon as it is known.
///
/// A rejected case gets its verdict, and the judge continues. Lines that are not JSON and files that cannot be read are
/// reported as complaints; blank lines are skipped. Memory does not grow with the number of lines. The judge does not
/// check whether ids are unique, unless failures are known.
///
/// Each engine gets one case after the other. If it is late, ends, or prints anything except one line that is a verdict
/// on the case, the judge reports this with the case, ends the engine and the processes that it has started, and
/// restarts it for the next case. A case without a verdict is a complaint, and its line has no answer. Throws
/// std::system_error if the verdicts cannot be written, and methods::EngineNotStarted if the command of an engine
/// cannot be started. Commands must be UTF-8.
[[nodiscard]] Status judge(const Order& order);

/// Asks as `judge` does, and calls take(entry) with what is to be told. Before each line calls proceeds(lines) with the
/// number of lines whose entries are complete, and ends if that returns false. Returns that number at the end.
std::uint64_t ask(const Order& order, const std::function<void(Entry&&)>& take,
                  const std::function<bool(std::uint64_t lines)>& proceeds);

/// Tells entries as `judge` does: prints verdicts on cases and complaints, and keeps the worst status. Entries of
/// several parts of the lines, one part after the other, give what all lines at once give, if the engines answer each
/// case without regard to those before.
class Teller {
 public:
  /// Keeps a reference to `order`, which must outlive the teller.
  explicit Teller(const Order& order) : order_(order) {}

  /// Throws std::system_error if a verdict cannot be written.
  void tell(Entry&& entry);
  /// Tells how engines ended. Returns the status.
  [[nodiscard]] Status finish();

 private:
  void complain(const std::string& sentence);
  void worsen(Status status) { status_ = std::max(status_, status); }
  /// Worsens the status by a failure that is not known, if the known ones can note it.
  void worsen_by_new_failure() {
    if (!order_.new_ones_pass) worsen(ExpectationNotMet);
  }
  [[nodiscard]] bool knows(const Failure& failure) const {
    return order_.known != nullptr && order_.known->has(failure);
  }
  void tell_repeated_id(const Entry& entry);
  void tell_fault(const Judged& judged);
  void print(const std::string& verdict);
  void tell_differences(Judged& judged);

  const Order& order_;
  Status status_ = AllMet;
  std::set<std::string> ids_;  ///< if failures are known
  std::vector<std::string> endings_;
};

}  // namespace touchstone::judge
