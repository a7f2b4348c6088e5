// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mannequin/body/anthropometry.h"
#include "mannequin/posture/posture.h"
#include "workcell/document/command.h"

namespace hapticell::app {

// What the dock of the mannequin does to the document, as commands; no widgets.

/// The mannequin's posture in the document.
mannequin::Posture postureOf(const workcell::Entity& entity);

/// The command that sets a posture.
workcell::Command postureCommand(const workcell::Entity& entity, const mannequin::Posture& posture);

/// A built-in posture at the mannequin's present position and heading, standing or sitting on the floor below it.
std::optional<mannequin::Posture> libraryPostureAt(const workcell::Entity& entity, std::string_view name);
/// A posture from a file (its root is placed as above unless `has_root`).
mannequin::Posture placedHere(const workcell::Entity& entity, mannequin::Posture posture);

/// The request that the mannequin was built from, read from its source; if that is unusable, its sex and stature.
mannequin::BodyRequest requestOf(const workcell::Entity& entity);

/// The commands that give the mannequin another size, with the same joint angles and position: one undo step. Takes a
/// tenth of a second; any thread. Errors of makeFigure().
Expected<std::vector<workcell::Command>> resizeCommands(const workcell::Entity& entity,
                                                        const mannequin::BodyRequest& request);

/// A new standing mannequin; its name is not in `taken`. Takes a tenth of a second; any thread.
Expected<workcell::Entity> newMannequin(const mannequin::BodyRequest& request, const Pose& X_WE,
                                        const std::vector<std::string>& taken);

/// Name of a hand's link, for what it carries.
const char* handLink(mannequin::Side side);

}  // namespace hapticell::app
