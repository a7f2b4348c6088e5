// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMenu>
#include <functional>

#include "app/panels/tree/tree_edits.h"

namespace hapticell::app {

class Host;

/// What can be done with entities, in the tree and in the scene alike: fit, hide, isolate, lock, check, colour, attach,
/// rename, copy, duplicate, remove, properties. Each is one step of undo. `ids` are those that are meant, the first is
/// the one that words are about; empty: only what needs none is enabled. `rename` begins an edit of the name; empty:
/// there is none. GUI thread.
void fillEntityMenu(QMenu& menu, Host& host, const Entities& ids, const std::function<void()>& rename);

/// What can be done where nothing stands: insert, paste (at `p_W`), select, show and fit all, views.
void fillFloorMenu(QMenu& menu, Host& host, const dvec3& p_W);

/// Copy and paste of entities (Ctrl+C, Ctrl+V) for the Edit menu; the copies outlive their cell. Made once a window.
void addCopyAndPaste(Host& host);

}  // namespace hapticell::app
