// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/gil.h>

#include <cstdint>
#include <mutex>
#include <shared_mutex>
#include <variant>
#include <vector>

#include "bindings/python/fair_shared_mutex.h"
#include "bindings/python/words.h"
#include "robust/mesh/scene_faces.h"
#include "robust/scene/scene.h"

namespace touchstone::python {

/// A scene, and what each of its objects was made of.
struct HeldScene : scene::Scene {
  struct Source {
    std::vector<std::uint32_t> numbers;        ///< for each face of the object, its number in what was added
    std::vector<mesh::RejectedFace> left_out;  ///< the faces of what was added that are not in the object
    std::vector<mesh::SegmentFace> segments;   ///< those that are taken as segments
  };
  std::vector<Source> sources;
};

/// A scene that Python threads may ask and change at once: questions share it, a change has it alone. Each waits for
/// what was asked before it, and for nothing later. Both release the interpreter, also while they wait.
class SharedScene {
 public:
  /// Returns f(scene).
  template <class F>
  auto ask(const F& f) const {
    const pybind11::gil_scoped_release release;
    const std::shared_lock lock(mutex_);
    return f(scene_);
  }
  /// Returns f(scene), which may change it.
  template <class F>
  auto change(const F& f) {
    const pybind11::gil_scoped_release release;
    const std::unique_lock lock(mutex_);
    return f(scene_);
  }

 private:
  mutable FairSharedMutex mutex_;
  HeldScene scene_;
};

/// An object's number or name.
using ObjectKey = std::variant<std::uint32_t, Name>;

[[nodiscard]] inline std::uint32_t number_of(const scene::Scene& scene, const ObjectKey& key) {
  if (const auto* const number = std::get_if<std::uint32_t>(&key)) return *number;
  return scene.find(std::get<Name>(key).utf8);
}

}  // namespace touchstone::python
