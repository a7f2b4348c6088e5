// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <map>
#include <string>
#include <vector>

#include "workcell/entity/entity.h"

namespace hapticell::app {

/// One sentence of an import's report.
struct RemarkLine {
  QString kind;  ///< What it is about without names, numbers and files: equal for remarks of the same kind.
  QString text;
  std::vector<workcell::EntityId> parts;  ///< That it names, in the order of the sentence.
};

/// By the names that a file gives its parts and the links of its robots: the entities they became.
using NamedParts = std::multimap<std::string, workcell::EntityId>;

/// The names that the file gives `entity` and its links and joints, for the `id` that the document gave it.
void addNames(const workcell::Entity& entity, workcell::EntityId id, NamedParts& parts);

/// The remarks with those of one kind side by side, kinds in the order of their first remark. A part is found by its
/// name in single quotes.
std::vector<RemarkLine> remarkLines(const std::vector<std::string>& remarks, const NamedParts& parts);

}  // namespace hapticell::app
