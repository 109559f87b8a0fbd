// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "experiments/methods/process/engine.h"
#include "experiments/methods/registry.h"

namespace touchstone::methods {
namespace {

TEST(EngineOption, HasTheNameAfterTheLastSign) {
  EXPECT_EQ(engine_of("./engine=mine"), (Engine{"mine", "./engine"}));
  EXPECT_EQ(engine_of("python3 engine.py --fast=mine-2.0"),
            (Engine{"python3 engine.py --fast=mine-2.0", "python3 engine.py --fast=mine-2.0"}));
  EXPECT_EQ(engine_of("python3 engine.py --mode=fast =mine"), (Engine{"mine", "python3 engine.py --mode=fast "}));
  EXPECT_EQ(engine_of("A=1 ./engine"), (Engine{"A=1 ./engine", "A=1 ./engine"}));
  EXPECT_EQ(engine_of("A=1 ./engine=mine"), (Engine{"mine", "A=1 ./engine"}));
  EXPECT_EQ(engine_of("sh -c 'x=1'"), (Engine{"sh -c 'x=1'", "sh -c 'x=1'"}));
  EXPECT_EQ(engine_of("cat"), (Engine{"cat", "cat"}));
}

TEST(EngineOption, RefusesWhatIsNoCommandOrNoName) {
  for (const char* text : {"", "  ", "=mine", " =mine", "\xff", "\xff=mine"})
    EXPECT_THROW((void)engine_of(text), std::invalid_argument) << text;
}

TEST(EngineOption, ThatAShellCannotStartIsNamedAsSuch) {
  EXPECT_THROW(require_started("x", "exit status 126"), EngineNotStarted);
  EXPECT_THROW(require_started("x", "exit status 127"), EngineNotStarted);
  for (const char* ending : {"", "exit status 1", "exit status 125", "signal 9"})
    EXPECT_NO_THROW(require_started("x", ending));
}

TEST(Selection, AddsEnginesToTheMethods) {
  const Selection selection{{"fast", "s-mine"}, {"cat -u =s-mine", "cat=s-other"}};
  const auto methods = selection.methods();
  ASSERT_EQ(methods.size(), 3U);
  EXPECT_EQ(methods[0], find_method("fast"));
  EXPECT_EQ(methods[1]->name(), "s-mine");
  EXPECT_EQ(methods[2]->name(), "s-other");
  EXPECT_TRUE(methods[1]->through_pipe());
  EXPECT_FALSE(methods[0]->through_pipe());
  EXPECT_EQ(selection.text(), "fast,s-mine,s-other");
  EXPECT_EQ(find_method("s-mine"), methods[1]);
  EXPECT_EQ(&add_engine({"s-mine", "cat -u "}), methods[1]);
}

TEST(Selection, RefusesNamesThatAreTaken) {
  EXPECT_THROW((void)(Selection{{}, {"cat=fast"}}.methods()), std::invalid_argument);
  EXPECT_THROW((void)(Selection{{}, {"cat=all"}}.methods()), std::invalid_argument);
  EXPECT_THROW((void)(Selection{{}, {"cat=t-mine", "cat -u =t-mine"}}.methods()), std::invalid_argument);
  EXPECT_THROW((void)(Selection{{"t-nothing"}, {}}.methods()), std::invalid_argument);
  EXPECT_THROW((void)(Selection{{}, {"cat # \x1b[31m"}}.methods()), std::invalid_argument);
  EXPECT_THROW((void)(Selection{{}, {"cat # \n"}}.methods()), std::invalid_argument);
}

/// Parses these arguments. Returns the names of the selected methods, and the line that repeats the run.
std::pair<std::string, std::string> selected(const std::vector<std::string>& arguments) {
  Selection selection{{"fast", "thesis"}};
  program::Call call;
  program::Command command("measure", "Measures");
  declare_compared_methods(command, selection);
  command.keep_call(call);
  command.runs([] { return 0; });
  (void)command(arguments);
  EXPECT_EQ(call.result_options(), (std::vector<std::pair<std::string, std::string>>{{"methods", selection.text()}}));
  return {selection.text(), call.line};
}

TEST(Selection, EnginesAloneReplaceTheDefaultMethods) {
  using Pair = std::pair<std::string, std::string>;
  EXPECT_EQ(selected({}), Pair("fast,thesis", "touchstone measure --methods fast,thesis"));
  EXPECT_EQ(selected({"--engine", "cat=u-mine"}), Pair("u-mine", "touchstone measure --engine cat=u-mine"));
  EXPECT_EQ(selected({"--engine", "cat=u-mine", "--methods", "fast", "--engine", "cat -u =u-b"}),
            Pair("fast,u-mine,u-b", "touchstone measure --methods fast --engine cat=u-mine --engine 'cat -u =u-b'"));
  EXPECT_THROW((void)selected({"--engine", " "}), program::UsageError);
}

}  // namespace
}  // namespace touchstone::methods
