// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/motion.h"

#include "geometry/detail/required.h"
#include "robust/filtered/detail/kernels.h"

namespace touchstone::filtered {
namespace {

NoCounts uncounted;

template <class Counts>
FirstContact first_contact_of(const KernelTable<Counts>& kernels, const Motion& motion, const Triangle& triangle,
                              Counts& counts) {
  FirstContact contact;
  kernels.triangle_first_contact(view_of(required(motion), required(triangle)), contact, counts);
  return contact;
}

}  // namespace

bool contact(const Motion& motion, const Triangle& triangle) {
  return kernels().plain.triangle_motion_contact(view_of(required(motion), required(triangle)), uncounted);
}
bool contact(const Motion& motion, const Triangle& triangle, StageCounts& counts) {
  return kernels().counted.triangle_motion_contact(view_of(required(motion), required(triangle)), counts);
}

FirstContact first_contact(const Motion& motion, const Triangle& triangle) {
  return first_contact_of(kernels().plain, motion, triangle, uncounted);
}
FirstContact first_contact(const Motion& motion, const Triangle& triangle, StageCounts& counts) {
  return first_contact_of(kernels().counted, motion, triangle, counts);
}

}  // namespace touchstone::filtered
