// SPDX-License-Identifier: GPL-3.0-or-later
// A model file is refused by BrokenMesh, or read; written, it is read again as the same model.
#include <cstdint>
#include <stdexcept>

#include "experiments/thesis/cell/model/link_model.h"
#include "geometry/io/read_mesh.h"
#include "tests/system/fuzz/written_file.h"

using namespace touchstone;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const cell::LinkModel model = cell::read_link_model(fuzz_tests::written_file("model.txt", data, size));
    const std::string text = cell::link_model_text(model);
    const auto again =
        fuzz_tests::written_file("again.txt", reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    if (!(cell::read_link_model(again) == model)) throw std::logic_error("not read again as it was written:\n" + text);
  } catch (const BrokenMesh&) {
  }
  return 0;
}
