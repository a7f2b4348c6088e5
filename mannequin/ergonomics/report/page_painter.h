// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cairo.h>

#include <string>
#include <vector>

#include "mannequin/ergonomics/report/report.h"
#include "mannequin/ergonomics/report/report_canvas.h"

namespace hapticell::ergonomics {

/// Points: A4. Not tuned.
inline constexpr double kPageWidth = 595.28, kPageHeight = 841.89;

/// Lays a report out from top to bottom, page after page, and draws it. With a density below 1 all is drawn smaller by
/// it. Used once.
class PagePainter : protected ReportCanvas {
 public:
  /// `report` must outlive this.
  PagePainter(const Report& report, double density);
  virtual ~PagePainter() = default;

  /// Draws all of it; returns the number of pages.
  int paint();

 protected:
  /// What page `page` (from 1) is drawn on.
  virtual cairo_t* contextOf(int page) = 0;
  virtual void finishPage(int /*page*/) {}

 private:
  void begin();
  void endPage();
  void need(double height);
  double logo();
  void header();
  void top();
  void result(double x);
  double scene(double x, double y, double width);
  void paintPicture(const ReportPicture& picture, double x, double y, double scale);
  void picture(double x, double y, double width, double height);
  void paintBlock(const ReportBlock& block, double x, double width);
  void flow(const ReportBlock& block, double x, double width);
  void table(const ReportBlock& block, double x, double width);
  void tableHead(const std::vector<std::string>& columns, const std::vector<double>& widths, double x, double width);
  void tableRow(const std::vector<ReportBlock::Cell>& row, const std::vector<double>& widths, double x, double width);
  void strips(const ReportBlock& block, double x, double width);
  void signatures();
  const Report& report_;
  double density_, height_, margin_, inner_;
  int page_ = 0;
};

}  // namespace hapticell::ergonomics
