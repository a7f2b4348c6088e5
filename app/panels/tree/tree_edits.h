// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "app/host/document_model.h"

namespace hapticell::app {

// What the tree does with entities, each as one undo step. Entities below the given ones are included. Functions return
// false if the document refused the change (it is then unchanged) or if there is nothing to do.

using Entities = std::vector<workcell::EntityId>;

/// The entities of `ids` and all below them, each once, parents first.
Entities withBelow(const workcell::DocumentState& state, const Entities& ids);

bool showEntities(DocumentModel& document, const Entities& ids, bool shown);
bool lockEntities(DocumentModel& document, const Entities& ids, bool locked);
bool checkEntities(DocumentModel& document, const Entities& ids, bool checked);
bool colorEntities(DocumentModel& document, const Entities& ids, const std::array<float, 3>& color);
/// Hides all other entities.
bool isolateEntities(DocumentModel& document, const Entities& ids);
bool showAll(DocumentModel& document);
bool removeEntities(DocumentModel& document, const Entities& ids);
/// Copies entities next to the originals, along x; returns the new ones, top-level ones first.
Entities duplicateEntities(DocumentModel& document, const Entities& ids);
/// Copies of these entities and all below them, as values; attachments are not kept.
std::vector<workcell::Entity> copiesOf(const workcell::DocumentState& state, const Entities& ids);
/// Adds copies to the cell: with their middle above or below `p_W`, or next to the originals. Returns the new
/// entities.
Entities pasteEntities(DocumentModel& document, std::vector<workcell::Entity> copies, const std::optional<dvec3>& p_W);
/// Attaches entities to a robot's tip, or to a part; they keep their pose.
bool attachEntities(DocumentModel& document, const Entities& ids, workcell::EntityId to);
bool detachEntities(DocumentModel& document, const Entities& ids);
/// Renames, or removes, an entity's own frame (Entity::frames).
bool renameOwnFrame(DocumentModel& document, workcell::EntityId entity, const QString& frame, const QString& name);
bool removeOwnFrame(DocumentModel& document, workcell::EntityId entity, const QString& frame);
/// Moves entities below `parent` (an entity's or a folder's name; empty: top level). Their poses do not change.
bool moveBelow(DocumentModel& document, const Entities& ids, const QString& parent);

}  // namespace hapticell::app
