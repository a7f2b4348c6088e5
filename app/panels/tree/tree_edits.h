// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "app/host/document_model.h"

namespace hapticell::app {

// What the tree does with entities, each one step of undo. Entities below those that are named are meant too. False
// where the document refused it (it is then as it was) or there is nothing to do.

using Entities = std::vector<workcell::EntityId>;

/// Those of `ids` and all that stands below them, each once, parents first.
Entities withBelow(const workcell::DocumentState& state, const Entities& ids);

bool showEntities(DocumentModel& document, const Entities& ids, bool shown);
bool lockEntities(DocumentModel& document, const Entities& ids, bool locked);
bool checkEntities(DocumentModel& document, const Entities& ids, bool checked);
bool colorEntities(DocumentModel& document, const Entities& ids, const std::array<float, 3>& color);
/// Hides all others.
bool isolateEntities(DocumentModel& document, const Entities& ids);
bool showAll(DocumentModel& document);
bool removeEntities(DocumentModel& document, const Entities& ids);
/// Copies next to the originals, along x; gives the new ones, those of the top first.
Entities duplicateEntities(DocumentModel& document, const Entities& ids);
/// Copies as values, of those and all below them; attachments are not kept.
std::vector<workcell::Entity> copiesOf(const workcell::DocumentState& state, const Entities& ids);
/// Puts copies into the cell: the middle of the floor under them at `p_W`, or beside where they stood. Gives the new
/// ones.
Entities pasteEntities(DocumentModel& document, std::vector<workcell::Entity> copies, const std::optional<dvec3>& p_W);
/// Attached to a robot's tip, or to a part as it stands.
bool attachEntities(DocumentModel& document, const Entities& ids, workcell::EntityId to);
bool detachEntities(DocumentModel& document, const Entities& ids);
/// An entity's own frame (Entity::frames) gets another name, or goes.
bool renameOwnFrame(DocumentModel& document, workcell::EntityId entity, const QString& frame, const QString& name);
bool removeOwnFrame(DocumentModel& document, workcell::EntityId entity, const QString& frame);
/// Puts them below `parent` (an entity's or a folder's name; empty: at the top). They stay where they stand.
bool moveBelow(DocumentModel& document, const Entities& ids, const QString& parent);

}  // namespace hapticell::app
