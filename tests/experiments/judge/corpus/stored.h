// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/case.h"
#include "geometry/contact/answer.h"
#include "geometry/contact/first_contact.h"

namespace touchstone::corpus {

/// A line of the corpus.
struct Stored {
  std::string file, text, id;
  cases::Case read;
  std::vector<std::string> tags;
  std::optional<Answer> answer;       ///< what it expects, of a case that is not to be rejected
  std::optional<FirstContact> first;  ///< the same if the ball moves; then there is no `answer`

  [[nodiscard]] const cases::Shapes& shapes() const { return std::get<cases::Shapes>(read.content); }
  [[nodiscard]] const Ball& ball() const { return shapes().ball(); }
  [[nodiscard]] const Motion& motion() const { return *shapes().motion(); }
  [[nodiscard]] const Polygon& polygon() const { return shapes().polygon; }
  [[nodiscard]] bool fails(const std::string& method) const;
};

/// Returns all lines, by file.
[[nodiscard]] const std::vector<Stored>& stored_cases();

/// While an object of this class exists, a crash reports `case ID of FILE` on standard output.
class Asked {
 public:
  Asked(const std::string& id, const std::string& file);
  explicit Asked(const Stored& stored) : Asked(stored.id, stored.file) {}
  Asked(const Asked&) = delete;
  Asked& operator=(const Asked&) = delete;
  ~Asked();
};

/// Returns `case ID of FILE`, the name of a case in failures.
std::ostream& operator<<(std::ostream& out, const Stored& stored);

}  // namespace touchstone::corpus
