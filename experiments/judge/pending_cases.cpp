// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/pending_cases.h"

#include <utility>

namespace touchstone::judge {

namespace {

/// Returns the id of a case that was sent to the engine.
std::optional<std::string> asked_id(const PendingCases::Entry& entry) {
  return entry.sent && entry.line.read ? entry.line.read->id : std::nullopt;
}

}  // namespace

bool PendingCases::push(Entry&& entry) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return room(); });
  if (abandoned_) return false;
  if (auto id = asked_id(entry)) asked_.insert(std::move(*id));
  entries_.push_back(std::move(entry));
  changed_.notify_all();
  return true;
}

bool PendingCases::has_room() {
  const std::lock_guard lock(mutex_);
  return room();
}

void PendingCases::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

void PendingCases::stop_growing() {
  const std::lock_guard lock(mutex_);
  may_grow_ = false;
}

bool PendingCases::wait_for(std::chrono::milliseconds time) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, time, [this] { return has_news(); });
}

bool PendingCases::is_asked(const std::string& id) {
  const std::lock_guard lock(mutex_);
  return asked_.contains(id);
}

std::optional<PendingCases::Entry> PendingCases::pop() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return has_news(); });
  if (entries_.empty()) return std::nullopt;
  Entry entry = std::move(entries_.front());
  entries_.pop_front();
  if (const auto id = asked_id(entry)) asked_.erase(asked_.find(*id));
  changed_.notify_all();
  return entry;
}

void PendingCases::await_reply(bool awaiting) {
  const std::lock_guard lock(mutex_);
  awaiting_reply_ = awaiting;
  changed_.notify_all();
}

void PendingCases::abandon() {
  const std::lock_guard lock(mutex_);
  abandoned_ = true;
  changed_.notify_all();
}

}  // namespace touchstone::judge
