// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/blocks.h"

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

namespace touchstone::run {

std::uint64_t run_blocks(std::uint64_t blocks, unsigned threads, const std::atomic<bool>& stop,
                         const Progress& progress,
                         const std::function<void(unsigned thread, std::uint64_t block)>& work) {
  std::uint64_t begun = 0, done = 0;
  const auto begin = [&](tbb::flow_control& control) -> std::uint64_t {
    if (stop || begun == blocks) {
      control.stop();
      return 0;
    }
    return begun++;
  };
  const auto run = [&](std::uint64_t block) {
    work(static_cast<unsigned>(tbb::this_task_arena::current_thread_index()), block);
  };
  // Only the count matters: blocks end in any order.
  const auto end = [&](int) { progress(++done); };

  const tbb::global_control as_many(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute([&] {
    tbb::parallel_pipeline(threads, tbb::make_filter<void, std::uint64_t>(tbb::filter_mode::serial_in_order, begin) &
                                        tbb::make_filter<std::uint64_t, int>(tbb::filter_mode::parallel,
                                                                             [&](std::uint64_t block) {
                                                                               run(block);
                                                                               return 0;
                                                                             }) &
                                        tbb::make_filter<int, void>(tbb::filter_mode::serial_out_of_order, end));
  });
  return done;
}

}  // namespace touchstone::run
