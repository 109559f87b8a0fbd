// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "experiments/studies/bench/cgal.h"

namespace touchstone::bench::cgal {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

Kernel::Point_3 point(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Kernel::Triangle_3 triangle_of(const Triangle& t) { return {point(t.a), point(t.b), point(t.c)}; }

bool within(const Kernel::Point_3& center, const Kernel::Triangle_3& triangle, const Kernel::FT& radius) {
  return CGAL::squared_distance(center, triangle) <= radius * radius;
}

}  // namespace

bool epeck_contact(const Ball& ball, const Triangle& triangle) {
  return within(point(ball.center), triangle_of(triangle), Kernel::FT(ball.radius));
}

struct EpeckQueries::Objects {
  std::vector<Kernel::Point_3> centers;
  std::vector<Kernel::Triangle_3> triangles;
  std::vector<Kernel::FT> radii;
};

EpeckQueries::EpeckQueries() : objects_(std::make_unique<Objects>()) {}
EpeckQueries::EpeckQueries(EpeckQueries&&) noexcept = default;
EpeckQueries& EpeckQueries::operator=(EpeckQueries&&) noexcept = default;
EpeckQueries::~EpeckQueries() = default;

void EpeckQueries::make(std::span<const workloads::TriangleQuery> queries) {
  *objects_ = {};
  for (const auto& [ball, triangle] : queries) {
    objects_->centers.push_back(point(ball.center));
    objects_->triangles.push_back(triangle_of(triangle));
    objects_->radii.emplace_back(ball.radius);
  }
}

bool EpeckQueries::contact(std::size_t i) const {
  return within(objects_->centers[i], objects_->triangles[i], objects_->radii[i]);
}

}  // namespace touchstone::bench::cgal
