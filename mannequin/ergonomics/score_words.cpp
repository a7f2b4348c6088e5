// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/score_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <unordered_map>

namespace hapticell::ergonomics {
namespace {

using mannequin::Side;

const std::unordered_map<std::string_view, std::string_view>& french() {
  static const std::unordered_map<std::string_view, std::string_view> words{
      {"left", "gauche"},
      {"right", "droit"},
      {"upper arm", "bras"},
      {"lower arm", "avant-bras"},
      {"wrist", "poignet"},
      {"wrist twist", "torsion du poignet"},
      {"neck", "cou"},
      {"trunk", "tronc"},
      {"legs", "jambes"},
      {"load", "charge"},
      {"coupling", "prise"},
      {"activity", "activité"},
      {"muscle use, arm", "usage musculaire, bras"},
      {"muscle use, body", "usage musculaire, corps"},
      {"force, arm", "effort, bras"},
      {"force, body", "effort, corps"},
      {"force", "force"},
      {"raised", "épaule levée"},
      {"abducted", "écarté"},
      {"rotated", "tourné"},
      {"supported", "soutenu"},
      {"across or outside", "hors du plan"},
      {"deviated", "dévié"},
      {"end of range", "fin de course"},
      {"mid range", "milieu de course"},
      {"twisted", "tourné"},
      {"bent sideways", "incliné de côté"},
      {"both feet", "deux pieds"},
      {"one foot", "un pied"},
      {"seated", "assis"},
      {"knees", "genoux"},
      {"not entered", "non saisi"},
      {"Acceptable", "Acceptable"},
      {"Look into it", "À examiner"},
      {"Change soon", "À changer bientôt"},
      {"Change now", "À changer maintenant"},
      {"negligible", "négligeable"},
      {"low", "faible"},
      {"medium", "moyen"},
      {"high", "élevé"},
      {"very high", "très élevé"},
      {"normal", "normal"},
      {"soon", "bientôt"},
      {"as early as possible", "dès que possible"},
      {"at once", "tout de suite"},
      {"The %s scores %d: %s.", "Le %s est coté %d : %s."},
      {"Posture assessment", "Évaluation de la posture"},
      {"Task assessment", "Évaluation de la tâche"},
      {"Body", "Corps"},
      {"Task", "Tâche"},
      {"Result", "Résultat"},
      {"Body size", "Corpulence"},
      {"Driver", "Cause"},
      {"Reach", "Atteinte"},
      {"What drives the score", "Ce qui détermine la cote"},
      {"Sub-scores", "Cotes partielles"},
      {"Inputs", "Données"},
      {"Assumptions", "Hypothèses"},
      {"Method and limits of this report", "Méthode et limites de ce rapport"},
      {"Source of the posture", "Origine de la posture"},
      {"Assessed by", "Évalué par"},
      {"Date", "Date"},
      {"Signature", "Signature"},
      {"Page", "Page"},
      {"of", "sur"},
      {"woman", "femme"},
      {"man", "homme"},
      {"Stature", "Taille"},
      {"Side", "Côté"},
      {"Part", "Partie"},
      {"Score", "Cote"},
      {"Reason", "Raison"},
      {"Method", "Méthode"},
      {"Level", "Niveau"},
      {"Joint", "Articulation"},
      {"Joint angles", "Angles des articulations"},
      {"Zones by part", "Zones par partie"},
      {"Angle", "Angle"},
      {"Zone", "Zone"},
      {"Condition", "Condition"},
      {"Four bodies at the same task", "Quatre corps à la même tâche"},
      {"Over the recorded motion", "Au fil du mouvement enregistré"},
      {"acceptable", "acceptable"},
      {"conditionally acceptable", "acceptable sous condition"},
      {"not acceptable", "non acceptable"},
      {"The score is partial: not entered", "La cote est partielle : non saisi"},
      {"repetitions", "répétitions"},
      {"static", "statique"},
      {"grip", "prise"},
      {"Standard", "Norme"},
      {"1.3.6, posture outline only", "1.3.6, esquisse de la posture"},
      {"As it stands in the cell.", "Comme elle se tient dans la cellule."},
      {"trunk forward", "tronc en avant"},
      {"trunk side bend", "tronc, inclinaison latérale"},
      {"trunk twist", "tronc, torsion"},
      {"upper arm", "bras"},
      {"line of sight", "ligne de regard"},
      {"trunk symmetry", "symétrie du tronc"},
      {"trunk inclination", "inclinaison du tronc"},
      {"head inclination", "inclinaison de la tête"},
      {"upper arm elevation", "élévation du bras"},
      {"shoulder", "épaule"},
      {"full trunk support", "tronc entièrement soutenu"},
      {"fewer than 2 movements a minute", "moins de 2 mouvements par minute"},
      {"fewer than 2 movements a minute, not held", "moins de 2 mouvements par minute, non tenu"},
      {"not held longer than the holding time", "pas tenu plus longtemps que la durée de maintien"},
      {"standing without support", "debout sans appui"},
      {"arm supported, or fewer than 10 movements a minute", "bras soutenu, ou moins de 10 mouvements par minute"},
      {"standing and walking in turn", "debout et marchant en alternance"},
      {"standing, bent forward 20 to 60 deg", "debout, penché de 20 à 60°"},
      {"standing, bent forward over 60 deg", "debout, penché de plus de 60°"},
      {"standing, elbow at or above shoulder", "debout, coude à l'épaule ou plus haut"},
      {"standing, hands above head", "debout, mains au-dessus de la tête"},
      {"sitting with back support", "assis avec dossier"},
      {"sitting upright", "assis droit"},
      {"sitting, bent forward", "assis, penché en avant"},
      {"sitting, elbow at or above shoulder", "assis, coude à l'épaule ou plus haut"},
      {"sitting, hands above head", "assis, mains au-dessus de la tête"},
      {"kneeling or crouching upright", "à genoux ou accroupi, droit"},
      {"kneeling or crouching, bent forward", "à genoux ou accroupi, penché"},
      {"lying", "couché"},
      {"climbing", "grimpant"},
      {"Lifting", "Levage"},
      {"Forces on the hands", "Efforts aux mains"},
      {"Force", "Effort"},
      {"Limit", "Limite"},
      {"own table", "table propre"},
      {"heaviest class", "classe la plus lourde"},
      {"Own limits:", "Limites propres :"},
      {"Partial: no own limit of the hands' force is entered for this place.",
       "Partiel : aucune limite propre de l'effort aux mains n'est entrée pour cet endroit."},
      {"not reached, short by", "hors d'atteinte, il manque"},
      {"What would bring it down", "Ce qui l'abaisserait"}};
  return words;
}

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
  if (language == Language::kFrench) {
    const auto found = french().find(english);
    if (found != french().end()) return std::string(found->second);
  }
  return std::string(english);
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
