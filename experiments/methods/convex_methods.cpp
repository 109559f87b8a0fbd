// SPDX-License-Identifier: GPL-3.0-or-later
// What the thesis sets out to avoid: the convex hull of a polygon, and convex parts of it.
#include <algorithm>
#include <vector>

#include "experiments/methods/add_methods.h"
#include "experiments/methods/convex.h"
#include "geometry/contact/fast.h"

namespace touchstone::methods {
namespace {

/// Whether a ball touches one of some convex polygons, by `fast`.
class PreparedConvex final : public PreparedMethod {
 public:
  explicit PreparedConvex(const std::vector<Polygon>& parts) {
    for (const Polygon& part : parts) parts_.emplace_back(part);
  }

  PartialAnswer ask(const Ball& ball, QueryKind /*kind*/) const override {
    PartialAnswer answer;
    answer.contact = std::ranges::any_of(parts_, [&](const auto& part) { return fast::contact(ball, part); });
    answer.stage = "double";
    return answer;
  }

 private:
  std::vector<fast::PreparedPolygon<double>> parts_;
};

class Convex final : public Method {
 public:
  using Parts = std::vector<Polygon> (*)(const Polygon& polygon);
  Convex(std::string_view name, std::string_view summary, Parts parts)
      : name_(name), summary_(summary), parts_(parts) {}
  std::string_view name() const override { return name_; }
  std::string_view summary() const override { return summary_; }
  std::unique_ptr<PreparedMethod> prepare(const Polygon& polygon) const override {
    return std::make_unique<PreparedConvex>(parts_(polygon));
  }

 private:
  std::string_view name_, summary_;
  Parts parts_;
};

}  // namespace

void add_convex(MethodList& list) {
  list.push_back(std::make_unique<Convex>("hull", "fast on the polygon's convex hull, which fills notches and holes",
                                          [](const Polygon& polygon) { return std::vector{convex_hull(polygon)}; }));
  list.push_back(std::make_unique<Convex>("convex-parts", "fast on convex parts of the polygon, joined from triangles",
                                          convex_parts));
}

}  // namespace touchstone::methods
