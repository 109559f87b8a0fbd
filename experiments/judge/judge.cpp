// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/judge.h"

#include "experiments/cases/input_lines.h"
#include "experiments/judge/engine_trial.h"
#include "experiments/judge/proceedings.h"

namespace touchstone::judge {

Status judge(const Order& order) {
  if (!order.engine.empty()) return order.time_limit ? judge_one_by_one(order) : judge_with_engine(order);
  Proceedings proceedings(order);
  cases::read_lines(order.files, [&](cases::Line&& line) {
    if (line.read) {
      proceedings.give_own(line);
    } else {
      proceedings.complain(line.complaint);
      proceedings.worsen(InputRejected);
    }
    return true;
  });
  return proceedings.status();
}

}  // namespace touchstone::judge
