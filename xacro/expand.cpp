// SPDX-License-Identifier: Apache-2.0
#include "xacro/expand.h"

#include "geometry/system/markup.h"
#include "xacro/expander.h"

namespace hapticell::xacro {

namespace {

/// On one line, so that places are lines.
std::string escaped(const std::string& text) {
  std::string result = escapedMarkup(text);
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return result;
}

/// Each tag and each text on a line of its own.
class Writer {
 public:
  Writer(const Expander& expander, Expanded& result) : expander_(expander), result_(result) {}

  void write(const XmlNode& node) {
    if (!node.isElement()) return line(escaped(node.text), node);
    std::string tag = "<" + node.name;
    for (const XmlNode::Attribute& attribute : node.attributes)
      tag += " " + attribute.name + "=\"" + escaped(attribute.value) + "\"";
    if (node.children.empty()) return line(tag + "/>", node);
    line(tag + ">", node);
    for (const XmlPointer& child : node.children) write(*child);
    line("</" + node.name + ">", node);
  }

 private:
  const Expander& expander_;
  Expanded& result_;

  void line(const std::string& text, const XmlNode& node) {
    result_.text += text + "\n";
    result_.places.push_back({expander_.nameOf(node.file), node.line});
  }
};

}  // namespace

Expected<Expanded> expand(const std::filesystem::path& file, const Arguments& arguments, const Files& files,
                          std::vector<DeclaredArgument>& declared, Diagnostics& diagnostics) {
  Expander expander(arguments, files, declared, diagnostics);
  try {
    Expanded result;
    Writer(expander, result).write(*expander.run(file));
    result.files = expander.files();
    return result;
  } catch (const Fault& fault) {
    const std::string name = fault.file.empty() ? file.string() : fault.file;
    return makeError(
        {.file = name, .place = fault.place, .found = fault.found, .expected = fault.expected, .fix = fault.fix});
  }
}

}  // namespace hapticell::xacro
