// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/value_kind.h"

#include <algorithm>

namespace hapticell::cli {

std::span<const ValueWords> valueKinds() {
  static const std::vector<ValueWords> kKinds{
      {ValueKind::kFile, "FILE", {}},
      {ValueKind::kFolder, "FOLDER", {}},
      {ValueKind::kWorkcell, "WORKCELL", {"hcell"}},
      {ValueKind::kRobot, "ROBOT", {"urdf", "xacro", "sdf", "toml"}, true},
      {ValueKind::kModel,
       "MODEL",
       {"step", "stp", "p21", "stpz", "iges", "igs",  "stl",   "obj", "ply",   "off",  "gltf",
        "glb",  "dae", "3mf", "fbx",  "3ds",  "urdf", "xacro", "sdf", "world", "toml", "hcell"},
       true},
      {ValueKind::kMesh, "MESH", {"stl", "obj", "ply", "off"}},
      {ValueKind::kMotion,
       "MOTION",
       {"htraj", "json", "csv", "yaml", "yml", "src", "mod", "modx", "prg", "ls", "script", "urscript", "jbi", "mcap"}},
      {ValueKind::kMcap, "MCAP", {"mcap"}},
      {ValueKind::kExercise, "EXERCISE", {"hexercise"}},
      {ValueKind::kTrainingResults, "TRAINING", {"htrain"}},
      {ValueKind::kStudy, "STUDY", {"hstudy"}},
      {ValueKind::kStudyResults, "RESULTS", {"hresults"}},
      {ValueKind::kTable, "CSV", {"csv"}},
      {ValueKind::kJson, "JSON", {"json"}},
      {ValueKind::kToml, "TOML", {"toml"}},
      {ValueKind::kPicture, "PNG", {"png"}},
  };
  return kKinds;
}

const ValueWords& wordsOf(ValueKind kind) {
  const auto kinds = valueKinds();
  return *std::find_if(kinds.begin(), kinds.end(), [kind](const ValueWords& words) { return words.kind == kind; });
}

}  // namespace hapticell::cli
