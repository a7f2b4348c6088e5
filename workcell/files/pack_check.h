// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/system/error.h"
#include "workcell/document/document_state.h"
#include "workcell/scenes/import_monitor.h"

namespace hapticell::workcell {

/// Reads the packed document, whose folder is the pack, with all its files and compares it with the packed state: the
/// same entities at the same poses, joints and links with the same triangles within 1e-9 m, sets, rules, guides and
/// recordings; all files that it names are inside the pack. Entities that had no shape when they were packed
/// (Entity::unloaded) need none. `monitor` may be null. Error: the file or entity, and what differs.
Expected<void> checkPack(const DocumentState& packed, const std::filesystem::path& document, ImportMonitor* monitor);

/// Checks that both files contain the same bytes. Error: names `copy`.
Expected<void> checkCopy(const std::filesystem::path& copy, const std::filesystem::path& original);

/// Reads an archive to its end and checks that it contains all files below `folder`, byte for byte, and nothing else.
/// Error: names the file in it, and what differs.
Expected<void> checkArchive(const std::filesystem::path& archive, const std::filesystem::path& folder);

}  // namespace hapticell::workcell
