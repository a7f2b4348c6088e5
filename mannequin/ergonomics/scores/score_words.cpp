// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/scores/score_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "geometry/system/text.h"
#include "mannequin/ergonomics/scores/french_words.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::Side;

std::string degrees(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f°", std::abs(value) < 0.5 ? 0.0 : value);
  return text;
}

/// A part of an arm, left and right.
using ArmPart = std::array<std::string_view, 2>;
constexpr std::array<ArmPart, 4> kArmParts{{{HAPTICELL_TRANSLATED("left upper arm", "right upper arm")},
                                            {HAPTICELL_TRANSLATED("left lower arm", "right lower arm")},
                                            {HAPTICELL_TRANSLATED("left wrist", "right wrist")},
                                            {HAPTICELL_TRANSLATED("left wrist twist", "right wrist twist")}}};

std::string armPart(const ArmPart& part, Side side, Language language) {
  return word(part[side == Side::kLeft ? 0 : 1], language);
}

void add(std::string& text, bool given, std::string_view english, Language language) {
  if (given) text += ", " + word(english, language);
}

bool is(const std::optional<bool>& flag) {
  return flag.value_or(false);
}

std::string armReason(const SideScores& s, Language language, bool reba) {
  std::string text = degrees(s.measured.upper_arm_flexion);
  add(text, is(s.angles.shoulder_raised), HAPTICELL_TRANSLATED("raised"), language);
  add(text, is(s.angles.upper_arm_abducted), HAPTICELL_TRANSLATED("abducted"), language);
  if (reba) add(text, is(s.angles.upper_arm_rotated), HAPTICELL_TRANSLATED("rotated"), language);
  add(text, is(s.angles.arm_supported), HAPTICELL_TRANSLATED("supported"), language);
  return text;
}

std::string neckReason(const SideScores& s, Language language) {
  std::string text = degrees(s.measured.neck_flexion);
  add(text, is(s.angles.neck_twisted), HAPTICELL_TRANSLATED("twisted"), language);
  add(text, is(s.angles.neck_side_bent), HAPTICELL_TRANSLATED("bent sideways"), language);
  return text;
}

std::string trunkReason(const SideScores& s, Language language) {
  std::string text = degrees(s.measured.trunk_flexion);
  add(text, is(s.angles.trunk_twisted), HAPTICELL_TRANSLATED("twisted"), language);
  add(text, is(s.angles.trunk_side_bent), HAPTICELL_TRANSLATED("bent sideways"), language);
  return text;
}

std::string legReason(const SideScores& s, Language language) {
  if (s.measured.seated) return word("seated", language);
  return word(is(s.angles.legs_supported) ? "both feet" : "one foot", language);
}

std::string lowerArmReason(const SideScores& s, Language language) {
  std::string text = degrees(s.measured.lower_arm_flexion);
  add(text, is(s.angles.lower_arm_across_midline), HAPTICELL_TRANSLATED("across or outside"), language);
  return text;
}

std::string wristReason(const SideScores& s, Language language) {
  std::string text = degrees(s.measured.wrist_flexion);
  add(text, is(s.angles.wrist_deviated), HAPTICELL_TRANSLATED("deviated"), language);
  return text;
}

}  // namespace

std::string_view codeOf(Language language) {
  constexpr std::array<std::string_view, 2> kCodes{"en", "fr"};
  return kCodes[static_cast<std::size_t>(language)];
}

Language languageOf(std::string_view code) {
  return code.substr(0, 2) == codeOf(Language::kFrench) ? Language::kFrench : Language::kEnglish;
}

std::string word(std::string_view english, Language language) {
  if (language == Language::kFrench) return std::string(french(english));
  return std::string(english);
}

std::string phrase(std::string_view form, const std::vector<std::string>& values, Language language) {
  return filled(word(form, language), values);
}

std::string rulaPart(Rula::Index index, Side side, Language language) {
  if (index <= Rula::kWristTwist) return armPart(kArmParts[index], side, language);
  constexpr std::array<std::string_view, Rula::kCount - 4> kNames{HAPTICELL_TRANSLATED(
      "neck", "trunk", "legs", "muscle use, arm", "force, arm", "muscle use, body", "force, body")};
  return word(kNames[index - Rula::kNeck], language);
}

std::string rebaPart(Reba::Index index, Side side, Language language) {
  switch (index) {
    case Reba::kUpperArm:
      return armPart(kArmParts[Rula::kUpperArm], side, language);
    case Reba::kLowerArm:
      return armPart(kArmParts[Rula::kLowerArm], side, language);
    case Reba::kWrist:
      return armPart(kArmParts[Rula::kWrist], side, language);
    default:
      break;
  }
  constexpr std::array<std::string_view, Reba::kCount> kNames{
      HAPTICELL_TRANSLATED("neck", "trunk", "legs", "", "", "", "load", "coupling", "activity")};
  return word(kNames[index], language);
}

