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

/// Returns whether an edge at this distance from the ball can be `seen` so.
bool can_be(const EdgesAndFoot& seen, int edges, bool outside) {
  if (seen.hit ? edges >= 0 : !seen.unsure && edges <= 0) return false;
  return seen.near_boundary || seen.inside != outside;
}

// Later stages add what is exact: the signs of the distances to the plane and to the nearest edge, and where the foot
// is. A foot that is not outside is not farther than the edges.
TEST(PolygonDecisions, OfLaterStagesAreThoseOfTheDefinition) {
  int asked = 0;
  for (int plane = -1; plane <= 1; ++plane)
    for (int edges = plane; edges <= 1; ++edges)
      for (const bool outside : {false, true})
        for (unsigned bits = 0; bits < 16; ++bits) {
          const EdgesAndFoot seen{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
          if (!can_be(seen, edges, outside)) continue;
          const int expected = outside ? edges : plane;
          const auto of_plane = [plane] { return plane; };
          const auto of_edges = [edges] { return edges; };
          const auto foot = [outside] { return outside; };
          EXPECT_EQ(seen.sign<false>(of_plane, of_edges, foot), expected) << plane << edges << outside << bits;
          EXPECT_EQ(seen.sign<true>(of_plane, of_edges, foot) <= 0, expected <= 0) << plane << edges << outside << bits;
          ++asked;
        }
  EXPECT_GT(asked, 50);
}

}  // namespace
}  // namespace touchstone::proofs
