// SPDX-License-Identifier: GPL-3.0-or-later
// What no program can compute: drawings without a number, screens of a program that is not public, photographs. Where
// a photograph's caption states an angle, the arm's here stands beside it.
#include <fmt/core.h>

#include "experiments/thesis/figures/entries.h"

namespace touchstone::figures {
namespace {

using namespace kinematics;

std::string photograph(std::string_view virtual_figure) {
  return fmt::format(
      "A photograph of the real cell. The angle in its caption is that of Fig. {}, where our arm's pose is drawn.",
      virtual_figure);
}

}  // namespace

void add_diagrams_and_photographs(const Study& study, EntryList& entries) {
  entries.add("2.1", Status::NotComputable,
              "A drawing in a survey of kinds of flexible manufacturing systems. Its caption names no number, and the "
              "chapter is not public.",
              {});
  entries.add("3.1", Status::NotComputable,
              "A drawing of the method's steps. The table of contents names three: the virtual environment, the "
              "algorithm, the algorithm in the environment. There is nothing in it to compute.",
              {});
  entries.add("5.1", Status::NotComputable,
              "A drawing of how the system is thought of. Its caption names no number; what our cell consists of is "
              "under Fig. 5.6.",
              {});
  entries.add("5.3", Status::Photograph, "A photograph of the real cell, without a number in its caption.", {});
  entries.add(
      "5.4", Status::Photograph,
      "A photograph of the milling machine, without a number in its caption. Ours is a model with chosen sizes: "
      "Table 5.2.",
      {});
  entries.add("5.16", Status::WithChosen,
              "The screen of the thesis's program is not public. Ours is the page of `touchstone cell serve`, with the "
              "same cell and case 1. What its configuration window is for is under Fig. 5.17.",
              {},
              "The page of the cell: the run in perspective and beside it a close view of the gripper, which puts the "
              "material into the machine; the answer at this stop; the plan, in which the storage can be dragged.");

  const auto& [first, second] = study.cases;
  entries.add("6.3", Status::Photograph,
              "A photograph of the real cell. Its storage stands as in Fig. 6.2, where ours is drawn.",
              {set_angle("angle of the storage", study.cell.storage.angle, 1)});
  entries.add("6.5", Status::Photograph, photograph("6.4"), {captioned("elbow down", -moved(first, 0, kElbow), 3)});
  entries.add("6.8", Status::Photograph, photograph("6.7"),
              {captioned("base clockwise", -moved(first, 1, kBase), 149)});
  entries.add("6.12", Status::Photograph, photograph("6.11"), {captioned("elbow up", moved(first, 2, kElbow), 38)});
  entries.add("6.15", Status::Photograph, photograph("6.14"),
              {captioned("shoulder down", moved(first, 4, kShoulder), 28)});
  entries.add("6.21", Status::Photograph, photograph("6.20"), {captioned("elbow up", moved(second, 0, kElbow), 12)});
  entries.add("6.24", Status::Photograph, photograph("6.23"),
              {captioned("base clockwise", -moved(second, 1, kBase), 183),
               captioned("shoulder down", moved(second, 2, kShoulder), 25)});
  entries.add("6.26", Status::Photograph, photograph("6.25"), {captioned("elbow up", moved(second, 4, kElbow), 23)});
  entries.add("6.29", Status::Photograph,
              photograph("6.28") + " Its \"storage\" must be the machine, to which these moves lead.",
              {captioned("base counter-clockwise", moved(second, 5, kBase), 100),
               captioned("shoulder down", moved(second, 6, kShoulder), 14)});
}

}  // namespace touchstone::figures
