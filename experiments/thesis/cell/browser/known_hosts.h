// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace touchstone::cell::browser {

/// The names that a request's Host header may use for this server. A foreign web page can make its own name resolve to
/// this server (DNS rebinding), and its requests then carry that name. So only names that nobody else can register are
/// accepted.
class KnownHosts {
 public:
  /// `name` is the address as the user gave it; `loopback`: only this machine can reach it.
  KnownHosts(std::string_view name, bool loopback);

  /// Returns whether a Host header names this server: `localhost`, an IPv4 address of 127.0.0.0/8 in dotted form,
  /// `[::1]`, or the name that the user gave; if other machines can reach the server, also any other literal address. A
  /// port may follow. Case and one dot at the end of a name are ignored.
  [[nodiscard]] bool names(std::string_view host) const;

 private:
  std::string name_;
  bool loopback_;
};

}  // namespace touchstone::cell::browser
