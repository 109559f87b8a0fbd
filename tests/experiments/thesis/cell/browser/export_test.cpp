// SPDX-License-Identifier: GPL-3.0-or-later
// `touchstone cell export`: one page that needs nothing else.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "experiments/commands.h"
#include "experiments/program/output.h"
#include "experiments/thesis/cell/browser/cell_json.h"
#include "experiments/thesis/cell/browser/page.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/thesis/cell/browser/aristo.h"

namespace touchstone::cell::browser {
namespace {

using Json = nlohmann::ordered_json;

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

class ExportCommand : public testing::Test {
 protected:
  [[nodiscard]] run_tests::Ran run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "export");
    for (const char* word : {"--methods", "filtered"}) arguments.emplace_back(word);
    return run_tests::run_captured(commands::cell_command, std::move(arguments));
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (scratch.path / name).string(); }
  const run_tests::Scratch scratch;
  const std::string file = aristo().file.string();
};

TEST_F(ExportCommand, WritesAPage) {
  const run_tests::Ran page = run({file, path("run.html"), "--set", "storage.angle=2"});
  EXPECT_EQ(page.status, 0) << page.err;
  EXPECT_EQ(run_tests::text_of(path("run.html")).rfind("<!DOCTYPE html>", 0), 0U);
}

TEST_F(ExportCommand, WritesOverNothingUnlessForced) {
  program::write_file(path("run.html"), "mine");
  const run_tests::Ran refused = run({file, path("run.html")});
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.err, path("run.html") + ": exists already; --force overwrites it");
  EXPECT_EQ(run_tests::text_of(path("run.html")), "mine");
  EXPECT_EQ(run({file, path("run.html"), "--force"}).status, 0);
  EXPECT_EQ(run_tests::text_of(path("run.html")).rfind("<!DOCTYPE html>", 0), 0U);
  // A link to what is not there would be followed.
  std::filesystem::create_symlink(path("victim"), path("link.html"));
  EXPECT_EQ(run({file, path("link.html")}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(path("victim")));
}

TEST_F(ExportCommand, NamesWhatIsWrong) {
  EXPECT_EQ(run({file, path("run.step")}).err, path("run.step") + ": the extension '.step' must be .html");
  const run_tests::Ran bad = run({file, path("run.html"), "--set", "storage.height=-1"});
  EXPECT_EQ(bad.status, 2);
  EXPECT_NE(bad.err.find("storage.height: "), std::string::npos) << bad.err;
  EXPECT_NE(run({file, path("no/run.html")}).err.find(path("no/run.html")), std::string::npos);
}

}  // namespace
}  // namespace touchstone::cell::browser
