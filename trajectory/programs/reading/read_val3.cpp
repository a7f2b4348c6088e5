// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <map>

#include "trajectory/motion/csv_table.h"
#include "trajectory/programs/reading/program_path.h"
#include "trajectory/programs/reading/program_readers.h"
#include "trajectory/programs/reading/robot_angles.h"

namespace hapticell::trajectory {

namespace {

using Attributes = std::map<std::string, std::string>;

/// name="value" ... of a tag.
Attributes attributesIn(const std::string& tag) {
  Attributes attributes;
  for (std::size_t at = tag.find("=\""); at != std::string::npos; at = tag.find("=\"", at)) {
    const std::size_t blank = tag.find_last_of(" \t\n", at);
    const std::size_t end = tag.find('"', at + 2);
    if (end == std::string::npos) break;
    const std::size_t begin = blank == std::string::npos ? 0 : blank + 1;
    attributes[tag.substr(begin, at - begin)] = tag.substr(at + 2, end - at - 2);
    at = end + 1;
  }
  return attributes;
}

std::map<std::string, std::vector<Attributes>> database(const std::string& text) {
  std::map<std::string, std::vector<Attributes>> data;
  std::string name;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) break;
    const std::string tag = text.substr(at + 1, end - at - 1);
    if (tag.starts_with("Data ")) name = attributesIn(tag)["name"];
    if (tag.starts_with("Value ")) data[name].push_back(attributesIn(tag));
  }
  return data;
}

std::optional<Pose> pointOf(const Attributes& value) {
  std::array<double, 6> n{};
  static constexpr std::array<const char*, 6> kNames{"x", "y", "z", "rx", "ry", "rz"};
  for (std::size_t i = 0; i < n.size(); ++i) {
    const auto found = value.find(kNames[i]);
    const auto number = found == value.end() ? std::nullopt : parseNumber(found->second);
    if (!number) return std::nullopt;
    n[i] = *number;
  }
  return Pose{1e-3 * dvec3(n[0], n[1], n[2]), fromStaubliAngles({n[3], n[4], n[5]})};
}

/// "name[3]" as its value; the first element where no index is said.
const Attributes* valueOf(const std::map<std::string, std::vector<Attributes>>& data, const std::string& text) {
  const std::size_t bracket = text.find('[');
  const auto found = data.find(text.substr(0, bracket));
  if (found == data.end()) return nullptr;
  const auto index = bracket == std::string::npos
                         ? std::optional(0.0)
                         : parseNumber(text.substr(bracket + 1, text.find(']', bracket) - bracket - 1));
  if (!index || !(*index >= 0.0) || !(*index < static_cast<double>(found->second.size()))) return nullptr;
  return &found->second[static_cast<std::size_t>(*index)];
}

}  // namespace

/// What is written only: movej and movel to data, delay(). The first move by joints is to the first of the points.
Expected<ReadProgram> readVal3(const std::string& data_text, const std::string& code) {
  const ProgramReadOptions options;
  ProgramPath path(options);
  const auto data = database(data_text);
  std::size_t line = 0;
  for (std::size_t begin = 0; begin < code.size() && !path.hasFailed(); ++line) {
    const std::size_t end = std::min(code.find('\n', begin), code.size());
    std::string text = code.substr(begin, end - begin);
    begin = end + 1;
    text.erase(0, std::min(text.find_first_not_of(" \t"), text.size()));
    if (text.starts_with("delay(")) path.wait(parseNumber(text.substr(6, text.find(')') - 6)).value_or(0.0));
    if (!text.starts_with("movej(") && !text.starts_with("movel(")) continue;
    const Attributes* value = valueOf(data, text.substr(6, text.find(',') - 6));
    if (value && value->contains("j1")) value = valueOf(data, "pPoint[0]");
    const auto X = value ? pointOf(*value) : std::nullopt;
    if (X)
      path.moveTo(line, *X, text.starts_with("movej("));
    else
      path.missTarget(line, Text("data that is not in the database"));
  }
  return path.finish("");
}

}  // namespace hapticell::trajectory
