// SPDX-License-Identifier: GPL-3.0-or-later
// Which Host headers may be meant for a server: none that a web page from elsewhere can make lead here.
#include "experiments/thesis/cell/browser/known_hosts.h"

#include <gtest/gtest.h>

namespace touchstone::cell_browser_tests {
namespace {

using cell::browser::KnownHosts;

constexpr const char* kHere[] = {"localhost",  "LOCALHOST",    "Localhost.",     "localhost:8080",      "localhost.:1",
                                 "127.0.0.1",  "127.0.0.1:80", "127.1.2.3",      "127.255.255.255:443", "[::1]",
                                 "[::1]:8080", "[0:0:0::1]",   "localhost:65535"};
constexpr const char* kNowhere[] = {"",
                                    " ",
                                    ":",
                                    ":80",
                                    ".",
                                    "127.",
                                    "127.evil.com",
                                    "127.1",
                                    "127.0.1",
                                    "127.0.0.01",
                                    "127.0.0.256",
                                    "127.0.0.1.",
                                    "2130706433",
                                    "127.0.0.1.evil.com",
                                    "127.0.0.1a",
                                    "0x7f.0.0.1",
                                    "localhost.evil.com",
                                    "localhost..",
                                    "localhosts",
                                    "evil.localhost.com",
                                    "127.0.0.1:80@evil",
                                    "127.0.0.1@evil:80",
                                    "evil@127.0.0.1",
                                    "127.0.0.1:",
                                    "127.0.0.1:x",
                                    "127.0.0.1:123456",
                                    "127.0.0.1:80:80",
                                    "127.0.0.1 evil",
                                    "127.0.0.1, evil",
                                    "[::1",
                                    "::1",
                                    "[::1]x",
                                    "[::1]:",
                                    "[::1].evil.com",
                                    "[::1%lo]",
                                    "[evil]",
                                    "[127.0.0.1]",
                                    "localhost/evil",
                                    "\xff"};

TEST(KnownHosts, AreLiteralLoopbackAddressesAndLocalhost) {
  const KnownHosts hosts("127.0.0.1", true);
  for (const char* host : kHere) EXPECT_TRUE(hosts.names(host)) << host;
  for (const char* host : kNowhere) EXPECT_FALSE(hosts.names(host)) << host;
  for (const char* host : {"8.8.8.8", "0.0.0.0", "192.168.1.7:8080", "[fe80::1]", "128.0.0.1"})
    EXPECT_FALSE(hosts.names(host)) << host;
  EXPECT_FALSE(hosts.names({"127.0.0.1\0.evil.com", 19}));
}

// A page from elsewhere cannot have a literal address as its name and lead here too.
TEST(KnownHosts, AreAllLiteralAddressesWhereOthersReachTheServer) {
  const KnownHosts hosts("0.0.0.0", false);
  for (const char* host : kHere) EXPECT_TRUE(hosts.names(host)) << host;
  for (const char* host : kNowhere) EXPECT_FALSE(hosts.names(host)) << host;
  for (const char* host : {"8.8.8.8", "192.168.1.7:8080", "[fe80::1]"}) EXPECT_TRUE(hosts.names(host)) << host;
}

TEST(KnownHosts, IncludeTheUsersOwnName) {
  for (const bool loopback : {true, false}) {
    const KnownHosts hosts("Cell.example", loopback);
    for (const char* host : {"cell.example", "CELL.EXAMPLE.:8080"}) EXPECT_TRUE(hosts.names(host)) << host;
    for (const char* host : {"cell.example.com", "xcell.example", "example"}) EXPECT_FALSE(hosts.names(host)) << host;
  }
}

}  // namespace
}  // namespace touchstone::cell_browser_tests
