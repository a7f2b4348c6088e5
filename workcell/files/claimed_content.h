// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace hapticell::workcell {

/// Whether a file that is named by another one (a picture, a material library, a part of an assembly, a buffer) is of a
/// kind that such files name, and begins as its name claims: a picture with its format's first bytes, MTL with
/// `newmtl`, STEP with ISO-10303-21, XML with '<'. A buffer of glTF may contain anything; only its extension is
/// checked. False for other names. Only regular files.
bool isWhatItClaims(const std::filesystem::path& file);

}  // namespace hapticell::workcell
