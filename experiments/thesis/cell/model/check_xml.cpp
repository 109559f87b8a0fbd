// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/check_xml.h"

#include <expat.h>
#include <fmt/core.h>

#include <memory>
#include <new>
#include <utility>

namespace touchstone::cell {
namespace {

/// The handlers of expat for one text. Exceptions cannot pass through expat, so the first fault stops the parser.
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

}  // namespace

XmlLines check_xml(std::string_view text) { return XmlCheck().lines(text); }

}  // namespace touchstone::cell
