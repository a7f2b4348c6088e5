// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <map>
#include <string>
#include <vector>

#include "geometry/system/text.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

/// One sentence of an import's report.
struct RemarkLine {
  QString kind;  ///< The heading of its group: the sentence with "…" in place of names, numbers and files.
  QString text;
  std::vector<workcell::EntityId> parts;  ///< The parts that it names, in the order of its arguments.
};

/// Maps the names that a file gives its parts, and the links of its robots, to the entities made of them.
using NamedParts = std::multimap<std::string, workcell::EntityId>;

/// Adds the file's names for `entity`, its links and its joints, mapped to the `id` that the document gave it.
void addNames(const workcell::Entity& entity, workcell::EntityId id, NamedParts& parts);

/// Groups remarks by kind, kinds in the order of their first remark. Remarks with the same id are of one kind; plain
/// texts are a kind of their own. A part is found if an argument is its name, or is a list of names in single quotes
/// that contains its name.
std::vector<RemarkLine> remarkLines(const std::vector<Text>& remarks, const NamedParts& parts);

}  // namespace hapticell::app
