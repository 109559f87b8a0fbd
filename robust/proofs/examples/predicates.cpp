// SPDX-License-Identifier: Apache-2.0
// Prints the records of third-party filters, for prove.py and prove_in_coq.py.
#include <iostream>
#include <vector>

#include "robust/proofs/recorded.h"

namespace touchstone::proofs {
namespace {

template <class N>
int certain_sign(const N& value, const N& bound) {
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return 0;
}

/// Stage A of orient2d [shewchuk1997]. `in`: ax, ay, bx, by, cx, cy.
template <class N>
int orient2d(const std::vector<N>& in, double constant) {
  const N left = (in[0] - in[4]) * (in[3] - in[5]), right = (in[1] - in[5]) * (in[2] - in[4]);
  return certain_sign(left - right, constant * (magnitude(left) + magnitude(right)));
}

/// Stage A of orient3d [shewchuk1997]. `in`: ax, ay, az, bx, ... dz.
template <class N>
int orient3d(const std::vector<N>& in, double constant) {
  const N adx = in[0] - in[9], ady = in[1] - in[10], adz = in[2] - in[11];
  const N bdx = in[3] - in[9], bdy = in[4] - in[10], bdz = in[5] - in[11];
  const N cdx = in[6] - in[9], cdy = in[7] - in[10], cdz = in[8] - in[11];
  const N bdxcdy = bdx * cdy, cdxbdy = cdx * bdy, cdxady = cdx * ady, adxcdy = adx * cdy;
  const N adxbdy = adx * bdy, bdxady = bdx * ady;
  const N permanent = (magnitude(bdxcdy) + magnitude(cdxbdy)) * magnitude(adz) +
                      (magnitude(cdxady) + magnitude(adxcdy)) * magnitude(bdz) +
                      (magnitude(adxbdy) + magnitude(bdxady)) * magnitude(cdz);
  return certain_sign(adz * (bdxcdy - cdxbdy) + bdz * (cdxady - adxcdy) + cdz * (adxbdy - bdxady),
                      constant * permanent);
}

/// The static filter of CGAL's Orientation_3 [cgal2022], but all maxima are compared, not the smallest and the largest.
/// `in`: px, py, pz, qx, ... sz.
template <class N>
int orientation_3(const std::vector<N>& in, double constant) {
  const N pqx = in[3] - in[0], pqy = in[4] - in[1], pqz = in[5] - in[2];
  const N prx = in[6] - in[0], pry = in[7] - in[1], prz = in[8] - in[2];
  const N psx = in[9] - in[0], psy = in[10] - in[1], psz = in[11] - in[2];
  const N maxx = maximum(maximum(magnitude(pqx), magnitude(prx)), magnitude(psx));
  const N maxy = maximum(maximum(magnitude(pqy), magnitude(pry)), magnitude(psy));
  const N maxz = maximum(maximum(magnitude(pqz), magnitude(prz)), magnitude(psz));
  if (maxx < 1e-97 || maxy < 1e-97 || maxz < 1e-97) return 0;
  if (maxx > 1e102 || maxy > 1e102 || maxz > 1e102) return 0;
  const N det = (pqx * pry - prx * pqy) * psz - (pqx * psy - psx * pqy) * prz + (prx * psy - psx * pry) * pqz;
  return certain_sign(det, constant * maxx * maxy * maxz);
}

}  // namespace
}  // namespace touchstone::proofs

int main() {
  using namespace touchstone::proofs;
  constexpr double kEpsilon = 0x1p-53;
  print_model(std::cout);
  const auto print = RecordedFunction::print_filter;
  print(std::cout, "orient2d", 6, [](const auto& in) { return orient2d(in, (3 + 16 * kEpsilon) * kEpsilon); });
  print(std::cout, "orient3d", 12, [](const auto& in) { return orient3d(in, (7 + 56 * kEpsilon) * kEpsilon); });
  print(std::cout, "Orientation_3", 12, [](const auto& in) { return orientation_3(in, 5.1107127829973299e-15); });
}
