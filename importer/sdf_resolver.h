// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/system/error.h"
#include "workcell/scenes/sdf_content.h"

namespace hapticell::importer {

/// What libsdformat understands of a text that workcell::SdfTidier made, with the files that it takes in. What the
/// library complains of is in the content. Errors, without the file: content at which the library throws.
Expected<workcell::SdfContent> resolveSdf(const std::string& text);

}  // namespace hapticell::importer
