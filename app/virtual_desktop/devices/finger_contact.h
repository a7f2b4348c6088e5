// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "manipulation/engine/scene_snapshot.h"
#include "mannequin/body/skeleton.h"

namespace hapticell::app {

/// How strongly each vibrator of a glove shakes, 0 .. 1: thumb, index, middle, ring, little finger, palm.
using FingerVibration = std::array<double, 6>;

/// What a hand of the mannequin `figure` feels through the glove: a finger that touches something shakes, the harder it
/// is pressed the more (`force_n` over `peak_n`, where the stylus pushes at all), and a finger that slips into its near
/// miss does not. Only pairs that `snapshot` tells count; both ways round, for what is held may meet the mannequin too.
FingerVibration fingerVibration(const manipulation::SceneSnapshot& snapshot, workcell::EntityId figure,
                                mannequin::Side side, double peak_n);

}  // namespace hapticell::app
