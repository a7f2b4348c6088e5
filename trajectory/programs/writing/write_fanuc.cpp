// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "trajectory/motion/number_text.h"
#include "trajectory/programs/writing/program_writers.h"
#include "trajectory/programs/reading/robot_angles.h"

namespace hapticell::trajectory {

namespace {

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.insert(0, width - text.size(), ' ');
  return text;
}

/// Adds numbered lines of the program's body.
class Body {
 public:
  void add(const std::string& statement) { text_ += padded(std::to_string(++count_), 4) + ":" + statement + " ;\n"; }
  const std::string& text() const { return text_; }
  std::size_t count() const { return count_; }

 private:
  std::string text_;
  std::size_t count_ = 0;
};

std::string numberOr(const std::string& number, const char* otherwise) {
  return number.empty() ? otherwise : number;
}

std::string positionOf(const ProgramInput& input, std::size_t i) {
  const Pose& X = input.trajectory[i].X_WT;
  const dvec3 p = kMillimetres * X.p;
  const dvec3 wpr = fanucAngles(X.q);
  std::string configuration = input.configurationAt(i);
  if (configuration.empty()) configuration = "N U T, 0, 0, 0";
  const auto field = [](const char* name, double value, const char* unit, int decimals) {
    return "\t" + std::string(name) + " = " + padded(fixedText(value, decimals), 10) + "  " + unit;
  };
  return "P[" + std::to_string(i + 1) + "]{\n   GP1:\n\tUF : " + numberOr(input.options.base, "0") +
         ", UT : " + numberOr(input.options.tool, "1") + ",\t\tCONFIG : '" + configuration + "',\n" +
         field("X", p.x, "mm", 4) + "," + field("Y", p.y, "mm", 4) + "," + field("Z", p.z, "mm", 4) + ",\n" +
         field("W", wpr.x, "deg", 5) + "," + field("P", wpr.y, "deg", 5) + "," + field("R", wpr.z, "deg", 5) + "\n};\n";
}

/// CNT100 rounds as far as the next half way; less in proportion to the blend wanted. CNT0 passes the point itself.
std::string termination(const ProgramInput& input, std::size_t i) {
  if (input.blends[i] <= 0.0) return "FINE";
  const double before = glm::length(input.trajectory[i].X_WT.p - input.trajectory[i - 1].X_WT.p);
  const double share = before > 0.0 ? 200.0 * input.blends[i] / before : 0.0;
  return "CNT" + fixedText(std::min(share, 100.0), 0);
}

}  // namespace

std::vector<ProgramFile> writeFanuc(const ProgramInput& input) {
  Body body;
  body.add("!Made by HaptiCell");
  body.add("!Your own: tool, base, safety");
  body.add("!Before running: check UTOOL,");
  body.add("!UFRAME and start; run slowly");
  if (!input.options.base.empty()) body.add("  UFRAME_NUM=" + input.options.base);
  if (!input.options.tool.empty()) body.add("  UTOOL_NUM=" + input.options.tool);
  const std::string speed = input.speed() + "mm/sec";
  for (std::size_t i = 0; i < input.trajectory.size(); ++i) {
    std::string line = (i == 0 ? "J P[" : "L P[") + std::to_string(i + 1) + "] ";
    line += i == 0 ? input.jointSpeed() + "% FINE" : speed;
    if (i > 0) line += ' ' + termination(input, i);
    body.add(line);
    if (input.trajectory[i].dwell > 0.0) body.add("  WAIT   " + input.dwell(i) + "(sec)");
  }
  std::string text =
      "/PROG  " + input.name + "\n/ATTR\nOWNER\t\t= MNEDITOR;\nCOMMENT\t\t= \"HaptiCell\";\nPROTECT\t\t= READ_WRITE;\n";
  text += "DEFAULT_GROUP\t= 1,*,*,*,*;\nCONTROL_CODE\t= 00000000 00000000;\n/MN\n" + body.text() + "/POS\n";
  for (std::size_t i = 0; i < input.trajectory.size(); ++i) text += positionOf(input, i);
  text += "/END\n";
  return {{input.name + ".LS", std::move(text)}};
}

}  // namespace hapticell::trajectory
