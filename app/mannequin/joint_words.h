// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace hapticell::app {

/// A joint angle of a mannequin in the user's words, without its side: "ankle plantar flexion" for the H-Anim name
/// "l_talocrural_plantar_flexion".
QString jointName(const QString& h_anim_name);

/// The same with its side: "left ankle plantar flexion".
QString jointNameWithSide(const QString& h_anim_name);

}  // namespace hapticell::app
