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
  if (!entry.ending.empty()) {
    const auto known = std::ranges::find(endings_, entry.ending);
    if (entry.complaint.empty() && known == endings_.end()) endings_.push_back(entry.ending);
    // A part cannot know that the engine would have ended so before the next case, too.
    if (!entry.complaint.empty() && known != endings_.end()) endings_.erase(known);
  }
  if (!entry.place.empty()) tell_repeated_id(entry);
  if (!entry.complaint.empty()) complain(entry.complaint);
  worsen(entry.status);
  if (entry.judged) tell_fault(*entry.judged);
  if (!entry.verdict.empty()) print(entry.verdict);
  if (entry.judged && entry.judged->has_expectation) tell_differences(*entry.judged);
}

Status Teller::finish() {
  for (const std::string& ending : endings_) complain(ending);
  return status_;
}

void Teller::complain(const std::string& sentence) {
  if (order_.before_complaint) order_.before_complaint();
  fmt::print(order_.complaints, "{}\n", io::all_legible(sentence));
}

void Teller::tell_repeated_id(const Entry& entry) {
  if (order_.known == nullptr || ids_.insert(entry.id).second) return;
  complain(fmt::format("touchstone: {}: case {}: its id is not unique, so its failures cannot be known", entry.place,
                       io::legible(entry.id)));
  worsen(InputRejected);
}

void Teller::tell_fault(const Judged& judged) {
  const bool answers = judged.fault.empty();
  if (order_.known != nullptr) order_.known->judged(no_answer(judged), !answers);
  if (answers || knows(no_answer(judged))) return;
  if (judged.fault != Judged::kNoMotions || order_.prints_differences) complain(about(judged, judged.fault));
  worsen_by_new_failure();
}

void Teller::print(const std::string& verdict) {
  if (!order_.prints_verdicts) return;
  const methods::DeferSignals whole;
  const bool written = std::fwrite(verdict.data(), 1, verdict.size(), order_.verdicts) == verdict.size();
  if (!written || std::fflush(order_.verdicts) != 0)
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
    if (order_.prints_differences) complain(about(judged, to_string(difference)));
    worsen_by_new_failure();
  }
  judged.known = is_known_fault || (known > 0 && known == judged.differences.size());
  if (order_.known != nullptr && answers)
    for (const std::string& key : judged.compared) {
      const auto found = std::ranges::find(judged.differences, key, &cases::Difference::key);
      const bool fails = found != judged.differences.end(), omits = fails && !found->found;
      order_.known->judged(failure(key, false), fails && !omits);
      order_.known->judged(failure(key, true), omits);
    }
  if (order_.judged) order_.judged(judged);
}

}  // namespace touchstone::judge
