// SPDX-License-Identifier: Apache-2.0
#include "xacro/xml_node.h"

#include <tinyxml.h>

#include <algorithm>

#include "xacro/xml_document.h"

namespace hapticell::xacro {

namespace {

XmlPointer converted(const TiXmlElement& element, int file) {
  XmlNode node;
  node.name = element.ValueStr();
  node.file = file;
  node.line = element.Row();
  for (const TiXmlAttribute* attribute = element.FirstAttribute(); attribute; attribute = attribute->Next()) {
    std::string value = attribute->ValueStr();
    std::replace_if(
        value.begin(), value.end(), [](char c) { return c == '\n' || c == '\t' || c == '\r'; }, ' ');  // XML 3.3.3.
    node.attributes.push_back({attribute->Name(), std::move(value), attribute->Row()});
  }
  for (const TiXmlNode* child = element.FirstChild(); child; child = child->NextSibling()) {
    if (const TiXmlElement* inside = child->ToElement()) {
      node.children.push_back(converted(*inside, file));
    } else if (const TiXmlText* text = child->ToText()) {
      XmlNode words;
      words.text = text->ValueStr();
      words.file = file;
      words.line = text->Row();
      node.children.push_back(std::make_shared<const XmlNode>(std::move(words)));
    }
  }
  return std::make_shared<const XmlNode>(std::move(node));
}

}  // namespace

const XmlNode::Attribute* XmlNode::attribute(const std::string& wanted) const {
  const auto found =
      std::find_if(attributes.begin(), attributes.end(), [&](const Attribute& one) { return one.name == wanted; });
  return found == attributes.end() ? nullptr : &*found;
}

XmlPointer readXml(const std::string& content, const std::string& file, int file_index) {
  TiXmlDocument document;
  if (const auto parsed = parseXml(content, file, document); !parsed) {
    const Error& error = parsed.error();
    throw Fault{.found = error.found, .expected = error.expected, .fix = error.fix, .file = file, .place = error.place};
  }
  if (!document.RootElement()) {
    throw Fault{.found = "no XML element", .expected = "<robot>", .file = file};
  }
  return converted(*document.RootElement(), file_index);
}

}  // namespace hapticell::xacro
