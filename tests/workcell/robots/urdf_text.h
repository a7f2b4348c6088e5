// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace hapticell::workcell::test {

inline std::string robotText(const std::string& body) {
  return "<?xml version=\"1.0\"?>\n<robot name=\"r\">\n" + body + "</robot>\n";
}

inline std::string linkText(const std::string& name, const std::string& body = {}) {
  return "<link name=\"" + name + "\">" + body + "</link>\n";
}

inline std::string jointText(
    const std::string& name, const std::string& parent, const std::string& child, const std::string& type = "revolute",
    const std::string& body = "<axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\" velocity=\"2\" effort=\"1\"/>") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent + "\"/><child link=\"" + child +
         "\"/>" + body + "</joint>\n";
}

/// A tetrahedron with edges of one unit, ASCII STL; `inward`: written inside out.
inline std::string tetrahedronStl(bool inward = false) {
  const char* corners[4] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  std::string text = "solid t\n";
  for (const auto& face : faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int k : {0, inward ? 2 : 1, inward ? 1 : 2}) text += std::string("vertex ") + corners[face[k]] + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid t\n";
}

inline std::string meshText(const std::string& what, const std::string& file, const std::string& attributes = {}) {
  return "<" + what + "><geometry><mesh filename=\"" + file + "\" " + attributes + "/></geometry></" + what + ">";
}

}  // namespace hapticell::workcell::test
