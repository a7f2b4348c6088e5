// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "workcell/text/package_path.h"

namespace hapticell::workcell {

/// A file, or a model's folder, that an SDF file names by `uri`; empty if it does not exist. "model://NAME/…" is
/// searched next to the file, in "models" and upwards from there, and in the folders of GZ_SIM_RESOURCE_PATH,
/// GAZEBO_MODEL_PATH and SDF_PATH; these and other URIs then as in findReference(). Percent-encoded names (RFC 3986)
/// are found both unchanged and decoded.
std::optional<FoundFile> findSdfFile(const std::string& uri, const std::filesystem::path& file);

/// The SDF file of the model that an <include> names: `uri` itself, or, if it is a folder, the file that its
/// model.config (else manifest.xml) names for the newest version up to 1.9, else model.sdf. Empty if it does not exist.
std::filesystem::path findSdfModel(const std::string& uri, const std::filesystem::path& file);

}  // namespace hapticell::workcell
