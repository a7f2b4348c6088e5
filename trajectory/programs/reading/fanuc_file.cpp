// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/reading/fanuc_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "geometry/system/text_case.h"
#include "trajectory/motion/csv_table.h"
#include "trajectory/programs/reading/robot_angles.h"

namespace hapticell::trajectory {

namespace {

constexpr double kJointDegree = 0.017453292519943295;  // rad
constexpr double kFanucMillimetre = 1e-3;              // m

class FanucParser {
 public:
  explicit FanucParser(const std::string& text) {
    std::string part, line;
    std::size_t number = 0, begin = 0;
    while (begin < text.size()) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      line = text.substr(begin, end - begin);
      begin = end + 1;
      ++number;
      const auto first = line.find_first_not_of(" \t\r");
      if (first == std::string::npos) continue;
      if (line[first] == '/') {
        part = upperCase(line.substr(first, line.find_first_of(" \t\r", first) - first));
        if (part == "/PROG") file_.name = nameIn(line);
      } else if (part == "/MN") {
        addStatement(line, number);
      } else if (part == "/POS") {
        addPosition(line, number);
      }
    }
    endPosition();
  }

  FanucFile take() { return std::move(file_); }

 private:
  static std::string nameIn(const std::string& line) {
    const auto begin = line.find_first_not_of(" \t", line.find_first_of(" \t"));
    if (begin == std::string::npos) return {};
    return line.substr(begin, line.find_first_of(" \t\r", begin) - begin);
  }

  /// "   4:L P[2] 250mm/sec FINE    ;", or "    :  P[3] ..." that goes on with the line before.
  void addStatement(const std::string& line, std::size_t number) {
    const auto colon = line.find(':');
    if (colon == std::string::npos) return;
    const bool goes_on = is_open_ && !file_.lines.empty();
    std::string text = line.substr(colon + 1);
    const auto begin = text.find_first_not_of(" \t");
    const bool is_remark = begin != std::string::npos && (text[begin] == '!' || text.compare(begin, 2, "//") == 0);
    if (is_remark) return;
    const auto end = text.rfind(';');
    is_open_ = end == std::string::npos;
    if (!is_open_) text.erase(end);
    text = compact(text);
    if (goes_on) {
      file_.lines.back().text += (text.empty() ? "" : " ") + text;
    } else if (!text.empty()) {
      file_.lines.push_back({number, text});
    }
  }

  static std::string compact(const std::string& text) {
    std::string result;
    bool is_text = false;
    for (const char c : text) {
      if (c == '\'') is_text = !is_text;
      if (!is_text && std::isspace(static_cast<unsigned char>(c)) != 0) {
        if (!result.empty() && result.back() != ' ') result += ' ';
      } else {
        result += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      }
    }
    while (!result.empty() && result.back() == ' ') result.pop_back();
    return result;
  }

  void addPosition(const std::string& line, std::size_t number) {
    if (text_.empty()) line_ = number;
    text_ += line + ' ';
    if (line.find('}') != std::string::npos) endPosition();
  }

  void endPosition() {
    const std::string text = upperCase(std::exchange(text_, {}));
    const auto open = text.find("P[");
    if (open == std::string::npos) return;
    const auto number = parseNumber(text.substr(open + 2, text.find_first_of(":]", open) - open - 2));
    if (!number || *number < 0 || *number > 1e6) return;
    FanucPosition position;
    position.line = line_;
    const auto second = text.find("GP2");
    position.has_more_groups = second != std::string::npos;
    const std::string group = text.substr(open, second == std::string::npos ? second : second - open);
    readGroup(group, position);
    file_.positions[static_cast<int>(*number)] = position;
  }

  /// The number behind "NAME =" or "NAME :"; nothing for "********".
  static std::optional<double> field(const std::string& text, const std::string& name, char sign) {
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
      if (at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0) continue;
      const auto behind = text.find_first_not_of(" \t", at + name.size());
      if (behind == std::string::npos || text[behind] != sign) continue;
      const auto begin = text.find_first_not_of(" \t", behind + 1);
      if (begin == std::string::npos) return std::nullopt;
      const auto end = text.find_first_not_of("0123456789.+-E", begin);
      return parseNumber(text.substr(begin, end == std::string::npos ? end : end - begin));
    }
    return std::nullopt;
  }

  static void readGroup(const std::string& whole, FanucPosition& position) {
    // The configuration has letters and numbers of its own.
    std::string text = whole;
    if (const auto begin = text.find('\''); begin != std::string::npos) {
      const auto end = text.find('\'', begin + 1);
      text.erase(begin, end == std::string::npos ? end : end - begin + 1);
    }
    // "UF : F" is the frame that is chosen when the program runs.
    const double unsaid = text.find("UF") == std::string::npos ? 0.0 : -1.0;
    position.frame = static_cast<int>(std::clamp(field(text, "UF", ':').value_or(unsaid), -1.0, 1000.0));
    std::array<std::optional<double>, 6> x{}, j{};
    position.has_external_axes = field(text, "E1", '=').value_or(0.0) != 0.0;
    static constexpr std::array<const char*, 6> kNames{"X", "Y", "Z", "W", "P", "R"};
    for (std::size_t i = 0; i < 6; ++i) {
      x[i] = field(text, kNames[i], '=');
      j[i] = field(text, "J" + std::to_string(i + 1), '=');
    }
    const auto isThere = [](const auto& v) { return v.has_value(); };
    if (std::all_of(x.begin(), x.end(), isThere)) {
      position.X = Pose{kFanucMillimetre * dvec3(*x[0], *x[1], *x[2]), fromFanucAngles({*x[3], *x[4], *x[5]})};
    } else if (std::all_of(j.begin(), j.end(), isThere)) {
      ProgramPath::Joints joints{};
      for (std::size_t i = 0; i < 6; ++i) joints[i] = *j[i] * kJointDegree;
      position.joints = joints;
    }
  }

  FanucFile file_;
  std::string text_;
  std::size_t line_ = 0;
  bool is_open_ = false;  // the line before has no ';'
};

}  // namespace

FanucFile parseFanuc(const std::string& text) {
  return FanucParser(text).take();
}

}  // namespace hapticell::trajectory
