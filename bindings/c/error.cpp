// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <exception>
#include <new>

#include "bindings/c/calls.h"
#include "geometry/shapes/rejection.h"
#include "robust/scene/solid.h"

namespace touchstone::c {
namespace {

/// Returns whether a byte is within a character of UTF-8, not its first.
bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

}  // namespace

touchstone_status report(touchstone_error* error, touchstone_status status, std::string_view message) noexcept {
  if (error == nullptr) return status;
  constexpr std::string_view kCut = "...";
  constexpr std::size_t kMost = sizeof(error->message) - 1;
  const bool fits = message.size() <= kMost;
  std::size_t length = fits ? message.size() : kMost - kCut.size();
  while (!fits && continues(message[length])) --length;  // every message begins with a first byte
  char* end = std::copy_n(message.data(), length, error->message);
  if (!fits) end = std::copy(kCut.begin(), kCut.end(), end);
  *end = '\0';
  error->status = status;
  return status;
}

touchstone_status report_exception(touchstone_error* error) noexcept {
  try {
    throw;
  } catch (const Rejected& rejected) {
    return report(error, static_cast<touchstone_status>(rejected.rejection().code), rejected.what());
  } catch (const scene::NotClosed& open) {
    return report(error, TOUCHSTONE_NOT_CLOSED, open.what());
  } catch (const std::out_of_range& absent) {
    return report(error, TOUCHSTONE_NO_SUCH_OBJECT, absent.what());
  } catch (const std::length_error&) {
    return report(error, TOUCHSTONE_OUT_OF_MEMORY, "more elements than memory can hold");
  } catch (const std::bad_alloc&) {
    return report(error, TOUCHSTONE_OUT_OF_MEMORY, "there is not enough memory");
  } catch (const std::invalid_argument& wrong) {
    return report(error, TOUCHSTONE_INVALID_ARGUMENT, wrong.what());
  } catch (const std::exception& defect) {
    return report(error, TOUCHSTONE_INTERNAL_ERROR, defect.what());
  } catch (...) {
    return report(error, TOUCHSTONE_INTERNAL_ERROR, "an exception that is not of the standard library");
  }
}

}  // namespace touchstone::c

const char* touchstone_status_name(touchstone_status status) {
  switch (status) {
    case TOUCHSTONE_OK: return "ok";
    case TOUCHSTONE_NOT_CLOSED: return "not-closed";
    case TOUCHSTONE_INVALID_ARGUMENT: return "invalid-argument";
    case TOUCHSTONE_NO_SUCH_OBJECT: return "no-such-object";
    case TOUCHSTONE_OUT_OF_MEMORY: return "out-of-memory";
    case TOUCHSTONE_INTERNAL_ERROR: return "internal-error";
    default: break;
  }
  if (status < TOUCHSTONE_NOT_FINITE || status > TOUCHSTONE_HOLE_OUTSIDE) return "unknown";
  return touchstone::to_string(static_cast<touchstone::RejectionCode>(status)).data();  // a literal, which ends in 0
}

const char* touchstone_version() { return TOUCHSTONE_VERSION; }
