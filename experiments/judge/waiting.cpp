// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/waiting.h"

#include <utility>

namespace touchstone::judge {

bool Waiting::push(Entry&& entry) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return room(); });
  if (abandoned_) return false;
  entries_.push_back(std::move(entry));
  changed_.notify_all();
  return true;
}

bool Waiting::has_room() {
  const std::lock_guard lock(mutex_);
  return room();
}

void Waiting::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

void Waiting::stop_growing() {
  const std::lock_guard lock(mutex_);
  may_grow_ = false;
}

bool Waiting::wait_for(std::chrono::milliseconds time) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, time, [this] { return has_news(); });
}

std::optional<Waiting::Entry> Waiting::pop() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return has_news(); });
  if (entries_.empty()) return std::nullopt;
  Entry entry = std::move(entries_.front());
  entries_.pop_front();
  changed_.notify_all();
  return entry;
}

void Waiting::await_reply(bool awaiting) {
  const std::lock_guard lock(mutex_);
  awaiting_reply_ = awaiting;
  changed_.notify_all();
}

void Waiting::abandon() {
  const std::lock_guard lock(mutex_);
  abandoned_ = true;
  changed_.notify_all();
}

}  // namespace touchstone::judge
