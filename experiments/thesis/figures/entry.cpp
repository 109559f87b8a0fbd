// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/entry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace touchstone::figures {

std::string_view to_string(Basis basis) {
  constexpr std::array<std::string_view, 4> words{"fitted", "input", "own check", "other source"};
  return words[static_cast<std::size_t>(basis)];
}

std::optional<bool> Number::agrees() const {
  if (!stated) return std::nullopt;
  return std::abs(ours - *stated) <= tolerance;
}

Number found(std::string what, std::string unit, double ours, bool chosen) {
  Number number;
  number.what = std::move(what);
  number.unit = std::move(unit);
  number.ours = ours;
  number.chosen = chosen;
  return number;
}

Number share(std::string what, std::uint64_t count, std::uint64_t samples, bool chosen) {
  const double ours = samples == 0 ? 0 : 100 * static_cast<double>(count) / static_cast<double>(samples);
  Number number = found(std::move(what), "%", ours, chosen);
  const auto limits = statistics::clopper_pearson(count, samples);
  number.limits = {100 * limits.lower, 100 * limits.upper};
  number.samples = samples;
  return number;
}

Number beside(Number ours, Label label, double stated, double tolerance) {
  ours.stated = stated;
  ours.tolerance = tolerance;
  ours.label = label;
  ours.basis = label == Label::Text ? Basis::Input : label == Label::Source ? Basis::OtherSource : Basis::OwnCheck;
  return ours;
}

bool Entry::agrees() const {
  return std::ranges::all_of(numbers, [](const Number& number) { return number.agrees().value_or(true); });
}

std::string_view Entry::status_words() const {
  switch (status) {
    case Status::Photograph: return "photograph: not computable";
    case Status::NotComputable: return "not computable";
    case Status::Reproduced:
    case Status::WithChosen: break;
  }
  if (!agrees()) return "differs";
  return status == Status::Reproduced ? "reproduced" : "reproduced with chosen values";
}

std::string Entry::file_stem() const {
  std::string stem(caption->id);
  std::ranges::replace_if(
      stem, [](char c) { return c == '.' || c == ' '; }, '-');
  return stem;
}

}  // namespace touchstone::figures
