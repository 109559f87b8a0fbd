// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/read_urdf.h"

#include <console_bridge/console.h>
#include <fmt/core.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/thesis/cell/first_contact/arc.h"
#include "experiments/thesis/cell/model/cell_entry.h"
#include "experiments/thesis/cell/model/poses.h"
#include "experiments/thesis/cell/model/urdf_text.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::cell {
namespace {

/// Collects the messages of urdfdom during its lifetime.
class Sentences : public console_bridge::OutputHandler {
 public:
  Sentences() { console_bridge::useOutputHandler(this); }
  Sentences(const Sentences&) = delete;
  Sentences& operator=(const Sentences&) = delete;
  ~Sentences() override { console_bridge::restorePreviousOutputHandler(); }

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) text_.append(text_.empty() ? "" : "; ").append(text);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// The link or joint that is being read, after the file and its line.
struct XmlLocation {
  std::string where;

  [[noreturn]] void bad(const std::string& reason) const { throw BadCell(where + ": " + reason); }
  [[nodiscard]] double finite(double number) const {
    if (!std::isfinite(number)) bad("a number is not finite");
    return number;
  }
};

class UrdfReader {
 public:
  UrdfReader(std::string file, const XmlLines& lines, int sides, const SolidContext& context)
      : file_(std::move(file)), lines_(lines), sides_(sides), context_(context) {}

  [[nodiscard]] Robot robot(const urdf::ModelInterface& model, const UrdfEnds& ends) {
    Robot robot;
    robot.name = model.getName();
    require_legible(location("robot", robot.name), robot.name);
    robot.urdf = file_;
    const auto chain = chain_of(model, ends, file_);
    for (std::size_t i = 0; i < chain.size(); ++i) {
      robot.links.push_back(link(*chain[i]));
      if (i > 0) robot.joints.push_back(joint(*chain[i]->parent_joint));
    }
    if (robot.joints.empty()) throw BadCell(file_ + ": the robot has no joints");
    for (std::size_t i = 1; i < chain.size(); ++i)
      if (chain[i]->parent_joint->mimic) couple(robot, i - 1, *chain[i]->parent_joint);
    const std::set<urdf::LinkConstSharedPtr> links(chain.begin(), chain.end());
    std::string bare;
    for (std::size_t i = 0; i < chain.size(); ++i)
      for (const urdf::JointSharedPtr& side : chain[i]->child_joints)
        if (const auto child = model.getLink(side->child_link_name); !links.contains(child))
          carry(robot.links[i], model, *child, rest(model, *side), bare);
    if (!bare.empty()) warn(fmt::format("{}: links without shapes beside the arm are left out: {}", file_, bare));
    std::string before;
    for (urdf::LinkConstSharedPtr above = chain[0]->getParent(); above; above = above->getParent())
      before.append(before.empty() ? "" : ", ").append(above->name);
    if (!before.empty())
      warn(fmt::format("{}: links before {} are left out, with what else they carry: {}", file_, chain[0]->name,
                       before));
    if (turned_ > 0)
      warn(fmt::format("{}: turns within {:g} of quarter turns are taken as these; the furthest is {:.3g} off", file_,
                       kNear, turned_));
    robot.warnings = std::move(warnings_);
    return robot;
  }

 private:
  [[nodiscard]] XmlLocation location(const char* kind, const std::string& name) const {
    const auto line = lines_.find({kind, name});
    const std::string at = line == lines_.end() ? "" : fmt::format("line {}: ", line->second);
    return {fmt::format("{}: {}{} {}", file_, at, kind, name)};
  }

  /// Names reach terminals, pages and files of JSON. An entity like `&#233;` becomes a lone byte in urdfdom.
  static void require_legible(const XmlLocation& location, const std::string& name) {
    if (io::all_legible(name) != name) location.bad("the name has a control character, or is not UTF-8");
  }

  void warn(std::string sentence) { warnings_.push_back(std::move(sentence)); }

  [[nodiscard]] double length(const XmlLocation& location, double metres) const {
    return workloads::converted(location.finite(metres), workloads::find_unit("m"), context_.unit);
  }

  [[nodiscard]] Eigen::Vector3d vector(const XmlLocation& location, const urdf::Vector3& metres) const {
    return {length(location, metres.x), length(location, metres.y), length(location, metres.z)};
  }

  /// Descriptions write 90 degrees as 1.5708, and an axis as 1 and -5.5e-17.
  static constexpr double kNear = 1e-5;

