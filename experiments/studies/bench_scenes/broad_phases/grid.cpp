// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench_scenes/broad_phases/broad_phase.h"

namespace touchstone::bench_scenes {
namespace {

/// Cells of one size, about as many as triangles, each with the triangles whose boxes meet it. Rounding is monotone:
/// what meets in space meets in cells.
class Grid {
 public:
  explicit Grid(std::span<const Triangle> triangles) : boxes_(boxes_of(triangles)), whole_(around(boxes_)) {
    if (triangles.empty()) return;
    const Eigen::Vector3d size = whole_.high - whole_.low;
    const double longest = size.maxCoeff();
    double volume = 1;
    for (int i = 0; i < 3; ++i) volume *= std::max(size[i], longest * 1e-3);
    const double side = std::cbrt(volume / static_cast<double>(triangles.size()));
    std::size_t cells = 1;
    for (int i = 0; i < 3; ++i) {
      counts_[i] = side > 0 ? static_cast<long>(std::clamp(std::ceil(size[i] / side), 1.0, 1024.0)) : 1;
      cells *= static_cast<std::size_t>(counts_[i]);
    }
    begin_.assign(cells + 1, 0);
    for (const Box& box : boxes_)
      each_cell(box, [&](std::size_t cell) {
        ++begin_[cell + 1];
        return false;
      });
    for (std::size_t i = 0; i < cells; ++i) begin_[i + 1] += begin_[i];
    numbers_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t i = 0; i < boxes_.size(); ++i)
      each_cell(boxes_[i], [&](std::size_t cell) {
        numbers_[next[cell]++] = i;
        return false;
      });
  }

  template <class Test>
  void find(const Ball& ball, const Test& test) const {
    const Box box = box_around(ball);
    if (boxes_.empty() || !meet(box, whole_)) return;
    each_cell(box, [&](std::size_t cell) {
      for (std::size_t k = begin_[cell]; k < begin_[cell + 1]; ++k)
        if (meet(boxes_[numbers_[k]], box) && test(numbers_[k])) return true;
      return false;
    });
  }

 private:
  using Cell = Eigen::Matrix<long, 3, 1>;

  [[nodiscard]] long place(double x, int i) const {
    const double size = whole_.high[i] - whole_.low[i];
    if (!(size > 0)) return 0;
    const double share = (x - whole_.low[i]) / size * static_cast<double>(counts_[i]);
    return static_cast<long>(std::clamp(share, 0.0, static_cast<double>(counts_[i] - 1)));
  }
  template <class Visit>
  void each_cell(const Box& box, const Visit& visit) const {
    Cell low, high;
    for (int i = 0; i < 3; ++i) low[i] = place(box.low[i], i), high[i] = place(box.high[i], i);
    for (long x = low[0]; x <= high[0]; ++x)
      for (long y = low[1]; y <= high[1]; ++y)
        for (long z = low[2]; z <= high[2]; ++z)
          if (visit(static_cast<std::size_t>((x * counts_[1] + y) * counts_[2] + z))) return;
  }

  std::vector<Box> boxes_;
  Box whole_;
  Cell counts_{1, 1, 1};
  std::vector<std::size_t> begin_;  // of each cell's numbers
  std::vector<std::uint32_t> numbers_;
};

}  // namespace

Library grid_library() { return broad_phase<Grid>("Uniform grid"); }

}  // namespace touchstone::bench_scenes
