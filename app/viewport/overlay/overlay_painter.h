// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPainter>
#include <optional>

#include "app/style/theme.h"
#include "app/viewport/overlay/label_layout.h"
#include "app/viewport/overlay/overlay_boxes.h"
#include "app/viewport/overlay/overlay_labels.h"
#include "app/viewport/scene/scene_curve.h"
#include "app/viewport/overlay/view_cube.h"
#include "app/viewport/overlay/view_strip.h"

namespace hapticell::app {

/// What to write over an empty scene.
struct EmptyState {
  QString title;  ///< What is missing.
  QString how;    ///< How to begin, with a key.
};

/// All that is painted over one picture of the scene.
struct Overlay {
  const Theme* theme = nullptr;
  Camera camera;
  ViewSize size;  ///< Pixels at 100 %.
  const SceneModel* scene = nullptr;
  std::vector<OverlayLabel> labels;
  std::vector<PlacedLabel> places;  ///< Of the labels, the force's number and the curves' texts; none: not shown.
  const PlacedLabel* placeOf(std::uint64_t key) const {
    for (const PlacedLabel& place : places)
      if (place.key == key) return &place;
    return nullptr;
  }
  std::vector<SceneCurve> curves;
  Strips strips;  ///< The stylus's, the figure's; none: no strip.
  QString hint;   ///< One quiet line above the strips: what the mouse does now.
  ViewCube cube{{0, 0}, 1};
  std::optional<ViewCubeSpot> cube_hover;
  std::optional<EmptyState> empty;
  double empty_height = 0.46;  ///< Where that is written, as a part of the view's height.
  const ViewStrip* view_strip = nullptr;
  int view_strip_hover = -1;  ///< Index of its cell, or -1.
  std::optional<QRectF> box;  ///< Drawn by the mouse to choose what lies in it,
  bool box_touching = false;  ///< or what it touches: dashed.
  /// What the pointer is over, and where it came there.
  QString hover_name;
  QPointF hover_place;
  bool simplified = false;        ///< The picture shows less than it does at rest, so that it keeps up.
  std::size_t missing_parts = 0;  ///< Still being made ready for drawing.
};

/// Paints cube, labels, leaders, points, arrow, strip and grid size. Plain QPainter; no widgets, no OpenGL.
void paintOverlay(QPainter& painter, const Overlay& overlay);

/// Where an empty state is written.
PixelBox emptyBox(const ViewSize& size, double height);

/// Boxes that together hold all that paintOverlay() paints; they may overlap.
std::vector<QRectF> overlayPieces(const Overlay& overlay);

}  // namespace hapticell::app
