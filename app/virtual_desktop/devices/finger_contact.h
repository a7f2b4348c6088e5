// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "manipulation/engine/scene_snapshot.h"
#include "mannequin/body/skeleton.h"

namespace hapticell::app {

/// Strength of each vibrator of a glove, 0 to 1: thumb, index, middle, ring, little finger, palm.
using FingerVibration = std::array<double, 6>;

/// What a hand of the mannequin `figure` feels through the glove: a finger in contact vibrates, more if pressed harder
/// (`force_n` over `peak_n`, if the stylus exerts any force); a finger only within the near-miss distance does not.
/// Only pairs in `snapshot` count, in both orders, because what is held may touch the mannequin too.
FingerVibration fingerVibration(const manipulation::SceneSnapshot& snapshot, workcell::EntityId figure,
                                mannequin::Side side, double peak_n);

}  // namespace hapticell::app
