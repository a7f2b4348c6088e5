// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace hapticell::app {

/// Text that may contain foreign words (names in files, what a server or driver sends), made safe to draw: hapticell's
/// plainText() of each line, at most `most_lines` lines of at most 2000 bytes.
QString plainLines(const QString& text, int most_lines = 1);

}  // namespace hapticell::app
