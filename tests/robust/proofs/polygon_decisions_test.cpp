// SPDX-License-Identifier: GPL-3.0-or-later
// What the first stage makes of what a walk finds out about a polygon, for all combinations: one ball, and a lane of
// four.
#include <gtest/gtest.h>

#include "robust/filtered/detail/polygon/frame_query.h"
#include "robust/filtered/detail/sets/four_balls.h"

namespace touchstone::proofs {
namespace {

using namespace filtered::detail;

/// Returns the certain sign of the distance less the radius. A ball touches a polygon if it touches an edge, or if its
/// foot is inside and it touches the plane.
int defined(int plane, const EdgesAndFoot& seen) {
  if (plane > 0) return 1;
  const auto touches = [&](bool favourable) {
    const bool edge = seen.hit || (favourable && seen.unsure);
    const bool foot = seen.near_boundary ? favourable : seen.inside;
    return edge || (foot && (plane < 0 || favourable));
  };
  return touches(false) ? -1 : touches(true) ? 0 : 1;
}

TEST(PolygonDecisions, AreRightWhateverIsBehindWhatIsNotCertain) {
  for (int plane = -1; plane <= 1; ++plane)
    for (unsigned bits = 0; bits < 16; ++bits) {
      const EdgesAndFoot seen{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
      const int expected = defined(plane, seen);
      if (plane <= 0) {
        EXPECT_EQ(seen.certain_sign(plane), expected) << plane << ' ' << bits;
      }
      for (unsigned ball = 0; ball < kLanes; ++ball) {
        // The other balls have the opposite of everything.
        const auto lanes = [ball](bool of) { return of ? 1U << ball : 0xF & ~(1U << ball); };
        const EdgesAndFeet four{lanes(seen.hit), lanes(seen.near_boundary), lanes(seen.unsure), lanes(seen.inside)};
        const CertainContacts certain = four.contacts(lanes(plane > 0), lanes(plane < 0));
        EXPECT_EQ((certain.touching >> ball & 1) != 0, expected < 0) << plane << ' ' << bits << ' ' << ball;
        EXPECT_EQ((certain.separate >> ball & 1) != 0, expected > 0) << plane << ' ' << bits << ' ' << ball;
      }
    }
}

}  // namespace
}  // namespace touchstone::proofs
