// SPDX-License-Identifier: GPL-3.0-or-later
// The server of `touchstone cell serve` over HTTP: every route, every refusal.
#include "experiments/thesis/cell/browser/routes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "experiments/thesis/cell/model/plant.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "tests/experiments/support/cells.h"
#include "tests/experiments/thesis/cell/browser/aristo.h"
#include "tests/experiments/thesis/cell/browser/http_client.h"
#include "tests/experiments/thesis/cell/browser/serving.h"

namespace touchstone::cell::browser {
namespace {

using run_tests::kAristo;

class Page : public testing::Test {
 protected:
  static nlohmann::json json_of(const Received& received) { return nlohmann::json::parse(received.body); }

  void refuses(const Received& received, unsigned status, const std::string& begin) const {
    EXPECT_EQ(received.status, status) << received.body;
    EXPECT_EQ(received.content_type, "application/json");
    const std::string error = json_of(received).at("error");
    EXPECT_EQ(error.rfind(begin, 0), 0U) << error;
    EXPECT_EQ(ask(serving.port(), "GET", "/").status, 200U) << "it does not serve after " << begin;
  }

  const Routes routes{simulator(),
                      KnownHosts("127.0.0.1", true),
                      {{"case 2", [](const Variation&) {
                          return Simulator(cell::read_cell(kAristo, std::nullopt, cell::preset(kAristo, "case 2")), {});
                        }}}};
  const Serving serving{[this](const HttpRequest& request) { return routes.answer(request); }};
};

TEST_F(Page, AnswersEveryRoute) {
  const Received page = ask(serving.port(), "GET", "/");
  EXPECT_EQ(page.status, 200U);
  EXPECT_EQ(page.content_type, "text/html; charset=utf-8");
  EXPECT_EQ(page.body.rfind("<!DOCTYPE html>", 0), 0U);

  const Received cell = ask(serving.port(), "GET", "/api/cell");
  EXPECT_EQ(cell.status, 200U);
  EXPECT_EQ(json_of(cell)["setting"]["storage"]["radius"], 480.2);

  const Received run = ask(serving.port(), "POST", "/api/run", json_of(cell)["setting"].dump());
  ASSERT_EQ(run.status, 200U) << run.body;
  EXPECT_EQ(json_of(run)["failure"], "");
  EXPECT_EQ(json_of(run)["stops"].size(), recording().process.stops.size());

  // Figure 6.23's case: the base turns by 183 degrees.
  const Received second = ask(serving.port(), "POST", "/api/run", R"({"storage": {"angle": -33, "radius": 609}})",
                              "application/json; charset=utf-8");
  ASSERT_EQ(second.status, 200U) << second.body;
  bool turned = false;
  const nlohmann::json answer = json_of(second);
  for (const auto& move : answer["moves"]) turned = turned || (move["joint"] == "base" && move["degrees"] == -183);
  EXPECT_TRUE(turned);
}

TEST_F(Page, RefusesWithAReasonAndGoesOn) {
  const std::uint16_t port = serving.port();
  refuses(ask(port, "GET", "/api/runs"), 404,
          "there are /, /api/presets, /api/cell, /api/varied, /api/run, /api/area and /api/pose, not "
          "/api/runs");
  refuses(ask(port, "GET", "/../etc/passwd"), 404, "there are");
  refuses(ask(port, "DELETE", "/api/cell"), 405, "/api/cell takes GET, HEAD, not DELETE");
  refuses(ask(port, "GET", "/api/run"), 405, "/api/run takes POST, not GET");
  EXPECT_EQ(ask(port, "GET", "/api/run").allow, "POST");
  EXPECT_EQ(ask(port, "DELETE", "/api/cell").allow, "GET, HEAD");
  for (const char* type : {"text/plain", "application/jsonpwn", "application/json-seq;x=application/json", ""})
    refuses(ask(port, "POST", "/api/run", "{}", type), 415, "the Content-Type must be application/json");
  refuses(ask(port, "POST", "/api/run", "{\"storage\""), 400, "request: is not JSON: column 11: ");
  refuses(ask(port, "POST", "/api/run", R"({"storage": {"radius": -1}})"), 400, "request: storage.radius: ");
  refuses(ask(port, "POST", "/api/run", R"({"storage": {"radius": 1e999}})"), 400, "request: storage.radius: ");
  refuses(ask(port, "POST", "/api/run", std::string(65537, ' ')), 413, "a request's body may have 65536 bytes");
  refuses(ask(port, "POST", "/api/run", R"({"storage": {"radius": 1500}})"), 422, "storage.radius: ");
}

TEST_F(Page, ServesThePresetsOfTheFile) {
  EXPECT_EQ(json_of(ask(serving.port(), "GET", "/api/presets")), nlohmann::json({"case 2"}));
  const Received cell = ask(serving.port(), "GET", "/api/cell/1");
  ASSERT_EQ(cell.status, 200U) << cell.body;
  EXPECT_EQ(json_of(cell)["setting"]["storage"]["angle"], -33);
  const Received run = ask(serving.port(), "POST", "/api/run/1", "{}");
  ASSERT_EQ(run.status, 200U) << run.body;
  EXPECT_EQ(json_of(run)["moves"][1]["degrees"], -183);
  for (const char* path : {"/api/cell/2", "/api/cell/0", "/api/cell/x", "/api/cell/1x", "/api/presets/1"})
    refuses(ask(serving.port(), "GET", path), 404, "there are");
}

// The third joint of the default cell lowers the hand into the floor; the arm at home touches nothing.
TEST_F(Page, AnswersAboutAPose) {
  const auto pose = [&](const std::string& commanded) {
    return ask(serving.port(), "POST", "/api/pose", R"({"setting": {}, "commanded": )" + commanded + "}");
  };
  const Received home = pose("[0, 29.8, -25, 0, 0, 0]");
  ASSERT_EQ(home.status, 200U) << home.body;
  EXPECT_TRUE(json_of(home)["hindrance"].is_null());
  EXPECT_EQ(json_of(home)["links"].size(), 7U);
  EXPECT_EQ(json_of(home)["nearest"].size(), 2U);  // nothing is held
  EXPECT_GT(json_of(home)["nearest"][0]["distance"], 10);
  const Received low = pose("[0, 85, -55, 0, 0, 0]");
  ASSERT_EQ(low.status, 200U) << low.body;
  EXPECT_NE(json_of(low)["hindrance"]["what"].get<std::string>().find("the floor"), std::string::npos) << low.body;
  refuses(pose("[0, 0]"), 400, "request: commanded: must hold 6 numbers");
  refuses(pose("[0, 300, 0, 0, 0, 0]"), 422, "joint shoulder: 300 degrees");
}

TEST_F(Page, AnswersAboutTheArea) {
  const Received area = ask(serving.port(), "POST", "/api/area", R"({"storage": {"angle": 1}})");
  ASSERT_EQ(area.status, 200U) << area.body;
  std::size_t completed = 0;
  for (const auto& place : json_of(area)) completed += place["cause"].is_null();
  EXPECT_GT(completed, 0U);
  EXPECT_LT(completed, json_of(area).size());
}

// A request does not start a program of the user's own.
TEST_F(Page, LetsAMethodDriveButNoProgram) {
  refuses(ask(serving.port(), "POST", "/api/run", R"({"drive": "exec:true"})"), 400,
          "request: drive: there is no method");
  const Received run = ask(serving.port(), "POST", "/api/run", R"({"drive": "thesis"})");
  ASSERT_EQ(run.status, 200U) << run.body;
  EXPECT_EQ(json_of(run)["setting"]["drive"], "thesis");
}

// A page from elsewhere, whose name leads to this machine, sends its own name; of two it may be either.
TEST_F(Page, AnswersToThisMachineAlone) {
  const std::uint16_t port = serving.port();
  for (const char* host : {"localhost", "127.0.0.1", "[::1]"})
    EXPECT_EQ(ask(port, "GET", "/", "", "", host).status, 200U) << host;
  for (const char* host : {"evil.example", "127.evil.com", "127.0.0.1.evil.com", "127.0.0.1:80@evil"})
    for (const char* path : {"/", "/api/cell", "/nothing"})
      refuses(ask(port, "GET", path, "", "", host), 421, "this server answers to localhost or its address, not to");
  refuses(ask(port, "POST", "/api/run", "{}", "application/json", "127.evil.com"), 421, "this server answers to");
  refuses(send_raw(port, "GET / HTTP/1.1\r\nHost:\r\n\r\n"), 421, "this server answers to");
  refuses(send_raw(port, "GET / HTTP/1.0\r\n\r\n"), 421, "this server answers to");
}

TEST_F(Page, AnswersHeadAsGetWithoutABody) {
  for (const char* path : {"/", "/api/cell"}) {
    const std::string bytes = read_all(
        serving.port(), std::string("HEAD ") + path + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
    EXPECT_TRUE(bytes.starts_with("HTTP/1.1 200 OK\r\n")) << bytes;
    EXPECT_TRUE(bytes.ends_with("\r\n\r\n")) << bytes;
    EXPECT_NE(bytes.find("Content-Length: " + std::to_string(ask(serving.port(), "GET", path).body.size()) + "\r\n"),
              std::string::npos)
        << bytes;
  }
}

// Bytes that are not UTF-8 would not be JSON in the refusal that quotes them.
TEST_F(Page, RefusesBytesThatAreNotUtf8ByTheirPlace) {
  const std::uint16_t port = serving.port();
  refuses(send_raw(port, "GET /\xff HTTP/1.1\r\nHost: localhost\r\n\r\n"), 404,
          "there are /, /api/presets, /api/cell, /api/varied, /api/run, /api/area and /api/pose, not /\\xff");
  refuses(send_raw(port, "GET / HTTP/1.1\r\nHost: \xff\r\n\r\n"), 421,
          "this server answers to localhost or its address, not to \"\\xff\"");
  refuses(ask(port, "POST", "/api/run", "{\"\xff\": 1}"), 400, "request: is not JSON: column 3: ");
  refuses(ask(port, "POST", "/api/run", "\xff"), 400, "request: is not JSON: column 1: ");
  refuses(ask(port, "POST", "/api/run", "{\"storage\": {\"\\u001b[31m\": 1}}"), 400,
          "request: storage.\\x1b[31m: is an unknown key");
}

// A variation is asked about by its changes; without the means to build others, only the served cell is there.
TEST(Variations, AreAskedAboutLikeTheCell) {
  std::size_t built = 0;
  const Routes routes{
      simulator(), KnownHosts("127.0.0.1", true), {}, [&built](const Variation& variation) {
        ++built;
        auto plant = std::make_shared<const cell::Plant>(cell::read_plant(kAristo, std::nullopt, variation.changes));
        const std::size_t piece = variation.piece.empty() ? 0 : cell::piece_named(*plant, variation.piece);
        return Simulator(cell::cell_of(*plant, piece), {.plant = plant, .piece = piece});
      }};
  const auto post = [&](const std::string& path, const nlohmann::json& body) {
    return routes.answer(
        {.method = "POST", .path = path, .host = "localhost", .content_type = "application/json", .body = body.dump()});
  };
  const nlohmann::json changes{R"(zones[0]={"name": "z", "sphere": {"at": [400, 0, 300], "radius": 100}})",
                               "materials[0]=@material", "materials[0].name=second", "materials[0].slot=C"};
  const HttpReply cell = post("/api/varied", {{"changes", changes}});
  ASSERT_EQ(cell.status, 200U) << cell.body;
  const nlohmann::json shown = nlohmann::json::parse(cell.body);
  EXPECT_EQ(shown["pieces"], (nlohmann::json{"material", "second"}));
  EXPECT_EQ(shown["elements"].back()["key"], "zones[0]");
  EXPECT_EQ(shown["zones"][0]["name"], "z");
  const HttpReply run = post("/api/run", {{"changes", changes}, {"piece", "second"}});
  ASSERT_EQ(run.status, 200U) << run.body;
  const nlohmann::json ran = nlohmann::json::parse(run.body);
  EXPECT_EQ(ran["setting"]["slot"], "C");
  ASSERT_FALSE(ran["triggers"].empty());
  EXPECT_EQ(ran["triggers"][0]["zone"], "z");
  EXPECT_EQ(post("/api/run", {{"changes", {"storage.hight=1"}}}).status, 400U);
  EXPECT_EQ(post("/api/run", {{"changes", {"storage.slots[9].name=x"}}}).status, 422U);
  const std::size_t built_before = built;
  for (const char* path : {"/api/varied", "/api/run", "/api/area", "/api/pose"})
    EXPECT_EQ(post(path, {{"changes", {"step=0.004"}}}).status, 400U) << path;
  EXPECT_EQ(built, built_before) << "a cell is built for a step that is refused";
  const char* const profile = R"(obstacles[0]={"name":"profile","box":{"from":[0,0,0],"to":[9,9,9]},"move":[0,900,0]})";
  const HttpReply named = post("/api/varied", {{"changes", {profile}}});
  EXPECT_EQ(named.status, 200U) << named.body;
  EXPECT_EQ(post("/api/run", {{"piece", "third"}}).status, 422U);
  EXPECT_EQ(nlohmann::json::parse(post("/api/varied", nlohmann::json::object()).body)["zones"].size(), 0U);
}

// The storage stands in the robot: there is no first stop.
TEST_F(Page, AnswersWithARunWithoutStops) {
  const Received run = ask(serving.port(), "POST", "/api/run", R"({"storage": {"radius": 150}})");
  ASSERT_EQ(run.status, 200U) << run.body;
  EXPECT_TRUE(json_of(run)["stops"].empty());
  EXPECT_EQ(json_of(run)["failure"].get<std::string>().rfind("at home ", 0), 0U) << json_of(run)["failure"];
}

TEST_F(Page, GivesEveryoneTheAnswerToTheirOwnQuestion) {
  std::vector<std::thread> clients;
  std::vector<std::string> bodies(6);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    clients.emplace_back([&, i] {
      bodies[i] = ask(serving.port(), "POST", "/api/run", "{\"storage\": {\"angle\": " + std::to_string(i) + "}}").body;
    });
  for (std::thread& client : clients) client.join();
  for (std::size_t i = 0; i < bodies.size(); ++i)
    EXPECT_EQ(nlohmann::json::parse(bodies[i])["setting"]["storage"]["angle"], i);
}

// Which Host headers may be meant for a server: none that a web page from elsewhere can make lead here.
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
}  // namespace touchstone::cell::browser
