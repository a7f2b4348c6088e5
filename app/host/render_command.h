// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSize>
#include <QString>
#include <optional>

#include "app/viewport/camera.h"
#include "geometry/error.h"

namespace hapticell::app {

/// What `hapticell --render` was asked for.
struct RenderCommand {
  QString input;         ///< A workcell, or anything else that can be imported.
  QString output;        ///< A picture; its ending names the format (png, jpg, bmp, ...).
  QString view = "iso";  ///< See viewNamed(); "saved" is the view that the workcell keeps.
  QSize size{1920, 1080};
  bool light = false;  ///< Theme.
  bool floor = true;
};

/// "front", "back", "right", "left", "top", "bottom", "iso"; nothing for other words.
std::optional<StandardView> viewNamed(const QString& name);

/// Draws the picture and writes it whole or not at all. What could not be shown is told in `diagnostics`. Refused:
/// files that cannot be read, views that are not known, formats that cannot be written, a display without OpenGL 3.3.
Expected<void> render(const RenderCommand& command, Diagnostics& diagnostics);

}  // namespace hapticell::app
