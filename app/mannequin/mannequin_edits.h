// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mannequin/body/anthropometry.h"
#include "mannequin/posture/posture.h"
#include "workcell/document/command.h"

namespace hapticell::app {

// What the dock of mannequins does to the document, as commands; no widgets.

/// The posture that the document has.
mannequin::Posture postureOf(const workcell::Entity& entity);

/// Takes the figure into a posture.
workcell::Command postureCommand(const workcell::Entity& entity, const mannequin::Posture& posture);

/// A built-in posture at the figure's present place: same place and heading, standing or sitting on the floor under it.
std::optional<mannequin::Posture> libraryPostureAt(const workcell::Entity& entity, std::string_view name);
/// A posture of a file (its root is placed as above unless `has_root`).
mannequin::Posture placedHere(const workcell::Entity& entity, mannequin::Posture posture);

/// What the figure was built from, read from its source; where that says nothing of use, its sex and stature.
mannequin::BodyRequest requestOf(const workcell::Entity& entity);

/// A body of another size with the same joint angles, standing on the same place: one step. Takes a tenth of a second;
/// any thread. Errors of makeFigure().
Expected<std::vector<workcell::Command>> resizeCommands(const workcell::Entity& entity,
                                                        const mannequin::BodyRequest& request);

/// A new standing mannequin; its name is not in `taken`. Takes a tenth of a second; any thread.
Expected<workcell::Entity> newMannequin(const mannequin::BodyRequest& request, const Pose& X_WE,
                                        const std::vector<std::string>& taken);

/// Link of a hand, for what it carries.
const char* handLink(mannequin::Side side);

}  // namespace hapticell::app
