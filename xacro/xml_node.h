// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "xacro/fault.h"

namespace hapticell::xacro {

struct XmlNode;
using XmlPointer = std::shared_ptr<const XmlNode>;

/// An element or a text, with its place in the file.
struct XmlNode {
  struct Attribute {
    std::string name, value;
    int line = 0;
  };
  std::string name;  ///< Empty: a text.
  std::string text;
  std::vector<Attribute> attributes;
  std::vector<XmlPointer> children;
  int file = 0;  ///< Index among the files that were read.
  int line = 0;

  bool isElement() const { return !name.empty(); }
  /// Null if it does not exist.
  const Attribute* attribute(const std::string& wanted) const;
};

/// The root element of an XML text without its comments. Fault with the line for what parseXml() refuses, and where
/// there is no element.
XmlPointer readXml(const std::string& content, const std::string& file, int file_index);

}  // namespace hapticell::xacro
