// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/case.h"
#include "geometry/contact/answer.h"

namespace touchstone {

/// A line of the corpus.
struct Stored {
  std::string file, text, id;
  cases::Case read;
  std::vector<std::string> tags;
  std::optional<Answer> answer;  ///< what it expects, of a case that is not to be rejected

  [[nodiscard]] const Ball& ball() const { return std::get<cases::Shapes>(read.content).ball; }
  [[nodiscard]] const Polygon& polygon() const { return std::get<cases::Shapes>(read.content).polygon; }
  [[nodiscard]] bool fails(const std::string& method) const;
};

/// All of them, by file.
[[nodiscard]] const std::vector<Stored>& stored_cases();

/// While one lives, a crash is told with `case ID of FILE` on standard output.
class Asked {
 public:
  Asked(const std::string& id, const std::string& file);
  explicit Asked(const Stored& stored) : Asked(stored.id, stored.file) {}
  Asked(const Asked&) = delete;
  Asked& operator=(const Asked&) = delete;
  ~Asked();
};

/// `case ID of FILE`: how failures name a case.
std::ostream& operator<<(std::ostream& out, const Stored& stored);

}  // namespace touchstone
