// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/kinematics/layout_output.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/harness/write_file.h"

namespace touchstone::kinematics {
namespace {

constexpr std::array<const char*, 6> kJoints{"base", "shoulder", "elbow", "wrist roll", "wrist pitch", "hand roll"};

/// Returns the names of moves in the captions of a case, in the order of the moves.
std::vector<std::string> captions_of(std::size_t number) {
  if (number == 0)
    return {"elbow down 3", "base 149 CW; contact", "elbow up 38", "base 66", "shoulder down 28; contact"};
  return {"elbow up 12", "base 183 CW",  "shoulder down 25; contact", "not captioned (11 derived)",
          "elbow up 23", "base 100 CCW", "shoulder down 14"};
}

/// In a field of CSV.
std::string quoted(const std::string& text) { return "\"" + text + "\""; }

std::string family_text(const std::vector<Member>& members) {
  std::string text =
      "coupling,lean_deg,elevation_deg,storage_radius_1_mm,storage_radius_2_mm,storage_height_1_mm,storage_height_2_mm,"
      "machine_radius_mm,machine_height_mm,gap_mm,clearance_mm,captions_come_out,otherwise\n";
  for (const Member& m : members) {
    const std::string home = fmt::format("{},{:.6f},{:.6f}", to_string(m.coupling), m.home.lean, m.home.elevation);
    std::string values(7, ',');
    if (m.layout) {
      const Layout& l = *m.layout;
      values = fmt::format("{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}", l.storage_radius[0],
                           l.storage_radius[1], l.storage_height[0], l.storage_height[1], l.machine_radius,
                           l.machine_height, l.gap, l.clearance);
    }
    text += fmt::format("{},{},{},{}\n", home, values, m.failure.empty() ? "yes" : "no", quoted(m.failure));
  }
  return text;
}

std::string choice_text(const LayoutStudy& study) {
  std::string text = "name,value,unit,label,lowest,highest\n";
  text += fmt::format("coupling,{},,C,,\n", to_string(study.chosen.coupling));
  text += "way to the material,from the side where the shoulder can stay; else from above; else from the side,,C,,\n";
  const Chain chain = aristo(study.chosen.coupling);
  for (const Joint& joint : chain.joints())
    text += fmt::format("limits of {} in degrees,{:g} to {:g},,C,,\n", joint.name, joint.lowest, joint.highest);
  for (const Choice& c : study.choices)
    text += fmt::format("{},{:.4g},{},C,{:.3f},{:.3f}\n", c.name, c.value, c.unit, c.lowest, c.highest);
  return text;
}

std::string moves_text(const LayoutStudy& study) {
  std::string text =
      "case,move,caption,joint,until,degrees,exact_deg,margin_deg,contact_low_deg,contact_high_deg,kind,feature\n";
  for (std::size_t number = 0; number < study.cases.size(); ++number) {
    const auto captions = captions_of(number);
    const auto& moves = study.cases[number].moves;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const Move& m = moves[i];
      text += fmt::format("{},{},{},{},{},{},{:.6f},{:.6f}", number + 1, i + 1, quoted(captions.at(i)),
                          kJoints[m.joint], to_string(m.until), m.degrees, m.exact, m.margin);
      text += m.contact ? fmt::format(",{:.17g},{:.17g},{},{}\n", m.contact->low, m.contact->high,
                                      to_string(m.contact->kind), to_string(m.contact->feature.kind))
                        : ",,,,\n";
    }
  }
  return text;
}

std::string predictions_text(const std::vector<Prediction>& predictions) {
  std::string text =
      "place,storage_angle_deg,storage_height_mm,elbow_to_storage,base_to_storage,shoulder_to_storage,lift,"
      "base_to_machine,net_elbow,net_shoulder,least_margin_deg,otherwise\n";
  for (const Prediction& p : predictions) {
    const SimulatedPath& r = p.path;
    text += fmt::format("{},{:g},{:g}", p.place + 1, p.angle, p.height);
    if (!r.complete()) {
      text += fmt::format(",,,,,,,,,{}\n", quoted(r.failure));
      continue;
    }
    const double margin = std::ranges::min_element(r.moves, {}, &Move::margin)->margin;
    const auto lift = std::ranges::find(r.moves, Until::Cleared, &Move::until);
    text += fmt::format(",{},{},{},{},{},{},{},{:.6f},\n", r.to_storage(kElbow), r.to_storage(kBase),
                        r.to_storage(kShoulder), lift == r.moves.end() ? 0 : lift->degrees,
                        r.net(kBase) - r.to_storage(kBase), r.net(kElbow), r.net(kShoulder), margin);
  }
  return text;
}

std::string poses_text(const LayoutStudy& study) {
  std::string text = "case,moment,point,out_mm,up_mm\n";
  const Layout& layout = study.chosen;
  const Chain chain = aristo(layout.coupling);
  for (std::size_t number = 0; number < study.cases.size(); ++number) {
    Angles angles = home_pose(layout);
    const auto draw = [&](const char* moment) {
      Angles in_plane = angles;
      in_plane[kBase] = 0;
      const auto frames = chain.frames(in_plane);
      const auto point = [&](const char* name, const Eigen::Vector3d& at) {
        text += fmt::format("{},{},{},{:.4f},{:.4f}\n", number + 1, moment, name, at.x(), at.z());
      };
      point("shoulder", frames[kShoulder].translation);
      point("elbow", frames[kElbow].translation);
      point("wrist", frames[kWristPitch].translation);
      point("flange", frames.back().translation);
      point("sphere", chain.place(in_plane, sphere_center(layout)));
    };
    draw("home");
    int contacts = 0;
    for (const Move& m : study.cases[number].moves) {
      angles[m.joint] += m.degrees;
      if (m.until == Until::Contact) draw(++contacts == 1 ? "storage" : "machine");
    }
  }
  return text;
}

/// Returns the number of predictions that satisfy what the captions imply for every angle.
std::size_t kept(const std::vector<Prediction>& predictions) {
  return static_cast<std::size_t>(std::ranges::count_if(predictions, [](const Prediction& p) {
    const SimulatedPath& r = p.path;
    return r.complete() && r.to_storage(kBase) == kStorageHome + p.angle && r.net(kBase) == kMachineAzimuth &&
           r.net(kElbow) == 35 && r.net(kShoulder) == 28;
  }));
}

}  // namespace

