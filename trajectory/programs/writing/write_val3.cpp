// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "trajectory/motion/number_text.h"
#include "trajectory/programs/writing/program_writers.h"
#include "trajectory/programs/reading/robot_angles.h"

namespace hapticell::trajectory {

namespace {

constexpr const char* kMark = "\xEF\xBB\xBF";  // VAL3 reads UTF-8 with a byte order mark
constexpr const char* kDeclaration = "<?xml version=\"1.0\" encoding=\"utf-8\" ?>\n";
constexpr const char* kNamespace = "http://www.staubli.com/robotics/VAL3/";

std::string program(const std::string& name, const std::string& code) {
  return std::string(kMark) + kDeclaration + "<Programs xmlns=\"" + kNamespace + "Program/2\">\n  <Program name=\"" +
         name + "\">\n    <Code><![CDATA[begin\n" + code + "end]]></Code>\n  </Program>\n</Programs>\n";
}

std::string project(const ProgramInput& input) {
  return std::string(kMark) + kDeclaration + "<Project xmlns=\"" + kNamespace +
         "Project/3\">\n  <Parameters version=\"s7.10.2\" stackSize=\"5000\" millimeterUnit=\"true\" />\n"
         "  <Programs>\n    <Program file=\"start.pgx\" />\n    <Program file=\"stop.pgx\" />\n  </Programs>\n"
         "  <Database>\n    <Data file=\"" +
         input.name + ".dtx\" />\n  </Database>\n  <Libraries />\n</Project>\n";
}

std::string jointValue(std::span<const double> joints) {
  std::string text = "      <Value key=\"0\"";
  for (std::size_t i = 0; i < joints.size(); ++i) {
    text += " j" + std::to_string(i + 1) + "=\"" + fixedText(joints[i] * kDegreesPerRadian, 6) + "\"";
  }
  return text + " />\n";
}

std::string pointValue(const Pose& X, std::size_t key, const std::string& father) {
  const dvec3 p = kMillimetres * X.p;
  const dvec3 r = staubliAngles(X.q);
  return "      <Value key=\"" + std::to_string(key) + "\" x=\"" + fixedText(p.x, 4) + "\" y=\"" + fixedText(p.y, 4) +
         "\" z=\"" + fixedText(p.z, 4) + "\" rx=\"" + fixedText(r.x, 5) + "\" ry=\"" + fixedText(r.y, 5) + "\" rz=\"" +
         fixedText(r.z, 5) + "\" fatherId=\"" + father + "[0]\" />\n";
}

/// Motion data: `share` of the joints' greatest speed, and the TCP's.
std::string motionValue(const std::string& share, const std::string& speed, const std::string& blend, std::size_t key) {
  return "      <Value key=\"" + std::to_string(key) + "\" accel=\"100\" vel=\"" + share + "\" decel=\"100\" tmax=\"" +
         speed + "\" rmax=\"180\" blend=\"" + (blend.empty() ? "off" : "joint") + "\" leave=\"" +
         (blend.empty() ? "0.000" : blend) + "\" reach=\"" + (blend.empty() ? "0.000" : blend) + "\" />\n";
}

/// A tool or frame at its father's place, for the user to teach.
std::string frameValue(const std::string& father) {
  return "      <Value key=\"0\" x=\"0\" y=\"0\" z=\"0\" rx=\"0\" ry=\"0\" rz=\"0\" fatherId=\"" + father +
         "[0]\" />\n";
}

/// Data of a library ("lib:tGrip") or of an array's element are not declared here.
bool isDeclaredHere(const std::string& name) {
  return name.find_first_of(":[") == std::string::npos;
}

std::string array(const std::string& name, const std::string& type, std::size_t size, const std::string& values) {
  return "    <Data name=\"" + name + "\" access=\"private\" xsi:type=\"array\" type=\"" + type + "\" size=\"" +
         std::to_string(size) + "\">\n" + values + "    </Data>\n";
}

}  // namespace

/// An application: project, data, and the programs start and stop, in a folder of its name.
std::vector<ProgramFile> writeVal3(const ProgramInput& input) {
  const std::string tool = input.options.tool.empty() ? "tTool" : input.options.tool;
  const std::string father = input.options.base.empty() ? "world" : input.options.base;
  std::map<std::string, std::size_t> motions;  // by blend
  std::string motion_values, points;
  std::string code =
      "  // Made by HaptiCell. mm and degrees.\n"
      "  // Tool, frame (base) and safety (limits, zones) are your own: check them and the start, run slowly.\n"
      "  // The user's own: " +
      tool + ", " + father + "\n";
  for (std::size_t i = 0; i < input.trajectory.size(); ++i) {
    points += pointValue(input.trajectory[i].X_WT, i, father);
    if (i == 0) {
      code += (input.hasJoints() ? "  movej(jStart[0]," : std::string("  movej(pPoint[0],")) + tool + ",mStart[0])\n";
    } else {
      const std::string blend = input.blends[i] > 0.0 ? input.blend(i) : std::string();
      const auto [motion, is_new] = motions.emplace(blend, motions.size());
      if (is_new) motion_values += motionValue("100", input.speed(), blend, motion->second);
      code +=
          "  movel(pPoint[" + std::to_string(i) + "]," + tool + ",mMotion[" + std::to_string(motion->second) + "])\n";
    }
    if (input.trajectory[i].dwell > 0.0) code += "  waitEndMove()\n  delay(" + input.dwell(i) + ")\n";
  }
  code += "  waitEndMove()\n";
  std::string data = std::string(kMark) + kDeclaration + "<Database xmlns=\"" + kNamespace +
                     "Data/2\" xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\">\n  <Datas>\n";
  if (father != "world" && isDeclaredHere(father)) data += array(father, "frame", 1, frameValue("world"));
  if (input.hasJoints()) data += array("jStart", "jointRx", 1, jointValue(input.trajectory.joints(0)));
  data += array("pPoint", "pointRx", input.trajectory.size(), points);
  data += array("mStart", "mdesc", 1, motionValue(input.jointSpeed(), input.speed(), "", 0));
  if (!motions.empty()) data += array("mMotion", "mdesc", motions.size(), motion_values);
  if (isDeclaredHere(tool)) data += array(tool, "tool", 1, frameValue("flange"));
  data += "  </Datas>\n</Database>\n";
  const std::string folder = input.name + "/";
  return {{folder + input.name + ".pjx", project(input)},
          {folder + input.name + ".dtx", std::move(data)},
          {folder + "start.pgx", program("start", code)},
          {folder + "stop.pgx", program("stop", "  resetMotion()\n")}};
}

}  // namespace hapticell::trajectory
