// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/first_contact/stepped_contact.h"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "geometry/shapes/ball.h"

namespace touchstone::kinematics {

std::optional<SteppedContact> stepped_contact(const Arc& arc, double radius, double step, const scene::Faces& faces) {
  require_valid(arc);
  if (const auto fault = find_fault({arc.start, radius})) throw Rejected(*fault);
  if (!(step > 0 && std::isfinite(step)))
    throw std::invalid_argument(fmt::format("the step must be finite and positive, is {} degrees", step));
  scene::Scene scene;
  scene.add("faces", faces);
  for (std::uint64_t stop = 0; static_cast<double>(stop) * step <= arc.degrees; ++stop) {
    const double degrees = static_cast<double>(stop) * step;
    const auto touched = scene.touched({point_at(arc, degrees), radius});
    if (!touched.empty()) return SteppedContact{stop, degrees, touched.front().face};
  }
  return std::nullopt;
}

}  // namespace touchstone::kinematics
