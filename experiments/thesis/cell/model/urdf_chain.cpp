// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/urdf_chain.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "experiments/thesis/cell/model/cell_entry.h"

namespace touchstone::cell {
namespace {

using Links = std::vector<urdf::LinkConstSharedPtr>;

class Tree {
 public:
  /// Throws BadCell unless every link is reached from the root by one way; else walks would not end.
  Tree(const urdf::ModelInterface& model, const std::string& file) : file_(file) {
    for (const auto& [name, joint] : model.joints_) {
      const auto child = model.getLink(joint->child_link_name);
      if (child && child->parent_joint != joint)
        bad(fmt::format("joint {}: link {} is the child of another joint, too", name, child->name));
      if (joint->mimic) drivers_.insert(joint->mimic->joint_name);
    }
    links_.push_back(model.getRoot());
    for (std::size_t i = 0; i < links_.size(); ++i)
      links_.insert(links_.end(), links_[i]->child_links.begin(), links_[i]->child_links.end());
    for (const auto& [name, link] : model.links_)
      if (std::ranges::find(links_, link) == links_.end())
        bad(fmt::format("link {}: no chain of joints leads from the root {} to it", name, links_[0]->name));
  }

  [[noreturn]] void bad(const std::string& reason) const { throw BadCell(file_ + ": " + reason); }

  [[nodiscard]] urdf::LinkConstSharedPtr named(const std::string& name, const char* key) const {
    const auto link =
        std::ranges::find_if(links_, [&](const urdf::LinkConstSharedPtr& each) { return each->name == name; });
    if (link == links_.end()) bad(fmt::format("{}: the robot has no link \"{}\"", key, name));
    return *link;
  }

  /// Returns the links from the root, or from `first`, to `last`; none if `first` does not carry it.
  [[nodiscard]] Links way(const urdf::LinkConstSharedPtr& first, urdf::LinkConstSharedPtr last) const {
    Links links{last};
    while (last != first) {
      last = last->getParent();
      if (!last) return {};
      links.push_back(last);
    }
    std::ranges::reverse(links);
    return links;
  }

  [[nodiscard]] Links chosen(const urdf::LinkConstSharedPtr& first) const {
    Links best;
    std::size_t most = 0;
    std::string end;
    for (const urdf::LinkConstSharedPtr& link : links_) {
      if (!link->child_joints.empty()) continue;
      Links other = way(first, link);
      if (other.empty() || (!best.empty() && turning(other) < most)) continue;
      if (best.empty() || turning(other) > most) {
        most = turning(other);
        end = link->name;
        best = std::move(other);
        continue;
      }
      const auto part = std::ranges::mismatch(best, other);
      best.erase(part.in1, best.end());
      if (turning(best) < most)
        bad(fmt::format("as many joints turn on the way to link {} as to {}: robot.tip must name the last link", end,
                        link->name));
    }
    return best;
  }

 private:
  [[nodiscard]] std::size_t turning(const Links& links) const {
    return static_cast<std::size_t>(std::count_if(links.begin() + 1, links.end(), [&](const auto& link) {
      const urdf::Joint& joint = *link->parent_joint;
      return (joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS) && !joint.mimic &&
             !drivers_.contains(joint.name);
    }));
  }

  const std::string& file_;
  Links links_;                    // each after its parent
  std::set<std::string> drivers_;  // the joints that others mimic
};

}  // namespace

std::vector<urdf::LinkConstSharedPtr> chain_of(const urdf::ModelInterface& model, const UrdfEnds& ends,
                                               const std::string& file) {
  const Tree tree(model, file);
  const urdf::LinkConstSharedPtr first = ends.root ? tree.named(*ends.root, "root") : model.getRoot();
  if (!ends.tip) return tree.chosen(first);
  Links links = tree.way(first, tree.named(*ends.tip, "tip"));
  if (links.empty()) tree.bad(fmt::format("root: link {} does not carry the tip {}", first->name, *ends.tip));
  return links;
}

}  // namespace touchstone::cell
