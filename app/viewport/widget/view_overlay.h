// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/viewport/overlay/overlay_painter.h"

namespace hapticell::app {

class ViewportWidget;

/// What the viewport paints over the scene: labels, strips, curves, view cube. GUI thread.
class ViewOverlay {
 public:
  /// The view must outlive it.
  explicit ViewOverlay(ViewportWidget& view) : view_(view) {}

  /// See ViewportWidget.
  void setCurves(const std::string& owner, std::vector<SceneCurve> curves);
  std::vector<SceneCurve> allCurves() const;
  void setLabels(const std::string& owner, std::vector<OverlayLabel> labels);
  std::vector<OverlayLabel> allLabels() const;
  const std::vector<PlacedLabel>& drawnLabels() const { return drawn_labels_; }
  void setStrip(const StripContext& context) { strip_ = context; }
  void setFigureStrip(std::vector<StripCell> cells);
  const std::vector<StripCell>& figureStrip() const { return figure_strip_; }
  void setViewStrip(std::vector<ViewStripCell> cells) { view_strip_.setCells(std::move(cells)); }
  const ViewStrip& viewStrip() const { return view_strip_; }
  void setEmptyState(const std::optional<EmptyState>& state) { empty_ = state; }
  /// Drops curves, labels and the mannequin's strip.
  void forgetCell();

  /// True if the strip or a label would show other text than is drawn.
  bool hasNewNumbers() const { return spokenNumbers() != drawn_numbers_; }
  /// True while a label is still moving.
  bool isMoving() const { return layout_.moving(); }
  /// Paints everything onto the view, in paintGL().
  void paint();
  /// Paints everything onto a picture of the view, with labels at their final positions.
  void paintStill(QPainter& painter);

 private:
  KeptFree keptFree(const Overlay& overlay) const;
  std::vector<PlacedLabel> placeLabels(const Overlay& overlay, const KeptFree& kept);
  Overlay make();
  /// What strip and labels show of the snapshot, to be compared with what is drawn.
  std::vector<StripCell> spokenNumbers() const;
  Strips strips() const;

  ViewportWidget& view_;
  LabelLayout layout_;
  QImage image_;  ///< What is painted over the scene; only its present pieces are valid.
  double last_s_ = 0.0;
  std::vector<StripCell> drawn_numbers_;
  std::vector<PlacedLabel> drawn_labels_;
  StripContext strip_;
  std::map<std::string, std::vector<SceneCurve>> curves_;
  std::map<std::string, std::vector<OverlayLabel>> labels_;
  std::vector<StripCell> figure_strip_;
  std::optional<EmptyState> empty_;
  ViewStrip view_strip_;
};

}  // namespace hapticell::app
