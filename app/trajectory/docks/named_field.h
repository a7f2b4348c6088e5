// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/style/value_field.h"

namespace hapticell::app {

/// A number field with an object name and an initial value.
inline ValueField* namedField(const char* name, const ValueField::Format& format, double value) {
  auto* made = new ValueField(format);
  made->setObjectName(name);
  made->setValue(value);
  return made;
}

}  // namespace hapticell::app
