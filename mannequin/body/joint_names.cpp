// SPDX-License-Identifier: Apache-2.0
#include "mannequin/body/joint_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "geometry/system/text_case.h"

namespace hapticell::mannequin {

namespace {

constexpr std::array kLimbWords = {
    "upleg",      "upperleg",         "uleg",   "thigh",    "femur",  "hip",     "hipjoint",   "leg",
    "lowleg",     "lowerleg",         "lleg",   "knee",     "shin",   "calf",    "tibia",      "shank",
    "ankle",      "talocrural",       "foot",   "toe",      "toes",   "toebase", "ball",       "clavicle",
    "collar",     "shoulder",         "arm",    "upperarm", "uparm",  "uarm",    "humerus",    "forearm",
    "lowerarm",   "lowarm",           "farm",   "elbow",    "radius", "ulna",    "radioulnar", "wrist",
    "hand",       "fingers",          "finger", "thumb",    "index",  "middle",  "ring",       "pinky",
    "metatarsal", "sternoclavicular", "breast", "eye",      "heel",   "palm",    "shldr",      "shldrbend",
    "thighbend",  "forearmbend",      "buttock"};

bool isSeparator(char c) {
  return c == ' ' || c == '_' || c == '-' || c == '.';
}

/// Words between separators, small letters.
std::vector<std::string> wordsOf(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : lowerCase(text)) {
    if (!isSeparator(c)) {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::string_view withoutNamespace(std::string_view name) {
  const std::size_t mark = name.find_last_of(":|");
  return mark == std::string_view::npos || mark + 1 == name.size() ? name : name.substr(mark + 1);
}

using Of = JointName::Of;

Of sideOf(std::string_view word) {
  if (word == "l" || word == "left") return Of::kLeft;
  if (word == "r" || word == "right") return Of::kRight;
  return Of::kMiddle;
}

/// The side written at the word's begin or end, taken off it.
Of takeSide(std::string& part) {
  for (const auto& [word, side] : {std::pair{"left", Of::kLeft}, {"right", Of::kRight}}) {
    const std::string_view letters(word);
    if (part.size() > letters.size() && part.starts_with(letters)) {
      part.erase(0, letters.size());
      return side;
    }
    if (part.size() > letters.size() && part.ends_with(letters)) {
      part.erase(part.size() - letters.size());
      return side;
    }
  }
  if (part.size() > 1 && (part[0] == 'l' || part[0] == 'r') && isLimbWord(std::string_view(part).substr(1))) {
    const Of side = part[0] == 'l' ? Of::kLeft : Of::kRight;
    part.erase(0, 1);
    return side;
  }
  return Of::kMiddle;
}

void dropClosingDigits(std::string& part) {
  while (part.size() > 1 && std::isdigit(static_cast<unsigned char>(part.back())) != 0) part.pop_back();
}

JointName nameFrom(std::vector<std::string> words) {
  JointName name;
  if (words.size() > 1) {
    for (std::size_t at : {std::size_t{0}, words.size() - 1}) {
      name.side = sideOf(words[at]);
      if (name.side == Of::kMiddle) continue;
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    }
  }
  for (const std::string& word : words) name.part += word;
  dropClosingDigits(name.part);
  if (name.side == Of::kMiddle) name.side = takeSide(name.part);
  dropClosingDigits(name.part);
  return name;
}

}  // namespace

bool isLimbWord(std::string_view part) {
  std::string word(part);
  dropClosingDigits(word);
  return std::any_of(kLimbWords.begin(), kLimbWords.end(), [&](const char* each) { return word == each; });
}

std::vector<JointName> jointNames(const std::vector<std::string>& names) {
  std::vector<std::vector<std::string>> words;
  std::map<std::string, std::size_t> first;
  for (const std::string& name : names) {
    words.push_back(wordsOf(withoutNamespace(name)));
    if (words.back().empty()) words.back().push_back(lowerCase(name));
    if (words.back().size() > 1 && sideOf(words.back().front()) == Of::kMiddle) ++first[words.back().front()];
  }
  std::string shared;
  for (const auto& [word, count] : first) {
    if (count >= 4 && 10 * count >= 6 * names.size() && !isLimbWord(word)) shared = word;
  }
  std::vector<JointName> result;
  for (std::vector<std::string>& each : words) {
    if (!shared.empty() && each.size() > 1 && each.front() == shared) each.erase(each.begin());
    result.push_back(nameFrom(std::move(each)));
  }
  return result;
}

}  // namespace hapticell::mannequin
