// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/report/page_painter.h"

#include <algorithm>

namespace hapticell::ergonomics {
namespace {

// Points: 15 mm. Not tuned.
constexpr double kMargin = 42.0;
constexpr double kFoot = 96.0;  // Kept free for the signatures on the last page.
constexpr double kPictureWidth = 190.0, kPictureHeight = 218.0, kSceneWidth = 190.0, kBesideScene = 90.0;
constexpr double kLogoWidth = 130.0, kLogoHeight = 32.0;

/// Makes columns as wide together as `width`: what is left all share; where it is too little the widest give, down to
/// one width that they have in common.
void fit(std::vector<double>& widths, double width) {
  std::vector<double> rising = widths;
  std::sort(rising.begin(), rising.end());
  double left = width;
  for (std::size_t i = 0; i < rising.size(); ++i) {
    const double each = left / static_cast<double>(rising.size() - i);
    if (rising[i] > each) {
      for (double& one : widths) one = std::min(one, each);
      return;
    }
    left -= rising[i];
  }
  for (double& one : widths) one += left / static_cast<double>(widths.size());
}

}  // namespace

PagePainter::PagePainter(const Report& report, double density)
    : report_(report),
      density_(density),
      height_(kPageHeight / density),
      margin_(kMargin / density),
      inner_(kPageWidth / density - 2.0 * margin_) {}

int PagePainter::paint() {
  begin();
  header();
  top();
  for (const ReportBlock& block : report_.blocks) paintBlock(block, margin_, inner_);
  signatures();
  endPage();
  return page_;
}

void PagePainter::begin() {
  cr_ = contextOf(++page_);
  y_ = margin_;
  cairo_save(cr_);
  cairo_scale(cr_, density_, density_);
  exactWidths();
  cairo_set_source_rgb(cr_, 1, 1, 1);
  cairo_paint(cr_);
  ink();
}

void PagePainter::endPage() {
  cairo_restore(cr_);
  finishPage(page_);
}

void PagePainter::need(double height) {
  if (y_ + height <= height_ - margin_) return;
  endPage();
  begin();
}

/// The logo at the right end, at most as wide as `kLogoWidth`; returns how wide it is drawn.
double PagePainter::logo() {
  if (report_.logo.isEmpty()) return 0.0;
  const double scale = std::min(kLogoHeight / report_.logo.height, kLogoWidth / report_.logo.width);
  const double width = scale * report_.logo.width;
  paintPicture(report_.logo, margin_ + inner_ - width, y_, scale);
  return width + 10.0;
}

void PagePainter::header() {
  const double taken = logo();
  font(16, true);
  show(margin_, y_ + 12, report_.title);
  font(9);
  quiet();
  show(margin_ + inner_ - taken - widthOf(report_.date), y_ + 12, report_.date);
  show(margin_, y_ + 27, report_.subtitle);
  // Under the date, so that the page stays one page.
  font(9, true);
  ink();
  show(margin_ + inner_ - taken - widthOf(report_.company), y_ + 27, report_.company);
  ink();
  y_ += 36;
  rule(margin_, inner_, 1.4, 0.1);
  y_ += 14;
}

/// The pictures at the left; beside them blocks, the one number, and blocks under it.
void PagePainter::top() {
  const double start = y_;
  double left = margin_, height = 0.0;
  if (!report_.scene.isEmpty()) {
    height = scene(left, y_, kSceneWidth);
    left += kSceneWidth + 8.0;
  }
  if (!report_.picture.empty()) {
    const double width = report_.scene.isEmpty() ? kPictureWidth : kBesideScene;
    const double tall = report_.scene.isEmpty() ? kPictureHeight : height;
    picture(left, y_, width, tall);
    left += width + 16.0;
    height = std::max(height, tall);
  }
  const double width = margin_ + inner_ - left;
  for (const ReportBlock& block : report_.beside) paintBlock(block, left, width);
  if (!report_.result.empty() || !report_.result_words.empty()) result(left);
  for (const ReportBlock& block : report_.under_result) paintBlock(block, left, width);
  y_ = std::max(y_, start + height + 6.0);
}

void PagePainter::result(double x) {
  font(26, true);
  show(x, y_ + 24, report_.result);
  double at = x + widthOf(report_.result) + (report_.result.empty() ? 0.0 : 10.0);
  if (report_.result_band >= 0) {
    patch(at, y_ + 9, 30, 16, report_.result_band);
    at += 40;
  }
  font(10, true);
  show(at, y_ + 21, report_.result_words);
  y_ += 36;
}

/// The scene's picture; returns how tall it is drawn.
double PagePainter::scene(double x, double y, double width) {
  const double scale = width / report_.scene.width;
  paintPicture(report_.scene, x, y, scale);
  return scale * report_.scene.height;
}

void PagePainter::paintPicture(const ReportPicture& picture, double x, double y, double scale) {
  const Surface surface = surfaceOf(picture);
  cairo_save(cr_);
  cairo_translate(cr_, x, y);
  cairo_scale(cr_, scale, scale);
  cairo_set_source_surface(cr_, surface.get(), 0, 0);
  cairo_paint(cr_);
  cairo_restore(cr_);
}

void PagePainter::picture(double x, double y, double width, double height) {
  cairo_set_source_rgb(cr_, 0.933, 0.945, 0.957);
  cairo_rectangle(cr_, x, y, width, height);
  cairo_fill(cr_);
  glm::dvec2 low(1e9), high(-1e9);
  for (const ReportShape& shape : report_.picture) {
    for (const auto& p : shape.outline) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  const double scale = std::min((width - 16.0) / (high.x - low.x), (height - 16.0) / (high.y - low.y));
  const double x0 = x + 0.5 * width - 0.5 * scale * (low.x + high.x), y0 = y + height - 8.0 + scale * low.y;
  const auto& shapes = report_.picture;
  for (std::size_t first = 0; first < shapes.size();) {
    std::size_t last = first;
    cairo_new_path(cr_);
    for (; last < shapes.size() && shapes[last].group == shapes[first].group; ++last) {
      for (std::size_t i = 0; i < shapes[last].outline.size(); ++i) {
        const auto& p = shapes[last].outline[i];
        if (i == 0) {
          cairo_move_to(cr_, x0 + scale * p.x, y0 - scale * p.y);
        } else {
          cairo_line_to(cr_, x0 + scale * p.x, y0 - scale * p.y);
        }
      }
      cairo_close_path(cr_);
    }
    cairo_set_line_width(cr_, 1.6);
    ink();
    cairo_stroke_preserve(cr_);
    fillPath(shapes[first].band);
    first = last;
  }
}

void PagePainter::paintBlock(const ReportBlock& block, double x, double width) {
  if (!block.heading.empty()) {
    font(9.5, true);
    need(28);
    show(x, y_ + 9, block.heading);
    y_ += 14;
  }
  font(9);
  for (const std::string& line : block.lines) {
    for (const std::string& piece : wrapped(line, width)) {
      need(12);
      font(9);
      show(x, y_ + 8.5, piece);
      y_ += 11.5;
    }
  }
  if (block.flows) flow(block, x, width);
  if (!block.rows.empty() && !block.flows) table(block, x, width);
  if (!block.strips.empty()) strips(block, x, width);
  y_ += 8;
}

/// Rows as running text, "name value", what is 0 left out.
void PagePainter::flow(const ReportBlock& block, double x, double width) {
  std::string text;
  for (const auto& row : block.rows) {
    if (row.size() < 2 || row[1].text == "0.0") continue;
    text += (text.empty() ? "" : ", ") + row[0].text + "\u00A0" + row[1].text;
  }
  for (const std::string& piece : wrapped(text, width)) {
    need(12);
    font(9);
    show(x, y_ + 8.5, piece);
    y_ += 11.5;
  }
}

void PagePainter::table(const ReportBlock& block, double x, double width) {
  std::size_t count = block.columns.size();
  for (const auto& row : block.rows) count = std::max(count, row.size());
  std::vector<double> widths(count, 0.0);
  font(9, true);
  for (std::size_t i = 0; i < block.columns.size(); ++i) widths[i] = widthOf(block.columns[i]) + 10.0;
  font(9);
  for (const auto& row : block.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], widthOf(row[i].text) + 10.0 + (row[i].band >= 0 ? 22.0 : 0.0));
    }
  }
  fit(widths, width);
  if (!block.columns.empty()) tableHead(block.columns, widths, x, width);
  for (const auto& row : block.rows) tableRow(row, widths, x, width);
}

