// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/checkpoint.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "experiments/run/output.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::run {
namespace {

namespace fs = std::filesystem;
struct Done {
  std::uint64_t done = 0;

  auto members() { return std::tie(done); }
};

std::uint64_t items_done(const Done& state) { return state.done; }

/// The settings of a run of this version, seed and these methods.
ResultSettings settings(int version, const char* seed, const char* methods) {
  return {version, {{"seed", seed}, {"methods", methods}}};
}

class CheckpointFile : public testing::Test {
 protected:
  [[nodiscard]] fs::path path() const { return folder_ / "checkpoint.json"; }
  [[nodiscard]] Checkpoint with(const ResultSettings& settings) const { return {path(), settings}; }
  [[nodiscard]] std::string refusal(const ResultSettings& settings) const {
    return run_tests::message_of([&] { return with(settings).read(Done()); });
  }

  const run_tests::Scratch scratch_;
  const fs::path folder_ = scratch_.path;
};

const ResultSettings kSettings = settings(1, "3", "fast,thesis");

TEST_F(CheckpointFile, GivesBackWhatWasWrittenLast) {
  EXPECT_FALSE(with(kSettings).read(Done()));
  with(kSettings).write(Done{4});
  with(kSettings).write(Done{5});
  EXPECT_EQ(with(kSettings).read(Done())->done, 5);
}

TEST_F(CheckpointFile, NamesTheSettingsThatDiffer) {
  with(kSettings).write(Done{4});
  EXPECT_EQ(refusal(kSettings), "");
  EXPECT_EQ(refusal(settings(1, "4", "fast,thesis")), path().string() + ": is of --seed 3, not of --seed 4");
  EXPECT_EQ(refusal(settings(1, "4", "fast")),
            path().string() + ": is of --seed 3 --methods fast,thesis, not of --seed 4 --methods fast");
  EXPECT_EQ(refusal(settings(2, "3", "fast,thesis")), path().string() + ": is of another version of this program");
}

// Only a file that does not exist means that the run begins: otherwise a checkpoint would be overwritten.
TEST_F(CheckpointFile, IsRefusedIfItCannotBeOpened) {
  write_file(folder_ / "file", "");
  const Checkpoint below(folder_ / "file" / "checkpoint.json", kSettings);
  EXPECT_THROW((void)below.read(Done()), std::runtime_error);
}

TEST_F(CheckpointFile, IsRefusedWhereItIsDamaged) {
  for (const char* text : {"", "{", "[]", "{\"version\":1,\"seed\":\"3\",\"method\":\"fast,thesis\"}",
                           "{\"version\":1,\"seed\":\"3\",\"method\":\"fast,thesis\",\"state\":\"\"}",
                           "{\"version\":1,\"seed\":\"3\",\"method\":\"fast,thesis\",\"state\":\"4 4\"}"}) {
    write_file(path(), text);
    EXPECT_NE(refusal(kSettings).find("is not a checkpoint of this program"), std::string::npos) << text;
  }
}

// If the process is killed while it writes, the file still holds the last complete state.
TEST_F(CheckpointFile, IsNeverWrittenInPlace) {
  with(kSettings).write(Done{4});
  fs::create_hard_link(path(), folder_ / "same-file");
  with(kSettings).write(Done{5});
  EXPECT_EQ(with(kSettings).read(Done())->done, 5);
  EXPECT_EQ(nlohmann::json::parse(run_tests::text_of(folder_ / "same-file")).at("done"), 4);
}

// A run without --resume keeps the checkpoint of an earlier run, from which that run can continue.
TEST_F(CheckpointFile, IsKeptByARunWithoutResume) {
  EXPECT_FALSE(with(kSettings).set_aside());
  with(kSettings).write(Done{4});
  EXPECT_TRUE(with(kSettings).set_aside());
  EXPECT_FALSE(with(kSettings).read(Done()));
  fs::rename(folder_ / "checkpoint.json.previous", path());
  EXPECT_EQ(with(kSettings).read(Done())->done, 4);
  fs::create_directory(folder_ / "checkpoint.json.previous");  // now it cannot be renamed
  EXPECT_THROW(with(kSettings).set_aside(), std::runtime_error);
  EXPECT_EQ(with(kSettings).read(Done())->done, 4);
}

}  // namespace
}  // namespace touchstone::run
