// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/experiments/judge/corpus/stored.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ostream>

#include "experiments/judge/corpus/corpus.h"

namespace touchstone::corpus {
namespace {

/// A depth beyond the doubles, of which JSON keeps no sign, is that of a ball far away.
double signed_depth(double depth) { return std::isinf(depth) ? -depth : depth; }

/// Throws std::bad_optional_access if a key is missing.
Answer answer_of(const cases::PartialAnswer& expected) {
  return {.plane = expected.plane.value(),
          .plane_tangent = expected.plane_tangent.value(),
          .foot = expected.foot.value(),
          .edges_hit = expected.edges_hit.value(),
          .relation = expected.relation.value(),
          .nearest = expected.nearest.value(),
          .point = expected.point.value(),
          .distance = expected.distance.value(),
          .off_plane = expected.off_plane.value(),
          .contact_normal = expected.contact_normal.value(),
          .depth = signed_depth(expected.depth.value())};
}

/// Throws std::bad_optional_access if a key is missing that the contract does not call null.
FirstContact first_contact_of(const cases::PartialAnswer& expected) {
  const FirstContactKind kind = expected.first.value();
  if (kind == FirstContactKind::None) return {};
  return {kind,
          expected.time.value(),
          kind == FirstContactKind::Way && expected.momentary.value(),
          expected.feature.value(),
          expected.point.value(),
          expected.contact_normal.value(),
          expected.depth.value()};
}

std::string asked;

void tell_what_was_asked(int signal) {
  if (!asked.empty() && write(STDOUT_FILENO, asked.data(), asked.size()) < 0) std::_Exit(signal);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

std::vector<Stored> read_corpus() {
  std::vector<Stored> cases;
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / "tests/corpus"))
    if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
  std::ranges::sort(files);
  for (const auto& file : files) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
      const Asked reading(line.substr(0, line.find(',')), file.stem().string());
      cases::Case read = cases::read_case(line);
      Stored stored{file.stem().string(), line, read.id.value_or("without id"), std::move(read), {}, {}, {}};
      if (std::holds_alternative<cases::Shapes>(stored.read.content) && stored.read.expected &&
          !stored.read.expected->rejects()) {
        stored.tags = labels_of(line).tags;
        const cases::PartialAnswer& expected = stored.read.expected->values;
        if (stored.shapes().motion())
          stored.first = first_contact_of(expected);
        else
          stored.answer = answer_of(expected);
      }
      cases.push_back(std::move(stored));
    }
  }
  return cases;
}

}  // namespace

bool Stored::fails(const std::string& method) const { return std::ranges::find(tags, "fails:" + method) != tags.end(); }

Asked::Asked(const std::string& id, const std::string& file) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE}) std::signal(signal, tell_what_was_asked);
  asked = "\ncase " + id + " of " + file + "\n";
}

Asked::~Asked() { asked.clear(); }

const std::vector<Stored>& stored_cases() {
  static const std::vector<Stored> cases = read_corpus();
  return cases;
}

std::ostream& operator<<(std::ostream& out, const Stored& stored) {
  return out << "case " << stored.id << " of " << stored.file;
}

}  // namespace touchstone::corpus
