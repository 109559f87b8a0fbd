// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geometry/io/detail/legible.h"
#include "geometry/io/detail/mesh_source.h"

namespace touchstone::io {

/// Collects the vertices and faces of a file, numbered as in the file, and handles its faults.
///
/// Faces may name vertices that come later in the file; `finish` resolves their numbers.
class MeshBuilder {
 public:
  /// `first_number` is the number that the file gives to its first vertex: 0, or 1 in OBJ.
  MeshBuilder(const MeshSource& source, OnFault on_fault, std::int64_t first_number)
      : source_(source), on_fault_(on_fault), first_number_(first_number) {}

  /// Runs `read_part` and returns whether it succeeded. A fault of that part is rethrown with OnFault::Refuse and
  /// recorded with OnFault::Skip. StructureLost always propagates, to `attempt_file`.
  template <class ReadPart>
  bool attempt(ReadPart read_part) {
    try {
      read_part();
      return true;
    } catch (const StructureLost&) {
      throw;
    } catch (const BrokenMesh& fault) {
      note(fault);
      return false;
    }
  }

  /// Runs `read_file`. With OnFault::Skip a fault that arrives here is recorded, and what was read before it is kept.
  template <class ReadFile>
  void attempt_file(ReadFile read_file) {
    try {
      read_file();
    } catch (const BrokenMesh& fault) {
      note(fault);
    }
  }

  /// Adds the point that `read_point` returns. If that throws, the vertex is left out, but keeps its number in the
  /// file. A point that is not finite is the fault of a face that uses it.
  template <class ReadPoint>
  void add_vertex(SourceLocation place, ReadPoint read_point) {
    const bool was_read = attempt([&] { mesh_.vertices.push_back(read_point()); });
    if (was_read && !mesh_.vertices.back().allFinite()) not_finite_.emplace_back(number_in_mesh_.size(), place);
    number_in_mesh_.push_back(was_read ? static_cast<std::uint32_t>(mesh_.vertices.size() - 1) : kLeftOut);
  }

  /// Adds a face whose corners are vertex numbers of the file. Reports a fault if there are fewer than three.
  /// `corner_places` has the place of each corner, or none if all are at `place`.
  void add_face(SourceLocation place, std::span<const std::int64_t> corners,
                std::span<const SourceLocation> corner_places = {}) {
    if (corners.size() < 3)
      source_.broken(place, "a face needs at least 3 vertices, this one has " + std::to_string(corners.size()));
    std::vector<std::uint32_t> face;
    face.reserve(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::int64_t number = corners[i];
      if (number < first_number_ || number - first_number_ >= kLeftOut)
        out_of_range(corner_places.empty() ? place : corner_places[i], number);
      face.push_back(static_cast<std::uint32_t>(number - first_number_));
    }
    if (!corner_places.empty())
      corner_places_.emplace_back(mesh_.faces.size(), std::vector(corner_places.begin(), corner_places.end()));
    mesh_.faces.push_back(std::move(face));
    places_.push_back(place);
  }

  /// Returns the number of vertices read so far, including those left out.
  [[nodiscard]] std::size_t vertices_so_far() const { return number_in_mesh_.size(); }

  /// Records what is odd, although nothing of the mesh is missing.
  void warn(SourceLocation place, const std::string& reason) {
    warnings_.push_back(sentence(source_.name, place, reason));
  }
  /// Reports a fault if bytes are left over at the end of the file, or warns if they are blank.
  void end(const ByteReader& bytes) {
    if (bytes.bytes_left() == 0) return;
    const std::string left_over = std::to_string(bytes.bytes_left()) + (bytes.only_blanks_left() ? " blank" : "") +
                                  " bytes left over after the elements that the counts declare";
    if (!bytes.only_blanks_left()) source_.broken(bytes.place(), left_over);
    warn(bytes.place(), left_over);
  }

  /// Returns the mesh; each face has the numbers that its vertices have there.
  [[nodiscard]] ReadMesh finish() && {
    if (number_in_mesh_.size() >= kLeftOut)
      throw BrokenMesh(all_legible(source_.name) + ": more vertices than 32-bit numbers can count");
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh_.faces.size(); ++i)
      if (attempt([&] { renumber(i, mesh_.faces[i]); })) {
        if (kept != i) mesh_.faces[kept] = std::move(mesh_.faces[i]);
        places_[kept++] = places_[i];
      }
    mesh_.faces.resize(kept);
    places_.resize(kept, SourceLocation{});
    return {std::move(mesh_), std::move(places_), std::move(left_out_), parts_left_out_, std::move(warnings_)};
  }

 private:
  /// The number in the file of a vertex that is not finite, and its place.
  using NotFinite = std::pair<std::size_t, SourceLocation>;
  /// The number of a face on several lines, and the places of its corners.
  using CornerPlaces = std::pair<std::size_t, std::vector<SourceLocation>>;

  static constexpr std::uint32_t kLeftOut = std::numeric_limits<std::uint32_t>::max();

  void note(const BrokenMesh& fault) {
    if (on_fault_ == OnFault::Refuse) throw;  // the current fault
    if (parts_left_out_++ < kMostSentences) left_out_.emplace_back(fault.what());
  }

  void renumber(std::size_t index, std::vector<std::uint32_t>& face) const {
    const auto own = std::ranges::lower_bound(corner_places_, index, {}, &CornerPlaces::first);
    const bool has_own = own != corner_places_.end() && own->first == index;
    for (std::size_t i = 0; i < face.size(); ++i) {
      std::uint32_t& corner = face[i];
      const SourceLocation place = has_own ? own->second[i] : places_[index];
      const std::int64_t number = first_number_ + corner;
      if (corner >= number_in_mesh_.size()) out_of_range(place, number);
      const auto found = std::ranges::lower_bound(not_finite_, std::size_t{corner}, {}, &NotFinite::first);
      if (found != not_finite_.end() && found->first == corner)
        source_.broken(place, "the face uses vertex " + std::to_string(number) + ", whose coordinates (" +
                                  text_of(found->second) + ") are not finite doubles");
      corner = number_in_mesh_[corner];
      if (corner == kLeftOut)
        source_.broken(place, "the face uses vertex " + std::to_string(number) + ", which was left out");
    }
  }

  [[noreturn]] void out_of_range(SourceLocation place, std::int64_t number) const {
    source_.broken(place, "vertex " + std::to_string(number) +
                              " is out of range: " + std::to_string(vertices_so_far()) +
                              " vertices were read, numbered from " + std::to_string(first_number_));
  }

  const MeshSource& source_;
  OnFault on_fault_;
  std::int64_t first_number_;
  Mesh mesh_;
  std::vector<SourceLocation> places_;         // of the faces
  std::vector<std::uint32_t> number_in_mesh_;  // by number in the file
  std::vector<NotFinite> not_finite_;          // ascending
  std::vector<CornerPlaces> corner_places_;    // ascending
  std::vector<std::string> left_out_, warnings_;
  std::size_t parts_left_out_ = 0;
};

/// Reads a file like `read_mesh`, but accepts files without faces.
[[nodiscard]] ReadMesh read_content(const std::filesystem::path& file, OnFault on_fault);

// Each of these reads a file of one format into the builder. `read_mesh` documents the formats.

void read_obj(const MeshSource& source, MeshBuilder& builder);
void read_off(const MeshSource& source, MeshBuilder& builder);
void read_stl(const MeshSource& source, MeshBuilder& builder);
void read_ply(const MeshSource& source, MeshBuilder& builder);

}  // namespace touchstone::io
