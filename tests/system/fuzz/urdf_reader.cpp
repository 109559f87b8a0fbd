// SPDX-License-Identifier: GPL-3.0-or-later
// A URDF file is refused by BadCell, or read.
#include <cstdint>

#include "experiments/thesis/cell/model/read_urdf.h"
#include "tests/system/fuzz/written_file.h"

using namespace touchstone;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = fuzz_tests::written_file("arm.urdf", data, size);
  try {
    (void)cell::read_urdf(file, 8, {workloads::find_unit("mm"), file.parent_path()});
  } catch (const cell::BadCell&) {
  }
  return 0;
}
