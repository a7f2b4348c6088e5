// SPDX-License-Identifier: Apache-2.0
#include "app/studies/study_fields.h"

#include <QCoreApplication>
#include <algorithm>

namespace hapticell::app {

namespace {

constexpr StudyField kEntityField{"entity", QT_TRANSLATE_NOOP("StudyField", "Entity"), StudyEdit::kEntity};
constexpr StudyField kEntitiesField{"entities", QT_TRANSLATE_NOOP("StudyField", "Or several"), StudyEdit::kWords};
constexpr StudyField kRobotField{"entity", QT_TRANSLATE_NOOP("StudyField", "Robot"), StudyEdit::kRobot};
constexpr StudyField kBodyField{"entity", QT_TRANSLATE_NOOP("StudyField", "Mannequin"), StudyEdit::kMannequin};
constexpr StudyField kAxisField{"axis", QT_TRANSLATE_NOOP("StudyField", "Axis"), StudyEdit::kAxis};
constexpr StudyField kRangeField{"from", QT_TRANSLATE_NOOP("StudyField", "Values"), StudyEdit::kRange};
constexpr StudyField kWordsField{"values", QT_TRANSLATE_NOOP("StudyField", "Values"), StudyEdit::kWords};
constexpr StudyField kFileField{"targets", QT_TRANSLATE_NOOP("StudyField", "Targets"), StudyEdit::kFile};
constexpr StudyField kFrameField{"frame", QT_TRANSLATE_NOOP("StudyField", "Relative to"), StudyEdit::kEntity};

std::vector<StudyField> ofTargets(const std::vector<StudyField>& more) {
  std::vector<StudyField> fields{
      kRobotField,
      {"frames", QT_TRANSLATE_NOOP("StudyField", "Frames"), StudyEdit::kFrames},
      kFileField,
      kFrameField,
      {"turns", QT_TRANSLATE_NOOP("StudyField", "Tool turns"), StudyEdit::kWhole, 1.0},
      {"clearance", QT_TRANSLATE_NOOP("StudyField", "Clearance"), StudyEdit::kLength}};
  fields.insert(fields.end(), more.begin(), more.end());
  return fields;
}

std::vector<StudyKind> makeVaryKinds() {
  return {
      {"position", QT_TRANSLATE_NOOP("StudyField", "Position"),
       {kEntityField, kEntitiesField, kAxisField, kRangeField,
        {"absolute", QT_TRANSLATE_NOOP("StudyField", "Absolute"), StudyEdit::kYes}}},
      {"rotation", QT_TRANSLATE_NOOP("StudyField", "Rotation"), {kEntityField, kEntitiesField, kAxisField, kRangeField}},
      {"size", QT_TRANSLATE_NOOP("StudyField", "Size of a part"),
       {kEntityField, {"size", QT_TRANSLATE_NOOP("StudyField", "Size"), StudyEdit::kName}, kRangeField}},
      {"robot", QT_TRANSLATE_NOOP("StudyField", "Robot model"),
       {kRobotField, {"library", QT_TRANSLATE_NOOP("StudyField", "All of the library"), StudyEdit::kYes}, kWordsField}},
      {"joint", QT_TRANSLATE_NOOP("StudyField", "Joint"),
       {kRobotField, {"joint", QT_TRANSLATE_NOOP("StudyField", "Joint"), StudyEdit::kName}, kRangeField}},
      {"tool", QT_TRANSLATE_NOOP("StudyField", "Tool"), {kRobotField, kWordsField}},
      {"tool_offset", QT_TRANSLATE_NOOP("StudyField", "Tool offset"), {kRobotField, kAxisField, kRangeField}},
      {"body", QT_TRANSLATE_NOOP("StudyField", "Body size"), {kBodyField, kWordsField}},
      {"stance", QT_TRANSLATE_NOOP("StudyField", "Stance"), {kBodyField, kWordsField}},
      {"motion", QT_TRANSLATE_NOOP("StudyField", "Motion"), {kWordsField}},
  };
}

std::vector<StudyKind> makeAskKinds() {
  constexpr StudyField kTimeToSpeed{"time_to_speed", QT_TRANSLATE_NOOP("StudyField", "Time to speed"),
                                    StudyEdit::kSeconds, 0.25};
  return {
      {"reach", QT_TRANSLATE_NOOP("StudyField", "Reach"), ofTargets({}),
       {"share", "targets", "reached", "colliding", "beyond_limits", "unreachable"}},
      {"configuration", QT_TRANSLATE_NOOP("StudyField", "Best configuration"), ofTargets({}), {"share", "reached"}},
      {"clearance", QT_TRANSLATE_NOOP("StudyField", "Clearance"),
       ofTargets({{"look", QT_TRANSLATE_NOOP("StudyField", "Look as far as"), StudyEdit::kLength, 0.2}}),
       {"least", "mean"}},
      {"joint_margin", QT_TRANSLATE_NOOP("StudyField", "Joint margin"), ofTargets({}), {"least", "mean"}},
      {"manipulability", QT_TRANSLATE_NOOP("StudyField", "Manipulability"), ofTargets({}), {"least", "mean"}},
      {"cycle_time", QT_TRANSLATE_NOOP("StudyField", "Cycle time"),
       ofTargets({{"dwell", QT_TRANSLATE_NOOP("StudyField", "Dwell"), StudyEdit::kSeconds},
                  {"returns", QT_TRANSLATE_NOOP("StudyField", "Returns"), StudyEdit::kYes, 1.0},
                  kTimeToSpeed,
                  {"check_motions", QT_TRANSLATE_NOOP("StudyField", "Check motions"), StudyEdit::kYes}}),
       {"time", "changes", "collisions"}},
      {"motion", QT_TRANSLATE_NOOP("StudyField", "Motion"),
       {kRobotField, {"motion", QT_TRANSLATE_NOOP("StudyField", "Motion"), StudyEdit::kName}, kTimeToSpeed},
       {"collisions", "limits", "singularities", "clearance", "duration", "least_time"}},
      {"posture", QT_TRANSLATE_NOOP("StudyField", "Posture"),
       {kBodyField,
        {"bodies", QT_TRANSLATE_NOOP("StudyField", "Bodies"), StudyEdit::kWords},
        kFileField,
        kFrameField,
        {"methods", QT_TRANSLATE_NOOP("StudyField", "Methods"), StudyEdit::kMethods},
        {"task", QT_TRANSLATE_NOOP("StudyField", "Work task"), StudyEdit::kName},
        {"may_step", QT_TRANSLATE_NOOP("StudyField", "May step"), StudyEdit::kYes},
        {"balance", QT_TRANSLATE_NOOP("StudyField", "Balance"), StudyEdit::kYes, 1.0},
        {"orientation", QT_TRANSLATE_NOOP("StudyField", "Orientation"), StudyEdit::kYes, 1.0},
        {"all_pairs", QT_TRANSLATE_NOOP("StudyField", "All pairs"), StudyEdit::kYes},
        {"each_body", QT_TRANSLATE_NOOP("StudyField", "Each body"), StudyEdit::kYes},
        {"postures", QT_TRANSLATE_NOOP("StudyField", "Postures"), StudyEdit::kYes}},
       {"share", "steps", "reached", "touching", "short"}},
      {"sight", QT_TRANSLATE_NOOP("StudyField", "Sight"),
       {kBodyField, {"target", QT_TRANSLATE_NOOP("StudyField", "Target"), StudyEdit::kEntity}},
       {"seen", "distance"}},
  };
}

}  // namespace

std::span<const StudyKind> varyKinds() {
  static const std::vector<StudyKind> kinds = makeVaryKinds();
  return kinds;
}

std::span<const StudyKind> askKinds() {
  static const std::vector<StudyKind> kinds = makeAskKinds();
  return kinds;
}

const StudyKind* studyKind(const std::string& table, const std::string& what) {
  const auto kinds = table == "vary" ? varyKinds() : askKinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const StudyKind& one) { return what == one.name; });
  return found == kinds.end() ? nullptr : &*found;
}

QString studyFieldLabel(const char* label) {
  return QCoreApplication::translate("StudyField", label);
}

std::span<const char* const> rangeKeys() {
  static constexpr const char* kKeys[] = {"from", "to", "steps", "values", "middle", "sigma"};
  return kKeys;
}

std::span<const char* const> postureMethods() {
  static constexpr const char* kMethods[] = {"rula", "reba", "owas", "eaws", "comfort", "lifting_index"};
  return kMethods;
}

}  // namespace hapticell::app