void PagePainter::tableHead(const std::vector<std::string>& columns, const std::vector<double>& widths, double x,
                            double width) {
  font(9, true);
  std::vector<std::vector<std::string>> cells;
  std::size_t lines = 1;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    cells.push_back(wrapped(columns[i], widths[i] - 8.0));
    lines = std::max(lines, cells.back().size());
  }
  const double height = 1.5 + 11.5 * static_cast<double>(lines);
  need(height + 2);
  font(9, true);  // A page that begins has its own.
  double at = x;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    // On the rule, as tables have them.
    const double first = y_ + 9.0 + 11.5 * static_cast<double>(lines - cells[i].size());
    for (std::size_t k = 0; k < cells[i].size(); ++k) show(at, first + 11.5 * static_cast<double>(k), cells[i][k]);
    at += widths[i];
  }
  y_ += height;
  rule(x, width, 0.9, 0.1);
}

void PagePainter::tableRow(const std::vector<ReportBlock::Cell>& row, const std::vector<double>& widths, double x,
                           double width) {
  font(9);
  std::vector<std::vector<std::string>> cells;
  std::size_t lines = 1;
  for (std::size_t i = 0; i < row.size(); ++i) {
    cells.push_back(wrapped(row[i].text, widths[i] - 8.0 - (row[i].band >= 0 ? 22.0 : 0.0)));
    lines = std::max(lines, cells.back().size());
  }
  const double height = 1.5 + 11.5 * static_cast<double>(lines);
  need(height + 2);
  double at = x;
  for (std::size_t i = 0; i < row.size(); ++i) {
    double left = at;
    if (row[i].band >= 0) {
      patch(left, y_ + 2.5, 17, 8, row[i].band);
      left += 22;
    }
    font(9);
    for (std::size_t k = 0; k < cells[i].size(); ++k) show(left, y_ + 9.8 + 11.5 * static_cast<double>(k), cells[i][k]);
    at += widths[i];
  }
  y_ += height + 1;
  rule(x, width, 0.4, 0.74);
}

