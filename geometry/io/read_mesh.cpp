// SPDX-License-Identifier: Apache-2.0
// Readers of our own, after a look at others. assimp holds coordinates as floats, and returns other geometry for some valid
// files without an error. tinyply reads a
// text number as the type that the header declares, so that a decimal of a `float` becomes a float. rply reads numbers
// in the caller's locale, and compares only the first letters of a keyword. We found none that names the line of a
// fault and can leave out one face.
#include "geometry/io/read_mesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "geometry/detail/floating_point_state.h"
#include "geometry/io/detail/legible.h"
#include "geometry/io/detail/mesh_builder.h"
#include "geometry/io/detail/mesh_source.h"

namespace touchstone {
namespace {

struct Format {
  std::string_view name;
  void (*read)(const io::MeshSource&, io::MeshBuilder&);
  std::int64_t first_vertex;
};

constexpr std::array<Format, 4> kFormats{{
    {"obj", io::read_obj, 1},
    {"off", io::read_off, 0},
    {"stl", io::read_stl, 0},
    {"ply", io::read_ply, 0},
}};

constexpr const char* kConvert = "a modelling program, such as Blender, exports other files as these";

/// Returns nothing if there is no format of that name.
const Format* find_format(std::string name) {
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  const auto* const format =
      std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& known) { return known.name == name; });
  return format == kFormats.end() ? nullptr : format;
}

const Format& format_of(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  const Format* const format = extension.empty() ? nullptr : find_format(extension.substr(1));
  if (format != nullptr) return *format;
  throw BrokenMesh(io::all_legible(file.string()) + ": unknown extension '" + io::legible(extension) +
                   "'; expected .obj, .off, .stl or .ply: " + kConvert);
}

io::MeshSource load(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) throw BrokenMesh(io::all_legible(file.string()) + ": cannot be opened: " + error.message());
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw BrokenMesh(io::all_legible(file.string()) + ": cannot be opened");
  io::MeshSource source{file.string(), std::string(static_cast<std::size_t>(size), '\0')};
  if (!stream.read(source.bytes.data(), static_cast<std::streamsize>(size)))
    throw BrokenMesh(io::all_legible(file.string()) + ": cannot be read to its end");
  return source;
}

}  // namespace

std::string io::text_of(SourceLocation place) {
  return (place.unit == SourceLocation::Unit::Line ? "line " : "byte ") + std::to_string(place.number);
}

std::string io::sentence(const std::string& file, SourceLocation place, const std::string& reason) {
  return all_legible(file) + ": " + text_of(place) + ": " + reason;
}

namespace {

ReadMesh content_of(const io::MeshSource& source, const Format& format, OnFault on_fault) {
  const FloatingPointState nearest;  // subnormal floats of binary files become doubles, too
  io::MeshBuilder builder(source, on_fault, format.first_vertex);
  builder.attempt_file([&] { format.read(source, builder); });
  return std::move(builder).finish();
}

/// Returns what was read. Throws BrokenMesh if that has no face.
ReadMesh with_faces(ReadMesh read, const std::string& name) {
  if (!read.mesh.faces.empty()) return read;
  throw BrokenMesh((read.left_out.empty() ? io::all_legible(name) + ":" : read.left_out.front() + ";") +
                   " the file has no face");
}

}  // namespace

ReadMesh io::read_content(const std::filesystem::path& file, OnFault on_fault) try {
  const Format& format = format_of(file);
  return content_of(load(file), format, on_fault);
} catch (const std::bad_alloc&) {
  throw BrokenMesh(io::all_legible(file.string()) + ": there is not enough memory to read it");
}

ReadMesh read_mesh(const std::filesystem::path& file, OnFault on_fault) {
  return with_faces(io::read_content(file, on_fault), file.string());
}

ReadMesh read_mesh(std::string content, std::string_view format, const std::string& name, OnFault on_fault) {
  const Format* const known = find_format(std::string(format));
  if (known == nullptr)
    throw BrokenMesh(io::all_legible(name) + ": unknown format '" + io::legible(format) +
                     "'; expected obj, off, stl or ply: " + kConvert);
  return with_faces(content_of({name, std::move(content)}, *known, on_fault), name);
}

}  // namespace touchstone
