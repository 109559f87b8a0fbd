// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh file of the format that the first byte chooses is refused by BrokenMesh, or read; with what is wrong left out,
// every index is one of a vertex and every number of a face finite.
#include <cstdint>
#include <stdexcept>

#include "geometry/io/read_mesh.h"
#include "tests/system/fuzz/written_file.h"

using namespace touchstone;

namespace {

void check(const Mesh& mesh) {
  for (const auto& face : mesh.faces)
    for (const std::uint32_t vertex : face) {
      if (vertex >= mesh.vertices.size()) throw std::logic_error("an index beyond the vertices");
      if (!mesh.vertices[vertex].allFinite()) throw std::logic_error("a vertex that is not finite");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const char* const names[] = {"mesh.obj", "mesh.off", "mesh.stl", "mesh.ply"};
  const auto file = fuzz_tests::written_file(names[data[0] % 4], data + 1, size - 1);
  for (const OnFault on_fault : {OnFault::Refuse, OnFault::Skip}) {
    try {
      check(read_mesh(file, on_fault).mesh);
    } catch (const BrokenMesh&) {
    }
  }
  return 0;
}
