// SPDX-License-Identifier: Apache-2.0
#include "xacro/xml_document.h"

#include <tinyxml.h>

#include <algorithm>
#include <string_view>

namespace hapticell::xacro {

namespace {

constexpr int kDeepestElements = 200;  // Real files stay under twenty.

/// Behind what begins at `i` and ends with `end`; the text's end where it does not.
std::size_t behind(const std::string& text, std::size_t i, const char* end) {
  const std::size_t found = text.find(end, i);
  return found == std::string::npos ? text.size() : found + std::char_traits<char>::length(end);
}

/// Behind the tag that begins at `i`; '>' in its values counts for nothing. `closed`: it is an element by itself.
std::size_t behindTag(const std::string& text, std::size_t i, bool& closed) {
  char mark = '\0';
  for (std::size_t at = i; at < text.size(); ++at) {
    const char c = text[at];
    if (mark != '\0') {
      if (c == mark) mark = '\0';
    } else if (c == '"' || c == '\'') {
      mark = c;
    } else if (c == '>') {
      closed = text[at - 1] == '/';
      return at + 1;
    }
  }
  return text.size();
}

/// One look over the raw text for how deep its elements nest.
int deepestNesting(const std::string& text) {
  int depth = 0, deepest = 0;
  for (std::size_t i = text.find('<'); i < text.size(); i = text.find('<', i)) {
    if (text.compare(i, 4, "<!--") == 0) {
      i = behind(text, i, "-->");
    } else if (text.compare(i, 9, "<![CDATA[") == 0) {
      i = behind(text, i, "]]>");
    } else if (text.compare(i, 2, "</") == 0) {
      --depth;
      ++i;
    } else if (text.compare(i, 2, "<!") == 0 || text.compare(i, 2, "<?") == 0) {
      ++i;
    } else {
      bool closed = false;
      deepest = std::max(deepest, depth + 1);
      i = behindTag(text, i, closed);
      if (!closed) ++depth;
    }
  }
  return deepest;
}

int lineAt(const std::string& text, std::size_t place) {
  return static_cast<int>(1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
}

}  // namespace

Expected<void> parseXml(const std::string& content, const std::string& file, TiXmlDocument& document) {
  const auto refuse = [&file](int line, std::string found, std::string expected, std::string fix = {}) {
    return makeError(
        {file, line > 0 ? "line " + std::to_string(line) : "", std::move(found), std::move(expected), std::move(fix)});
  };
  constexpr std::string_view kNothing("\0 \t\r\n", 5);  // Some programs write NULs behind the end.
  if (const std::size_t nul = content.find('\0'); content.find_first_not_of(kNothing, nul) != std::string::npos)
    return refuse(lineAt(content, nul), "a NUL byte", "XML text");
  if (deepestNesting(content) > kDeepestElements) return refuse(0, "elements nested deeper than 200", "a robot's file");
  if (const auto entities = content.find("<!ENTITY"); entities != std::string::npos)
    return refuse(lineAt(content, entities), "a document type with entities of its own (<!ENTITY ...>)",
                  "a file without them", "Write out the text that they stand for.");
  document.Parse(content.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (!document.Error()) return {};
  return refuse(document.ErrorRow() > 0 ? document.ErrorRow() : lineAt(content, content.size()),
                std::string("XML that does not parse (") + document.ErrorDesc() + ")", "well-formed XML");
}

}  // namespace hapticell::xacro
