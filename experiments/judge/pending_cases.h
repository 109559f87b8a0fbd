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

/// The queue of lines from the thread that sends cases to an engine to the thread that receives its replies.
///
/// It holds at most kMost lines, unless the receiver waits for a reply: an engine may read all cases before it answers.
class PendingCases {
 public:
  static constexpr std::size_t kMost = 256;

  struct Entry {
    cases::Line line;
    bool sent;  ///< the case is sent to the engine
  };

  /// Appends a line; waits for room. Returns false if the receiver takes no more lines.
  bool push(Entry&& entry);
  /// Returns whether push would not wait.
  [[nodiscard]] bool has_room();
  /// For the sender: closes the queue.
  void close();
  /// For the sender: reports that the engine has stopped reading, so that the queue no longer grows while the receiver
  /// waits for a reply.
  void stop_growing();

  /// Waits for a line or the end of the queue, but no longer than `time`. Returns false on timeout.
  [[nodiscard]] bool wait_for(std::chrono::milliseconds time);
  /// Returns whether a line waits that is a case of this id and was sent to the engine.
  [[nodiscard]] bool is_asked(const std::string& id);
  /// Waits for the next line and removes it; returns nothing at the end.
  [[nodiscard]] std::optional<Entry> pop();
  /// For the receiver: states whether it now waits for a reply.
  void await_reply(bool awaiting);
  /// For the receiver: refuses all further lines.
  void abandon();

 private:
  [[nodiscard]] bool has_news() const { return closed_ || !entries_.empty(); }
  [[nodiscard]] bool room() const { return abandoned_ || entries_.size() < kMost || (awaiting_reply_ && may_grow_); }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Entry> entries_;
  std::unordered_multiset<std::string> asked_;  ///< ids of the entries that were sent to the engine
  bool closed_ = false, abandoned_ = false, awaiting_reply_ = false, may_grow_ = true;
};

}  // namespace touchstone::judge