  template <class Matrix>
  [[nodiscard]] Matrix rounded(const Matrix& given) {
    Matrix whole = given.array().round();
    const double off = (given - whole).cwiseAbs().maxCoeff();
    if (!(off < kNear)) return given;
    if (off > 1e-9) turned_ = std::max(turned_, off);
    return whole;
  }

  [[nodiscard]] Pose pose(const XmlLocation& location, const urdf::Pose& given) {
    const urdf::Rotation& q = given.rotation;
    const Eigen::Matrix3d rotation = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
    if (!rotation.allFinite()) location.bad("a number is not finite");
    return {rounded(rotation), vector(location, given.position)};
  }

  /// Returns the file of the name: in a package, absolute, or relative to the mesh folder or to that of the URDF.
  [[nodiscard]] std::filesystem::path mesh_path(const XmlLocation& location, const std::string& name) const {
    constexpr std::string_view kPackage = "package://", kModel = "model://", kFile = "file://";
    if (name.find("$(") != std::string::npos || name.find("${") != std::string::npos)
      location.bad(fmt::format("mesh: {}: is of a xacro file; xacro must make a URDF of it first", name));
    if (name.starts_with(kFile)) return name.substr(kFile.size());
    if (!name.starts_with(kPackage) && !name.starts_with(kModel)) {
      const std::filesystem::path beside = std::filesystem::path(file_).parent_path() / name;
      return std::filesystem::is_regular_file(context_.mesh_folder / name) || !std::filesystem::is_regular_file(beside)
                 ? context_.mesh_folder / name
                 : beside;
    }
    const std::filesystem::path in_package = name.substr(name.find("://") + 3);
    std::string searched;
    for (const std::filesystem::path& folder : context_.packages) {
      // The folder may hold the package, or be it.
      const bool is_it = folder.filename() == *in_package.begin();
      for (const auto& path : {folder / in_package, is_it ? folder.parent_path() / in_package : folder / in_package})
        if (std::filesystem::is_regular_file(path)) return path;
      searched.append(searched.empty() ? "" : ", ").append(folder.string());
    }
    location.bad(
        fmt::format("mesh: {} is in none of the folders {}; robot.packages of the cell file and the environment "
                    "variable ROS_PACKAGE_PATH name others",
                    name, searched));
  }

  [[nodiscard]] MeshFile mesh(const XmlLocation& location, const urdf::Mesh& given) const {
    constexpr std::array<std::string_view, 5> kUnits{"m", "cm", "mm", "inch", "foot"};
    const std::filesystem::path path = mesh_path(location, given.filename);
    if (!std::filesystem::is_regular_file(path)) location.bad("mesh: there is no file " + path.string());
    const Eigen::Vector3d scale(given.scale.x, given.scale.y, given.scale.z);
    for (const std::string_view name : kUnits) {
      const workloads::Unit unit = workloads::find_unit(name);
      if ((scale.array() == static_cast<double>(unit.micrometres) / 1e6).all()) return {path, unit, context_.unit};
    }
    if (!scale.allFinite() || (scale.array() == 0).any())
      location.bad(fmt::format("mesh: the scale {} {} {} leaves no solid", scale.x(), scale.y(), scale.z()));
    return {path, workloads::find_unit("m"), context_.unit, scale};
  }

  [[nodiscard]] decltype(Solid::shape) shape(const XmlLocation& location, const urdf::Geometry& geometry) const {
    const auto positive = [&](double metres) {
      if (!(metres > 0)) location.bad(fmt::format("a size must be positive, is {}", metres));
      return length(location, metres);
    };
    switch (geometry.type) {
      case urdf::Geometry::BOX: {
        const urdf::Vector3& size = static_cast<const urdf::Box&>(geometry).dim;
        const Eigen::Vector3d half = Eigen::Vector3d(positive(size.x), positive(size.y), positive(size.z)) / 2;
        return Box{-half, half};
      }
      case urdf::Geometry::CYLINDER: {
        const auto& given = static_cast<const urdf::Cylinder&>(geometry);
        const double half = positive(given.length) / 2;
        return Cylinder{2, {0, 0, -half}, {0, 0, half}, positive(given.radius), sides_};
      }
      case urdf::Geometry::MESH: return mesh(location, static_cast<const urdf::Mesh&>(geometry));
      case urdf::Geometry::SPHERE: break;
    }
    return Sphere{{0, 0, 0}, positive(static_cast<const urdf::Sphere&>(geometry).radius), sides_};
  }

