// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "manipulation/engine/scene_snapshot.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

enum class Mark { kNone, kContact, kNearMiss, kLimit };

/// The mark of a pair.
constexpr Mark pairMark(const manipulation::PairState& pair) {
  if (pair.contact) return Mark::kContact;
  return pair.near_miss ? Mark::kNearMiss : Mark::kNone;
}

/// One cell of the stylus strip: a value with its unit, and its name.
struct StripCell {
  Mark mark = Mark::kNone;
  std::string value;
  std::string meaning;
  friend bool operator==(const StripCell&, const StripCell&) = default;
};

/// What the strip needs in addition to the snapshot.
struct StripContext {
  workcell::OnContact on_contact = workcell::OnContact::kSlide;
  std::string free_axes = "X Y Z";
  std::string scale_name;             ///< "Fine"; empty if a number was chosen.
  double near_miss_distance = 0.010;  ///< m
};

/// The stylus strip: clearance, force, motion scale, contact mode, free axes, distance to the edge of the workspace.
std::vector<StripCell> stripCells(const manipulation::SceneSnapshot& snapshot, const StripContext& context);

/// "6.4 mm"; never with a minus zero; in metres from 10 m on.
std::string millimetres(double metres);
/// "1.1 N".
std::string newtons(double newtons);
/// "1 : 4" for 0.25, "2 : 1" for 2: millimetres in the cell per millimetre of the hand.
std::string scaleText(double motion_scale);

}  // namespace hapticell::app
