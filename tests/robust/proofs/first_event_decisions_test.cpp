// SPDX-License-Identifier: GPL-3.0-or-later
// Which of up to four events is first, for all orders of the ends of the intervals that their times may lie in, and of
// events that may not happen at all.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "robust/filtered/detail/motion/moving_edge.h"

namespace touchstone::proofs::first_event {
namespace {

using namespace filtered::detail;

constexpr std::size_t kEvents = 4;
constexpr int kEnds = 8;  ///< as many as the ends of four intervals

/// Where the time of an event certainly lies, in units; nothing if it is not certain whether it happens.
struct Event {
  std::optional<int> earliest, latest;
};

/// All that may be known of an event: that it does not happen is that it is not there.
std::vector<std::optional<Event>> possibilities() {
  std::vector<std::optional<Event>> all{std::nullopt, Event{}};
  for (int earliest = 0; earliest < kEnds; ++earliest)
    for (int latest = earliest; latest < kEnds; ++latest) all.emplace_back(Event{earliest, latest});
  return all;
}

/// Up to four events, and what is known of the first of them.
template <class Time>
struct Events {
  static constexpr double kUnit = 0x1p-3;
  FirstCandidate<Time> first;
  std::vector<std::pair<std::size_t, Event>> certain;
  bool unsure = false;

  void add(std::size_t number, const Event& event) {
    if (!event.earliest) {
      unsure = true;
      return;
    }
    certain.emplace_back(number, event);
    const double sum = kUnit / 2 * (*event.earliest + *event.latest),
                 width = kUnit / 2 * (*event.latest - *event.earliest);
    first.add({Feature::Kind::Edge, number}, sum, width);
  }
  /// The event that is before all others wherever their times lie.
  [[nodiscard]] std::optional<std::size_t> definite() const {
    for (const auto& one : certain)
      if (std::all_of(certain.begin(), certain.end(), [&](const auto& other) {
            return other.first == one.first || *one.second.latest < *other.second.earliest;
          }))
        return one.first;
    return std::nullopt;
  }
  void expect_known() const {
    const std::optional<std::size_t> expected = definite();
    ASSERT_EQ(first.any(), !certain.empty());
    ASSERT_EQ(first.certain(), expected.has_value());
    if (expected) {
      ASSERT_EQ(first.feature().index, *expected);
    }
    ASSERT_EQ(first.template known<false>(unsure), unsure            ? FilterResult::Unsure
                                                   : certain.empty() ? FilterResult::No
                                                   : expected        ? FilterResult::Yes
                                                                     : FilterResult::Unsure);
    ASSERT_EQ(first.template known<true>(unsure), !certain.empty() ? FilterResult::Yes
                                                  : unsure         ? FilterResult::Unsure
                                                                   : FilterResult::No);
    expect_times();
  }
  /// The times that bound the first one are those of the intervals, up to what covers rounding.
  void expect_times() const {
    if (certain.empty()) {
      ASSERT_GE(first.latest(), 1);
      return;
    }
    int earliest = kEnds, latest = kEnds;
    for (const auto& [number, event] : certain)
      earliest = std::min(earliest, *event.earliest), latest = std::min(latest, *event.latest);
    ASSERT_TRUE(first.earliest() <= kUnit * earliest && first.earliest() > kUnit * earliest - 0x1p-30);
    ASSERT_TRUE(first.latest() >= kUnit * latest && first.latest() < kUnit * latest + 0x1p-30);
  }
};

template <class Time>
void expect_known_of(const Events<Time>& events, std::size_t number) {
  static const auto all = possibilities();
  if (number == kEvents) {
    events.expect_known();
    return;
  }
  for (const auto& event : all) {
    Events<Time> more = events;
    if (event) more.add(number, *event);
    expect_known_of(more, number + 1);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(FirstEventDecisions, AreThoseOfTheDefinitionInDoubles) { expect_known_of(Events<double>{}, 0); }
TEST(FirstEventDecisions, AreThoseOfTheDefinitionInDoubleDoubles) { expect_known_of(Events<DoubleDouble>{}, 0); }

}  // namespace
}  // namespace touchstone::proofs::first_event
