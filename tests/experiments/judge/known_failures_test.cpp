// SPDX-License-Identifier: GPL-3.0-or-later
// A judge that knows of failures reports new ones alone, and one with a margin those beyond it.
#include "experiments/judge/known_failures.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "experiments/judge/report.h"
#include "tests/experiments/judge/run_judge.h"

namespace touchstone::judge {
namespace {

constexpr auto kKnown = R"({"method":"exact","case":"t","key":"contact"})"
                        "\n"
                        R"({"method":"exact","case":"t","key":"depth"})"
                        "\n"
                        R"({"method":"other","case":"t","key":"contact"})"
                        "\n";

/// What the judge says of a touching ball that is expected to have this answer.
struct Ratchet {
  explicit Ratchet(const std::string& expected, const std::string& known_text, Order order = {})
      : known(write_file("known.jsonl", known_text)) {
    order.known = &known;
    order.judged = [this](const Judged& judged) {
      tally.add(judged);
      junit.add(judged);
    };
    result = run(with(kTouching, R"(,"expected":)" + expected), order);
  }
  KnownFailures known;
  Tally tally;
  JunitReport junit;
  Result result;
};

TEST(KnownFailures, AreNotToldAndDoNotFail) {
  const Ratchet ratchet(R"({"contact":false,"depth":1})", kKnown);
  EXPECT_EQ(ratchet.result.status, AllMet);
  EXPECT_EQ(ratchet.result.complaints, "");
  EXPECT_EQ(ratchet.tally.methods().front().all.wrong, 1U) << "they are counted";
  EXPECT_EQ(ratchet.tally.methods().front().all.known, 1U);
  EXPECT_NE(ratchet.junit.text().find("failures=\"0\" errors=\"0\" skipped=\"1\""), std::string::npos);
  EXPECT_TRUE(ratchet.known.mended().empty());
  EXPECT_EQ(ratchet.known.new_ones(), 0U);
  EXPECT_EQ(ratchet.known.text(), kKnown);
}

TEST(KnownFailures, DoNotHideNewOnes) {
  const Ratchet ratchet(R"({"contact":false,"depth":1,"distance":2})", kKnown);
  EXPECT_EQ(ratchet.result.status, ExpectationNotMet);
  EXPECT_EQ(ratchet.result.complaints, "case t: method exact: distance: expected 2, found 1\n");
  EXPECT_EQ(ratchet.tally.methods().front().all.known, 0U);
  EXPECT_EQ(ratchet.known.new_ones(), 1U);
  EXPECT_NE(ratchet.known.text().find("\"distance\""), std::string::npos);
}

TEST(KnownFailures, ThatAreMendedAreNamed) {
  const Ratchet ratchet(R"({"contact":true,"depth":1})", kKnown);
  EXPECT_EQ(ratchet.known.mended(), (std::vector<Failure>{{"exact", "t", "contact"}}));
  EXPECT_EQ(ratchet.known.text().find(R"("exact","case":"t","key":"contact")"), std::string::npos);
}

// An engine that begins to answer is held to its answers.
TEST(KnownFailures, OfAKeyThatWasNotGivenDoNotHideWrongValues) {
  const std::string known = R"({"method":"exact","case":"t","key":"depth","given":false})"
                            "\n";
  const Ratchet wrong(R"({"depth":1})", known);
  EXPECT_EQ(wrong.result.status, ExpectationNotMet);
  EXPECT_EQ(wrong.result.complaints, "case t: method exact: depth: expected 1, found 0\n");
  EXPECT_EQ(wrong.known.mended(), (std::vector<Failure>{{"exact", "t", "depth", true}}));
  EXPECT_EQ(wrong.known.text(), R"({"method":"exact","case":"t","key":"depth"})"
                                "\n");
  const std::string silent = R"({"method":"thesis","case":"t","key":"depth","given":false})"
                             "\n";
  Order order;
  order.methods = {methods::find_method("thesis")};  // it has no depth
  EXPECT_EQ(Ratchet(R"({"depth":0})", silent, order).result.status, AllMet);
  EXPECT_EQ(Ratchet(R"({"depth":0})", R"({"method":"thesis","case":"t","key":"depth"})", order).result.status,
            ExpectationNotMet)
      << "it gave a wrong one before";
}

// Another run may ask other keys, cases and methods: what it does not judge is neither mended nor forgotten.
TEST(KnownFailures, ThatAreNotJudgedStay) {
  Order order;
  order.keys = {*cases::find_key("distance")};
  const Ratchet ratchet(R"({"contact":true,"distance":1})", kKnown, order);
  EXPECT_TRUE(ratchet.known.mended().empty());
  EXPECT_EQ(ratchet.known.text(), kKnown);
}

TEST(KnownFailures, MayBeThatThereIsNoAnswer) {
  const std::string known = R"({"method":"exit 0","case":"t","key":"no answer"})"
                            "\n";
  const Ratchet silent(R"({"contact":true})", known, engine("exit 0"));
  EXPECT_EQ(silent.result.status, AllMet) << silent.result.complaints;
  EXPECT_EQ(silent.known.text(), known);
  const Ratchet unknown(R"({"contact":true})", "", engine("exit 0"));
  EXPECT_EQ(unknown.result.status, ExpectationNotMet);
  EXPECT_EQ(unknown.known.text(), known);
}

TEST(KnownFailures, ThatThereIsNoAnswerAreMendedWithoutAnExpectation) {
  const std::string known = R"({"method":"exact","case":"t","key":"no answer"})"
                            "\n";
  KnownFailures failures(write_file("known.jsonl", known));
  Order order;
  order.known = &failures;
  (void)run(with(kTouching, ""), order);
  EXPECT_EQ(failures.mended().size(), 1U);
}

// A failure is known by the id of its case, so another case with that id would hide a new one.
TEST(KnownFailures, NeedIdsThatAreUnique) {
  KnownFailures failures;
  Order order;
  order.known = &failures;
  const std::string line = with(kTouching, R"(,"expected":{"contact":true})");
  const Result repeated = run(line + "\n" + line, order);
  EXPECT_EQ(repeated.status, InputRejected);
  EXPECT_NE(repeated.complaints.find("line 2: case t: its id is not unique"), std::string::npos) << repeated.complaints;
  EXPECT_EQ(run(line + "\n" + line).status, AllMet);
}

// An update passes what it writes. What it cannot write fails as ever.
TEST(KnownFailures, ThatCannotBeNotedDoNotPass) {
  KnownFailures failures;
  Order order = engine("while read line; do echo '{\"id\":\"t\",\"contact\":false}'; done; exit 7");
  order.known = &failures;
  order.new_ones_pass = true;
  const std::string line = with(kTouching, R"(,"expected":{"contact":true})");
  EXPECT_EQ(run(line, order).status, ExpectationNotMet) << "it ends with 7";
  order.engines.front().command = "while read line; do echo '{\"id\":\"t\",\"contact\":false}'; done";
  EXPECT_EQ(run(line, order).status, AllMet);
  EXPECT_EQ(failures.new_ones(), 1U);
}

TEST(KnownFailures, OfAFaultyFileAreRefusedWithItsLine) {
  for (const char* line :
       {"nonsense", "{}", R"({"method":"a","case":"b"})", R"({"method":"a","case":"b","key":3})", "[]",
        R"({"method":"a","case":"b","key":"contact","key":"depth"})",
        R"({"method":"a","case":"b","key":"contact","more":1})", R"({"method":"a","case":"b","key":"nonsense"})"})
    try {
      (void)KnownFailures(write_file("faulty.jsonl", std::string(kKnown) + line + "\n"));
      ADD_FAILURE() << line;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("faulty.jsonl: line 4: "), std::string::npos) << error.what();
    }
  EXPECT_THROW((void)KnownFailures("/no/such/file"), std::runtime_error);
  EXPECT_THROW((void)KnownFailures("/"), std::runtime_error) << "a folder";
}

TEST(Beyond, CountsOnlyAnswersThatAreWrongByMoreThanTheMargin) {
  const auto judged = [](const std::string& answer, const char* expected, const char* margin) {
    Order order = engine("while read line; do echo '{\"id\":\"t\"," + answer + "}'; done");
    order.beyond = cases::margin_of(margin);
    return Ratchet(expected, "", order);
  };
  constexpr auto kWrong = R"("contact":false,"distance":1.0000001)", kTrue = R"({"contact":true,"distance":1})";
  const Ratchet within = judged(kWrong, kTrue, "2^-20");
  EXPECT_EQ(within.result.status, AllMet) << within.result.complaints;
  EXPECT_EQ(within.tally.methods().front().all.wrong, 0U);
  EXPECT_EQ(within.tally.methods().front().all.within, 1U);
  const Ratchet beyond = judged(kWrong, kTrue, "2^-30");
  EXPECT_EQ(beyond.result.status, ExpectationNotMet);
  EXPECT_EQ(beyond.result.complaints.find("contact: expected"), std::string::npos)
      << "a touching ball has contact by no margin";
  EXPECT_EQ(judged(R"("contact":true)", kTrue, "2^-20").result.status, ExpectationNotMet) << "a key is missing";
  EXPECT_EQ(judged(kWrong, R"({"contact":true,"distance":1.0000002})", "2^-20").result.status, ExpectationNotMet)
      << "the expectation is wrong";
}

}  // namespace
}  // namespace touchstone::judge
