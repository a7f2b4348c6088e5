// SPDX-License-Identifier: Apache-2.0
#include "studies/variants/study_inputs.h"

#include "geometry/system/listed.h"
#include "studies/document/study_section.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/import/entity_source.h"

namespace hapticell::studies {

Expected<const workcell::Entity*> StudyInputs::shapeOf(const std::string& source) {
  const auto known = shapes.find(source);
  if (known != shapes.end()) return &known->second;
  workcell::EntityLoader loader(document.file.parent_path());
  Diagnostics diagnostics;
  auto entity = loader.load(source, 0.0, diagnostics);
  HAPTICELL_TRY(entity);
  if (!workcell::isBuiltIn(source)) files.push_back((document.file.parent_path() / source).lexically_normal());
  notes.insert(notes.end(), diagnostics.warnings.begin(), diagnostics.warnings.end());
  return &shapes.emplace(source, std::move(*entity)).first->second;
}

Expected<std::shared_ptr<const trajectory::Trajectory>> StudyInputs::motionOf(const std::filesystem::path& file) {
  const auto known = motions.find(file.string());
  if (known != motions.end()) return known->second;
  auto motion = trajectory::readTrajectory(file);
  HAPTICELL_TRY(motion);
  files.push_back(file);
  auto shared = std::make_shared<const trajectory::Trajectory>(std::move(*motion));
  motions.emplace(file.string(), shared);
  return shared;
}

Expected<const workcell::Entity*> StudyInputs::entityNamed(const StudySection& section, const std::string& name) const {
  const workcell::Entity* entity = cell.findByName(name);
  if (entity != nullptr) return entity;
  const std::string known = listed(cell.state().entities, [](const auto& one) { return one->name; });
  return makeError(section.fault(Text("no entity of the cell is named '%1'", name), Text("one of %1", known)));
}

}  // namespace hapticell::studies
