// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/system/error.h"
#include "importer/reading.h"

namespace hapticell::importer {

/// Reads STEP (AP203, AP214, AP242) or IGES with OpenCASCADE and meshes the faces. Names are those of the parts; a part
/// that is used several times has one mesh. Changes the working directory (external references are found from there).
/// May throw the library's exceptions.
Expected<workcell::ImportedScene> readCad(const Reading& reading, ParentLink& parent);

}  // namespace hapticell::importer
