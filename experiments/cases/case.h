// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "experiments/cases/key.h"
#include "experiments/cases/method.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/rejection.h"

namespace touchstone::cases {

/// A valid ball, at a place or moving, and a valid polygon: input for every method.
struct Shapes {
  Question question;
  Polygon polygon;

  /// Returns the ball; of one that moves, at its start.
  [[nodiscard]] const Ball& ball() const { return ball_of(question); }
  /// Returns nothing for a ball at a place.
  [[nodiscard]] const Motion* motion() const { return std::get_if<Motion>(&question); }
};

/// A valid ball, at a place or moving, and a mesh: input for every method.
struct MeshShapes {
  Question question;
  PosedMesh mesh;
};

/// A question about a polygon or a mesh.
using AnyShapes = std::variant<Shapes, MeshShapes>;
[[nodiscard]] const Question& question_of(const AnyShapes& shapes);
/// Returns the polygon, or the posed faces of the mesh.
[[nodiscard]] std::span<const Polygon> faces_of(const AnyShapes& shapes);
/// Returns the question about a ball with another radius.
[[nodiscard]] AnyShapes with_radius(AnyShapes shapes, double radius);
/// Prepares the polygon or the mesh.
[[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Method& method, const AnyShapes& shapes);

/// @{
/// Returns the exact answer with all its keys. About a mesh it compares the exact distances or times of all faces.
[[nodiscard]] PartialAnswer exact_answer(const Shapes& shapes);
[[nodiscard]] PartialAnswer exact_answer(const MeshShapes& shapes);
[[nodiscard]] PartialAnswer exact_answer(const AnyShapes& shapes);
/// @}

/// One line of a file of cases, read according to the contract.
struct Case {
  std::optional<std::string> id;         ///< absent only from malformed cases
  std::optional<StatedAnswer> expected;  ///< keys of an answer, or `error`; absent if malformed
  /// The message of the rejection names the loop, vertex or edge, or the face.
  std::variant<Shapes, MeshShapes, Rejection> content;
  std::vector<std::string> tags{};  ///< empty if malformed
  bool rewritten = false;  ///< whether engines are to read it otherwise: its loops repeat their first point at the end,
                           ///< or its mesh is a file

  /// Returns the content of a case that is not rejected.
  [[nodiscard]] AnyShapes shapes() const;
};

/// Reads one case and reports the first rejection of the contract that applies, in the order of the contract.
///
/// A case has a `polygon` or a `mesh`. A mesh that is a file has its path from `folder`, unless that is absolute; a
/// fault of the file makes the case malformed. Numbers are read as the nearest doubles; a number beyond the finite
/// doubles is `not-finite`. Besides `id`, `ball`, `motion`, `polygon`, `mesh`, `pose`, `expected` and `tags`, unknown
/// keys are allowed and ignored. If `polygon.closed` is true, each loop ends with its first point again, as in GeoJSON;
/// a loop that does not is malformed. Within `expected`, an unknown key makes the case malformed. A duplicate key
/// anywhere, or arrays and objects nested deeper than kMostLevels, also make it malformed. Throws NotJson. Cost: that
/// of exact::validate, of each face of a mesh, plus time linear in the length of the line.
[[nodiscard]] Case read_case(std::string_view line, const std::filesystem::path& folder = {});

/// A line of input: a case, or the reason why it could not be read.
struct Line {
  std::string text;
  std::string place;  ///< `FILE: line NUMBER`; empty for a file that cannot be read
  std::optional<Case> read;
  std::string complaint;  ///< set if the line is not JSON or the file cannot be read
  std::string file{};     ///< the name of the file, or `standard input`
  std::uint64_t end = 0;  ///< the number of bytes read up to the end of the line, of all files
};

/// The lines of files, one after the other, that are not blank. A file that cannot be read is a line, too.
class LineReader {
 public:
  /// Without files, reads standard input.
  explicit LineReader(std::vector<std::string> files);
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  /// Returns the next line without its case; nothing at the end.
  [[nodiscard]] std::optional<Line> next();
  /// Returns the next line with its case.
  [[nodiscard]] std::optional<Line> next_case();

 private:
  std::vector<std::string> files_;
  std::size_t opened_ = 0;  ///< files
  std::ifstream file_;
  std::istream* stream_ = nullptr;  ///< what is read now
  std::string name_;                ///< of that
  std::uint64_t number_ = 0, bytes_ = 0;
};

/// How many lines files have, and a hash of them: parts of a run are of the same lines.
struct LineCount {
  std::uint64_t lines = 0;
  std::size_t hash = 0;
  std::vector<std::string> meshes{};  ///< the paths of the mesh files that the lines name, sorted
};
/// Counts the lines without reading meshes or checking cases.
[[nodiscard]] LineCount count_lines(const std::vector<std::string>& files);

}  // namespace touchstone::cases
