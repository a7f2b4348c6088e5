// SPDX-License-Identifier: Apache-2.0
#include "app/kit/typed_key.h"

namespace hapticell::app {

bool isTypedKey(int key, Qt::KeyboardModifiers modifiers) {
  if (modifiers & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
  return (key != 0 && key < Qt::Key_Escape) || key == Qt::Key_Delete || key == Qt::Key_Backspace;
}

}  // namespace hapticell::app
