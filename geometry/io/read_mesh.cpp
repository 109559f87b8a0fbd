// SPDX-License-Identifier: Apache-2.0
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
  std::string_view extension;
  void (*read)(const io::MeshSource&, io::MeshBuilder&);
  std::int64_t first_vertex;
};

constexpr std::array<Format, 4> kFormats{{
    {".obj", io::read_obj, 1},
    {".off", io::read_off, 0},
    {".stl", io::read_stl, 0},
    {".ply", io::read_ply, 0},
}};

const Format& format_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  const auto* const format =
      std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& known) { return known.extension == extension; });
  if (format == kFormats.end())
    throw BrokenMesh(io::all_legible(file.string()) + ": unknown extension '" + io::legible(extension) +
                     "'; expected .obj, .off, .stl or .ply");
  return *format;
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

std::string io::sentence(const std::string& file, SourceLocation place, const std::string& reason) {
  return all_legible(file) + (place.unit == SourceLocation::Unit::Line ? ": line " : ": byte ") +
         std::to_string(place.number) + ": " + reason;
}

ReadMesh io::read_content(const std::filesystem::path& file, OnFault on_fault) try {
  const FloatingPointState nearest;  // subnormal floats of binary files become doubles, too
  const Format& format = format_of(file);
  const io::MeshSource source = load(file);
  io::MeshBuilder builder(source, on_fault, format.first_vertex);
  builder.attempt_file([&] { format.read(source, builder); });
  return std::move(builder).finish();
} catch (const std::bad_alloc&) {
  throw BrokenMesh(io::all_legible(file.string()) + ": there is not enough memory to read it");
}

ReadMesh read_mesh(const std::filesystem::path& file, OnFault on_fault) {
  ReadMesh read = io::read_content(file, on_fault);
  if (!read.mesh.faces.empty()) return read;
  throw BrokenMesh((read.left_out.empty() ? io::all_legible(file.string()) + ":" : read.left_out.front() + ";") +
                   " the file has no face");
}

}  // namespace touchstone
