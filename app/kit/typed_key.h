// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Qt>

namespace hapticell::app {

/// A key that is text where text is wanted: letters, digits, signs, Space, Delete and Backspace, with Shift or on the
/// keypad too. Not with Ctrl, Alt or Meta; not Enter, arrows, function keys.
bool isTypedKey(int key, Qt::KeyboardModifiers modifiers);

}  // namespace hapticell::app
