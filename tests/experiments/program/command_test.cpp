// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/command.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "tests/experiments/program/light.h"

namespace touchstone::program {
namespace {

/// A command with an option of every kind.
struct Declared {
  std::uint64_t seed = 7, most = 0;
  unsigned threads = 3, count = 20;
  int offset = -2;
  double step = 0.5, limit = 0;
  std::string truth = "exact", folder = "results/it", file, mesh = "a.obj";
  Light colour = Light::Green;
  std::vector<std::string> methods{"all"}, meshes, changes;
  bool quick = false, force = false;
  Call call;
  int runs = 0;

  int run(const std::vector<std::string>& arguments) {
    Command command("measure", "Measures");
    command.keep_call(call);
    command.texts("MESH", meshes, "Meshes");
    declare_seed(command, seed);
    declare_threads(command, threads);
    declare_methods(command, methods);
    command.whole("--count", count, "A count", 1, 1000);
    command.whole("--most", most, "At most so much", 1);
    command.integer("--offset", offset, "An offset");
    command.real("--step", step, "A step", 0, 90);
    declare_positive(command, "--limit", limit, "A limit");
    command.choice("--oracle", truth, {"exact", "filtered"}, "The truth");
    command.choice("--colour", colour, std::vector{Light::Red, Light::Green}, "A colour");
    command.texts("--set", changes, "Changes");
    command.text("--file", file, "A file").needs("--step");
    command.flag("--quick", quick, "Quickly");
    declare_folder(command, folder, "The folder");
    declare_force(command, force);
    command.runs([this] { return ++runs; });
    return command(arguments);
  }
};

constexpr const char* kUnchanged =
    "touchstone measure --seed 7 --threads 3 --methods all --count 20 --offset -2 --step 0.5 --oracle exact --colour "
    "green --output results/it";

TEST(Command, KeepsWhatTheVariablesHeldWhereNothingIsSaid) {
  Declared declared;
  EXPECT_EQ(declared.run({}), 1);
  EXPECT_EQ(declared.seed, 7U);
  EXPECT_EQ(declared.methods, std::vector<std::string>{"all"});
  EXPECT_EQ(declared.call.line, kUnchanged);
}

// The line holds every option that was given, with the given values.
TEST(Command, ItsLineRepeatsTheRun) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> given{
      {{"--seed", "8"}, "--seed 8"},
      {{"--threads", "4"}, "--threads 4"},
      {{"--methods", "fast,exact"}, "--methods fast,exact"},
      {{"--count", "21"}, "--count 21"},
      {{"--most", "9"}, "--most 9"},
      {{"--most", "1e6"}, "--most 1000000"},
      {{"--offset", "3"}, "--offset 3"},
      {{"--step", "0.1"}, "--step 0.1"},
      {{"--limit", "2"}, "--limit 2"},
      {{"--oracle", "filtered"}, "--oracle filtered"},
      {{"--colour", "red"}, "--colour red"},
      {{"--set", "a=1", "--set", "b c=2"}, "--set a=1 --set 'b c=2'"},
      {{"--file", "it's", "--step", "1"}, "--file 'it'\\''s'"},
      {{"--quick"}, "--quick"},
      {{"--output", "elsewhere"}, "--output elsewhere"},
      {{"--output", ""}, "--output ''"},
      {{"--set", "", "--quick"}, "--set '' --quick"},
      {{"m.obj", "my mesh.obj"}, "measure m.obj 'my mesh.obj' --seed"}};
  for (const auto& [arguments, expected] : given) {
    Declared declared;
    declared.run(arguments);
    EXPECT_NE(declared.call.line.find(expected), std::string::npos) << expected << " is not in " << declared.call.line;
    EXPECT_NE(declared.call.line, kUnchanged);
  }
  Declared forced;
  forced.run({"--force"});
  EXPECT_EQ(forced.call.line, kUnchanged);
}

TEST(Command, TakesTheWholeRangeOfItsNumbers) {
  Declared declared;
  declared.run(
      {"--seed", "18446744073709551615", "--threads", "1024", "--count", "1000", "--step", "90", "--limit", "5e-324"});
  EXPECT_EQ(declared.seed, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(declared.threads, 1024U);
  EXPECT_EQ(declared.count, 1000U);
  EXPECT_EQ(declared.step, 90);
  EXPECT_EQ(declared.limit, std::numeric_limits<double>::denorm_min());
}

TEST(Command, RefusesWhatIsNotInTheRange) {
  const std::vector<std::vector<std::string>> wrong{{"--seed", "-1"},
                                                    {"--seed", "18446744073709551616"},
                                                    {"--threads", "0"},
                                                    {"--threads", "1025"},
                                                    {"--seed", "1.5"},
                                                    {"--seed", "2e19"},
                                                    {"--seed", "1e-1"},
                                                    {"--seed", "e3"},
                                                    {"--threads", "4294967297"},
                                                    {"--count", "0"},
                                                    {"--count", "1001"},
                                                    {"--offset", "many"},
                                                    {"--step", "-0.1"},
                                                    {"--step", "90.1"},
                                                    {"--step", "nan"},
                                                    {"--limit", "0"},
                                                    {"--limit", "1e999"},
                                                    {"--oracle", "thesis"},
                                                    {"--colour", "blue"},
                                                    {"--file", "without"},
                                                    {"--unknown"},
                                                    {"--seed"}};
  for (const auto& arguments : wrong) {
    Declared declared;
    EXPECT_THROW(declared.run(arguments), UsageError) << arguments.front() << ' ' << arguments.back();
    EXPECT_EQ(declared.runs, 0);
  }
}

TEST(Command, LeavesWhatStandsBehindAListOfNamesToOthers) {
  Declared declared;
  declared.run({"--methods", "fast,exact", "mesh.obj"});
  EXPECT_EQ(declared.methods, (std::vector<std::string>{"fast", "exact"}));
  EXPECT_EQ(declared.meshes, std::vector<std::string>{"mesh.obj"});
}

TEST(Command, ItsGroupsOfOptionsTakeOne) {
  const auto run = [](const std::vector<std::string>& arguments) {
    std::string file, random;
    Command command("ask", "Asks");
    command.text("--file", file, "A file");
    command.text("--random", random, "Random ones");
    require_one_of(command, {"--file", "--random"});
    return command(arguments);
  };
  EXPECT_EQ(run({"--file", "a"}), 0);
  EXPECT_EQ(run({"--random", "a"}), 0);
  EXPECT_THROW(run({}), UsageError);
  EXPECT_THROW(run({"--file", "a", "--random", "a"}), UsageError);
}

// A line that held the default, too, would be refused.
TEST(Command, ItsLineLeavesOutTheDefaultOfWhatAnotherOptionExcludes) {
  const auto line_of = [](const std::vector<std::string>& arguments) {
    std::vector<std::string> meshes;
    unsigned vertices = 24;
    Call call;
    Command command("measure", "Measures");
    command.keep_call(call);
    command.texts("MESH", meshes, "Meshes");
    command.whole("--vertices", vertices, "Vertices").excludes("MESH");
    command.runs([] { return 0; });
    command(arguments);
    return call.line;
  };
  EXPECT_EQ(line_of({}), "touchstone measure --vertices 24");
  EXPECT_EQ(line_of({"a.obj"}), "touchstone measure a.obj");
  EXPECT_THROW(line_of({"a.obj", "--vertices", "24"}), UsageError);
}

TEST(Command, RunsTheSubcommandThatIsNamed) {
  auto ran = std::make_shared<Call>();
  const auto named = [&](const std::string& name) {
    Command command(name, name);
    command.keep_call(*ran);
    command.runs([] { return 5; });
    return command;
  };
  const Command group("group", "Groups", {named("one"), named("two")});
  EXPECT_EQ(group({"two"}), 5);
  EXPECT_EQ(ran->line, "touchstone group two");
  EXPECT_THROW(group({}), UsageError);
  EXPECT_THROW(group({"three"}), UsageError);
}

// The canonical form is evaluated when it is asked for, since it may refuse the value.
TEST(Command, KeepsTheOptionsThatChangeResults) {
  std::uint64_t samples = 10, seed = 3;
  std::vector<std::string> methods{"all"};
  Call kept;
  Command command("measure", "Measures");
  command.whole("--samples", samples, "Samples");
  declare_seed(command, seed).changes_results();
  declare_methods(command, methods).changes_results([&] {
    if (methods.front() == "none") throw UsageError("no methods");
    return std::string("fast,thesis");
  });
  command.keep_call(kept);
  command.runs([] { return 0; });
  EXPECT_EQ(command({"--seed", "4"}), 0);
  EXPECT_EQ(kept.result_options(),
            (std::vector<std::pair<std::string, std::string>>{{"seed", "4"}, {"methods", "fast,thesis"}}));
  EXPECT_EQ(command({"--methods", "none"}), 0);
  EXPECT_THROW((void)kept.result_options(), UsageError);
}

TEST(Command, KnowsTheTablesThatItWrites) {
  Command command("measure", "Measures");
  command.writes({{"a.csv", "a thing", {{"x", "its place"}}}});
  command.writes({{"b.csv", "another", {}}});
  ASSERT_EQ(command.tables().size(), 2U);
  EXPECT_EQ(command.tables()[1].file, "b.csv");
  const Command group("group", "Groups", {command});
  EXPECT_EQ(group.subcommands().front().name(), "measure");
}

}  // namespace
}  // namespace touchstone::program
