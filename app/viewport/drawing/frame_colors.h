// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/style/theme.h"
#include "app/viewport/drawing/frame.h"

namespace hapticell::app {

/// The colours of a picture of the scene in a theme; `sets` (SceneModel::colouredSets()) colour their marks.
FrameColors frameColors(const Theme& theme, const std::vector<workcell::PairSet>& sets = {});

}  // namespace hapticell::app
