// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace touchstone::python {

/// A shared mutex that is given in the order of requests: each waits for those before it that do not share with it, and
/// for no later one. std::shared_mutex lets new readers pass a waiting writer, which then may never get it.
class FairSharedMutex {
 public:
  void lock() {
    std::unique_lock lock(mutex_);
    await_turn(lock);
    changed_.wait(lock, [this] { return readers_ == 0; });
  }
  void unlock() {
    change([this] { ++turn_; });
  }

  void lock_shared() {
    std::unique_lock lock(mutex_);
    await_turn(lock);
    ++readers_, ++turn_;
    changed_.notify_all();
  }
  void unlock_shared() {
    change([this] { --readers_; });
  }

 private:
  void await_turn(std::unique_lock<std::mutex>& lock) {
    changed_.wait(lock, [this, mine = requests_++] { return turn_ == mine; });
  }
  template <class F>
  void change(const F& f) {
    const std::lock_guard lock(mutex_);
    f();
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t requests_ = 0;  ///< so far
  std::uint64_t turn_ = 0;      ///< the request whose turn it is; a writer keeps its turn until it unlocks
  std::uint64_t readers_ = 0;   ///< that hold the mutex
};

}  // namespace touchstone::python
