// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/first_contact_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robust/exact/motion.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/motion.h"

namespace touchstone::scene::detail {

void FirstContactSearch::meet(const Triangle& triangle, std::uint32_t number, const std::optional<Feature>& feature,
                              double earliest, double latest) {
  meet(Met{{numbered(number), triangle}, feature, earliest, latest, std::nullopt});
}

void FirstContactSearch::start(const MetFace& face) {
  if (wanted_ == Wanted::All) return met_.push_back({face, std::nullopt, 0, 0, std::nullopt});
  if (!start_ || face.id < start_->id) start_.emplace(face);
  end_ = 0;
}

// The time was rounded to the nearest double.
void FirstContactSearch::meet(const MetFace& face, const FirstContact& contact) {
  meet(Met{face, contact.feature, std::nextafter(contact.time, -HUGE_VAL), std::nextafter(contact.time, HUGE_VAL),
           contact});
}

void FirstContactSearch::meet(Met met) {
  if (is_at_start() || met.earliest > end_) return;
  if (wanted_ == Wanted::First) end_ = std::min(end_, met.latest);
  met_.push_back(std::move(met));
}

void FirstContactSearch::find_contact(Met& met) const {
  if (met.contact) return;
  const MetFace& face = met.face;
  if (face.triangle && met.feature)
    met.contact = filtered::detail::kernels().triangle_first_contact_with(
        filtered::detail::view_of(motion_, *face.triangle), *met.feature);
  if (met.contact) return;
  met.contact = face.triangle ? filtered::first_contact(motion_, *face.triangle)
                              : filtered::first_contact(motion_, *face.polygon);
  met.feature = met.contact->feature;
}

int FirstContactSearch::compare(Met& first, Met& second) const {
  if (first.latest < second.earliest) return -1;
  if (second.latest < first.earliest) return 1;
  if (!first.feature) find_contact(first);
  if (!second.feature) find_contact(second);
  // The same vertex or edge, as it was given, is touched at the same time.
  if (const auto place = first.face.place(*first.feature); place && place == second.face.place(*second.feature))
    return 0;
  find_contact(first);
  find_contact(second);
  // Times whose doubles differ are in the same order.
  const double time = first.contact->time, other = second.contact->time;
  if (time != other) return time < other ? -1 : 1;
  return exact::compare_times(motion_, first.face.exactly(), second.face.exactly());
}

std::optional<FirstFace> FirstContactSearch::first() const {
  if (start_) {
    Met met{*start_, std::nullopt, 0, 0, std::nullopt};
    find_contact(met);
    return FirstFace{met.face.id, *met.contact};
  }
  Met* best = nullptr;
  for (Met& met : met_) {
    if (met.earliest > end_) continue;
    const int order = best == nullptr ? -1 : compare(met, *best);
    if (order < 0 || (order == 0 && met.face.id < best->face.id)) best = &met;
  }
  if (best == nullptr) return std::nullopt;
  find_contact(*best);
  return FirstFace{best->face.id, *best->contact};
}

std::vector<FirstFace> FirstContactSearch::all_in_order() const {
  std::vector<Met*> order;
  for (Met& met : met_) find_contact(met), order.push_back(&met);
  const auto at_start = [](const Met* met) { return met->contact->kind == FirstContactKind::Start; };
  std::ranges::sort(order, [&](Met* a, Met* b) {
    if (at_start(a) != at_start(b)) return at_start(a);
    const int times = at_start(a) ? 0 : compare(*a, *b);
    return times < 0 || (times == 0 && a->face.id < b->face.id);
  });
  std::vector<FirstFace> faces;
  faces.reserve(order.size());
  for (const Met* met : order) faces.push_back({met->face.id, *met->contact});
  return faces;
}

}  // namespace touchstone::scene::detail
