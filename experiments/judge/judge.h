// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/cases/comparison.h"
#include "experiments/cases/key.h"
#include "experiments/cases/margin.h"
#include "experiments/cases/method.h"
#include "experiments/judge/known_failures.h"
#include "experiments/methods/process/engine.h"

namespace touchstone::judge {

/// Exit status of the judge: the worst one that occurred.
enum Status { AllMet = 0, ExpectationNotMet = 1, InputRejected = 2 };

/// What the judge asks, of whom, and how it compares.
struct Question {
  std::vector<std::string> files{};             ///< JSON Lines; empty: standard input
  std::vector<const cases::Method*> methods{};  ///< answer each case, in this order
  std::vector<methods::Engine> engines{};       ///< commands that read cases and print verdicts; answer last
  std::chrono::milliseconds time_limit = methods::kTimeLimit;  ///< for each verdict of an engine
  std::vector<cases::Key> keys{};                              ///< only these are compared; empty: all
  std::optional<cases::Margin> beyond{};                       ///< an answer that is off by no more is not wrong
  bool explain = false;
  bool at_rest = false;     ///< leave out the cases of moving balls
  bool triangles = false;   ///< leave out the cases of other polygons, and of meshes with other faces
  bool keeps_wrong = true;  ///< Judged has the case and the verdict if a value is wrong
  std::uint64_t first_line = 0, lines = std::numeric_limits<std::uint64_t>::max();  ///< only these are judged, from 0
};

/// A valid case, and how a method met its expectation.
struct Judged {
  static constexpr const char* kNoMotions = "cannot answer about moving balls";

  std::string method, id;
  std::string file;  ///< of the case
  std::vector<std::string> tags;
  bool has_expectation = false;
  std::vector<std::string> compared;           ///< keys of the expectation
  std::vector<cases::Difference> differences;  ///< the expectations that are not met
  std::string fault;                           ///< why there is no answer; else empty
  bool within = false;  ///< whether an answer is wrong, but not by more than the margin of the question
  bool known = false;   ///< whether there is a failure, and every one is known; set when it is told

  // Of a case with a value that is wrong, if the question keeps them; else empty.
  std::string line, verdict;  ///< as lines of JSON
  std::int64_t doubles = 0;   ///< between radius and distance; 0 for a moving ball

  auto members() {
    return std::tie(method, id, file, tags, has_expectation, compared, differences, fault, within, known, line, verdict,
                    doubles);
  }
};

/// One finding. What is empty is not told.
struct Entry {
  std::string place{}, id{};  ///< of a case with an id, which must be unique if failures are known
  std::string complaint{};    ///< a sentence
  Status status = AllMet;     ///< what the complaint makes of the exit status
  std::string ending{};       ///< how an engine ended; told last, and once, unless a complaint has told it
  std::string verdict{};      ///< a line of JSON
  std::optional<Judged> judged{};

  auto members() { return std::tie(place, id, complaint, status, ending, verdict, judged); }
};

/// The findings about some lines of cases, which parts of a run keep.
struct Judgement {
  std::uint64_t lines = 0;
  std::vector<Entry> entries;  ///< in the order of the lines

  Judgement& operator+=(const Judgement& next) {
    lines += next.lines;
    entries.insert(entries.end(), next.entries.begin(), next.entries.end());
    return *this;
  }
  auto members() { return std::tie(lines, entries); }
};

[[nodiscard]] inline std::uint64_t items_done(const Judgement& judgement) { return judgement.lines; }

/// Asks about every case, and calls take(entry) with what is to be told, in input order, as soon as it is known.
///
/// Lines that are not JSON and files that cannot be read are complaints; blank lines are skipped. A rejected case gets
/// its verdict. Memory does not grow with the number of lines. Ids need not be unique.
///
/// Each engine gets one case after the other. If it is late, ends, or prints anything except one line that is a verdict
/// on the case, that is a complaint about the case; the engine ends with the processes that it has started, and is
/// restarted for the next case. A case without a verdict is a complaint, and its line has no answer. Throws
/// methods::EngineNotStarted if the command of an engine cannot be started. Commands must be UTF-8.
///
/// Before each line and at the end calls proceeds(lines, bytes) with the numbers of lines whose entries are complete and
/// of their bytes, and ends if that returns false. Returns that number of lines.
std::uint64_t ask(const Question& question, const std::function<void(Entry&&)>& take,
                  const std::function<bool(std::uint64_t lines, std::uint64_t bytes)>& proceeds);

/// Where the judge tells what it finds.
struct Output {
  std::FILE* verdicts = stdout;
  std::FILE* complaints = stderr;
  bool prints_verdicts = true, prints_differences = true;
  std::function<void(const Judged&)> judged{};  ///< receives each valid case for each method
  std::function<void()> before_complaint{};     ///< called before each line on `complaints`
  /// Failures that are neither complaints nor change the status; notes what occurs. A repeated id is then wrong input.
  KnownFailures* known = nullptr;
  bool new_ones_pass = false;  ///< failures that `known` notes do not change the status, either
};

/// Tells entries: prints verdicts on cases and complaints, and keeps the worst status. Entries of several parts of the
/// lines, one part after the other, give what all lines at once give, if the engines answer each case without regard to
/// those before.
class Teller {
 public:
  /// Keeps a reference to `output`, which must outlive the teller.
  explicit Teller(const Output& output) : output_(output) {}

  /// Throws std::system_error if a verdict cannot be written.
  void tell(Entry&& entry);
  /// Tells how engines ended. Returns the status.
  [[nodiscard]] Status finish();

 private:
  void complain(const std::string& sentence);
  void worsen(Status status) { status_ = std::max(status_, status); }
  /// Worsens the status by a failure that is not known, if the known ones can note it.
  void worsen_by_new_failure() {
    if (!output_.new_ones_pass) worsen(ExpectationNotMet);
  }
  [[nodiscard]] bool knows(const Failure& failure) const {
    return output_.known != nullptr && output_.known->has(failure);
  }
  void tell_repeated_id(const Entry& entry);
  void tell_fault(const Judged& judged);
  void print(const std::string& verdict);
  void tell_differences(Judged& judged);

  const Output& output_;
  Status status_ = AllMet;
  std::set<std::string> ids_;                     ///< if failures are known
  std::set<std::string> endings_, told_endings_;  ///< all, and those in complaints
};

/// Asks, and tells each case at once. Returns the exit status. `progress` receives the number of bytes read.
[[nodiscard]] Status judge(const Question& question, const Output& output,
                           const std::function<void(std::uint64_t bytes)>& progress = {});

}  // namespace touchstone::judge
