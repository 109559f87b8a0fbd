// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/read_urdf.h"

#include <console_bridge/console.h>
#include <expat.h>
#include <fmt/core.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <new>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/thesis/cell/first_contact/arc.h"
#include "experiments/thesis/cell/model/cell_entry.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::cell {
namespace {

/// Thrown for text that is not XML, or XML that exceeds our limits; the message begins with the line.
class BadXml : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The lines of the root element and of its direct children, if they have a `name`, by kind and name; the first of
/// several with the same name.
using XmlLines = std::map<std::pair<std::string, std::string>, std::size_t, std::less<>>;

/// Limits of XML that is read: the parser of urdfdom recurses from level to level, in time quadratic in their number,
/// looks for an attribute among all of its element's, and frees a chain of links by recursion.
constexpr std::size_t kMostXmlLevels = 64, kMostXmlAttributes = 64, kMostXmlElements = 100'000,
                      kMostNamedInRoot = 2'000;

/// Checks that a text is well-formed XML in UTF-8 within these limits, without a document type, by expat, which does
/// not recurse. Exceptions cannot pass through expat, so the first fault stops the parser.
class XmlCheck {
 public:
  XmlCheck() : parser_(XML_ParserCreate("UTF-8"), XML_ParserFree) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(
        parser_.get(), [](void* self, const char* name, const char** attributes) { of(self).begin(name, attributes); },
        [](void* self, const char*) { --of(self).levels_; });
    XML_SetStartDoctypeDeclHandler(parser_.get(), [](void* self, const char*, const char*, const char*, int) {
      of(self).refuse("a document type is not read");
    });
    // urdfdom's parser ends an instruction at the first '>', and would take what follows for elements.
    XML_SetProcessingInstructionHandler(parser_.get(), [](void* self, const char*, const char* data) {
      if (std::string_view(data).find('>') != std::string_view::npos) of(self).refuse("an instruction holds a '>'");
    });
  }

