// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/entry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/program/input.h"
#include "experiments/program/json.h"
#include "experiments/thesis/cell/model/cell_entry.h"

namespace touchstone::figures {
namespace {

using Item = cell::CellEntry;

constexpr std::array<std::string_view, 5> kBases{"fitted", "input", "predicted", "own check", "other source"};
constexpr std::array<std::string_view, 5> kStatuses{"reproduced with chosen values", "derived", "self-check",
                                                    "photograph: not computable", "not computable"};

/// Returns the enumerator of this word.
template <class Enum>
Enum one_of(const Item& item, const std::array<std::string_view, 5>& words) {
  const auto word = std::ranges::find(words, item.text());
  if (word == words.end()) item.bad("must be one of: " + fmt::format("{}", fmt::join(words, ", ")));
  return static_cast<Enum>(word - words.begin());
}

const std::optional<Value>& value_of(const Item& item, const Computed& computed) {
  const auto value = computed.numbers.find(item.text());
  if (value == computed.numbers.end()) item.bad("nothing computes \"" + item.text() + "\"");
  return value->second;
}

/// Reads a number, or the name of one that is measured.
double number(const Item& item, const Computed& computed) {
  if (item.is_number()) return item.number();
  const std::optional<Value>& value = value_of(item, computed);
  return value ? value->value : NAN;
}

/// Reads a text with its holes filled.
std::string sentence(const Item& item, const Computed& computed) {
  std::string text = item.text();
  for (std::size_t open = 0; (open = text.find('{', open)) != std::string::npos;) {
    const std::size_t close = text.find('}', open);
    if (close == std::string::npos) item.bad("has { without }");
    const std::string name = text.substr(open + 1, close - open - 1);
    std::string filling;
    if (const auto words = computed.texts.find(name); words != computed.texts.end())
      filling = words->second;
    else if (const auto value = computed.numbers.find(name); value != computed.numbers.end() && value->second)
      filling = fmt::format("{:g}", value->second->value);
    else
      item.bad("nothing computes \"" + name + "\"");
    text.replace(open, close + 1 - open, filling);
    open += filling.size();
  }
  return text;
}

/// Reads a number; nothing if it was not measured.
std::optional<Number> read_number(const Item& item, const Computed& computed) {
  item.has_only({"name", "what", "unit", "chosen", "stated", "basis", "tolerance", "stated samples", "rounded to"});
  const Item what = item.at("what");
  (void)what.text();
  const auto stated = item.find("stated"), tolerance_item = item.find("tolerance"), rounded = item.find("rounded to");
  if (stated.has_value() != item.find("basis").has_value()) item.bad("needs `stated` and `basis` together");
  const std::optional<Value> ours = value_of(item.at("name"), computed);
  if (!ours) return std::nullopt;
  Number result{sentence(what, computed), item.find("unit") ? item.at("unit").text() : "", *ours};
  result.chosen = item.at("chosen").yes();
  if (!stated) return result;
  result.stated = number(*stated, computed);
  result.basis = one_of<Basis>(item.at("basis"), kBases);
  if (tolerance_item) result.tolerance = number(*tolerance_item, computed);
  if (rounded)
    result.tolerance = 100 * tolerance(ours->wrong, ours->right, ours->samples,
                                       {*result.stated / 100, rounded->positive() / 100,
                                        static_cast<std::uint64_t>(item.at("stated samples").positive())});
  return result;
}

Entry read_entry(const Item& item, const std::string& id, const Computed& computed) {
  item.has_only({"id", "caption", "page", "status", "text", "shows", "numbers"});
  Entry entry{.id = id,
              .caption = item.at("caption").text(),
              .page = item.find("page") ? item.at("page").whole(1, 10'000) : 0,
              .status = one_of<Status>(item.at("status"), kStatuses),
              .text = sentence(item.at("text"), computed),
              .numbers = {},
              .shows = item.find("shows") ? item.at("shows").text() : ""};
  for (const Item& each : item.at("numbers").items())
    if (auto number = read_number(each, computed)) entry.numbers.push_back(std::move(*number));
  return entry;
}

}  // namespace

std::string_view to_string(Basis basis) { return kBases[static_cast<std::size_t>(basis)]; }

Label label_of(Basis basis) {
  constexpr std::array labels{Label::Text, Label::Text, Label::Derived, Label::Derived, Label::Source};
  return labels[static_cast<std::size_t>(basis)];
}

std::optional<bool> Number::agrees() const {
  if (!stated) return std::nullopt;
  return std::abs(ours.value - *stated) <= tolerance;
}

bool Entry::agrees() const {
  return std::ranges::all_of(numbers, [](const Number& number) { return number.agrees().value_or(true); });
}

std::string_view Entry::status_words() const {
  if (status < Status::Photograph && !agrees()) return "differs";
  return kStatuses[static_cast<std::size_t>(status)];
}

std::string Entry::file_stem() const {
  std::string stem = id;
  std::ranges::replace_if(
      stem, [](char c) { return c == '.' || c == ' '; }, '-');
  return stem;
}

double tolerance(std::uint64_t wrong, std::uint64_t right, std::uint64_t samples, const StatedShare& stated) {
  const auto right_here = static_cast<double>(right);
  const double right_then = right_here * static_cast<double>(stated.samples) / static_cast<double>(samples);
  const double wrong_both = static_cast<double>(wrong) + stated.share * right_then;
  const double share = std::max(1.0, wrong_both) / (right_here + right_then);
  return 4 * std::sqrt(share * (1 + share) * (1 / right_here + 1 / right_then)) + stated.unit / 2;
}

std::vector<Entry> read_entries(const std::filesystem::path& file, const Computed& computed) {
  program::StrictJson json;
  try {
    json = program::read_strict_json(cell::read_at_most<cell::BadCell>(file, 1));
  } catch (const program::NotJson& error) {
    throw cell::BadCell(file.string() + ": is not JSON: " + error.what());
  }
  const Item whole(file.string(), "", json.value);
  if (json.duplicate_key) whole.bad("duplicate key \"" + *json.duplicate_key + "\"");
  std::vector<Entry> entries;
  for (std::size_t i = 0; const Item& item : whole.items()) {
    const std::string id = item.at("id").text();
    if (std::ranges::find(entries, id, &Entry::id) != entries.end()) item.bad("is the second entry for " + id);
    entries.push_back(read_entry(Item(file.string(), "entry " + id, json.value[i++]), id, computed));
  }
  return entries;
}

std::vector<Entry> entries_of(const Study& study) {
  return read_entries(program::data("experiments/thesis/figures/figures.json"), computed(study));
}

}  // namespace touchstone::figures
