// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/sweep.h"

#include <fmt/core.h>

#include "experiments/program/words.h"

#ifndef TOUCHSTONE_WITHOUT_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>
#endif

namespace touchstone::program {

#ifdef TOUCHSTONE_WITHOUT_TBB

std::uint64_t run_blocks(std::uint64_t blocks, unsigned, const std::atomic<bool>& stop, const Progress& progress,
                         const std::function<void(unsigned thread, std::uint64_t block)>& work) {
  std::uint64_t done = 0;
  while (done < blocks && !stop) {
    work(0, done);
    progress(++done);
  }
  return done;
}

#else

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

#endif

std::uint64_t run_items(std::uint64_t items, std::uint64_t block, unsigned threads, const RunControl& control,
                        const std::function<void(unsigned thread, std::uint64_t item)>& work) {
  const std::uint64_t first = control.part.first(items), size = control.part.size(items);
  const std::uint64_t blocks = size / block + (size % block > 0 ? 1 : 0);
  const auto begin = [&](std::uint64_t number) { return number == blocks ? size : number * block; };
  const std::uint64_t done = run_blocks(
      blocks, threads, control.stop, [&](std::uint64_t finished) { control.progress(begin(finished)); },
      [&](unsigned thread, std::uint64_t number) {
        for (std::uint64_t n = begin(number); n < begin(number + 1); ++n) work(thread, first + n);
      });
  return begin(done);
}

std::optional<Part> Part::read(const std::string& text) {
  const auto slash = std::min(text.find('/'), text.size());
  const auto number = read_whole_number(text.substr(0, slash));
  const auto of = read_whole_number(slash < text.size() ? text.substr(slash + 1) : "");
  if (!number || !of || *number < 1 || *number > *of || *of > kMostParts) return std::nullopt;
  return Part{*number, *of};
}

std::string to_string(const Part& part) { return fmt::format("{}/{}", part.number, part.of); }

}  // namespace touchstone::program
