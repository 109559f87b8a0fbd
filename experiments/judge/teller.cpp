// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "experiments/judge/judge.h"
#include "experiments/methods/process/engine_process.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::judge {
namespace {

/// Returns the failure of giving no answer at all.
Failure no_answer(const Judged& judged) { return {judged.method, judged.id, std::string(Failure::kNoAnswer)}; }

std::string about(const Judged& judged, const std::string& what) {
  return fmt::format("case {}: method {}: {}", io::legible(judged.id), judged.method, what);
}

}  // namespace

void Teller::tell(Entry&& entry) {
  // A part cannot know that the engine would have ended so before the next case, too.
  if (!entry.ending.empty()) (entry.complaint.empty() ? endings_ : told_endings_).insert(entry.ending);
  if (!entry.place.empty()) tell_repeated_id(entry);
  if (!entry.complaint.empty()) complain(entry.complaint);
  worsen(entry.status);
  if (entry.judged) tell_fault(*entry.judged);
  if (!entry.verdict.empty()) print(entry.verdict);
  if (entry.judged && entry.judged->has_expectation) tell_differences(*entry.judged);
}

Status Teller::finish() {
  for (const std::string& ending : endings_)
    if (!told_endings_.contains(ending)) complain(ending);
  return status_;
}

void Teller::complain(const std::string& sentence) {
  if (output_.before_complaint) output_.before_complaint();
  fmt::print(output_.complaints, "{}\n", io::all_legible(sentence));
}

void Teller::tell_repeated_id(const Entry& entry) {
  if (output_.known == nullptr || ids_.insert(entry.id).second) return;
  complain(fmt::format("touchstone: {}: case {}: its id is not unique, so its failures cannot be known", entry.place,
                       io::legible(entry.id)));
  worsen(InputRejected);
}

void Teller::tell_fault(const Judged& judged) {
  const bool answers = judged.fault.empty();
  if (output_.known != nullptr) output_.known->judged(no_answer(judged), !answers);
  if (answers || knows(no_answer(judged))) return;
  if (judged.fault != Judged::kNoMotions || output_.prints_differences) complain(about(judged, judged.fault));
  worsen_by_new_failure();
}

void Teller::print(const std::string& verdict) {
  if (!output_.prints_verdicts) return;
  const methods::DeferSignals whole;
  const bool written = std::fwrite(verdict.data(), 1, verdict.size(), output_.verdicts) == verdict.size();
  if (!written || std::fflush(output_.verdicts) != 0)
    throw std::system_error(errno, std::generic_category(), "the verdicts cannot be written");
}

void Teller::tell_differences(Judged& judged) {
  const bool answers = judged.fault.empty(), is_known_fault = !answers && knows(no_answer(judged));
  const auto failure = [&](const std::string& key, bool omits) {
    return Failure{judged.method, judged.id, key, omits};
  };
  std::size_t known = 0;
  for (const cases::Difference& difference : judged.differences) {
    if (answers ? knows(failure(difference.key, !difference.found)) : is_known_fault) {
      ++known;
      continue;
    }
    if (output_.prints_differences) complain(about(judged, to_string(difference)));
    worsen_by_new_failure();
  }
  judged.known = is_known_fault || (known > 0 && known == judged.differences.size());
  if (output_.known != nullptr && answers)
    for (const std::string& key : judged.compared) {
      const auto found = std::ranges::find(judged.differences, key, &cases::Difference::key);
      const bool fails = found != judged.differences.end(), omits = fails && !found->found;
      output_.known->judged(failure(key, false), fails && !omits);
      output_.known->judged(failure(key, true), omits);
    }
  if (output_.judged) output_.judged(judged);
}

}  // namespace touchstone::judge
