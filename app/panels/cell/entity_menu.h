// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMenu>
#include <functional>

#include "app/panels/tree/tree_edits.h"

namespace hapticell::app {

class Host;

/// Fills the context menu of entities, for the tree and the scene: fit, hide, isolate, lock, check, colour, attach,
/// rename, copy, duplicate, remove, properties. Each edit is one undo step. `ids` are the entities; the texts name the
/// first one. If `ids` is empty, only actions without an entity are enabled. `rename` begins an edit of the name; it
/// may be empty. GUI thread.
void fillEntityMenu(QMenu& menu, Host& host, const Entities& ids, const std::function<void()>& rename);

/// Actions at an empty place: insert, paste (at `p_W`), select, show and fit all, views.
void fillFloorMenu(QMenu& menu, Host& host, const dvec3& p_W);

/// Adds copy and paste of entities (Ctrl+C, Ctrl+V) to the Edit menu; copies outlive their cell. Once per window.
void addCopyAndPaste(Host& host);

}  // namespace hapticell::app
