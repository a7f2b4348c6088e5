// SPDX-License-Identifier: Apache-2.0
#pragma once

class QMenu;
class QObject;

namespace hapticell::app {

class Host;

/// Adds to a menu: a picture of the view in several sizes, and a video of a turn around it. `owner` owns the actions.
void addPictures(Host& host, QMenu& menu, QObject* owner);

}  // namespace hapticell::app
