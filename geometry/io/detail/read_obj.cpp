// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ: `v x y z` and `f 1 2 3`. A corner may have `/texture/normal`, which are ignored.
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/io/detail/mesh_builder.h"
#include "geometry/io/detail/text_reader.h"

namespace touchstone::io {
namespace {

/// Takes a corner and returns its vertex number (from 1), for corners such as `7`, `7/1`, `7//2` or `-1/1/2`.
std::int64_t take_corner(TextReader& lines, std::size_t vertices_so_far) {
  const std::string_view field = lines.take();
  const std::optional<std::int64_t> number = whole_number(field.substr(0, field.find('/')));
  if (!number) lines.broken(TextReader::quoted(field) + " is not a corner of a face");
  if (*number >= 0) return *number;
  const std::int64_t from_start = static_cast<std::int64_t>(vertices_so_far) + 1 + *number;
  if (from_start < 1)
    lines.broken("vertex " + std::to_string(*number) + " is out of range: " + std::to_string(vertices_so_far) +
                 " vertices come before it");
  return from_start;
}

/// Keywords of the format that do not concern vertices and polygons.
constexpr std::string_view kPassedOver[] = {
    "vt",     "vn",     "vp",    "p",        "l",        "g",    "s",          "o",         "mg",   "usemtl", "mtllib",
    "usemap", "maplib", "bevel", "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj", "deg",  "bmat",   "step",
    "cstype", "curv",   "curv2", "surf",     "parm",     "trim", "hole",       "scrv",      "sp",   "end",    "con",
    "call",   "csh",    "bzp",   "bsp",      "cdc",      "cdp",  "res",        "ctech",     "stech"};

bool is_passed_over(std::string_view word) {
  return std::find(std::begin(kPassedOver), std::end(kPassedOver), word) != std::end(kPassedOver);
}

}  // namespace

void read_obj(const MeshSource& source, MeshBuilder& builder) {
  TextReader lines(source, {.comments = true, .continuations = true});
  std::vector<std::int64_t> corners;
  while (lines.next_line()) {
    const std::string_view keyword = lines.take();
    if (keyword == "v") {
      builder.add_vertex([&] {
        Eigen::Vector3d point = lines.take_point("after 'v'");
        lines.rest_is_numbers();  // a weight or a colour
        return point;
      });
    } else if (keyword == "f" || keyword == "fo") {
      builder.attempt([&] {
        corners.clear();
        while (!lines.line_is_done()) corners.push_back(take_corner(lines, builder.vertices_so_far()));
        builder.add_face(lines.place(), corners);
      });
    } else if (!is_passed_over(keyword)) {
      builder.pass_over(lines.place(), TextReader::quoted(keyword) + " is not an OBJ keyword");
    }
  }
}

}  // namespace touchstone::io