  /// Throws BadXml. Cost: linear in the length of the text.
  XmlLines lines(std::string_view text) {
    const XML_Status status = XML_Parse(parser_.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
    if (!fault_.empty()) throw BadXml(fault_);
    if (status != XML_STATUS_OK)
      throw BadXml(
          fmt::format("line {}: is not XML in UTF-8: {}", line(), XML_ErrorString(XML_GetErrorCode(parser_.get()))));
    return std::move(lines_);
  }

 private:
  static XmlCheck& of(void* self) { return *static_cast<XmlCheck*>(self); }
  [[nodiscard]] std::size_t line() const { return XML_GetCurrentLineNumber(parser_.get()); }

  void refuse(const std::string& reason) {
    if (fault_.empty()) fault_ = fmt::format("line {}: {}", line(), reason);
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  void begin(const char* element, const char** attributes) {
    if (++levels_ > kMostXmlLevels) refuse(fmt::format("elements are nested in more than {} levels", kMostXmlLevels));
    if (++elements_ > kMostXmlElements) refuse(fmt::format("there are more than {} elements", kMostXmlElements));
    std::size_t count = 0;
    for (const char** attribute = attributes; *attribute != nullptr; attribute += 2) {
      ++count;
      if (levels_ <= 2 && std::string_view(*attribute) == "name") lines_.try_emplace({element, attribute[1]}, line());
    }
    if (count > kMostXmlAttributes) refuse(fmt::format("an element has more than {} attributes", kMostXmlAttributes));
    if (lines_.size() > kMostNamedInRoot)
      refuse(fmt::format("there are more than {} links, joints and other named elements", kMostNamedInRoot));
  }

  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::size_t levels_ = 0, elements_ = 0;
  XmlLines lines_;
  std::string fault_;
};

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

  [[nodiscard]] Robot robot(const urdf::ModelInterface& model) const {
    Robot robot;
    robot.name = model.getName();
    require_legible(location("robot", robot.name), robot.name);
    robot.urdf = file_;
    for (urdf::LinkConstSharedPtr at = model.getRoot(); at;) {
      robot.links.push_back(link(*at));
      if (at->child_joints.empty()) break;
      if (at->child_joints.size() > 1)
        location("link", at->name).bad("has more than one child; a serial arm is expected");
      robot.joints.push_back(joint(*at->child_joints.front()));
      at = at->child_links.front();
    }
    if (robot.joints.empty()) throw BadCell(file_ + ": the robot has no joints");
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

  [[nodiscard]] double length(const XmlLocation& location, double metres) const {
    return workloads::converted(location.finite(metres), workloads::find_unit("m"), context_.unit);
  }

  [[nodiscard]] Eigen::Vector3d vector(const XmlLocation& location, const urdf::Vector3& metres) const {
    return {length(location, metres.x), length(location, metres.y), length(location, metres.z)};
  }

  [[nodiscard]] Pose pose(const XmlLocation& location, const urdf::Pose& given) const {
    constexpr double kNear = 1e-9;
    const urdf::Rotation& q = given.rotation;
    Eigen::Matrix3d rotation = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
    const Eigen::Matrix3d whole = rotation.array().round();
    if (!rotation.allFinite()) location.bad("a number is not finite");
    if ((rotation - whole).cwiseAbs().maxCoeff() < kNear) rotation = whole;
    return {rotation, vector(location, given.position)};
  }

  /// Returns the file of the name: in a package, absolute, or relative to the mesh folder.
  [[nodiscard]] std::filesystem::path mesh_path(const XmlLocation& location, const std::string& name) const {
    constexpr std::string_view kPackage = "package://", kFile = "file://";
    if (name.starts_with(kFile)) return name.substr(kFile.size());
    if (!name.starts_with(kPackage)) return context_.mesh_folder / name;
    const std::filesystem::path in_package = name.substr(kPackage.size());
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
    for (const std::string_view name : kUnits) {
      const workloads::Unit unit = workloads::find_unit(name);
      const double metres = static_cast<double>(unit.micrometres) / 1e6;
      if (given.scale.x == metres && given.scale.y == metres && given.scale.z == metres)
        return {path, unit, context_.unit};
    }
    location.bad(fmt::format("mesh: the scale {} {} {} is not that of a unit of length in metres", given.scale.x,
                             given.scale.y, given.scale.z));
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

  [[nodiscard]] Link link(const urdf::Link& given) const {
    Link link{given.name, {}};
    if (!is_name(given.name)) location("link", given.name).bad("a name must be of letters, digits, '-' and '_'");
    const auto add = [&](const auto& elements, const char* kind) {
      for (std::size_t i = 0; i < elements.size(); ++i) {
        const auto& element = *elements[i];
        std::string name = element.name.empty() ? fmt::format("{}{}", kind, i) : element.name;
        const XmlLocation part{location("link", given.name).where + ": " + name};
        if (!is_name(name)) part.bad("a name must be of letters, digits, '-' and '_'");
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

  [[nodiscard]] Joint joint(const urdf::Joint& given) const {
    const XmlLocation location = this->location("joint", given.name);
    require_legible(location, given.name);
    Joint joint{given.name, Joint::Kind::Fixed, pose(location, given.parent_to_joint_origin_transform), {0, 0, 1}, 0, 0,
                0};
    if (given.mimic) location.bad("mimics another joint; couplings are given in the cell file");
    if (given.type == urdf::Joint::FIXED) return joint;
    const bool slides = given.type == urdf::Joint::PRISMATIC;
    if (!slides && given.type != urdf::Joint::REVOLUTE && given.type != urdf::Joint::CONTINUOUS)
      location.bad("is neither revolute, continuous, prismatic nor fixed");
    joint.kind = slides ? Joint::Kind::Prismatic : Joint::Kind::Revolute;
    joint.axis =
        Eigen::Vector3d(location.finite(given.axis.x), location.finite(given.axis.y), location.finite(given.axis.z));
    if (joint.axis.isZero(0)) location.bad("has no axis");
    joint.axis = kinematics::direction_of(joint.axis);
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
};

}  // namespace

Robot read_urdf(const std::filesystem::path& file, int sides, const SolidContext& context) {
  const std::string text = read_at_most<BadCell>(file, kMostCellMib);
  XmlLines lines;
  try {
    lines = XmlCheck().lines(text);
  } catch (const BadXml& bad) {
    throw BadCell(file.string() + ": " + bad.what());
  }
  urdf::ModelInterfaceSharedPtr model;
  std::string said;
  {
    const Sentences sentences;
    model = urdf::parseURDF(text);
    said = sentences.text();
  }
  if (!model || !said.empty()) throw BadCell(file.string() + ": " + (said.empty() ? "is not a URDF file" : said));
  return UrdfReader(file.string(), lines, sides, context).robot(*model);
}

}  // namespace touchstone::cell
