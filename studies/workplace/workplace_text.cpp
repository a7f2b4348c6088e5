// SPDX-License-Identifier: Apache-2.0
#include "studies/workplace/workplace_text.h"

#include "geometry/system/assertion.h"

namespace hapticell::studies {

namespace {

/// A table [[vary]] that moves the station.
RangeKeys movedBy(const std::string& name, const std::vector<std::string>& station, const char* key, StudyValue along,
                  const RangeKeys& range) {
  RangeKeys keys{{"what", std::string("position")}, {"name", name}, {"entities", station}, {key, std::move(along)}};
  keys.insert(keys.end(), range.begin(), range.end());
  return keys;
}

StudyValue ifTrue(bool flag) {
  return flag ? StudyValue(true) : StudyValue();
}

}  // namespace

const std::vector<std::string>& workplaceBodies() {
  static const std::vector<std::string> bodies{"female:5", "female:50", "male:50", "male:95"};
  return bodies;
}

Expected<void> addWorkplaceTables(StudyText& text, const WorkplaceTables& tables, const WorkplaceNames& names) {
  HAPTICELL_DEMAND(!tables.station.empty());
  if (tables.may_sit) {
    std::vector<std::string> stances;
    if (tables.may_stand) stances.emplace_back("given");
    stances.emplace_back("seated");
    HAPTICELL_TRY(text.add("vary", {{"what", std::string("stance")},
                                    {"name", names.stance},
                                    {"entity", tables.mannequin},
                                    {"values", stances}}));
  }
  HAPTICELL_TRY(text.add("vary", movedBy(names.height, tables.station, "axis", std::string("z"), tables.height)));
  const std::vector<double> ahead{tables.ahead_W.x, tables.ahead_W.y, 0.0};
  HAPTICELL_TRY(text.add("vary", movedBy(names.distance, tables.station, "direction", ahead, tables.distance)));
  HAPTICELL_TRY(text.add("ask", {{"what", std::string("posture")},
                                 {"name", names.asked},
                                 {"entity", tables.mannequin},
                                 {"bodies", workplaceBodies()},
                                 {"frame", tables.station.front()},
                                 {"methods", tables.methods},
                                 {"task", tables.task.empty() ? StudyValue() : StudyValue(tables.task)},
                                 {"all_pairs", ifTrue(tables.all_pairs)},
                                 {"each_body", ifTrue(tables.each_body)},
                                 {"postures", ifTrue(tables.postures)}}));
  HAPTICELL_TRY(text.add("require", {{"value", names.asked + ".share"}, {"at_least", 1.0}}));
  return text.add("objective", {{"value", names.asked + ".rula"}});
}

}  // namespace hapticell::studies
