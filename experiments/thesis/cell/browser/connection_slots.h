// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <mutex>
#include <optional>

namespace touchstone::cell::browser {

/// The connections of a server, limited in number. A new connection replaces the one that has waited longest for its
/// client, so that idle clients cannot block others. Thread-safe.
class ConnectionSlots {
 public:
  using Number = std::uint64_t;

  explicit ConnectionSlots(std::size_t most) : most_(most) {}

  /// Takes a slot for a connection that waits for its client. `close` is called, from any thread, when another
  /// connection takes the slot; the number is then invalid. Returns nothing if no slot is free and no connection waits.
  [[nodiscard]] std::optional<Number> open(std::function<void()> close);
  /// Marks the connection as answering its client's request. Returns false if another connection has taken its slot.
  [[nodiscard]] bool begin_work(Number number);
  /// Marks the connection as waiting for its client.
  void begin_waiting(Number number);
  /// Frees the slot, if the connection still has it.
  void close(Number number);

 private:
  struct Slot {
    Number number;
    bool waits;
    std::function<void()> close;
  };
  [[nodiscard]] std::list<Slot>::iterator find(Number number);

  std::size_t most_;
  std::mutex mutex_;  // of what follows
  Number opened_ = 0;
  std::list<Slot> slots_;  // those that have waited longest before the others that wait
};

}  // namespace touchstone::cell::browser
