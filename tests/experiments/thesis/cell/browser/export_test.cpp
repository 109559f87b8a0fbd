// SPDX-License-Identifier: GPL-3.0-or-later
// `touchstone cell export`: one page that needs nothing else, and glTF.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "experiments/commands.h"
#include "experiments/run/write_file.h"
#include "experiments/thesis/cell/browser/cell_json.h"
#include "experiments/thesis/cell/browser/gltf.h"
#include "experiments/thesis/cell/browser/page.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/thesis/cell/browser/aristo.h"

namespace touchstone::cell_browser_tests {
namespace {

using namespace cell::browser;
using Json = nlohmann::ordered_json;
using PlainJson = nlohmann::json;

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin) + begin.size();
  return text.substr(from, text.find(end, from) - from);
}

TEST(Exported, PageRefersToNothingElse) {
  std::string page = recorded_page(cell_json(simulator()), run_json(recording()));
  const std::string name = "\"http://www.w3.org/2000/svg\"";  // a name, which nobody looks up
  page.erase(page.find(name), name.size());
  for (const char* reference : {"http:", "https:", "//cdn", "src=", "@import", "url(", "import("})
    EXPECT_EQ(page.find(reference), std::string::npos) << reference;
  EXPECT_EQ(between(page, "href=\"", "\""), "data:,");
  EXPECT_NE(page.find("connect-src 'none'"), std::string::npos);
  EXPECT_EQ(page.find("/*style*/"), std::string::npos);
  EXPECT_EQ(page.find("/*script*/"), std::string::npos);
}

TEST(Exported, PageHoldsTheRecordedRun) {
  const std::string cell = cell_json(simulator()), run = run_json(recording());
  const std::string page = recorded_page(cell, run);
  const Json read = Json::parse(between(page, "id=\"recorded\">", "</script>"));
  EXPECT_EQ(read["cell"], Json::parse(cell));
  EXPECT_EQ(read["run"], Json::parse(run));
  EXPECT_EQ(between(live_page(), "id=\"recorded\">", "</script>"), "null");
}

TEST(Exported, NameOfACellCannotEndTheScript) {
  Json cell = Json::parse(cell_json(simulator()));
  cell["name"] = "</script><script>alert(1)</script><!--";
  const std::string page = recorded_page(cell.dump(), run_json(recording()));
  EXPECT_EQ(page.find("alert(1)</script"), std::string::npos);
  EXPECT_EQ(Json::parse(between(page, "id=\"recorded\">", "</script>"))["cell"]["name"], cell["name"]);
}

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, 4);
  return word;
}

struct Glb {
  PlainJson gltf;
  std::string buffer;
};

Glb parsed(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(word_at(bytes, 4), 2U);
  EXPECT_EQ(word_at(bytes, 8), bytes.size());
  const std::uint32_t text = word_at(bytes, 12), buffer = word_at(bytes, 20 + text);
  EXPECT_EQ(text % 4, 0U);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  EXPECT_EQ(bytes.substr(24 + text, 4), std::string("BIN\0", 4));
  EXPECT_EQ(bytes.size(), 28 + text + buffer);
  return {PlainJson::parse(bytes.substr(20, text)), bytes.substr(28 + text)};
}

