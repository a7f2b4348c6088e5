// SPDX-License-Identifier: Apache-2.0
#include "xacro/xml_document.h"

#include <tinyxml.h>

#include <algorithm>
#include <string_view>

#include "geometry/system/nesting_limit.h"
#include "xacro/fault.h"

namespace hapticell::xacro {

namespace {

int lineAt(const std::string& text, std::size_t place) {
  return static_cast<int>(1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
}

}  // namespace

Expected<void> parseXml(const std::string& content, const std::string& file, TiXmlDocument& document) {
  const auto refuse = [&file](int line, Text found, Text expected, Text fix = {}) {
    return makeError({.file = file,
                      .place = linePlace(line),
                      .found = std::move(found),
                      .expected = std::move(expected),
                      .fix = std::move(fix)});
  };
  constexpr std::string_view kNothing("\0 \t\r\n", 5);  // Some programs write NULs behind the end.
  if (const std::size_t nul = content.find('\0'); content.find_first_not_of(kNothing, nul) != std::string::npos)
    return refuse(lineAt(content, nul), Text("a NUL byte"), Text("XML text"));
  if (auto flat = geometry::checkNesting(content, geometry::NestedText::kXml, file); !flat) return flat;
  if (const auto entities = content.find("<!ENTITY"); entities != std::string::npos)
    return refuse(lineAt(content, entities), Text("a document type that defines entities (<!ENTITY ...>)"),
                  Text("a file without entity definitions"), Text("Replace the entities by their text."));
  document.Parse(content.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (!document.Error()) return {};
  return refuse(document.ErrorRow() > 0 ? document.ErrorRow() : lineAt(content, content.size()),
                Text("invalid XML (%1)", document.ErrorDesc()), Text("well-formed XML"));
}

}  // namespace hapticell::xacro
