// SPDX-License-Identifier: GPL-3.0-or-later
// Whose connection is closed when there are too many.
#include "experiments/thesis/cell/browser/connection_slots.h"

#include <gtest/gtest.h>

#include <vector>

namespace touchstone::cell::browser {
namespace {

class Slots : public testing::Test {
 protected:
  ConnectionSlots::Number open(int name) {
    return slots.open([this, name] { closed.push_back(name); }).value();
  }
  ConnectionSlots slots{3};
  std::vector<int> closed;
};

TEST_F(Slots, TheOneThatHasWaitedLongestIsClosedForANewOne) {
  const auto first = open(1);
  open(2), open(3);
  EXPECT_TRUE(slots.begin_work(first));
  slots.begin_waiting(first);  // later than the others
  open(4), open(5), open(6);
  EXPECT_EQ(closed, (std::vector<int>{2, 3, 1}));
  EXPECT_FALSE(slots.begin_work(first));
}

TEST_F(Slots, OneAtWorkIsNotClosed) {
  const auto first = open(1), second = open(2), third = open(3);
  EXPECT_TRUE(slots.begin_work(first) && slots.begin_work(third));
  open(4);
  EXPECT_EQ(closed, (std::vector<int>{2}));
  EXPECT_FALSE(slots.begin_work(second));
  slots.begin_waiting(third);
  open(5), open(6);
  EXPECT_EQ(closed, (std::vector<int>{2, 4, 3}));
}

TEST_F(Slots, ThereIsNoneWhereAllWork) {
  for (int name = 1; name <= 3; ++name) EXPECT_TRUE(slots.begin_work(open(name)));
  EXPECT_FALSE(slots.open([] {}));
  EXPECT_TRUE(closed.empty());
}

TEST_F(Slots, AClosedConnectionLeavesItsSlot) {
  const auto first = open(1);
  open(2), open(3);
  slots.close(first);
  slots.close(first);
  open(4);
  EXPECT_TRUE(closed.empty());
}

}  // namespace
}  // namespace touchstone::cell::browser
