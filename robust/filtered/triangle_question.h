// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone::filtered {

/// A triangle and a ball as plain numbers where they lie: three vertices, centre, radius.
struct TriangleQuestion {
  const double (*vertex)[3];
  const double* center;
  double radius;
};

/// What is sure of one sign in each lane, a bit a lane; where neither bit is set, doubles cannot tell.
struct SureSigns {
  unsigned positive, negative;

  /// +1, -1, or 0 where it is not sure.
  [[nodiscard]] int of(int lane) const {
    return static_cast<int>(positive >> lane & 1) - static_cast<int>(negative >> lane & 1);
  }
};

/// Every sign of signs.h that bears on a contact, lane i for edge i. The plane's is one sign, seen from three edges.
struct TriangleSigns {
  SureSigns vertex, along, beyond, line, side, plane;
};

enum class Sure : unsigned char { No, Yes, Unsure };

}  // namespace touchstone::filtered
