// SPDX-License-Identifier: Apache-2.0
#include "workcell/sdf_xml.h"

#include <algorithm>
#include <string_view>

#include "workcell/file_content.h"
#include "workcell/text_cursor.h"
#include "workcell/xml_text.h"

namespace hapticell::workcell {

namespace {

constexpr int kDeepestXml = 200;

/// Elements open at once at the deepest place; the XML library would recurse that far.
int depthOf(std::string_view text) {
  int depth = 0, deepest = 0;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    const char next = at + 1 < text.size() ? text[at + 1] : '\0';
    if (next == '!' || next == '?') continue;
    const std::size_t end = text.find('>', at);
    const bool closed = end != std::string_view::npos && text[end - 1] == '/';
    depth += next == '/' ? -1 : closed ? 0 : 1;
    deepest = std::max(deepest, depth);
  }
  return deepest;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

}  // namespace

Expected<TiXmlElement*> parseSdf(const std::filesystem::path& file, TiXmlDocument& document) {
  const auto content = readFileContent(file);
  if (!content) return makeError(content.error());
  if (depthOf(*content) > kDeepestXml || content->find('\0') != std::string::npos) {
    return makeError({file.string(), "", "XML nested deeper than 200, or bytes that are no text", "SDF", ""});
  }
  document.Parse(soundXmlText(*content).text.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document.Error()) {
    return makeError({file.string(), "line " + std::to_string(document.ErrorRow()), document.ErrorDesc(), "XML", ""});
  }
  TiXmlElement* root = document.RootElement();
  if (!root || root->ValueStr() != "sdf") return makeError({file.string(), "", "no <sdf>", "an SDF file", ""});
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
