// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/robot_reader.h"

#include <cctype>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/regular_file.h"
#include "geometry/system/text_case.h"
#include "workcell/robots/srdf.h"
#include "workcell/robots/xacro_file.h"
#include "workcell/scenes/sdf_reader.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

// Bytes looked at for the first element, as kHead of claimed_content.cpp.
constexpr std::size_t kRobotHead = 65536;

/// An XML text without its comments.
std::string withoutComments(const std::string& text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = text.find("<!--", at);
    plain.append(text, at, begin - at);
    if (begin == std::string::npos) break;
    const std::size_t end = text.find("-->", begin + 4);
    at = end == std::string::npos ? text.size() : end + 3;
  }
  return plain;
}

/// The name of the first element of an XML text without comments; empty where it begins otherwise, or later than there
/// is text.
std::string rootElementOf(const std::string& text) {
  std::size_t at = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  while (at != std::string::npos && (text.compare(at, 2, "<?") == 0 || text.compare(at, 2, "<!") == 0)) {
    const std::size_t end = text.find('>', at);
    at = end == std::string::npos ? end : text.find_first_not_of(" \t\r\n", end + 1);
  }
  if (at == std::string::npos || text[at] != '<') return {};
  return text.substr(at + 1, text.find_first_of(" \t\r\n/>", at + 1) - at - 1);
}

/// Whether the text has `before`, one of the words, and one of the letters of `end`, in a row.
bool hasOneOf(std::string_view text, std::string_view before, std::span<const std::string_view> words,
              std::string_view end) {
  for (std::size_t at = text.find(before); at != std::string_view::npos; at = text.find(before, at + 1)) {
    const std::string_view rest = text.substr(at + before.size());
    for (const std::string_view word : words) {
      if (rest.starts_with(word) && rest.size() > word.size() && end.find(rest[word.size()]) != std::string_view::npos)
        return true;
    }
  }
  return false;
}

/// Whether something is defined, asked or worked out: a call of a macro that nothing defines is left of a file that was
/// expanded without it, and no reason to take the file for a xacro.
bool isXacroText(const std::string& text) {
  constexpr std::string_view kElements[] = {"macro",  "property",     "include",   "arg",    "if",
                                            "unless", "insert_block", "attribute", "element"};
  constexpr std::string_view kSubstitutions[] = {"arg", "optenv", "env", "eval"};
  return hasOneOf(text, "<xacro:", kElements, " \t\n\v\f\r/>") || hasOneOf(text, "$(", kSubstitutions, " ");
}

/// The moving joints on the way to each link that carries no other, as "rrp"; a turning joint is an "r", limited or
/// not.
std::map<std::string, int> freeLegs(const kinematics::RobotModel& model) {
  std::vector<std::string> way(model.links.size());
  std::vector<bool> carries(model.links.size(), false);
  for (const kinematics::Joint& joint : model.joints) {
    const auto parent = static_cast<std::size_t>(joint.parent_link);
    carries[parent] = true;
    const char* kind = joint.type == kinematics::JointType::kPrismatic ? "p" : "r";
    if (joint.variable < 0) kind = "";
    way[static_cast<std::size_t>(joint.child_link)] = way[parent] + kind;
  }
  std::map<std::string, int> legs;
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (!carries[i]) ++legs[way[i]];
  }
  return legs;
}

/// A parallel robot written as a tree, for URDF has no words for its loops: three or more equal legs that end free.
void hintAtOpenLoops(const kinematics::RobotModel& model, Diagnostics& diagnostics) {
  // Equal free legs, and joints of each, from which a robot looks parallel: fewer are grippers' fingers. Half: grippers
  // are warned of; twice: deltas are not.
  constexpr int kLegs = 3;
  // Joints of a leg; see kLegs.
  constexpr std::size_t kJoints = 3;
  for (const auto& [way, count] : freeLegs(model)) {
    if (count < kLegs || way.size() < kJoints) continue;
    diagnostics.warn(
        Text("%1 equal legs of %2 joints have free ends: for a parallel robot, the file does not define the closed "
             "loops; define them in a robot.toml (docs/user/formats.md)",
             count, way.size()));
  }
}

}  // namespace

std::optional<RobotFormat> robotFormatOf(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  const std::string extension = lowerExtension(file), head = geometry::headOfFile(file, kRobotHead);
  if (extension == ".toml") return RobotFormat::kToml;
  const std::size_t begin = head.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (begin == std::string::npos || head[begin] != '<') return std::nullopt;
  if (extension == ".xacro") return RobotFormat::kXacro;
  const std::string text = withoutComments(head), root = rootElementOf(text);
  if (root == "robot") return isXacroText(text) ? RobotFormat::kXacro : RobotFormat::kUrdf;
  if (extension == ".sdf" || extension == ".world" || root == "sdf") return RobotFormat::kSdf;
  return extension == ".urdf" ? std::optional(RobotFormat::kUrdf) : std::nullopt;
}

const char* formatName(RobotFormat format) {
  switch (format) {
    case RobotFormat::kXacro:
      return "xacro";
    case RobotFormat::kSdf:
      return "sdf";
    case RobotFormat::kToml:
      return "toml";
    case RobotFormat::kUrdf:
      break;
  }
  return "urdf";
}

Expected<TomlRobot> readRobot(const fs::path& file, Diagnostics& diagnostics, ImportMonitor* monitor,
                              RobotContent content, const xacro::Arguments& arguments,
                              std::vector<xacro::DeclaredArgument>* declared) {
  const RobotFormat format = robotFormatOf(file).value_or(RobotFormat::kUrdf);  // Whose reader says what it is instead.
  if (format != RobotFormat::kXacro && !arguments.empty())
    diagnostics.warn(Text("the file is not xacro; the value of '%1' was not used", arguments.begin()->first));
  if (format == RobotFormat::kToml) return readRobotToml(file, diagnostics);
  Pose X_FB;
  Expected<kinematics::RobotModel> model = [&]() -> Expected<kinematics::RobotModel> {
    if (format == RobotFormat::kSdf) {
      Expected<SdfRobot> read = readSdf(file, diagnostics, monitor);
      HAPTICELL_TRY(read);
      X_FB = read->X_FB;
      return std::move(read->model);
    }
    if (format == RobotFormat::kUrdf) return readUrdf(file, diagnostics, monitor, content);
    std::vector<xacro::DeclaredArgument> unasked;
    const auto expanded = expandXacroFile(file, arguments, declared ? *declared : unasked, diagnostics);
    HAPTICELL_TRY(expanded);
    return readUrdfText(expanded->text, file, diagnostics, monitor, content, &expanded->places);
  }();
  HAPTICELL_TRY(model);
  if (!model->closure) hintAtOpenLoops(*model, diagnostics);
  TomlRobot robot;
  robot.model = std::move(*model);
  robot.X_FB = X_FB;
  robot.sheet.name = robot.model.name;
  if (const auto srdf = format == RobotFormat::kSdf ? std::nullopt : findSrdf(file, robot.model.name)) {
    HAPTICELL_TRY(readSrdf(*srdf, robot.model, diagnostics));
  }
  return robot;
}

std::vector<xacro::DeclaredArgument> robotArguments(const fs::path& file, const xacro::Arguments& arguments) {
  std::vector<xacro::DeclaredArgument> declared;
  Diagnostics ignored;
  if (robotFormatOf(file) == RobotFormat::kXacro)
    static_cast<void>(expandXacroFile(file, arguments, declared, ignored));
  return declared;
}

}  // namespace hapticell::workcell
