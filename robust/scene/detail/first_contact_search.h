// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/contact/first_contact.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/triangle.h"
#include "robust/filtered/filtered.h"
#include "robust/scene/detail/nearest_search.h"
#include "robust/scene/scene.h"

namespace touchstone::scene::detail {

/// The search for the face that a moving ball touches first, or for all that it touches. For the first it shortens the
/// motion to a time until which the ball touches some face found so far, so faces that it touches only later are not
/// the first. At the end exact times decide among the faces that are left.
class FirstContactSearch {
 public:
  enum class Wanted { First, All };

  explicit FirstContactSearch(const Motion& motion, Wanted wanted = Wanted::First)
      : motion_(motion), wanted_(wanted), end_(motion.at_rest() ? 0 : 1) {}

  [[nodiscard]] const Motion& motion() const { return motion_; }
  /// Returns the end of the shortened motion: 1 at first, 0 for a ball at rest.
  [[nodiscard]] double end() const { return end_; }
  /// Sets the first face of the set that is searched next.
  void enter(FaceId first) { first_ = first; }

  /// Returns whether only faces matter that are touched at the start: one was found and is wanted alone, or the ball is
  /// at rest.
  [[nodiscard]] bool is_at_start() const { return start_.has_value() || motion_.at_rest(); }
  /// Returns whether a face, by its number in the set, is lower than any found that is touched at the start.
  [[nodiscard]] bool is_lower(std::uint32_t number) const { return !start_ || numbered(number) < start_->id; }
  /// Adds a face that the ball touches at its start. Always inlined into the walks, which are compiled for several
  /// targets.
  template <class Face>
  __attribute__((always_inline)) void start(const Face& face, std::uint32_t number) {
    start({numbered(number), face});
  }

  /// Adds a triangle that the ball does not touch at its start, but first touches between these times; if known, its
  /// feature that is touched first.
  void meet(const Triangle& triangle, std::uint32_t number, const std::optional<Feature>& feature, double earliest,
            double latest);
  /// Adds a face and its first contact, which may be None.
  template <class Face>
  void meet(const Face& face, std::uint32_t number, const FirstContact& contact) {
    if (contact.kind == FirstContactKind::Start) start(face, number);
    if (contact.kind == FirstContactKind::Way) meet({numbered(number), face}, contact);
  }

  /// Returns the first face, the lowest of those that are touched at the same time. Cost: about 1 us, and 100 us for
  /// each pair of faces with equal rounded times that do not share the touched vertex or edge.
  [[nodiscard]] std::optional<FirstFace> first() const;
  /// Returns all faces, if they are wanted, in the order of their times, the lowest first among equals. Cost: likewise.
  [[nodiscard]] std::vector<FirstFace> all_in_order() const;

 private:
  struct Met {
    MetFace face;
    std::optional<Feature> feature;
    double earliest, latest;              ///< bounds of the time
    std::optional<FirstContact> contact;  ///< where it was needed
  };
  [[nodiscard]] FaceId numbered(std::uint32_t number) const { return {first_.object, first_.face + number}; }
  void start(const MetFace& face);
  void meet(const MetFace& face, const FirstContact& contact);
  void meet(Met met);
  /// Finds the first contact, and thereby the feature.
  void find_contact(Met& met) const;
  /// Returns whether the first face is touched before (-), together with (0) or after (+) the second.
  [[nodiscard]] int compare(Met& first, Met& second) const;

  const Motion motion_;
  const Wanted wanted_;
  FaceId first_{0, 0};
  double end_;
  std::optional<MetFace> start_;
  static constexpr std::size_t kFew = 4;
  mutable boost::container::small_vector<Met, kFew> met_;  ///< contacts are found at the end
};

}  // namespace touchstone::scene::detail