  /// Names become those of files, and of parts behind a slash.
  [[nodiscard]] std::string plain(const XmlLocation& location, const std::string& given) {
    std::string name = given.empty() ? "_" : given;
    for (char& letter : name)
      if (!is_name({&letter, 1})) letter = '_';
    if (name != given) warn(fmt::format("{}: is called {} here", location.where, name));
    return name;
  }

  [[nodiscard]] Link link(const urdf::Link& given) {
    const XmlLocation whole = location("link", given.name);
    require_legible(whole, given.name);
    Link link{plain(whole, given.name), {}};
    if (!links_.insert(link.name).second) whole.bad(fmt::format("another link is called {}, too", link.name));
    std::set<std::string> names;
    const auto add = [&](const auto& elements, const char* kind) {
      for (std::size_t i = 0; i < elements.size(); ++i) {
        const auto& element = *elements[i];
        const std::string unnamed = fmt::format("{}{}", kind, i);
        const XmlLocation part{whole.where + ": " + (element.name.empty() ? unnamed : element.name)};
        require_legible(part, element.name);
        std::string name = element.name.empty() ? unnamed : plain(part, element.name);
        if (!names.insert(name).second) names.insert(name += "-" + unnamed);
        if (!element.geometry) part.bad("has no geometry");
        link.parts.push_back({std::move(name), {shape(part, *element.geometry), pose(part, element.origin)}});
      }
    };
    if (given.collision_array.empty())
      add(given.visual_array, "visual");
    else
      add(given.collision_array, "collision");
    return link;
  }

  /// Returns where a joint beside the arm stands: at 0 or the limit nearest to it, or where the joint that it mimics
  /// puts it.
  [[nodiscard]] double place(const urdf::ModelInterface& model, const urdf::Joint& given, int followed = 0) const {
    constexpr int kMostFollowed = 64;
    const XmlLocation location = this->location("joint", given.name);
    if (given.mimic) {
      const auto leader = model.getJoint(given.mimic->joint_name);
      if (!leader || followed == kMostFollowed)
        location.bad(fmt::format("mimics joint {}, {}", given.mimic->joint_name,
                                 leader ? "which mimics others without end" : "which the robot does not have"));
      return location.finite(given.mimic->multiplier * place(model, *leader, followed + 1) + given.mimic->offset);
    }
    if (!given.limits || given.type == urdf::Joint::CONTINUOUS) return 0;
    const double lower = location.finite(given.limits->lower), upper = location.finite(given.limits->upper);
    if (lower > upper) location.bad(fmt::format("limits are crossed: lower {} and upper {}", lower, upper));
    return std::clamp(0.0, lower, upper);
  }

  /// Returns the pose of a link beside the arm in the frame of the link that it is mounted on.
  [[nodiscard]] Pose rest(const urdf::ModelInterface& model, const urdf::Joint& given) {
    const Joint joint = this->joint(given);
    if (joint.kind == Joint::Kind::Fixed) return joint.origin;
    const XmlLocation location = this->location("joint", given.name);
    const double at = place(model, given);
    const bool slides = joint.kind == Joint::Kind::Prismatic;
    warn(fmt::format("{}: is beside the arm, and stands still at {:.6g} {}", location.where, at,
                     slides ? "metres" : "radians"));
    if (slides) return within(joint.origin, {Eigen::Matrix3d::Identity(), length(location, at) * joint.axis});
    return within(joint.origin, {rotation_about(joint.axis, degrees(at)), Eigen::Vector3d::Zero()});
  }

  /// Adds the parts of a link and of all that it carries to a link of the arm, in whose frame it is at `pose`. Appends
  /// the names of links without parts to `bare`.
  void carry(Link& arm, const urdf::ModelInterface& model, const urdf::Link& first, const Pose& pose,
             std::string& bare) {
    std::vector<std::pair<const urdf::Link*, Pose>> rest_of{{&first, pose}};
    while (!rest_of.empty()) {
      const auto [given, frame] = rest_of.back();
      rest_of.pop_back();
      Link side = link(*given);
      if (side.parts.empty())
        bare.append(bare.empty() ? "" : ", ").append(given->name);
      else
        warn(fmt::format("{}: is beside the arm, and moves with link {}", location("link", given->name).where,
                         arm.name));
      for (Part& part : side.parts)
        arm.parts.push_back(
            {side.name + "-" + part.name, {std::move(part.solid.shape), within(frame, part.solid.pose)}});
      for (const urdf::JointSharedPtr& joint : given->child_joints)
        rest_of.emplace_back(model.getLink(joint->child_link_name).get(), within(frame, rest(model, *joint)));
    }
  }

