// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/answer_arrays.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <string>

namespace touchstone::python {

namespace py = pybind11;

namespace {

py::object class_of_package(const char* name) { return py::module_::import("touchstone_contact").attr(name); }

/// Returns whether two arrays in C order share memory.
bool overlap(const py::array& a, const py::array& b) {
  const auto* const first = static_cast<const char*>(a.data());
  const auto* const second = static_cast<const char*>(b.data());
  return first < second + b.nbytes() && second < first + a.nbytes();
}

}  // namespace

AnswerArrays::AnswerArrays(std::size_t count, bool single, py::object out, py::array asked, const char* kind)
    : count_(count), out_(std::move(out)), asked_(std::move(asked)), kind_(kind) {
  if (out_.is_none()) return;
  if (single) throw py::value_error("out: it takes the answers of a batch, not of one question");
  if (kind_ != nullptr && !py::isinstance(out_, class_of_package(kind_)))
    throw py::type_error(std::string("out: expected what the same question returned, of class ") + kind_ + ", got " +
                         py::str(py::type::of(out_)).cast<std::string>());
}

py::object AnswerArrays::out_of(const char* field) const {
  return out_.is_none() || kind_ == nullptr ? out_ : py::object(out_.attr(field));
}

void AnswerArrays::expect(const char* field, py::handle given, const py::dtype& type, bool in_order,
                          const std::vector<py::ssize_t>& shape) const {
  const std::string name = field == nullptr ? "out" : std::string("out.") + field;
  const bool masked = py::isinstance(given, py::module_::import("numpy").attr("ma").attr("MaskedArray"));
  if (!py::isinstance<py::array>(given) || masked)
    throw py::type_error(name + ": expected an array, got " + py::str(py::type::of(given)).cast<std::string>());
  const auto array = py::reinterpret_borrow<py::array>(given);
  if (!array.dtype().equal(type))
    throw py::type_error(name + ": expected an array of " + py::str(py::handle(type)).cast<std::string>() + ", got " +
                         py::str(array.dtype()).cast<std::string>());
  if (!std::equal(shape.begin(), shape.end(), array.shape(), array.shape() + array.ndim()))
    throw py::value_error(name + ": expected the shape " + py::str(py::tuple(py::cast(shape))).cast<std::string>() +
                          ", got " + py::str(given.attr("shape")).cast<std::string>());
  if (!in_order || (array.flags() & py::detail::npy_api::NPY_ARRAY_ALIGNED_) == 0 || !array.writeable())
    throw py::value_error(name + ": the array must be in C order, aligned and writable");
  const auto shares = [&](py::handle other) {
    return py::isinstance<py::array>(other) && overlap(array, py::reinterpret_borrow<py::array>(other));
  };
  if (shares(asked_) || std::any_of(results_.begin(), results_.end(), shares))
    throw py::value_error(name + ": the array shares memory with another array of the call");
}

py::object AnswerArrays::result() const {
  if (kind_ == nullptr) return results_.front();
  py::tuple fields(results_.size());
  for (std::size_t i = 0; i < results_.size(); ++i) fields[i] = results_[i];
  return class_of_package(kind_)(*fields);
}

py::object hits_of(const std::vector<std::vector<std::size_t>>& lists) {
  const py::array indptr = indptr_of(lists);
  py::array_t<Number> numbers(static_cast<const Number*>(indptr.data())[lists.size()]);
  Number* number = numbers.mutable_data();
  for (const auto& list : lists) number = std::copy(list.begin(), list.end(), number);
  return class_of_package("Hits")(indptr, numbers);
}

}  // namespace touchstone::python
