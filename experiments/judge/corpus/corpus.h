// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cases/case.h"
#include "experiments/cases/key.h"
#include "experiments/cases/method.h"
#include "experiments/program/sweep.h"

// Cases with certified answers: what they are, those of tests/corpus, their check, and smaller ones that fail likewise.
namespace touchstone::corpus {

/// A valid ball, at a place or moving, a valid polygon or mesh, and their origin.
struct CorpusCase {
  std::string id;
  cases::AnyShapes shapes;
  std::vector<std::string> tags;
  std::string origin;  ///< the command that draws it again, or the reason why it was made
};

/// Returns whether the value of the key is yes or no, a choice or a count. Inexact methods nearly always miss the last
/// bit of `point`, `distance` and `time`.
[[nodiscard]] bool is_decisive(const cases::Key& key);

/// The keys that a method gets wrong, in the order of the contract, and its answer.
struct WrongAnswer {
  std::vector<cases::Key> keys;
  cases::PartialAnswer answer;
};

/// Compares the answer of the method with the truth. Keys that it omits or is unsure about are not wrong, nor is a
/// method that cannot answer about moving balls. If it throws, all keys are wrong, and the answer has none.
[[nodiscard]] WrongAnswer wrong_answer(const cases::Method& method, const cases::AnyShapes& shapes,
                                       const cases::PartialAnswer& truth);

/// Returns whether one of these keys is decisive.
[[nodiscard]] bool any_decisive(const std::vector<cases::Key>& keys);

/// Returns the methods that the corpus was chosen to fail: floating-point numbers of several kinds, the thesis, and
/// third-party kernels. Every build has all of them.
[[nodiscard]] const std::vector<const cases::Method*>& witnesses();
/// Returns the witnesses that get a decisive key wrong.
[[nodiscard]] std::vector<const cases::Method*> failing_witnesses(const cases::AnyShapes& shapes,
                                                                  const cases::PartialAnswer& truth);

/// Returns the case in the form of the contract with its whole answer, the tag `fails:NAME` for each failing witness,
/// and `origin`, as one line.
[[nodiscard]] std::string line_of(const CorpusCase& given, const cases::PartialAnswer& truth);

/// `origin` and `tags` of a line that cases::read_case accepts; empty where they are missing.
struct Labels {
  std::vector<std::string> tags;
  std::string origin;
};
[[nodiscard]] Labels labels_of(std::string_view line);

/// Returns whether every coordinate and the radius is a float, and a mesh has no pose.
[[nodiscard]] bool is_in_floats(const cases::AnyShapes& shapes);

/// Returns a case like this one whose coordinates and radius are floats.
///
/// Every coordinate becomes the nearest float, of a mesh that of its posed vertices. If the radius is within 2^-40 of
/// the one at which the ball begins to touch, relatively, it becomes the least float with which the ball touches, or a
/// neighbour of that: the last float without contact, or the next one with it, by the case's id, unless a point touches
/// already. Any other radius becomes the nearest float. `origin` says how the case was made. A case that is in floats
/// stays as it is. The id ends with `-float` in either case.
///
/// Returns nothing if a number is beyond the floats, if the contract rejects the rounded polygon or mesh, if the ball
/// then touches with no float as its radius, or if rounding moves vertices off a plane from which they were off by
/// 2^-30 sizes of the polygon at most: an engine that does not lift vertices would be asked about another polygon.
[[nodiscard]] std::optional<CorpusCase> in_floats(CorpusCase given);

/// The version of the corpus, raised whenever a case is added, changes or is removed.
inline constexpr int kVersion = 9;
/// The maximal size of a file, because people read it.
inline constexpr std::size_t kMostBytes = 350'000;

/// The numbers of the cases: any doubles, or floats alone (see in_floats).
enum class Numbers { Doubles, Floats };

/// One file of the corpus, or two: one of doubles and one of floats.
struct Family {
  std::string_view name;         ///< of the file, without `.jsonl`
  std::string_view subject;      ///< what it tests
  std::string (*text)(Numbers);  ///< its lines; empty if the family has no cases in these numbers
};

/// Returns the families in the order of the page that describes them.
///
/// A text is always the same: cases are drawn as functions of (seed, index), or read from
/// experiments/judge/corpus/given. It holds the exact answers. Texts throw std::runtime_error, which names the file and
/// line, if a given case cannot be used, and std::logic_error if a text is larger than kMostBytes. (Some cases of
/// `soak` are drawn in long doubles: those of x86-64.)
[[nodiscard]] const std::vector<Family>& all_families();

/// Draws a ball, which moves or not, near a feature of a small mesh: a box of squares or of triangles, a prism over an
/// L, a terrain on a grid, or a flat grid of triangles; half of them under a pose. The radius of a ball at a place is
/// the distance, or a double beside it. One that moves is to graze the mesh, or to come down on it. Vertices, centres
/// and ends are small integers and quarters, so that ties of faces are exact where there is no pose. Nothing if a posed
/// face is rejected, or if the centre is on the mesh. A function of its arguments.
[[nodiscard]] std::optional<CorpusCase> draw_mesh_case(std::uint64_t seed, std::uint64_t index, bool moves);

/// Returns every file of the corpus by its name: `FAMILY.jsonl`, `floats/FAMILY.jsonl`, `corpus.json` (version and
/// counts) and the page README.md. The result does not depend on the number of threads. Throws the exceptions of the
/// texts of families, and std::logic_error if a file is too large or an id is not unique.
[[nodiscard]] std::map<std::string, std::string> make_corpus(unsigned threads);

/// The result of a check: the number of cases, and the faults as sentences that name file, line, case and key. A check
/// that was stopped has those of the first cases.
struct Findings {
  std::size_t cases = 0;
  std::vector<std::string> faults;
};

/// Derives the whole answer of every case by `exact` and by `filtered`, and every rejection of loops; all must agree with
/// the expectation of the case. A missing key, an id that is not unique among all
/// files, and a line that is not a case are faults; the check continues with the other cases.
///
/// A part checks its share of the lines. It reads the ids of the lines before, so that the findings of all parts add up
/// to those of one check.
[[nodiscard]] Findings check_files(const std::vector<std::string>& files, program::Part part,
                                   const std::atomic<bool>& stop, const program::Progress& progress);

/// The amount to read in a case; compared member by member.
struct Size {
  std::size_t loops = 0;                  ///< or the faces of a mesh, and one for its pose
  std::size_t vertices = 0, corners = 0;  ///< corners of the faces of a mesh
  /// The bits of all coordinates, that of a moving ball's end too, and of the radius, each m 2^e with odd m: the bits
  /// of m and of e, and one for a minus sign. A zero counts 0.
  std::size_t bits = 0;