std::string rulaReason(const SideScores& s, Rula::Index index, Language language) {
  switch (index) {
    case Rula::kUpperArm:
      return armReason(s, language, false);
    case Rula::kLowerArm:
      return lowerArmReason(s, language);
    case Rula::kWrist:
      return wristReason(s, language);
    case Rula::kWristTwist:
      return word(is(s.angles.wrist_twist_at_end) ? "end of range" : "mid range", language);
    case Rula::kNeck:
      return neckReason(s, language);
    case Rula::kTrunk:
      return trunkReason(s, language);
    case Rula::kLegs:
      return legReason(s, language);
    default:
      return s.rula[index] ? std::string() : word("not entered", language);
  }
}

std::string rebaReason(const SideScores& s, Reba::Index index, Language language) {
  switch (index) {
    case Reba::kNeck:
      return neckReason(s, language);
    case Reba::kTrunk:
      return trunkReason(s, language);
    case Reba::kLegs:
      return legReason(s, language) + ", " + word("knees", language) + " " + degrees(s.measured.knee_flexion);
    case Reba::kUpperArm:
      return armReason(s, language, true);
    case Reba::kLowerArm:
      return degrees(s.measured.lower_arm_flexion);
    case Reba::kWrist:
      return wristReason(s, language);
    default:
      return s.reba[index] ? std::string() : word("not entered", language);
  }
}

MainDriver mainDriver(const PostureScores& scores, Language language) {
  const Rula method;
  const SideScores& worse = scores.worse();
  std::array<int, Rula::kCount> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = worse.rula[i].value_or(method.subScores()[i].least);
  MainDriver best;
  best.score = 99;
  double worst_share = -1.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const SubScore& sub = method.subScores()[i];
    const int had = values[i];
    values[i] = sub.least;
    const int score = method.score(values);
    values[i] = had;
    const double share =
        static_cast<double>(had - sub.least) / static_cast<double>(std::max(1, sub.greatest - sub.least));
    if (score > best.score || (score == best.score && share <= worst_share)) continue;
    best.score = score;
    best.index = static_cast<Rula::Index>(i);
    worst_share = share;
  }
  best.part = rulaPart(best.index, scores.worseSide(), language);
  best.reason = rulaReason(worse, best.index, language);
  return best;
}

std::string rulaAdvice(int score, Language language) {
  constexpr std::array<std::string_view, 4> kWords{
      HAPTICELL_TRANSLATED("Acceptable", "Look into it", "Change soon", "Change now")};
  return word(kWords[static_cast<std::size_t>(bandOfRula(score))], language);
}

std::string rebaAdvice(int score, Language language) {
  constexpr std::array<std::string_view, 5> kWords{
      HAPTICELL_TRANSLATED("negligible", "low", "medium", "high", "very high")};
  return word(kWords[static_cast<std::size_t>(std::clamp(Reba().levelOf(score), 0, 4))], language);
}

std::string owasAdvice(int category, Language language) {
  constexpr std::array<std::string_view, 4> kWords{
      HAPTICELL_TRANSLATED("normal", "soon", "as early as possible", "at once")};
  return word(kWords[static_cast<std::size_t>(std::clamp(category - 1, 0, 3))], language);
}

std::string whySentence(const PostureScores& scores, Language language) {
  const MainDriver driver = mainDriver(scores, language);
  const int value = scores.worse().rula[driver.index].value_or(0);
  return phrase("The %1 scores %2: %3.",
                {driver.part, std::to_string(value), driver.reason.empty() ? "-" : driver.reason}, language);
}

std::vector<std::string> assumptionsOf(const PostureScores& scores, const WorkTask& task, Language language) {
  std::vector<std::string> lines;
  lines.push_back(word(kBoundaryRule, language));
  lines.push_back(
      word("Twisted or bent sideways from 10° on, abducted from 45°, shoulder raised from 10°, wrist twist at its end "
           "beyond 75 % of the range (this program's choice).",
           language));
  lines.push_back(word(
      "Measured angles of trunk, neck and wrist are neutral within 5° of 0; RULA's neck in extension: class 2 up to "
      "6.5°, 3 up to 8°, beyond 4 (this program's choice).",
      language));
  if (!scores.missing.empty()) {
    std::string missing;
    for (const std::string_view what : scores.missing) missing += (missing.empty() ? "" : ", ") + word(what, language);
    lines.push_back(phrase("The score is partial: not entered: %1.", {missing}, language));
  }
  if (!task.arm_supported[0] && !task.arm_supported[1]) lines.push_back(word("No arm is supported.", language));
  return lines;
}

}  // namespace hapticell::ergonomics
