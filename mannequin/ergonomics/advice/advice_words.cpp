// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/advice/advice_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "geometry/system/text.h"

namespace hapticell::ergonomics {
namespace {

/// A field's words; of a flag the word is a statement that holds or not.
struct FieldWords {
  std::string_view field, words, unit;
};

constexpr auto kFieldWords = std::to_array<FieldWords>({
    {"upper_arm_flexion", HAPTICELL_TRANSLATED("upper arm"), "°"},
    {"lower_arm_flexion", HAPTICELL_TRANSLATED("elbow"), "°"},
    {"wrist_flexion", HAPTICELL_TRANSLATED("wrist"), "°"},
    {"neck_flexion", HAPTICELL_TRANSLATED("neck"), "°"},
    {"trunk_flexion", HAPTICELL_TRANSLATED("trunk forward"), "°"},
    {"knee_flexion", HAPTICELL_TRANSLATED("knees"), "°"},
    {"upper_arm_abducted", HAPTICELL_TRANSLATED("upper arm abducted"), ""},
    {"upper_arm_rotated", HAPTICELL_TRANSLATED("upper arm rotated"), ""},
    {"shoulder_raised", HAPTICELL_TRANSLATED("shoulder raised"), ""},
    {"arm_supported", HAPTICELL_TRANSLATED("arm supported"), ""},
    {"lower_arm_across_midline", HAPTICELL_TRANSLATED("lower arm across or outside"), ""},
    {"wrist_deviated", HAPTICELL_TRANSLATED("wrist deviated"), ""},
    {"wrist_twist", HAPTICELL_TRANSLATED("wrist twisted to its end"), ""},
    {"neck_twisted", HAPTICELL_TRANSLATED("neck twisted"), ""},
    {"neck_side_bent", HAPTICELL_TRANSLATED("neck bent sideways"), ""},
    {"trunk_twisted", HAPTICELL_TRANSLATED("trunk twisted"), ""},
    {"trunk_side_bent", HAPTICELL_TRANSLATED("trunk bent sideways"), ""},
    {"trunk_supported", HAPTICELL_TRANSLATED("trunk supported"), ""},
    {"legs_supported", HAPTICELL_TRANSLATED("both feet bear"), ""},
    {"legs_bilateral", HAPTICELL_TRANSLATED("weight on both legs"), ""},
    {"seated", HAPTICELL_TRANSLATED("seated"), ""},
    {"measured", HAPTICELL_TRANSLATED("measured"), ""},
    {"off_seat", HAPTICELL_TRANSLATED("from being seated"), "°"},
    {"trunk_twist", HAPTICELL_TRANSLATED("trunk twist"), "°"},
    {"trunk_side_bend", HAPTICELL_TRANSLATED("trunk side bend"), "°"},
    {"upper_arm_abduction", HAPTICELL_TRANSLATED("upper arm sideways"), "°"},
    {"gaze_below_horizontal", HAPTICELL_TRANSLATED("line of sight below level"), "°"},
    {"head_inclination", HAPTICELL_TRANSLATED("head forward"), "°"},
    {"shoulder_raised_deg", HAPTICELL_TRANSLATED("shoulder raised"), "°"},
    {"arms_at_or_above_shoulder", HAPTICELL_TRANSLATED("arms at or above the shoulder"), ""},
    {"on_one_leg", HAPTICELL_TRANSLATED("on one leg"), ""},
    {"kneeling", HAPTICELL_TRANSLATED("kneeling"), ""},
    {"hands_above_head", HAPTICELL_TRANSLATED("hands above the head"), ""},
    {"elbow_at_shoulder", HAPTICELL_TRANSLATED("elbow at the shoulder or above"), ""},
    {"h_cm", HAPTICELL_TRANSLATED("hands in front of the ankles"), " cm"},
    {"v_cm", HAPTICELL_TRANSLATED("hands above the floor"), " cm"},
    {"d_cm", HAPTICELL_TRANSLATED("way of the lift"), " cm"},
    {"asymmetry_deg", HAPTICELL_TRANSLATED("turned"), "°"},
    {"frequency_per_min", HAPTICELL_TRANSLATED("lifts a minute"), ""},
    {"load_kg", HAPTICELL_TRANSLATED("load"), " kg"},
    {"coupling", HAPTICELL_TRANSLATED("grip"), ""},
    {"", "", ""},
});

const FieldWords& wordsOf(std::string_view field) {
  const auto found =
      std::find_if(kFieldWords.begin(), kFieldWords.end(), [&](const FieldWords& w) { return w.field == field; });
  return found == kFieldWords.end() ? kFieldWords.back() : *found;
}

std::string nameOfField(std::string_view field, Language language) {
  const FieldWords& words = wordsOf(field);
  if (words.field.empty()) return std::string(field);
  return word(words.words, language);
}

/// Whole degrees, towards where it goes: just under a boundary stays under it.
std::string degrees(double to, double from) {
  const double whole = to < from ? std::floor(to) : std::ceil(to);
  char text[32];
  std::snprintf(text, sizeof text, "%.0f°", whole + 0.0);
  return text;
}

/// A tenth only where there is one.
std::string number(double value) {
  char text[32];
  const double rounded = std::round(10.0 * value) / 10.0;
  std::snprintf(text, sizeof text, rounded == std::round(rounded) ? "%.0f" : "%.1f", rounded + 0.0);
  return text;
}

std::string fromTo(std::string_view field, double from, double to, Language language) {
  const std::string unit(wordsOf(field).unit), name = nameOfField(field, language);
  if (unit == "°") return phrase("%1 %2 to %3", {name, degrees(std::round(from), from), degrees(to, from)}, language);
  return phrase("%1 %2 to %3", {name, number(from) + unit, number(to) + unit}, language);
}

std::string pointsWords(double points, Language language) {
  return phrase("%1 points", {number(points)}, language);
}

/// What a driver would make of it: of a part its zone, else the score.
std::string afterWords(PostureMethod method, const MethodDriver& driver, Language language) {
  if (driver.part.empty()) return scoreWords(method, {driver.score, driver.level}, language);
  return word(nameOf(zoneOfLevel(driver.score)), language);
}

std::string listed(const std::vector<FieldChange>& changes, Language language) {
  std::string text;
  for (const FieldChange& change : changes) text += (text.empty() ? "" : ", ") + changeWords(change, language);
  return text;
}

std::string liftingChangeWords(const LiftingChange& change, Language language) {
  if (change.field == "coupling") return word("good grip", language);
  return fromTo(change.field, change.from, change.to, language);
}

}  // namespace

std::string scoreWords(PostureMethod method, const MethodScore& score, Language language) {
  const int whole = static_cast<int>(std::lround(score.score));
  const std::string name(nameOf(method));
  switch (method) {
    case PostureMethod::kRula:
      return name + " " + std::to_string(whole);
    case PostureMethod::kReba:
      return name + " " + std::to_string(whole) + ", " + rebaAdvice(whole, language);
    case PostureMethod::kOwas:
      return name + " " + std::to_string(whole) + ", " + owasAdvice(whole, language);
    case PostureMethod::kEaws:
      return name + " " + pointsWords(score.score, language);
    case PostureMethod::kEn1005:
    case PostureMethod::kIso11226:
      break;
  }
  return phrase("%1: %2", {name, word(nameOf(zoneOfLevel(score.level)), language)}, language);
}

std::string changeWords(const FieldChange& change, Language language) {
  if (!change.is_flag) return fromTo(change.field, change.from, change.to, language);
  const bool holds = change.to > 0.5;
  return phrase("%1: %2", {nameOfField(change.field, language), word(holds ? "yes" : "no", language)}, language);
}

std::string driverWords(const MethodAdvice& advice, Language language, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(most, advice.drivers.size()); ++i) {
    const MethodDriver& driver = advice.drivers[i];
    text += (i == 0 ? "" : "; ") + listed(driver.changes, language) + " (" +
            afterWords(advice.method, driver, language) + ")";
  }
  return text;
}

