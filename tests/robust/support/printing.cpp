// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/support/printing.h"

#include <limits>
#include <ostream>

namespace touchstone {

void PrintTo(const Answer& answer, std::ostream* out) { showValue(answer, *out); }

void showValue(const Answer& answer, std::ostream& out) {
  out.precision(std::numeric_limits<double>::max_digits10);
  out << to_string(answer.plane) << (answer.plane_tangent ? ", tangent" : "") << "; foot " << to_string(answer.foot)
      << "; edges_hit";
  for (const std::size_t i : answer.edges_hit) out << ' ' << i;
  out << "; " << to_string(answer.relation) << "; nearest " << to_string(answer.nearest.kind) << ' '
      << answer.nearest.index << "; point (" << answer.point.x() << ", " << answer.point.y() << ", " << answer.point.z()
      << "); distance " << answer.distance << "; off_plane " << answer.off_plane << "; contact_normal ("
      << answer.contact_normal.x() << ", " << answer.contact_normal.y() << ", " << answer.contact_normal.z()
      << "); depth " << answer.depth;
}

}  // namespace touchstone
