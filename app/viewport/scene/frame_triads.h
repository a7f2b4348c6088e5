// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/viewport/scene/camera.h"
#include "app/viewport/scene/scene_curve.h"
#include "app/viewport/scene/scene_model.h"

namespace hapticell::app {

/// Three axes of `length` metres at X_WF, and a dot with the name at the origin. `width` in pixels at 100 %.
std::vector<SceneCurve> triadCurves(const Pose& X_WF, double length, const std::string& name, bool selected,
                                    double width);

/// How long the axes of a frame are drawn, metres: 0.1, but never so that they are tiny or fill the picture.
double triadLength(const dvec3& p_WF, const Camera& camera, const ViewSize& view);

/// All visible frames of the cell where they stand now; selected ones and the one under the pointer are bolder.
std::vector<SceneCurve> frameTriads(const SceneModel& scene, const Camera& camera, const ViewSize& view);

/// The visible frame whose triad is within 7 pixels of a pixel, the nearest of them; 0: none.
workcell::EntityId frameAt(const SceneModel& scene, const Camera& camera, const ViewSize& view,
                           const glm::dvec2& pixel);

/// The frames whose origin lies in a box from corner to corner, in pixels.
std::vector<workcell::EntityId> framesIn(const SceneModel& scene, const Camera& camera, const ViewSize& view,
                                         const glm::dvec2& least, const glm::dvec2& most);

}  // namespace hapticell::app
