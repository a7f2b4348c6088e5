// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <Qt>

#include "app/viewport/scene/camera.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

/// What the pointer did over the viewport.
struct PointerEvent {
  glm::dvec2 pixel{0.0};                  ///< At 100 %, origin top left.
  Qt::MouseButton button = Qt::NoButton;  ///< That caused it.
  Qt::MouseButtons buttons;               ///< Held now.
  Qt::KeyboardModifiers modifiers;
  double wheel_steps = 0.0;  ///< Away from the user positive.
  Camera camera;
  ViewSize size;
};

/// Something that takes the pointer before the viewport's own gestures: a module's tool. GUI thread.
class PointerTool {
 public:
  virtual ~PointerTool() = default;
  /// Each answers true when it used the event; the viewport then does nothing with it.
  virtual bool press(const PointerEvent& event) = 0;
  virtual bool move(const PointerEvent& event) = 0;
  virtual bool release(const PointerEvent& event) = 0;
  virtual bool wheel(const PointerEvent& event) = 0;
  /// One quiet line for the viewport: what the pointer does now; empty for nothing.
  virtual QString hint() const { return {}; }
};

}  // namespace hapticell::app
