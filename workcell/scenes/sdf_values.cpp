// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/sdf_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "geometry/system/plain_number.h"
#include "geometry/system/text_case.h"
#include "workcell/scenes/sdf_xml.h"
#include "workcell/text/text_cursor.h"

namespace hapticell::workcell {

std::string sdfTextOf(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) {
    text.append(text.empty() ? "" : " ").append(plainNumber(number, std::chars_format::general, 17));
  }
  return text;
}

std::size_t sdfNumbersOf(const std::string& name) {
  static const std::map<std::string, std::size_t> kCounts = {{"size", 3},         {"radius", 1},
                                                             {"length", 1},       {"radii", 3},
                                                             {"scale", 3},        {"xyz", 3},
                                                             {"lower", 1},        {"upper", 1},
                                                             {"velocity", 1},     {"diffuse", 4},
                                                             {"offset", 1},       {"ambient", 4},
                                                             {"multiplier", 1},   {"screw_thread_pitch", 1},
                                                             {"thread_pitch", 1}, {"step", 3},
                                                             {"reference", 1}};
  const auto found = kCounts.find(name);
  return found == kCounts.end() ? 0 : found->second;
}

bool keepSdfPose(TiXmlElement& pose, const TellSdf& tell) {
  const std::string text = textOf(pose), format = attributeOf(pose, "rotation_format");
  const bool quaternion = format == "quat_xyzw";
  if (!format.empty() && !quaternion && format != "euler_rpy") {
    tell(Text("the rotation format '%1' is not known; roll, pitch, yaw is assumed", format));
    pose.RemoveAttribute("rotation_format");
  }
  if (text.empty()) return true;
  std::vector<double> numbers = numbersIn(text);
  const auto usable = std::find_if_not(numbers.begin(), numbers.end(), [](double n) { return isUsable(n); });
  numbers.erase(usable, numbers.end());
  const std::size_t wanted = quaternion ? 7 : 6;
  if (numbers.size() != wanted) {
    tell(Text("the pose '%1' has %2 numbers instead of %3; 0 is assumed for the others", text, numbers.size(), wanted));
    numbers.resize(wanted, 0.0);
    setText(pose, sdfTextOf(numbers));
  }
  if (!quaternion) return true;
  if (std::hypot(std::hypot(numbers[3], numbers[4]), std::hypot(numbers[5], numbers[6])) > 1e-9) return true;
  tell(Text("the pose '%1' has a quaternion of length 0; no rotation is assumed", text));
  numbers[6] = 1.0;
  setText(pose, sdfTextOf(numbers));
  return true;
}

bool keepSdfNumbers(TiXmlElement& element, const TellSdf& tell) {
  const std::string kind = element.ValueStr(), text = textOf(element);
  const std::size_t wanted = sdfNumbersOf(kind);
  std::vector<double> numbers = numbersIn(text);
  const bool color = kind == "diffuse" || kind == "ambient";
  if (color && numbers.size() == 3) numbers.push_back(1.0);
  const bool limit = kind == "lower" || kind == "upper" || kind == "velocity";
  if (limit && numbers.size() == 1 && std::isinf(numbers[0])) numbers[0] = std::copysign(1e16, numbers[0]);
  const bool sound = numbers.size() == wanted &&
                     std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); });
  if (sound) {
    setText(element, sdfTextOf(numbers));
    return true;
  }
  if (color) return false;
  const Text is = wanted > 1 ? Text("<%1> is '%2' instead of %3 numbers", kind, text, wanted)
                             : Text("<%1> is '%2' instead of 1 number", kind, text);
  if (kind == "scale" || kind == "multiplier") {
    tell(Text("%1; 1 is assumed", is));
  } else if (kind == "lower" || kind == "upper") {
    tell(Text("%1; no limit is assumed", is));
  } else if (kind == "offset" || kind == "reference") {
    tell(Text("%1; 0 is assumed", is));
  } else {
    tell(is);
  }
  return false;
}

bool keepSdfWord(TiXmlElement& element) {
  const std::string word = lowerCase(textOf(element));
  if (word != "true" && word != "false" && word != "1" && word != "0") return false;
  setText(element, word == "true" || word == "1" ? "true" : "false");
  return true;
}

bool keepSdfShape(const TiXmlElement& geometry, const TellSdf& tell) {
  const TiXmlElement* const shape = geometry.FirstChildElement();
  if (!shape) return false;  // Told where it was taken out.
  static const std::map<std::string, std::vector<const char*>> kSizes = {{"box", {"size"}},
                                                                         {"sphere", {"radius"}},
                                                                         {"cylinder", {"radius", "length"}},
                                                                         {"capsule", {"radius", "length"}},
                                                                         {"ellipsoid", {"radii"}}};
  const auto sizes = kSizes.find(shape->ValueStr());
  if (sizes == kSizes.end()) return true;
  for (const char* size : sizes->second) {
    const std::vector<double> numbers = numbersIn(textOf(shape, size));
    const bool positive = !numbers.empty() &&
                          std::all_of(numbers.begin(), numbers.end(), [](double n) { return n > 0.0 && isUsable(n); });
    if (positive) continue;
    tell(Text("is left out: a shape <%1> without size", shape->ValueStr()));
    return false;
  }
  return true;
}

}  // namespace hapticell::workcell
