// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace hapticell::app {

/// Opens "About HaptiCell" over `parent`: the version, the licence, and the libraries in use with their licences (the
/// page docs/user/licences.md). A second call brings the open one to the front. Esc closes it.
void showAbout(QWidget& parent);

}  // namespace hapticell::app