void PagePainter::strips(const ReportBlock& block, double x, double width) {
  constexpr double kName = 84.0, kTall = 13.0;
  for (const auto& strip : block.strips) {
    need(kTall + 4);
    font(9);
    show(x, y_ + 10, strip.name);
    double at = x + kName;
    for (const auto& [share, band] : strip.pieces) {
      const double wide = share * (width - kName);
      cairo_rectangle(cr_, at, y_ + 1, wide, kTall);
      fillPath(band);
      at += wide;
    }
    y_ += kTall + 4;
  }
  quiet();
  font(8);
  show(x + kName, y_ + 8, block.scale_first);
  show(x + width - widthOf(block.scale_last), y_ + 8, block.scale_last);
  ink();
  y_ += 12;
}

void PagePainter::signatures() {
  if (report_.signatures.empty()) return;
  if (y_ > height_ - kFoot) need(height_);
  y_ = height_ - margin_ - 16;
  const double each = (inner_ - 30.0) / static_cast<double>(report_.signatures.size());
  double at = margin_;
  for (const std::string& name : report_.signatures) {
    rule(at, each - 8.0, 0.8, 0.1);
    font(8.5);
    show(at, y_ + 11, name);
    at += each + 15.0;
  }
}

}  // namespace hapticell::ergonomics
