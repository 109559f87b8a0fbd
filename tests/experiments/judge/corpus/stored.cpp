// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/experiments/judge/corpus/stored.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <ostream>
#include <stdexcept>

#include "experiments/judge/corpus/corpus_case.h"

namespace touchstone {
namespace {

using nlohmann::json;

template <class Enumerator>
Enumerator named(const json& name, std::initializer_list<Enumerator> all) {
  for (const Enumerator value : all)
    if (word(value) == name.get<std::string>()) return value;
  throw std::invalid_argument("unknown word " + name.dump());
}

/// Null means an infinite number.
double number(const json& value) {
  return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
}

Answer answer_of(const json& expected) {
  using Kind = Feature::Kind;
  const json &nearest = expected.at("nearest"), &point = expected.at("point");
  return {.plane = named(expected.at("plane"), {PlaneSide::InFront, PlaneSide::Behind, PlaneSide::Intersects}),
          .plane_tangent = expected.at("plane_tangent").get<bool>(),
          .foot = named(expected.at("foot"), {PointLocation::Inside, PointLocation::Boundary, PointLocation::Outside}),
          .edges_hit = expected.at("edges_hit").get<std::vector<std::size_t>>(),
          .relation = named(expected.at("relation"), {Relation::Separate, Relation::Touching, Relation::Overlapping}),
          .nearest = {named(nearest.at("kind"), {Kind::Face, Kind::Edge, Kind::Vertex}),
                      nearest.value("index", std::size_t{0})},
          .point = {number(point[0]), number(point[1]), number(point[2])},
          .distance = number(expected.at("distance")),
          .off_plane = number(expected.at("off_plane"))};
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
      Stored stored{file.stem().string(), line, read.id.value_or("without id"), std::move(read), {}, {}};
      if (std::holds_alternative<cases::Shapes>(stored.read.content) && stored.read.expected &&
          !stored.read.expected->contains("error")) {
        stored.tags = corpus::labels_of(line).tags;
        stored.answer = answer_of(*stored.read.expected);
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

}  // namespace touchstone
