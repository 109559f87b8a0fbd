// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/browser/connection_slots.h"

#include <algorithm>
#include <utility>

namespace touchstone::cell::browser {

std::optional<ConnectionSlots::Number> ConnectionSlots::open(std::function<void()> close) {
  std::function<void()> close_other;
  Number number = 0;
  {
    const std::lock_guard lock(mutex_);
    if (slots_.size() >= most_) {
      const auto other = std::find_if(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.waits; });
      if (other == slots_.end()) return std::nullopt;
      close_other = std::move(other->close);
      slots_.erase(other);
    }
    number = opened_++;
    slots_.push_back({number, true, std::move(close)});
  }
  if (close_other) close_other();
  return number;
}

bool ConnectionSlots::begin_work(Number number) {
  const std::lock_guard lock(mutex_);
  const auto slot = find(number);
  if (slot == slots_.end()) return false;
  slot->waits = false;
  return true;
}

void ConnectionSlots::begin_waiting(Number number) {
  const std::lock_guard lock(mutex_);
  const auto slot = find(number);
  if (slot == slots_.end()) return;
  slot->waits = true;
  slots_.splice(slots_.end(), slots_, slot);
}

void ConnectionSlots::close(Number number) {
  const std::lock_guard lock(mutex_);
  if (const auto slot = find(number); slot != slots_.end()) slots_.erase(slot);
}

std::list<ConnectionSlots::Slot>::iterator ConnectionSlots::find(Number number) {
  return std::find_if(slots_.begin(), slots_.end(), [&](const Slot& slot) { return slot.number == number; });
}

}  // namespace touchstone::cell::browser