std::size_t width(const PlainJson& accessor) {
  static const std::map<std::string, std::size_t> widths{{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
  return widths.at(accessor["type"]);
}

template <class T>
std::vector<T> values(const Glb& glb, std::size_t number) {
  const PlainJson& accessor = glb.gltf["accessors"][number];
  const PlainJson& view = glb.gltf["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  std::vector<T> result(accessor["count"].get<std::size_t>() * width(accessor));
  std::memcpy(result.data(), glb.buffer.data() + view["byteOffset"].get<std::size_t>(), sizeof(T) * result.size());
  return result;
}

TEST(Gltf, AccessorsStayWithinTheBuffer) {
  const Glb glb = parsed(gltf_binary(recording(), 25));
  EXPECT_EQ(glb.gltf["buffers"][0]["byteLength"], glb.buffer.size());
  for (const PlainJson& view : glb.gltf["bufferViews"]) {
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0U);
    EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(), glb.buffer.size());
  }
  for (const PlainJson& accessor : glb.gltf["accessors"]) {
    const PlainJson& view = glb.gltf["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
    EXPECT_EQ(4 * width(accessor) * accessor["count"].get<std::size_t>(), view["byteLength"]);
  }
}

TEST(Gltf, IndicesAndBoundsAreThoseOfThePoints) {
  const Glb glb = parsed(gltf_binary(recording(), 25));
  for (const PlainJson& mesh : glb.gltf["meshes"])
    for (const PlainJson& primitive : mesh["primitives"]) {
      const std::size_t at = primitive["attributes"]["POSITION"];
      const std::vector<float> points = values<float>(glb, at);
      for (const std::uint32_t index : values<std::uint32_t>(glb, primitive["indices"]))
        EXPECT_LT(3 * index, points.size());
      for (std::size_t axis = 0; axis < 3; ++axis) {
        float least = points[axis], most = least;
        for (std::size_t i = axis; i < points.size(); i += 3)
          least = std::min(least, points[i]), most = std::max(most, points[i]);
        EXPECT_EQ(glb.gltf["accessors"][at]["min"][axis].get<float>(), least);
        EXPECT_EQ(glb.gltf["accessors"][at]["max"][axis].get<float>(), most);
      }
    }
}

// Every node but the root is the child of exactly one; links are named as the robot's.
TEST(Gltf, NodesAreATreeOfTheLinks) {
  const PlainJson gltf = PlainJson::parse(gltf_text(recording(), 25));
  std::vector<int> parents(gltf["nodes"].size(), 0);
  std::vector<std::string> names;
  for (const PlainJson& node : gltf["nodes"]) {
    names.push_back(node["name"]);
    if (node.contains("children"))
      for (const PlainJson& child : node["children"]) ++parents.at(child.get<std::size_t>());
  }
  EXPECT_EQ(parents[0], 0);
  EXPECT_TRUE(std::all_of(parents.begin() + 1, parents.end(), [](int count) { return count == 1; }));
  for (const char* name : {"Base", "Axis1", "Axis6", "storage", "machine", "material", "sphere", "gripper/Gripper1"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
}

TEST(Gltf, AnimationIsTheRun) {
  const Recording& run = recording();
  const Glb glb = parsed(gltf_binary(run, 25));
  const PlainJson& animation = glb.gltf["animations"].at(0);
  std::map<std::string, std::vector<float>> places;
  for (const PlainJson& channel : animation["channels"]) {
    const PlainJson& sampler = animation["samplers"].at(channel["sampler"].get<std::size_t>());
    const std::vector<float> times = values<float>(glb, sampler["input"]);
    ASSERT_EQ(times.size(), run.snapshots.size());
    EXPECT_TRUE(std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) == times.end());
    const std::string name = glb.gltf["nodes"].at(channel["target"]["node"].get<std::size_t>())["name"];
    const std::vector<float> output = values<float>(glb, sampler["output"]);
    if (channel["target"]["path"] == "translation") {
      places[name] = output;
    } else {
      ASSERT_EQ(output.size(), 4 * times.size());
      for (std::size_t i = 0; i < output.size(); i += 4) {
        float norm = 0, along = 0;
        for (std::size_t k = 0; k < 4; ++k)
          norm += output[i + k] * output[i + k], along += output[i + k] * output[i < 4 ? k : i - 4 + k];
        EXPECT_NEAR(norm, 1, 1e-5);
        EXPECT_GE(along, 0) << "the turn from stop to stop goes the long way round";
      }
    }
  }
  EXPECT_EQ(places.count("Base"), 0U) << "the base stands still";
  for (const char* name : {"Axis1", "Axis6", "material", "sphere"}) ASSERT_EQ(places.count(name), 1U) << name;
  for (std::size_t i = 0; i < run.snapshots.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      EXPECT_EQ(places["sphere"][3 * i + k], static_cast<float>(run.process.stops[i].sphere.center[axis]));
      EXPECT_EQ(places["Axis6"][3 * i + k], static_cast<float>(run.snapshots[i].links.back().translation[axis]));
      EXPECT_EQ(places["material"][3 * i + k], static_cast<float>(run.snapshots[i].material.translation[axis]));
    }
}

TEST(Gltf, TextAndBinaryHoldTheSame) {
  PlainJson text = PlainJson::parse(gltf_text(recording(), 25));
  const Glb glb = parsed(gltf_binary(recording(), 25));
  const std::string uri = text["buffers"][0]["uri"], head = "data:application/octet-stream;base64,";
  ASSERT_EQ(uri.rfind(head, 0), 0U);
  EXPECT_EQ(uri.size(), head.size() + (glb.buffer.size() + 2) / 3 * 4);
  text["buffers"][0].erase("uri");
  EXPECT_EQ(text, glb.gltf);
  // The first three bytes, as four digits.
  const auto digit = [&](std::size_t i) {
    return std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/").find(uri[head.size() + i]);
  };
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(glb.buffer[i]); };
  EXPECT_EQ(digit(0) << 18U | digit(1) << 12U | digit(2) << 6U | digit(3),
            static_cast<std::size_t>(byte(0) << 16U | byte(1) << 8U | byte(2)));
}

class ExportCommand : public testing::Test {
 protected:
  [[nodiscard]] run_tests::Ran run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "export");
    for (const char* word : {"--cover-margin", "8", "--methods", "filtered"}) arguments.emplace_back(word);
    return run_tests::run_captured(commands::cell_command, std::move(arguments));
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (scratch.path / name).string(); }
  const run_tests::Scratch scratch;
  const std::string file = aristo().file.string();
};

