// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "app/viewport/tools/picked_feature.h"
#include "workcell/entity/guide.h"

namespace hapticell::app {

/// All kinds in the order of the editor.
const std::vector<workcell::GuideKind>& guideKinds();
/// "Hinge".
std::string guideKindName(workcell::GuideKind kind);

/// What may be picked for a kind: axes come from round faces and edges, planes from flat faces, points from anything.
FeatureFilter guideFilter(workcell::GuideKind kind);
/// The prompt for the pick: "Pick a round face or an edge: the axis".
QString guidePrompt(workcell::GuideKind kind);

/// Copies the geometry of `feature` into the guide: origin and axes, a circle's or tube's radius, a tube's path along
/// an edge, the name of the entity whose surface is followed (`surface_name`). Returns false and changes nothing if the
/// feature does not suit the guide's kind.
bool takeGeometry(const PickedFeature& feature, const std::string& surface_name, workcell::Guide& guide);

/// The guide's geometry in one line: "Axis at 512.0, 0.0, 300.0", millimetres.
QString geometryText(const workcell::Guide& guide);

/// A tube's path from recorded points: at most `most` of them; keeps the first and the last, drops neighbours closer
/// than 0.1 mm. Empty if fewer than two remain.
std::vector<dvec3> thinnedPath(const std::vector<dvec3>& points, std::size_t most = 200);

/// False for entities without a shape of their own: guides do not move them.
bool canBeGuided(const workcell::Entity& entity);

}  // namespace hapticell::app
