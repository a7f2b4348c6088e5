// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Qt>

namespace hapticell::app {

/// Whether a key is text in a text field: letters, digits, signs, Space, Delete and Backspace, also with Shift or on
/// the keypad. Not with Ctrl, Alt or Meta; not Enter, arrows or function keys.
bool isTypedKey(int key, Qt::KeyboardModifiers modifiers);

}  // namespace hapticell::app
