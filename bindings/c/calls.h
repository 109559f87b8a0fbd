// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#if !defined(TOUCHSTONE_WITHOUT_TBB)
#include <tbb/task_arena.h>
#endif

#include "bindings/c/touchstone.h"
#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/parts_in_parallel.h"

/// How a function of the library for C runs: what it is given, where its answers go, on which threads it asks, and how
/// it ends.
namespace touchstone::c {

/// Writes the status and the message to the error, if there is one, and returns the status.
touchstone_status report(touchstone_error* error, touchstone_status status, std::string_view message) noexcept;
/// The same for the exception that is being handled.
touchstone_status report_exception(touchstone_error* error) noexcept;

/// Calls f() and reports how it ended: the boundary that no exception crosses.
template <class F>
touchstone_status guarded(touchstone_error* error, const F& f) noexcept {
  try {
    f();
  } catch (...) {
    return report_exception(error);
  }
  return report(error, TOUCHSTONE_OK, {});
}

/// Returns what the pointer points to. Throws std::invalid_argument, which names it, for NULL.
template <class T>
T& given(T* pointer, const char* name) {
  if (pointer == nullptr) throw std::invalid_argument(std::string(name) + " is NULL");
  return *pointer;
}

/// Returns an array of `count` elements. Throws likewise, unless count is 0.
template <class T>
std::span<T> given(T* elements, std::size_t count, const char* name) {
  return {count == 0 ? elements : &given(elements, name), count};
}

/// Writes to answers[i] what `ask` returns for item i, as the caller's type.
template <class Answer, class Items, class Ask>
void answer_each(const Items& items, Answer* answers, const Ask& ask) {
  Answer* answer = given(answers, items.size(), "the array of answers").data();
  for (const auto& item : items) *answer++ = ask(item);
}

/// Calls ask(), whose batch of `count` runs on at most `threads` threads, the caller's among them. 0, like any number
/// above that of the cores, leaves it to the library.
template <class Ask>
void on_threads([[maybe_unused]] std::uint32_t threads, [[maybe_unused]] std::size_t count, const Ask& ask) {
#if !defined(TOUCHSTONE_WITHOUT_TBB)
  if (count > 1 && threads != 0 && threads < parts_at_once()) {
    const FloatingPointState state;  // an arena may change that of the caller
    tbb::task_arena arena(static_cast<int>(threads));
    return arena.execute(ask);
  }
#endif
  ask();
}

/// Makes *handle what make() returns, as guarded. It is NULL after an error.
template <class Handle, class Make>
touchstone_status created(Handle** handle, touchstone_error* error, const Make& make) noexcept {
  return guarded(error, [&] {
    given(handle, "the pointer to the new handle") = nullptr;
    *handle = make().release();
  });
}

}  // namespace touchstone::c
