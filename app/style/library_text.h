// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string>

namespace hapticell::app {

/// A sentence of the libraries under the window, which speak English, millimetres and degrees, as the user reads it: in
/// the window's language and the units in force. Several with "; " between are taken one by one; what is not known
/// stays as it is. Thread-safe as tr() is; any text is taken.
QString shownText(const std::string& sentence);

}  // namespace hapticell::app