  /// Makes a joint of the arm follow the one that it mimics.
  void couple(Robot& robot, std::size_t place, const urdf::Joint& given) const {
    const XmlLocation location = this->location("joint", given.name);
    const auto leader = std::ranges::find(robot.joints, given.mimic->joint_name, &Joint::name);
    if (leader == robot.joints.end() || leader->kind != Joint::Kind::Revolute ||
        robot.joints[place].kind != Joint::Kind::Revolute)
      location.bad(fmt::format("mimics joint {}: within the arm a joint that turns can only mimic another of these",
                               given.mimic->joint_name));
    robot.couplings.push_back(
        {place, static_cast<std::size_t>(leader - robot.joints.begin()), location.finite(given.mimic->multiplier)});
    robot.joints[place].home = degrees(location.finite(given.mimic->offset));
    robot.joints[place].mimics = true;
  }

  /// To the nearest 1e-9, so that what was written for a whole degree is one.
  [[nodiscard]] static double degrees(double radians) {
    return std::round(radians * (180 / std::numbers::pi) * 1e9) / 1e9;
  }

  /// A velocity of 0 says nothing: the format requires one.
  static void take_speed(Joint& joint, const urdf::Joint& given, const XmlLocation& location) {
    if (!given.limits) return;
    joint.speed = degrees(location.finite(given.limits->velocity));
    if (joint.speed < 0) location.bad("the velocity is negative");
  }

  [[nodiscard]] Joint joint(const urdf::Joint& given) {
    const XmlLocation location = this->location("joint", given.name);
    require_legible(location, given.name);
    Joint joint{given.name, Joint::Kind::Fixed, pose(location, given.parent_to_joint_origin_transform), {0, 0, 1}, 0, 0,
                0};
    if (given.type == urdf::Joint::FIXED) return joint;
    const bool slides = given.type == urdf::Joint::PRISMATIC;
    if (!slides && given.type != urdf::Joint::REVOLUTE && given.type != urdf::Joint::CONTINUOUS)
      location.bad("is neither revolute, continuous, prismatic nor fixed; robot.root can name a link behind it");
    joint.kind = slides ? Joint::Kind::Prismatic : Joint::Kind::Revolute;
    joint.axis =
        Eigen::Vector3d(location.finite(given.axis.x), location.finite(given.axis.y), location.finite(given.axis.z));
    if (joint.axis.isZero(0)) location.bad("has no axis");
    joint.axis = rounded(Eigen::Vector3d(kinematics::direction_of(joint.axis)));
    take_speed(joint, given, location);
    if (given.type == urdf::Joint::CONTINUOUS) {
      joint.lower = -360;
      joint.upper = 360;
      return joint;
    }
    joint.lower = slides ? length(location, given.limits->lower) : degrees(location.finite(given.limits->lower));
    joint.upper = slides ? length(location, given.limits->upper) : degrees(location.finite(given.limits->upper));
    if (joint.lower > joint.upper)
      location.bad(fmt::format("limits are crossed: lower {} and upper {}{}", joint.lower, joint.upper,
                               slides ? "" : " degrees"));
    return joint;
  }

  std::string file_;
  const XmlLines& lines_;
  int sides_;
  const SolidContext& context_;
  double turned_ = 0;  // the furthest that a turn was from what is taken
  std::set<std::string> links_;
  std::vector<std::string> warnings_;
};

}  // namespace

Robot read_urdf(const std::filesystem::path& file, int sides, const SolidContext& context, const UrdfEnds& ends) {
  const UrdfText checked = checked_urdf(read_at_most<BadCell>(file, kMostCellMib), file.string());
  urdf::ModelInterfaceSharedPtr model;
  std::string said;
  {
    const Sentences sentences;
    model = urdf::parseURDF(checked.text);
    said = sentences.text();
  }
  if (said.find("${") != std::string::npos || said.find("$(") != std::string::npos)
    said += "; it is a xacro file: xacro must make a URDF of it first";
  if (!model || !said.empty()) throw BadCell(file.string() + ": " + (said.empty() ? "is not a URDF file" : said));
  Robot robot = UrdfReader(file.string(), checked.lines, sides, context).robot(*model, ends);
  robot.warnings.insert(robot.warnings.begin(), checked.warnings.begin(), checked.warnings.end());
  return robot;
}

}  // namespace touchstone::cell
