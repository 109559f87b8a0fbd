// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/browser/known_hosts.h"

#include <boost/asio/ip/address.hpp>
#include <optional>

namespace touchstone::cell::browser {
namespace {

/// In lower case, without the dot that may end it.
std::string plain_name(std::string_view name) {
  if (name.size() > 1 && name.ends_with('.')) name.remove_suffix(1);
  std::string plain(name);
  for (char& c : plain)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return plain;
}

/// Returns the part before the port; none if the text after the last colon is not a port.
std::optional<std::string_view> without_port(std::string_view host) {
  const std::size_t colon = host.rfind(':');
  if (colon == std::string_view::npos || host.ends_with(']')) return host;
  const std::string_view port = host.substr(colon + 1);
  if (port.empty() || port.size() > 5 || port.find_first_not_of("0123456789") != std::string_view::npos)
    return std::nullopt;
  return host.substr(0, colon);
}

/// Returns the address of `127.0.0.1` or `[::1]`; none for a name.
std::optional<boost::asio::ip::address> literal_address(std::string_view host) {
  boost::system::error_code no_address;
  boost::asio::ip::address address;
  if (host.starts_with('[') && host.ends_with(']')) {
    host = host.substr(1, host.size() - 2);
    if (host.find_first_not_of("0123456789abcdefABCDEF:.") != std::string_view::npos) return std::nullopt;
    address = boost::asio::ip::make_address_v6(std::string(host), no_address);
  } else {
    if (host.find_first_not_of("0123456789.") != std::string_view::npos) return std::nullopt;
    address = boost::asio::ip::make_address_v4(std::string(host), no_address);
  }
  return no_address ? std::nullopt : std::optional(address);
}

}  // namespace

KnownHosts::KnownHosts(std::string_view name, bool loopback)
    : name_(literal_address(name) || name.find(':') != std::string_view::npos ? "" : plain_name(name)),
      loopback_(loopback) {}

bool KnownHosts::names(std::string_view host) const {
  const std::optional<std::string_view> bare = without_port(host);
  if (!bare || bare->empty()) return false;
  if (const auto address = literal_address(*bare)) return !loopback_ || address->is_loopback();
  const std::string name = plain_name(*bare);
  return name == "localhost" || name == name_;
}

}  // namespace touchstone::cell::browser
