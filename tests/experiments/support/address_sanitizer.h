// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#if defined(__has_feature)
#define TOUCHSTONE_HAS_FEATURE(feature) __has_feature(feature)
#else
#define TOUCHSTONE_HAS_FEATURE(feature) 0
#endif

namespace touchstone::run_tests {

/// Whether the address sanitizer is active. It has its own allocator, which malloc does not count, and reserves
/// terabytes of addresses.
#if defined(__SANITIZE_ADDRESS__) || TOUCHSTONE_HAS_FEATURE(address_sanitizer)
inline constexpr bool kAddressSanitizer = true;
#else
inline constexpr bool kAddressSanitizer = false;
#endif

}  // namespace touchstone::run_tests
