// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>

#include "bindings/python/answer_arrays.h"
#include "geometry/contact/answer.h"
#include "geometry/contact/first_contact.h"
#include "robust/scene/scene.h"

/// Groups of arrays that several kinds of answers have. Each adds its arrays in the order of its members.
namespace touchstone::python {

/// The kinds of features, and the numbers of their edges and vertices, which are 0 for faces.
class FeatureArrays {
 public:
  /// Adds two arrays, `name` and `name`_index.
  FeatureArrays(AnswerArrays& arrays, const std::string& name)
      : kinds_(arrays.add<Code>(name.c_str())), numbers_(arrays.add<Number>((name + "_index").c_str())) {}

  void set(std::size_t i, const Feature& feature) {
    kinds_[i] = code_of(feature.kind), numbers_[i] = static_cast<Number>(feature.index);
  }
  void set_none(std::size_t i) { kinds_[i] = kNoCode, numbers_[i] = kNoNumber; }

 private:
  std::span<Code> kinds_;
  std::span<Number> numbers_;
};

/// First contacts of motions, of which some touch nothing.
class FirstContactArrays {
 public:
  explicit FirstContactArrays(AnswerArrays& arrays)
      : kind_(arrays.add<Code>("kind")),
        time_(arrays.add<double>("time")),
        momentary_(arrays.add<bool>("momentary")),
        feature_(arrays, "feature"),
        point_(arrays.add<Eigen::Vector3d>("point")),
        contact_normal_(arrays.add<Eigen::Vector3d>("contact_normal")),
        depth_(arrays.add<double>("depth")) {}

  void set(std::size_t i, const FirstContact& first) {
    kind_[i] = code_of(first.kind), time_[i] = first.time, momentary_[i] = first.momentary;
    if (first.contact()) {
      feature_.set(i, first.feature);
      point_[i] = first.point, contact_normal_[i] = first.contact_normal, depth_[i] = first.depth;
      return;
    }
    feature_.set_none(i);
    point_[i].setConstant(kNoDouble), contact_normal_[i].setConstant(kNoDouble), depth_[i] = kNoDouble;
  }

 private:
  std::span<Code> kind_;
  std::span<double> time_;
  std::span<bool> momentary_;
  FeatureArrays feature_;
  std::span<Eigen::Vector3d> point_, contact_normal_;
  std::span<double> depth_;
};

/// The numbers of objects and faces.
class FaceArrays {
 public:
  explicit FaceArrays(AnswerArrays& arrays)
      : object_(arrays.add<Number>("object")), face_(arrays.add<Number>("face")) {}

  void set(std::size_t i, const scene::FaceId& id) { object_[i] = id.object, face_[i] = id.face; }
  void set_none(std::size_t i) { object_[i] = face_[i] = kNoNumber; }

 private:
  std::span<Number> object_, face_;
};

}  // namespace touchstone::python
