// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/style/theme.h"
#include "app/viewport/drawing/frame.h"

namespace hapticell::app {

/// The colours that a theme gives a picture of the scene, and `sets` (SceneModel::colouredSets()) the marks of theirs.
FrameColors frameColors(const Theme& theme, const std::vector<workcell::PairSet>& sets = {});

}  // namespace hapticell::app
