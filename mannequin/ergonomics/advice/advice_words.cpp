// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/advice/advice_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace hapticell::ergonomics {
namespace {

/// A field's words; of a flag the word is a statement that holds or not.
struct FieldWords {
  std::string_view field, english, french, unit;
};

constexpr auto kFieldWords = std::to_array<FieldWords>({
    {"upper_arm_flexion", "upper arm", "bras", "°"},
    {"lower_arm_flexion", "elbow", "coude", "°"},
    {"wrist_flexion", "wrist", "poignet", "°"},
    {"neck_flexion", "neck", "cou", "°"},
    {"trunk_flexion", "trunk forward", "tronc en avant", "°"},
    {"knee_flexion", "knees", "genoux", "°"},
    {"upper_arm_abducted", "upper arm abducted", "bras écarté", ""},
    {"upper_arm_rotated", "upper arm rotated", "bras tourné", ""},
    {"shoulder_raised", "shoulder raised", "épaule levée", ""},
    {"arm_supported", "arm supported", "bras soutenu", ""},
    {"lower_arm_across_midline", "lower arm across or outside", "avant-bras hors du plan", ""},
    {"wrist_deviated", "wrist deviated", "poignet dévié", ""},
    {"wrist_twist", "wrist twisted to its end", "torsion du poignet en fin de course", ""},
    {"neck_twisted", "neck twisted", "cou tourné", ""},
    {"neck_side_bent", "neck bent sideways", "cou incliné de côté", ""},
    {"trunk_twisted", "trunk twisted", "tronc tourné", ""},
    {"trunk_side_bent", "trunk bent sideways", "tronc incliné de côté", ""},
    {"trunk_supported", "trunk supported", "tronc soutenu", ""},
    {"legs_supported", "both feet bear", "appui sur les deux pieds", ""},
    {"legs_bilateral", "weight on both legs", "poids sur les deux jambes", ""},
    {"seated", "seated", "assis", ""},
    {"measured", "measured", "mesuré", ""},
    {"off_seat", "from being seated", "pour être assis", "°"},
    {"trunk_twist", "trunk twist", "torsion du tronc", "°"},
    {"trunk_side_bend", "trunk side bend", "inclinaison latérale du tronc", "°"},
    {"upper_arm_abduction", "upper arm sideways", "bras de côté", "°"},
    {"gaze_below_horizontal", "line of sight below level", "regard sous l'horizontale", "°"},
    {"head_inclination", "head forward", "tête en avant", "°"},
    {"shoulder_raised_deg", "shoulder raised", "épaule levée", "°"},
    {"arms_at_or_above_shoulder", "arms at or above the shoulder", "bras à l'épaule ou plus haut", ""},
    {"on_one_leg", "on one leg", "sur une jambe", ""},
    {"kneeling", "kneeling", "à genoux", ""},
    {"hands_above_head", "hands above the head", "mains au-dessus de la tête", ""},
    {"elbow_at_shoulder", "elbow at the shoulder or above", "coude à l'épaule ou plus haut", ""},
    {"h_cm", "hands in front of the ankles", "mains devant les chevilles", " cm"},
    {"v_cm", "hands above the floor", "mains au-dessus du sol", " cm"},
    {"d_cm", "way of the lift", "course du levage", " cm"},
    {"asymmetry_deg", "turned", "rotation", "°"},
    {"frequency_per_min", "lifts a minute", "levages par minute", ""},
    {"load_kg", "load", "charge", " kg"},
    {"coupling", "grip", "prise", ""},
    {"", "", "", ""},
});

const FieldWords& wordsOf(std::string_view field) {
  const auto found =
      std::find_if(kFieldWords.begin(), kFieldWords.end(), [&](const FieldWords& w) { return w.field == field; });
  return found == kFieldWords.end() ? kFieldWords.back() : *found;
}

std::string nameOfField(std::string_view field, Language language) {
  const FieldWords& words = wordsOf(field);
  if (words.field.empty()) return std::string(field);
  return std::string(language == Language::kFrench ? words.french : words.english);
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
  const std::string_view between = language == Language::kFrench ? " à " : " to ";
  if (unit == "°") return name + " " + degrees(std::round(from), from) + std::string(between) + degrees(to, from);
  return name + " " + number(from) + unit + std::string(between) + number(to) + unit;
}

std::string pointsWords(double points, Language language) {
  return number(points) + " " + word("points", language);
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
  const std::string colon = language == Language::kFrench ? " : " : ": ";
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
  return name + colon + word(nameOf(zoneOfLevel(score.level)), language);
}

std::string changeWords(const FieldChange& change, Language language) {
  if (!change.is_flag) return fromTo(change.field, change.from, change.to, language);
  const bool holds = change.to > 0.5;
  return nameOfField(change.field, language) + (language == Language::kFrench ? " : " : ": ") +
         word(holds ? "yes" : "no", language);
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
  const std::string gives = language == Language::kFrench ? " donne " : " gives ";
  return listed(advice.next->changes, language) + gives + scoreWords(advice.method, advice.next->score, language);
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
  const std::string colon = language == Language::kFrench ? " : " : ": ";
  return number(1000.0 * far) + " mm " + word(way, language) + colon + scoreWords(method, place.score, language);
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
  const std::string colon = language == Language::kFrench ? " : " : ": ";
  return text + colon + word("lifting index at most", language) + " " + number(advice.target);
}

}  // namespace hapticell::ergonomics