TEST_F(ExportCommand, WritesWhatTheExtensionSays) {
  const run_tests::Ran page = run({file, path("run.html")});
  EXPECT_EQ(page.status, 0) << page.err;
  EXPECT_EQ(run_tests::text_of(path("run.html")).rfind("<!DOCTYPE html>", 0), 0U);
  EXPECT_EQ(run({file, path("run.glb"), "--set", "storage.angle=2"}).status, 0);
  EXPECT_EQ(run_tests::text_of(path("run.glb")).rfind("glTF", 0), 0U);
}

TEST_F(ExportCommand, WritesOverNothingUnlessForced) {
  run::write_file(path("run.glb"), "mine");
  const run_tests::Ran refused = run({file, path("run.glb")});
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.err, path("run.glb") + ": exists already; --force overwrites it");
  EXPECT_EQ(run_tests::text_of(path("run.glb")), "mine");
  EXPECT_EQ(run({file, path("run.glb"), "--force"}).status, 0);
  EXPECT_EQ(run_tests::text_of(path("run.glb")).rfind("glTF", 0), 0U);
  // A link to what is not there would be followed.
  std::filesystem::create_symlink(path("victim"), path("link.glb"));
  EXPECT_EQ(run({file, path("link.glb")}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(path("victim")));
}

TEST_F(ExportCommand, NamesWhatIsWrong) {
  EXPECT_EQ(run({file, path("run.step")}).err,
            path("run.step") + ": the extension '.step' must be .html, .gltf or .glb");
  const run_tests::Ran bad = run({file, path("run.html"), "--set", "storage.height=-1"});
  EXPECT_EQ(bad.status, 2);
  EXPECT_NE(bad.err.find("storage.height: "), std::string::npos) << bad.err;
  EXPECT_NE(run({file, path("no/run.html")}).err.find(path("no/run.html")), std::string::npos);
}

}  // namespace
}  // namespace touchstone::cell_browser_tests
