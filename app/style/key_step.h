// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Qt>

namespace hapticell::app {

/// Direction of a key in a row: 1 for `forward`, -1 for `back`, 0 for any other key.
constexpr int keyStep(int key, Qt::Key back, Qt::Key forward) {
  if (key == forward) return 1;
  return key == back ? -1 : 0;
}

}  // namespace hapticell::app
