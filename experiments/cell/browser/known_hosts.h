// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace touchstone::cell::browser {

/// Who may be meant by a request's Host header. A web page from elsewhere can make its own name lead to this server
/// (DNS rebinding), and its requests carry that name; so only names count that nobody else can give.
class KnownHosts {
 public:
  /// `name` is the address as the user gave it; `loopback`: only this machine can reach it.
  KnownHosts(std::string_view name, bool loopback);

  /// Returns whether a Host header names this server: `localhost`, an IPv4 address of 127.0.0.0/8 in dotted form,
  /// `[::1]`, or the name that the user gave; where others reach the server, any other literal address too. A port may
  /// follow. Case, and one dot that ends a name, do not matter.
  [[nodiscard]] bool names(std::string_view host) const;

 private:
  std::string name_;
  bool loopback_;
};

}  // namespace touchstone::cell::browser
