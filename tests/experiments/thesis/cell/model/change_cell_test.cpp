// SPDX-License-Identifier: GPL-3.0-or-later
// Changing what a cell file says: elements added, taken away, swapped and moved.
#include "experiments/thesis/cell/model/change_cell.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "experiments/thesis/cell/model/cell_entry.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "tests/experiments/support/cells.h"
#include "tests/experiments/support/message_of.h"

namespace touchstone::cell {
namespace {

using nlohmann::json;
using run_tests::kAristo;

json changed(const std::string& assignment) {
  json cell = json::parse(R"({"a": {"b": 1, "list": [10, 20, 30]},
                              "labels": {"a": "C", "a.b": "T", "a.list[0]": "S", "a.list[2]": "D"}})");
  change_cell(cell, assignment);
  return cell;
}

std::string fault_of_change(const std::string& assignment) {
  return run_tests::message_of<BadCell>([&] { changed(assignment); });
}

TEST(ChangeCell, SetsAddsAndTakesAway) {
  EXPECT_EQ(changed("a.b=-33")["a"]["b"], -33);
  EXPECT_EQ(changed("a.new={\"x\": [1]}")["a"]["new"], json::parse(R"({"x": [1]})"));
  EXPECT_EQ(changed("a.b=slot B")["a"]["b"], "slot B");
  EXPECT_EQ(changed("a.list[1]=7")["a"]["list"], json::parse("[10, 7, 30]"));
  EXPECT_EQ(changed("a.list[3]=40")["a"]["list"], json::parse("[10, 20, 30, 40]"));
  EXPECT_EQ(changed("a.list[1]=null")["a"]["list"], json::parse("[10, 30]"));
  EXPECT_FALSE(changed("a.b=null")["a"].contains("b"));
}

TEST(ChangeCell, WhatIsSetIsChosen) {
  EXPECT_EQ(changed("a.b=2")["labels"]["a.b"], "C");
  EXPECT_FALSE(changed("a.b=null")["labels"].contains("a.b"));
  EXPECT_EQ(changed("a.list=[1]")["labels"], json::parse(R"({"a": "C", "a.b": "T", "a.list": "C"})"));
  // Elements that move up are other values than their labels speak of.
  EXPECT_EQ(changed("a.list[1]=null")["labels"], json::parse(R"({"a": "C", "a.b": "T"})"));
  const Cell cell = read_cell(kAristo, std::nullopt, {"storage.angle=-33"});
  EXPECT_EQ(cell.storage.angle, -33);
  EXPECT_EQ(cell.label("storage.angle"), Label::Chosen);
  EXPECT_EQ(cell.label("machine.angle"), Label::Derived);
}

TEST(ChangeCell, NamesItsKeysAsTheyReadOnceParsed) {
  using Keys = std::set<std::string>;
  EXPECT_EQ(keys_of_change("a.list[2].b=slot.c"), (Keys{"a", "b", "list"}));
  EXPECT_EQ(keys_of_change("a[0]=@b.c[1]"), (Keys{"a", "b", "c"}));
  EXPECT_EQ(keys_of_change(R"(a=[{"\u0062":[[{"c":"d"}]],"e":{"f":null}}])"), (Keys{"a", "b", "c", "e", "f"}));
  EXPECT_EQ(keys_of_change("a={\"b\":"), (Keys{"a"}));  // not JSON: text
  EXPECT_THROW((void)keys_of_change("a=@"), BadCell);
  EXPECT_THROW((void)keys_of_change(R"(a={"b":1,"b":2})"), BadCell);
}

TEST(ChangeCell, NamesThePathThatLeadsNowhere) {
  EXPECT_EQ(fault_of_change("a.b"), "a.b: has no \"=\"");
  EXPECT_EQ(fault_of_change("=1"), ": is not a path of keys");
  EXPECT_EQ(fault_of_change("a..b=1"), "a..b: is not a path of keys");
  EXPECT_EQ(fault_of_change("a.=1"), "a.: is not a path of keys");
  EXPECT_EQ(fault_of_change("a.list[x]=1"), "a.list[x]: is not a path of keys");
  EXPECT_EQ(fault_of_change("a.list[1=1"), "a.list[1: is not a path of keys");
  EXPECT_EQ(fault_of_change("c.b=1"), "c.b: there is no key \"c\"");
  EXPECT_EQ(fault_of_change("a.c=null"), "a.c: there is no key \"c\"");
  EXPECT_EQ(fault_of_change("a.list[4]=1"), "a.list[4]: there is no element 4");
  EXPECT_EQ(fault_of_change("a.list[3]=null"), "a.list[3]: there is no element 3");
  EXPECT_EQ(fault_of_change("a.b[0]=1"), "a.b[0]: there is no element 0");
  EXPECT_EQ(fault_of_change("a.b.c=1"), "a.b.c: there is no key \"c\"");
  EXPECT_EQ(fault_of_change(R"(a.b={"x":1,"x":2})"), "a.b: duplicate key \"x\"");
}

TEST(ChangeCell, AnElementOfTheCellCanBeAddedSwappedAndTakenAway) {
  const auto parts = [](const std::vector<std::string>& changes) {
    std::vector<std::string> names;
    for (const Part& part : read_cell(kAristo, std::nullopt, changes).machine.parts) names.push_back(part.name);
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(parts({"machine.parts[5]=null", "machine.parts[0]=null"}), (Names{"column", "head", "saddle", "table"}));
  EXPECT_EQ(parts({R"(machine.parts[6]={"name":"lamp","box":{"from":[0,0,500],"to":[9,9,510]}})"}),
            (Names{"bottom", "column", "head", "saddle", "table", "vice", "lamp"}));
  const Cell swapped = read_cell(
      kAristo, std::nullopt, {R"(material.solid={"cylinder":{"from":[0,0,0],"to":[0,0,40],"radius":20,"sides":16}})"});
  EXPECT_TRUE(std::holds_alternative<Cylinder>(swapped.material.solid.shape));
}

}  // namespace
}  // namespace touchstone::cell
