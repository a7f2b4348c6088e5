// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "geometry/system/assertion.h"
#include "mannequin/posture/posture.h"

namespace hapticell::mannequin {

namespace {

/// Angles in degrees; "l_" and "r_" stand for both sides where a name begins with "both_".
struct Angle {
  const char* name;
  double degrees;
};

void set(Posture& posture, const std::string& name, double degrees) {
  const std::optional<Dof> dof = findDof(name);
  HAPTICELL_DEMAND(dof.has_value());
  posture[*dof] = degrees * std::numbers::pi / 180.0;
}

LibraryPosture make(const char* name, std::initializer_list<Angle> angles, double root_pitch_degrees = 0.0) {
  LibraryPosture entry{name, {}};
  for (const Angle& angle : angles) {
    const std::string text = angle.name;
    if (!text.starts_with("both_")) {
      set(entry.posture, text, angle.degrees);
      continue;
    }
    for (const char* side : {"l_", "r_"}) set(entry.posture, side + text.substr(5), angle.degrees);
  }
  entry.posture.X_WR.q = quaternionFromRotationVector({0.0, root_pitch_degrees * std::numbers::pi / 180.0, 0.0});
  return entry;
}

void addAtRest(std::vector<LibraryPosture>& all) {
  all.push_back(make("zero", {}));
  all.push_back(make("standing", {{"both_shoulder_abduction", 9},
                                  {"both_shoulder_flexion", 4},
                                  {"both_elbow_flexion", 14},
                                  {"both_radioulnar_pronation", 12},
                                  {"both_fingers_curl", 25},
                                  {"both_thumb_flexion", 15},
                                  {"both_thumb_abduction", 15}}));
  all.push_back(make(
      "t_pose",
      {{"both_sternoclavicular_elevation", 13}, {"both_shoulder_abduction", 77}, {"both_radioulnar_pronation", 80}}));
  all.push_back(make("seated", {{"both_hip_flexion", 88},
                                {"both_hip_abduction", 6},
                                {"both_knee_flexion", 88},
                                {"vl5_flexion", 6},
                                {"both_shoulder_flexion", 14},
                                {"both_shoulder_abduction", 10},
                                {"both_elbow_flexion", 75},
                                {"both_shoulder_internal_rotation", 12},
                                {"both_radioulnar_pronation", 45},
                                {"both_fingers_curl", 25},
                                {"both_thumb_flexion", 15},
                                {"both_thumb_abduction", 15}}));
  all.push_back(make("typing", {{"both_hip_flexion", 88},
                                {"both_hip_abduction", 6},
                                {"both_knee_flexion", 88},
                                {"both_shoulder_flexion", 22},
                                {"both_shoulder_abduction", 8},
                                {"both_elbow_flexion", 85},
                                {"both_shoulder_internal_rotation", 20},
                                {"both_radioulnar_pronation", 75},
                                {"both_fingers_curl", 30},
                                {"both_thumb_flexion", 15},
                                {"vc7_flexion", 6},
                                {"vc4_flexion", 5}}));
}

void addAtWork(std::vector<LibraryPosture>& all) {
  all.push_back(make("overhead", {{"both_sternoclavicular_elevation", 26},
                                  {"both_shoulder_flexion", 122},
                                  {"both_shoulder_abduction", 14},
                                  {"both_elbow_flexion", 32},
                                  {"vt6_flexion", -4},
                                  {"vc7_flexion", -8},
                                  {"vc4_flexion", -10},
                                  {"skullbase_flexion", -8},
                                  {"both_radioulnar_pronation", 30},
                                  {"both_fingers_curl", 35},
                                  {"both_thumb_flexion", 15}}));
  all.push_back(make("reaching", {{"r_sternoclavicular_elevation", 6},
                                  {"r_sternoclavicular_protraction", 10},
                                  {"r_shoulder_flexion", 82},
                                  {"r_shoulder_abduction", 6},
                                  {"r_elbow_flexion", 18},
                                  {"r_radioulnar_pronation", 35},
                                  {"r_fingers_curl", 30},
                                  {"r_thumb_abduction", 25},
                                  {"vl5_flexion", 6},
                                  {"vl1_flexion", 6},
                                  {"vl1_left_turn", 4},
                                  {"vt6_left_turn", 8},
                                  {"l_shoulder_abduction", 10},
                                  {"l_elbow_flexion", 20},
                                  {"l_fingers_curl", 25}}));
  all.push_back(make("both_hands_forward", {{"both_shoulder_flexion", 62},
                                            {"both_shoulder_abduction", 8},
                                            {"both_elbow_flexion", 42},
                                            {"both_radioulnar_pronation", 10},
                                            {"both_fingers_curl", 45},
                                            {"both_thumb_abduction", 25}}));
  all.push_back(make("pushing",
                     {{"both_shoulder_flexion", 72},
                      {"both_shoulder_abduction", 12},
                      {"both_elbow_flexion", 48},
                      {"both_radioulnar_pronation", 60},
                      {"both_wrist_flexion", -45},
                      {"l_hip_flexion", 42},
                      {"l_knee_flexion", 44},
                      {"l_talocrural_plantar_flexion", -12},
                      {"r_hip_flexion", -8},
                      {"r_knee_flexion", 12},
                      {"r_talocrural_plantar_flexion", -14},
                      {"vl5_flexion", 4}},
                     10.0));
}

void addLowDown(std::vector<LibraryPosture>& all) {
  all.push_back(make("stooping",
                     {{"both_hip_flexion", 62},
                      {"both_knee_flexion", 12},
                      {"vl5_flexion", 20},
                      {"vl1_flexion", 18},
                      {"vt6_flexion", 8},
                      {"both_shoulder_flexion", 62},
                      {"both_shoulder_abduction", 8},
                      {"both_elbow_flexion", 20},
                      {"both_fingers_curl", 40},
                      {"vc7_flexion", -8},
                      {"vc4_flexion", -8},
                      {"both_talocrural_plantar_flexion", 4}},
                     54.0));
  all.push_back(make("squatting",
                     {{"both_hip_flexion", 112},
                      {"both_hip_abduction", 10},
                      {"both_knee_flexion", 128},
                      {"both_talocrural_plantar_flexion", -20},
                      {"vl5_flexion", 14},
                      {"vl1_flexion", 10},
                      {"both_shoulder_flexion", 80},
                      {"both_shoulder_abduction", 6},
                      {"both_elbow_flexion", 30},
                      {"both_fingers_curl", 35},
                      {"vc7_flexion", -6}},
                     28.0));
  all.push_back(make("kneeling", {{"both_hip_flexion", 4},
                                  {"both_knee_flexion", 110},
                                  {"both_talocrural_plantar_flexion", 8},
                                  {"both_metatarsal_extension", 70},
                                  {"both_shoulder_flexion", 25},
                                  {"both_shoulder_abduction", 10},
                                  {"both_elbow_flexion", 60},
                                  {"both_fingers_curl", 30},
                                  {"both_radioulnar_pronation", 25}}));
  all.push_back(make("kneeling_one", {{"l_hip_flexion", 90},
                                      {"l_knee_flexion", 90},
                                      {"r_hip_flexion", 0},
                                      {"r_knee_flexion", 104},
                                      {"r_talocrural_plantar_flexion", 8},
                                      {"r_metatarsal_extension", 70},
                                      {"both_shoulder_flexion", 30},
                                      {"both_shoulder_abduction", 10},
                                      {"both_elbow_flexion", 55},
                                      {"both_fingers_curl", 30},
                                      {"both_radioulnar_pronation", 25}}));
}

std::vector<LibraryPosture> makeLibrary() {
  std::vector<LibraryPosture> all;
  addAtRest(all);
  addAtWork(all);
  addLowDown(all);
  return all;
}

}  // namespace

const std::vector<LibraryPosture>& postureLibrary() {
  static const std::vector<LibraryPosture> kLibrary = makeLibrary();
  return kLibrary;
}

std::optional<Posture> libraryPosture(const Figure& figure, std::string_view name) {
  for (const LibraryPosture& entry : postureLibrary()) {
    if (entry.name == name) return onFloor(figure, entry.posture);
  }
  return std::nullopt;
}

}  // namespace hapticell::mannequin