  friend auto operator<=>(const Size&, const Size&) = default;  // NOLINT(modernize-use-nullptr)
};
[[nodiscard]] Size size_of(const cases::AnyShapes& shapes);

/// The condition that a reduced case must meet. A case that fails in decisive keys (is_decisive) must still fail in all
/// of them; if their values are words, the true and the given words must stay: a missed overlap does not become a
/// missed touch. A case that fails only in keys of numbers, such as `point` or `time`, must still fail in all of these,
/// and in no decisive key. A moving ball stays a moving one, and it first touches at the start, on the way or never, as
/// it did.
class SameFailure {
 public:
  /// Considers all keys that the method gets wrong, or only the named one. Requires the preconditions of the method.
  /// Throws std::invalid_argument if the method gets none of them wrong.
  SameFailure(const cases::Method& method, const cases::AnyShapes& shapes,
              const std::optional<std::string>& key = std::nullopt);

  /// Returns the keys that must stay wrong.
  [[nodiscard]] const std::vector<cases::Key>& keys() const { return keys_; }
  /// Returns whether the case, which need not be valid, fails in the same way.
  [[nodiscard]] bool holds(const cases::AnyShapes& shapes) const;

 private:
  const cases::Method& method_;
  std::vector<cases::Key> keys_;
  std::vector<std::string> true_words_, given_words_;  // a key each
  std::string true_first_;                             // of a moving ball
  bool nothing_decisive_;
};

/// Returns a smaller case that fails in the same way, by delta debugging. It leaves out loops and vertices, or the
/// pose, faces and corners of a mesh, in halves, quarters and so on down to single ones; moves everything towards the
/// origin, scales by powers of two and mirrors; removes bits of numbers, first of all numbers on one grid, then of each
/// number, and exponents. Each step is also tried with the radius at the same number of doubles from the new distance
/// as it was from the old one; of a moving ball, from the least radius that touches.
///
///  (1) The result is valid by the contract and fails in the same way.
///  (2) Its size is not larger, and is smaller unless the case is the same.
///  (3) Shrinking the result gives the result.
///  (4) It depends on the arguments alone.
/// If `stop` became true, (3) does not hold. Cost: some thousand queries to the method and to `exact`.
/// Source: [zeller2002].
[[nodiscard]] cases::AnyShapes shrink(const SameFailure& failure, const cases::AnyShapes& shapes,
                                      const std::atomic<bool>& stop);

}  // namespace touchstone::corpus