std::string nextLevelWords(const MethodAdvice& advice, Language language) {
  if (advice.now.level <= leastLevel(advice.method)) return {};
  if (!advice.next) return word("No change of the posture alone lowers the level.", language);
  return phrase("%1 gives %2",
                {listed(advice.next->changes, language), scoreWords(advice.method, advice.next->score, language)},
                language);
}

std::string placeWords(const BetterPlace& place, const mannequin::Posture& posture, PostureMethod method,
                       Language language) {
  const double far = glm::length(place.shift_W);
  const double ahead = glm::dot(place.shift_W, posture.X_WR.rotate({1.0, 0.0, 0.0}));
  std::string_view way = "to the side";
  if (std::abs(place.shift_W.z) > 0.5 * far)
    way = place.shift_W.z < 0.0 ? "lower" : "higher";
  else if (std::abs(ahead) > 0.5 * far)
    way = ahead < 0.0 ? "nearer" : "further away";
  return phrase("%1: %2",
                {number(1000.0 * far) + " mm " + word(way, language), scoreWords(method, place.score, language)}, language);
}

std::string liftingDriverWords(const LiftingAdvice& advice) {
  std::string text;
  for (const LiftingDriver& driver : advice.drivers) {
    char piece[48];
    std::snprintf(piece, sizeof piece, "%s%.*s %.2f", text.empty() ? "" : ", ",
                  static_cast<int>(driver.multiplier.size()), driver.multiplier.data(), driver.value);
    text += piece;
  }
  return text;
}

std::string liftingNextWords(const LiftingAdvice& advice, Language language) {
  if (advice.level <= 1) return {};
  const bool all = advice.alone.empty() || (advice.alone.size() == 1 && !advice.together.empty());
  const std::string either = " " + word("or", language) + " ";
  std::string text;
  if (all) {
    for (const LiftingChange& change : advice.together)
      text += (text.empty() ? "" : ", ") + liftingChangeWords(change, language);
    if (!advice.alone.empty()) text += (text.empty() ? "" : either) + liftingChangeWords(advice.alone[0], language);
  } else {
    for (const LiftingChange& change : advice.alone)
      text += (text.empty() ? "" : either) + liftingChangeWords(change, language);
  }
  if (text.empty()) return word("No change of this lift alone lowers the level.", language);
  return phrase("%1: lifting index at most %2", {text, number(advice.target)}, language);
}

}  // namespace hapticell::ergonomics
