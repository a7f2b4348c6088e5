// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <Qt>

#include "app/viewport/scene/camera.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

/// An action of the pointer over the viewport.
struct PointerEvent {
  glm::dvec2 pixel{0.0};                  ///< At 100 %, origin top left.
  Qt::MouseButton button = Qt::NoButton;  ///< The button that caused it.
  Qt::MouseButtons buttons;               ///< Held now.
  Qt::KeyboardModifiers modifiers;
  double wheel_steps = 0.0;  ///< Positive away from the user.
  Camera camera;
  ViewSize size;
};

/// Something that gets the pointer before the viewport's own gestures: a module's tool. GUI thread.
class PointerTool {
 public:
  virtual ~PointerTool() = default;
  /// Each returns true if it used the event; the viewport then ignores it.
  virtual bool press(const PointerEvent& event) = 0;
  virtual bool move(const PointerEvent& event) = 0;
  virtual bool release(const PointerEvent& event) = 0;
  virtual bool wheel(const PointerEvent& event) = 0;
  /// One line for the viewport, in quiet text: what the pointer does now; empty for nothing.
  virtual QString hint() const { return {}; }
};

}  // namespace hapticell::app
