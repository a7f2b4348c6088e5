// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/scores/score_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "mannequin/ergonomics/scores/french_words.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::Side;

std::string degrees(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f°", std::abs(value) < 0.5 ? 0.0 : value);
  return text;
}

std::string sided(std::string_view part, Side side, Language language) {
  const std::string which = word(side == Side::kLeft ? "left" : "right", language);
  return language == Language::kFrench ? word(part, language) + " " + which : which + " " + word(part, language);
}

void add(std::string& text, bool given, std::string_view english, Language language) {
  if (given) text += ", " + word(english, language);
}

bool is(const std::optional<bool>& flag) {
  return flag.value_or(false);
}

std::string armReason(const SideScores& s, Language language, bool reba) {
  std::string text = degrees(s.measured.upper_arm_flexion);
  add(text, is(s.angles.shoulder_raised), "raised", language);
  add(text, is(s.angles.upper_arm_abducted), "abducted", language);
  if (reba) add(text, is(s.angles.upper_arm_rotated), "rotated", language);
  add(text, is(s.angles.arm_supported), "supported", language);
  return text;
}

std::string neckReason(const SideScores& s, Language language) {
  std::string text = degrees(s.measured.neck_flexion);
  add(text, is(s.angles.neck_twisted), "twisted", language);
  add(text, is(s.angles.neck_side_bent), "bent sideways", language);
  return text;
}

std::string trunkReason(const SideScores& s, Language language) {
  std::string text = degrees(s.measured.trunk_flexion);
  add(text, is(s.angles.trunk_twisted), "twisted", language);
  add(text, is(s.angles.trunk_side_bent), "bent sideways", language);
  return text;
}

std::string legReason(const SideScores& s, Language language) {
  if (s.measured.seated) return word("seated", language);
  return word(is(s.angles.legs_supported) ? "both feet" : "one foot", language);
}

std::string lowerArmReason(const SideScores& s, Language language) {
  std::string text = degrees(s.measured.lower_arm_flexion);
  add(text, is(s.angles.lower_arm_across_midline), "across or outside", language);
  return text;
}

std::string wristReason(const SideScores& s, Language language) {
  std::string text = degrees(s.measured.wrist_flexion);
  add(text, is(s.angles.wrist_deviated), "deviated", language);
  return text;
}

}  // namespace

std::string word(std::string_view english, Language language) {
  return std::string(language == Language::kFrench ? french(english) : english);
}

std::string rulaPart(Rula::Index index, Side side, Language language) {
  constexpr std::array<std::string_view, Rula::kCount> kNames{
      "upper arm", "lower arm",       "wrist",      "wrist twist",      "neck",       "trunk",
      "legs",      "muscle use, arm", "force, arm", "muscle use, body", "force, body"};
  if (index <= Rula::kWristTwist) return sided(kNames[index], side, language);
  return word(kNames[index], language);
}

std::string rebaPart(Reba::Index index, Side side, Language language) {
  constexpr std::array<std::string_view, Reba::kCount> kNames{"neck",  "trunk", "legs",     "upper arm", "lower arm",
                                                              "wrist", "load",  "coupling", "activity"};
  const bool arm = index == Reba::kUpperArm || index == Reba::kLowerArm || index == Reba::kWrist;
  return arm ? sided(kNames[index], side, language) : word(kNames[index], language);
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
  constexpr std::array<std::string_view, 4> kWords{"Acceptable", "Look into it", "Change soon", "Change now"};
  return word(kWords[static_cast<std::size_t>(bandOfRula(score))], language);
}

std::string rebaAdvice(int score, Language language) {
  constexpr std::array<std::string_view, 5> kWords{"negligible", "low", "medium", "high", "very high"};
  return word(kWords[static_cast<std::size_t>(std::clamp(Reba().levelOf(score), 0, 4))], language);
}

std::string owasAdvice(int category, Language language) {
  constexpr std::array<std::string_view, 4> kWords{"normal", "soon", "as early as possible", "at once"};
  return word(kWords[static_cast<std::size_t>(std::clamp(category - 1, 0, 3))], language);
}

std::string whySentence(const PostureScores& scores, Language language) {
  const MainDriver driver = mainDriver(scores, language);
  const int value = scores.worse().rula[driver.index].value_or(0);
  const std::string form = word("The %s scores %d: %s.", language);
  char text[200];
  std::snprintf(text, sizeof text, form.c_str(), driver.part.c_str(), value,
                driver.reason.empty() ? "-" : driver.reason.c_str());
  return text;
}

std::vector<std::string> assumptionsOf(const PostureScores& scores, const WorkTask& task, Language language) {
  std::vector<std::string> lines;
  const bool fr = language == Language::kFrench;
  lines.emplace_back(fr ? "Limites : une limite intérieure appartient à la classe inférieure ; la dernière classe de "
                          "RULA comprend sa limite."
                        : kBoundaryRule);
  lines.emplace_back(fr ? "Tourné ou incliné à partir de 10°, écarté à partir de 45°, épaule levée à partir de 10°, "
                          "torsion du poignet en fin de course au-delà de 75 % (choix de ce programme)."
                        : "Twisted or bent sideways from 10° on, abducted from 45°, shoulder raised from 10°, wrist "
                          "twist at its end beyond 75 % of the range (this program's choice).");
  lines.emplace_back(
      fr ? "Angles mesurés de tronc, cou et poignet : neutres à moins de 5° de 0 ; extension du cou pour "
           "RULA : classe 2 jusqu'à 6,5°, 3 jusqu'à 8°, 4 au-delà (choix de ce programme)."
         : "Measured angles of trunk, neck and wrist are neutral within 5° of 0; RULA's neck in extension: "
           "class 2 up to 6.5°, 3 up to 8°, beyond 4 (this program's choice).");
  if (!scores.missing.empty()) {
    std::string line = word("The score is partial: not entered", language);
    const char* separator = fr ? " : " : ": ";
    for (const std::string_view what : scores.missing) {
      line += separator + word(what, language);
      separator = ", ";
    }
    lines.push_back(line + ".");
  }
  if (!task.arm_supported[0] && !task.arm_supported[1])
    lines.emplace_back(fr ? "Aucun bras n'est soutenu." : "No arm is supported.");
  return lines;
}

}  // namespace hapticell::ergonomics