void write_layout(const std::filesystem::path& folder, const LayoutStudy& study) {
  harness::write_file(folder / "family.csv", family_text(study.grid));
  harness::write_file(folder / "one_height.csv", family_text(study.one_height));
  harness::write_file(folder / "choice.csv", choice_text(study));
  harness::write_file(folder / "moves.csv", moves_text(study));
  harness::write_file(folder / "angles.csv", predictions_text(study.angles));
  harness::write_file(folder / "heights.csv", predictions_text(study.heights));
  harness::write_file(folder / "poses.csv", poses_text(study));
}

std::string layout_table(const LayoutStudy& study) {
  std::string text;
  for (std::size_t number = 0; number < study.cases.size(); ++number) {
    text += fmt::format("case {}: storage at {:+g} degrees\n", number + 1, kCases[number].storage_angle);
    const auto captions = captions_of(number);
    const auto& moves = study.cases[number].moves;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const Move& m = moves[i];
      text += fmt::format("  {:<28} {:<9}{:+4}   ", captions.at(i), kJoints[m.joint], m.degrees);
      text += m.until == Until::Facing
                  ? "exactly: it faces the station\n"
                  : fmt::format("{} at {:.6f}, {:.3f} from the next degree\n", to_string(m.until), m.exact, m.margin);
    }
  }
  text += fmt::format(
      "storage at -60 to 60 degrees: base {:g} + angle and 67 - angle, net elbow +35, net shoulder +28 in {} of {}\n",
      kStorageHome, kept(study.angles), study.angles.size());
  text += "Every length but the arm's and every angle of the home pose is chosen: no public source gives them.\n";
  return text;
}

}  // namespace touchstone::kinematics
