// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "geometry/system/error.h"
#include "workcell/scenes/sdf_content.h"

namespace hapticell::workcell {

/// The content as bytes between two processes of one build.
std::string sdfBytes(const SdfContent& content);

/// The content of such bytes. Errors: anything else, models nested deeper than 200. Any bytes are allowed.
Expected<SdfContent> sdfFromBytes(std::string_view bytes);

}  // namespace hapticell::workcell
