// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/urdf_text.h"

#include <expat.h>
#include <fmt/core.h>

#include <cstddef>
#include <memory>
#include <new>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/thesis/cell/model/cell_entry.h"

namespace touchstone::cell {
namespace {

/// Limits of XML that is read: the parser of urdfdom recurses from level to level, in time quadratic in their number,
/// looks for an attribute among all of its element's, and frees a chain of links by recursion.
constexpr std::size_t kMostXmlLevels = 64, kMostXmlAttributes = 64, kMostXmlElements = 100'000,
                      kMostNamedInRoot = 2'000;

/// Checks that a text is well-formed XML in UTF-8 within these limits, without a document type, by expat, which does
/// not recurse. Exceptions cannot pass through expat, so the first fault stops the parser.
class XmlCheck {
 public:
  XmlCheck(const std::string& text, std::string file)
      : text_(text), file_(std::move(file)), parser_(XML_ParserCreate("UTF-8"), XML_ParserFree) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(
        parser_.get(), [](void* self, const char* name, const char** attributes) { of(self).begin(name, attributes); },
        [](void* self, const char*) { of(self).end(); });
    XML_SetStartDoctypeDeclHandler(parser_.get(), [](void* self, const char*, const char*, const char*, int) {
      of(self).refuse("a document type is not read");
    });
    // urdfdom's parser ends an instruction at the first '>', and would take what follows for elements.
    XML_SetProcessingInstructionHandler(parser_.get(), [](void* self, const char*, const char* data) {
      if (std::string_view(data).find('>') != std::string_view::npos) of(self).refuse("an instruction holds a '>'");
    });
  }

  UrdfText checked() {
    const XML_Status status = XML_Parse(parser_.get(), text_.data(), static_cast<int>(text_.size()), XML_TRUE);
    if (!fault_.empty()) throw BadCell(fmt::format("{}: {}", file_, fault_));
    if (status != XML_STATUS_OK)
      throw BadCell(fmt::format("{}: line {}: is not XML in UTF-8: {}", file_, line(),
                                XML_ErrorString(XML_GetErrorCode(parser_.get()))));
    for (std::size_t from = 0; const auto& [at, added] : added_) {
      result_.text.append(text_, from, at - from).append(added);
      from = at;
    }
    result_.text.append(text_, added_.empty() ? 0 : added_.back().first);
    return std::move(result_);
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
      if (levels_ <= 2 && std::string_view(*attribute) == "name")
        result_.lines.try_emplace({element, attribute[1]}, line());
    }
    complete(element, attributes);
    if (count > kMostXmlAttributes) refuse(fmt::format("an element has more than {} attributes", kMostXmlAttributes));
    if (result_.lines.size() > kMostNamedInRoot)
      refuse(fmt::format("there are more than {} links, joints and other named elements", kMostNamedInRoot));
  }

  /// Called within the element, whose `attributes` are names and values in turn.
  void complete(std::string_view element, const char** attributes) {
    const auto given = [&](std::string_view name) {
      for (const char** each = attributes; *each != nullptr; each += 2)
        if (*each == name) return std::string_view(each[1]);
      return std::string_view();
    };
    if (levels_ == 2) joint_ = element == "joint" && given("type") == "revolute" ? given("name") : "";
    if (levels_ != 3 || element != "limit") return;
    joint_.clear();
    std::string added;
    for (const char* name : {"effort", "velocity"})
      if (given(name).data() == nullptr) added += fmt::format(" {}=\"0\"", name);
    if (!added.empty()) added_.emplace_back(place() + std::string_view("<limit").size(), added);
  }

  void end() {
    if (levels_-- != 2 || joint_.empty() || text_.compare(place(), 2, "</") != 0) return;
    added_.emplace_back(place(), fmt::format(R"(<limit lower="-{0:.17g}" upper="{0:.17g}" effort="0" velocity="0"/>)",
                                             2 * std::numbers::pi));
    result_.warnings.push_back(
        fmt::format("{}: line {}: joint {}: has no limit, turns from -360 to 360 degrees", file_, line(), joint_));
  }

  /// Where the element or its end begins.
  [[nodiscard]] std::size_t place() const { return static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_.get())); }

  const std::string& text_;
  std::string file_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::size_t levels_ = 0, elements_ = 0;
  std::string joint_;                                       // that is revolute, until its limit has come
  std::vector<std::pair<std::size_t, std::string>> added_;  // by place in the text
  UrdfText result_;
  std::string fault_;
};

}  // namespace

UrdfText checked_urdf(const std::string& text, const std::string& file) { return XmlCheck(text, file).checked(); }

}  // namespace touchstone::cell
