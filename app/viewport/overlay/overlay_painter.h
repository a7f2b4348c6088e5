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

/// The text over an empty scene.
struct EmptyState {
  QString title;  ///< What is missing.
  QString how;    ///< How to start, with a key.
};

/// All that is painted over one picture of the scene.
struct Overlay {
  const Theme* theme = nullptr;
  Camera camera;
  ViewSize size;  ///< Pixels at 100 %.
  const SceneModel* scene = nullptr;
  std::vector<OverlayLabel> labels;
  std::vector<PlacedLabel> places;  ///< Of labels, the force's number and curves' texts, if shown.
  const PlacedLabel* placeOf(std::uint64_t key) const {
    for (const PlacedLabel& place : places)
      if (place.key == key) return &place;
    return nullptr;
  }
  std::vector<SceneCurve> curves;
  Strips strips;  ///< Those of the stylus and of the mannequin; empty: no strip.
  QString hint;   ///< One line above the strips, in quiet text: what the mouse does now.
  ViewCube cube{{0, 0}, 1};
  std::optional<ViewCubeSpot> cube_hover;
  std::optional<EmptyState> empty;
  double empty_height = 0.46;  ///< Position of that text, as a fraction of the view's height.
  const ViewStrip* view_strip = nullptr;
  int view_strip_hover = -1;  ///< Index of its cell, or -1.
  std::optional<QRectF> box;  ///< Selection box of the mouse: selects what is inside,
  bool box_touching = false;  ///< or what it touches: dashed.
  /// The name of what the pointer is over, and where it entered.
  QString hover_name;
  QPointF hover_place;
  bool simplified = false;        ///< The picture shows less than at rest, to keep its rate.
  std::size_t missing_parts = 0;  ///< Still being prepared for drawing.
};

/// Paints cube, labels, leaders, points, arrow, strip and grid size. Plain QPainter; no widgets, no OpenGL.
void paintOverlay(QPainter& painter, const Overlay& overlay);

/// The box of the text over an empty scene.
PixelBox emptyBox(const ViewSize& size, double height);

/// Boxes that together contain all that paintOverlay() paints; they may overlap.
std::vector<QRectF> overlayPieces(const Overlay& overlay);

}  // namespace hapticell::app
