// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_set>

#include "experiments/cases/input_lines.h"

namespace touchstone::judge {

/// Lines on their way from the thread that sends cases to an engine to the one that receives its replies.
///
/// It holds at most kMost lines, unless the receiver awaits a reply: an engine may read all before it answers.
class PendingCases {
 public:
  static constexpr std::size_t kMost = 256;

  struct Entry {
    cases::Line line;
    bool sent;  ///< the engine is asked about it
  };

  /// Waits for room. False if nobody will take the line.
  bool push(Entry&& entry);
  /// Would a line be pushed without waiting?
  [[nodiscard]] bool has_room();
  /// For the sender: nothing more will come.
  void close();
  /// For the sender: the engine reads no more, so that further lines need not wait for it to answer.
  void stop_growing();

  /// Waits for a line or the end of them, no longer than `time`. False if there is neither.
  [[nodiscard]] bool wait_for(std::chrono::milliseconds time);
  /// Does a line wait that is a case of this id, about which the engine is asked?
  [[nodiscard]] bool is_asked(const std::string& id);
  /// The next line, waiting for it; nothing at the end.
  [[nodiscard]] std::optional<Entry> pop();
  /// For the receiver: it begins or ends to wait for a reply.
  void await_reply(bool awaiting);
  /// For the receiver: it takes no more lines.
  void abandon();

 private:
  [[nodiscard]] bool has_news() const { return closed_ || !entries_.empty(); }
  [[nodiscard]] bool room() const { return abandoned_ || entries_.size() < kMost || (awaiting_reply_ && may_grow_); }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Entry> entries_;
  std::unordered_multiset<std::string> asked_;  ///< ids of the entries about which the engine is asked
  bool closed_ = false, abandoned_ = false, awaiting_reply_ = false, may_grow_ = true;
};

}  // namespace touchstone::judge
