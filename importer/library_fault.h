// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/system/error.h"

namespace hapticell::importer {

/// What a library's own word for a fault ("std::bad_alloc", "stoi", "Standard_NullObject") says of the file, and what
/// helps; the word stands behind it in brackets only where no more is known. Without file and place.
Error libraryFault(const std::string& words);

}  // namespace hapticell::importer
