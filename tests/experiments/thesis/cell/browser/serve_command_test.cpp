// SPDX-License-Identifier: GPL-3.0-or-later
// `touchstone cell serve` before it serves.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "experiments/commands.h"
#include "experiments/run/output.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/thesis/cell/browser/aristo.h"
#include "tests/experiments/thesis/cell/browser/serving.h"

namespace touchstone::cell::browser {
namespace {

run_tests::Ran serve(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "serve");
  return run_tests::run_captured(commands::cell_command, std::move(arguments));
}

TEST(ServeCommand, NamesTheKeyOfABadCellFile) {
  const run_tests::Scratch scratch;
  const std::string file = scratch.path / "bad.json";
  run::write_file(file, R"({"nam": "x"})");
  const run_tests::Ran ran = serve({file});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.err.rfind(file + ": nam: is an unknown key", 0), 0U) << ran.err;
  EXPECT_NE(serve({aristo().file.string(), "--set", "storage.height=-1"}).err.find("storage.height: "),
            std::string::npos);
}

TEST(ServeCommand, NamesThePortThatIsTaken) {
  const Serving other([](const HttpRequest&) { return HttpReply{}; });
  const std::string port = std::to_string(other.port());
  const run_tests::Ran ran = serve({aristo().file.string(), "--port", port});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.err.rfind("cannot listen at 127.0.0.1, port " + port, 0), 0U) << ran.err;
}

TEST(ServeCommand, NamesAMethodThatThereIsNot) {
  EXPECT_NE(serve({aristo().file.string(), "--methods", "guess"}).err.find("guess"), std::string::npos);
}

}  // namespace
}  // namespace touchstone::cell::browser
