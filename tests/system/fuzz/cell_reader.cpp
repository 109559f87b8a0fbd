// SPDX-License-Identifier: GPL-3.0-or-later
// A cell file beside the arms that are ours is refused by BadCell, or read.
#include <cstdint>
#include <filesystem>

#include "experiments/thesis/cell/model/read_cell.h"
#include "tests/system/fuzz/written_file.h"

using namespace touchstone;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = fuzz_tests::written_file("cell.json", data, size);
  for (const char* arm : {"aristo.urdf", "melfa.urdf"}) {
    const auto copy = file.parent_path() / arm;
    if (!std::filesystem::exists(copy))
      std::filesystem::copy_file(std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / "experiments/thesis/cell/cells" / arm,
                                 copy);
  }
  try {
    (void)cell::read_cell(file);
  } catch (const cell::BadCell&) {
  }
  return 0;
}
