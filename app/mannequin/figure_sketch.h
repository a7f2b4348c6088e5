// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <memory>

#include "app/viewport/scene/render_item.h"
#include "mannequin/shape/figure_outline.h"

namespace hapticell::app {

/// The look of a body of the sketch.
using BodyFill = std::function<LinkLook(std::size_t body)>;

/// Draws the mannequin with QPainter into a rectangle, feet at its bottom; a pixel is `metres_per_pixel`, or chosen so
/// that it fits. The caller keeps `flesh`.
void drawFigure(QPainter& painter, const QRectF& area, const std::vector<mannequin::OutlinePart>& parts,
                const BodyFill& fill, const QColor& line);

/// The mannequin in its present posture, with what the stylus holds in the selection colour.
class FigureSketch : public QWidget {
  Q_OBJECT
 public:
  explicit FigureSketch(QWidget* parent = nullptr);
  void setFigure(std::shared_ptr<const mannequin::Figure> figure);
  void setPosture(const mannequin::Posture& posture);
  /// Bodies drawn in the selection colour.
  void setHeld(std::vector<std::size_t> bodies);
  QSize sizeHint() const override { return {132, 190}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::shared_ptr<const mannequin::Figure> figure_;
  std::vector<mannequin::Flesh> flesh_;
  mannequin::Posture posture_;
  std::vector<std::size_t> held_;
};

}  // namespace hapticell::app
