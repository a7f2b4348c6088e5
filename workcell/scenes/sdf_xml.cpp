// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/sdf_xml.h"

#include "geometry/system/nesting_limit.h"
#include "geometry/system/regular_file.h"
#include "workcell/text/read_record.h"
#include "workcell/text/text_cursor.h"
#include "workcell/text/xml_text.h"

namespace hapticell::workcell {

namespace {

// 64 MB, as kLargestUrdf.
constexpr std::uintmax_t kLargestSdf = std::uintmax_t{64} << 20;

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

}  // namespace

Expected<TiXmlElement*> parseSdf(const std::filesystem::path& file, TiXmlDocument& document) {
  const auto content = geometry::readRegularFile(file, kLargestSdf);
  HAPTICELL_TRY(content);
  ReadRecord::note(file);
  if (content->find('\0') != std::string::npos)
    return makeError({.file = file.string(), .found = "a NUL byte", .expected = "SDF"});
  auto flat = geometry::checkNesting(*content, geometry::NestedText::kXml, file.string());
  HAPTICELL_TRY(flat);
  document.Clear();  // Parse() adds to what is there, and the first root counts.
  document.Parse(soundXmlText(*content).text.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document.Error()) {
    return makeError({.file = file.string(),
                      .place = Text("line %1", document.ErrorRow()),
                      .found = std::string(document.ErrorDesc()),
                      .expected = "XML"});
  }
  TiXmlElement* root = document.RootElement();
  if (!root || root->ValueStr() != "sdf")
    return makeError({.file = file.string(), .found = "<sdf> is missing", .expected = "an SDF file"});
  return root;
}

std::string textOf(const TiXmlElement& element) {
  const char* text = element.GetText();
  return trimmed(text ? text : "");
}

std::string textOf(const TiXmlElement* parent, const char* name) {
  const TiXmlElement* element = parent ? parent->FirstChildElement(name) : nullptr;
  return element ? textOf(*element) : std::string();
}

void setText(TiXmlElement& element, const std::string& text) {
  element.Clear();
  element.LinkEndChild(new TiXmlText(text));  // The element owns it.
}

std::string attributeOf(const TiXmlElement& element, const char* name) {
  const char* text = element.Attribute(name);
  return text ? text : "";
}

std::vector<double> numbersIn(const std::string& text) {
  std::vector<double> numbers;
  TextCursor cursor(text);
  while (cursor.nextLine()) {
    for (std::string_view word = cursor.nextWord(); !word.empty(); word = cursor.nextWord()) {
      const std::optional<double> number = parseNumber(word);
      if (!number) return numbers;
      numbers.push_back(*number);
    }
  }
  return numbers;
}

bool hasMovingJoint(const TiXmlElement& model) {
  for (const TiXmlElement* joint = model.FirstChildElement("joint"); joint;
       joint = joint->NextSiblingElement("joint")) {
    if (attributeOf(*joint, "type") != "fixed") return true;
  }
  return false;
}

}  // namespace hapticell::workcell
