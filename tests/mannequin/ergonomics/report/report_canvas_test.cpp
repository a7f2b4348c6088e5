// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/report/report_canvas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "mannequin/ergonomics/report/page_painter.h"

namespace hapticell::ergonomics {
namespace {

constexpr int kWidth = 120, kHeight = 80;

/// A canvas on a white picture, `scale` pixels a point.
class PictureCanvas : public ReportCanvas {
 public:
  explicit PictureCanvas(double scale = 1.0)
      : surface_(surfaceOf({kWidth, kHeight, std::vector<std::uint32_t>(kWidth * kHeight, 0xFFFFFFFFu)})),
        context_(cairo_create(surface_.get())) {
    cr_ = context_.get();
    cairo_scale(cr_, scale, scale);
    cairo_set_antialias(cr_, CAIRO_ANTIALIAS_NONE);
  }
  using ReportCanvas::exactWidths;
  using ReportCanvas::font;
  using ReportCanvas::patch;
  using ReportCanvas::rule;
  using ReportCanvas::widthOf;
  using ReportCanvas::wrapped;
  void nextLineAt(double y) { y_ = y; }

  std::uint32_t pixel(int x, int y) const {
    cairo_surface_flush(surface_.get());
    std::uint32_t value = 0;
    std::memcpy(
        &value,
        cairo_image_surface_get_data(surface_.get()) + y * cairo_image_surface_get_stride(surface_.get()) + 4 * x, 4);
    return value;
  }
  int count(std::uint32_t color) const {
    int found = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) found += pixel(x, y) == color ? 1 : 0;
    return found;
  }

 private:
  Surface surface_;
  Context context_;
};

std::uint32_t argb(const std::array<double, 3>& color) {
  std::uint32_t value = 0xFFu;
  for (const double part : color) value = value << 8 | static_cast<std::uint32_t>(std::lround(255.0 * part));
  return value;
}

/// Paints on one picture of a page, in grey of a quarter of the size, and keeps how much of each page is written on.
class CountedPages : public PagePainter {
 public:
  using PagePainter::PagePainter;
  std::vector<int> written;  ///< Dark pixels of each finished page.

 protected:
  cairo_t* contextOf(int page) override {
    EXPECT_EQ(page, static_cast<int>(written.size()) + 1) << "pages come in order";
    cairo_identity_matrix(context_.get());
    cairo_set_source_rgb(context_.get(), 1.0, 1.0, 1.0);
    cairo_paint(context_.get());
    cairo_scale(context_.get(), kPageScale, kPageScale);
    return context_.get();
  }
  void finishPage(int page) override {
    EXPECT_EQ(page, static_cast<int>(written.size()) + 1);
    cairo_surface_flush(surface_.get());
    int dark = 0;
    const unsigned char* data = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    for (int y = 0; y < kPagePixelsHigh; ++y)
      for (int x = 0; x < kPagePixelsWide; ++x) dark += data[y * stride + 4 * x] < 128 ? 1 : 0;
    written.push_back(dark);
  }

 private:
  static constexpr double kPageScale = 0.5;
  static constexpr int kPagePixelsWide = 298, kPagePixelsHigh = 421;
  Surface surface_ = surfaceOf(
      {kPagePixelsWide, kPagePixelsHigh,
       std::vector<std::uint32_t>(static_cast<std::size_t>(kPagePixelsWide) * kPagePixelsHigh, 0xFFFFFFFFu)});
  Context context_{cairo_create(surface_.get())};
};

TEST(PagePainter, ALongTableTakesAsManyPagesAsItsRowsNeed) {
  Report report{.title = "Shift", .subtitle = "Line 4", .date = "27 Nov 2026"};
  ReportBlock table{.heading = "Minutes"};
  table.columns = {"Minute", "RULA"};
  std::size_t pages_before = 1;
  for (const int rows : {10, 100, 200, 400}) {
    table.rows.clear();
    for (int row = 0; row < rows; ++row) table.rows.push_back({{.text = std::to_string(row)}, {.text = std::to_string(1 + row % 7)}});
    report.blocks = {table};
    CountedPages whole(report, 1.0);
    const auto pages = static_cast<std::size_t>(whole.paint());
    EXPECT_EQ(pages, whole.written.size());
    EXPECT_GE(pages, pages_before) << rows;
    for (const int dark : whole.written) EXPECT_GT(dark, 50) << "no page is empty";
    EXPECT_LE(reportPages(report), static_cast<int>(pages)) << "a file is reduced to fit where it can";
    CountedPages small(report, 0.6);
    EXPECT_LE(static_cast<std::size_t>(small.paint()), pages) << "smaller, it takes no more pages";
    pages_before = pages;
  }
  EXPECT_GE(pages_before, 5u) << "400 rows of 4 mm or more on pages of 297 mm";
}

TEST(ReportCanvas, APictureIsCopiedPixelByPixel) {
  ReportPicture picture{5, 3, {}};
  for (std::uint32_t i = 0; i < 15; ++i) picture.pixels.push_back(0xFF000000u + 0x010305u * i);
  const Surface surface = surfaceOf(picture);
  ASSERT_EQ(cairo_surface_status(surface.get()), CAIRO_STATUS_SUCCESS);
  for (std::size_t y = 0; y < 3; ++y) {
    std::uint32_t row[5];
    std::memcpy(row,
                cairo_image_surface_get_data(surface.get()) +
                    static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface.get()),
                sizeof row);
    for (std::size_t x = 0; x < 5; ++x) EXPECT_EQ(row[x], picture.pixels[5 * y + x]);
  }
}

TEST(ReportCanvas, LinesAreAsLongAsFitsAndHoldEveryWord) {
  PictureCanvas canvas;
  canvas.font(9.0);
  const std::string text = "the trunk is bent by 40 degrees and turned; a table 150 mm higher would bring it upright";
  for (const double width : {40.0, 100.0, 200.0, 2000.0}) {
    const std::vector<std::string> lines = canvas.wrapped(text, width);
    std::string joined;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      joined += (i == 0 ? "" : " ") + lines[i];
      if (lines[i].find(' ') != std::string::npos) {
        EXPECT_LE(canvas.widthOf(lines[i]), width);
      }
      if (i + 1 == lines.size()) continue;
      const std::string next_word = lines[i + 1].substr(0, lines[i + 1].find(' '));
      EXPECT_GT(canvas.widthOf(lines[i] + " " + next_word), width) << "the next word had no room";
    }
    EXPECT_EQ(joined, text);
  }
  EXPECT_EQ(canvas.wrapped(text, 2000.0).size(), 1u);
  EXPECT_EQ(canvas.wrapped("incomprehensibilities", 3.0), std::vector<std::string>{"incomprehensibilities"})
      << "a word is not cut";
  EXPECT_TRUE(canvas.wrapped("", 50.0).empty());
}

TEST(ReportCanvas, LettersAreAsWideOnASmallPictureAsOnPaper) {
  PictureCanvas paper(1.0), small(0.25);
  for (PictureCanvas* canvas : {&paper, &small}) {
    canvas->exactWidths();
    canvas->font(9.0, true);
  }
  const std::string text = "What drives the score";
  EXPECT_GT(paper.widthOf(text), 50.0);
  EXPECT_NEAR(small.widthOf(text), paper.widthOf(text), 1e-3 * paper.widthOf(text));
}

TEST(ReportCanvas, BandsDifferInColourAndInPattern) {
  // The worse the band, the more of its colour is hatched: none, none, one way, both ways.
  int before = 0;
  for (int band = 0; band <= 3; ++band) {
    PictureCanvas canvas;
    canvas.patch(10.0, 10.0, 60.0, 40.0, band);
    const int plain = canvas.count(argb(bandColor(band)));
    if (band < 2) {
      EXPECT_EQ(plain, 60 * 40) << band;
    } else {
      EXPECT_LT(plain, before - 200) << band;
      EXPECT_GT(plain, 60 * 40 / 4) << "the colour is still seen";
    }
    before = plain;
    EXPECT_EQ(canvas.count(0xFFFFFFFFu), kWidth * kHeight - 60 * 40) << "nothing beside the patch";
  }
  PictureCanvas canvas;
  canvas.patch(10.0, 10.0, 60.0, 40.0, -1);
  const std::uint32_t grey = canvas.pixel(20, 20);
  EXPECT_EQ(canvas.count(grey), 60 * 40) << "plain";
  for (int band = 0; band <= 3; ++band) EXPECT_NE(grey, argb(bandColor(band)));
}

TEST(ReportCanvas, ARuleIsAsWideAndAsThickAsAsked) {
  PictureCanvas canvas;
  canvas.nextLineAt(20.0);
  canvas.rule(5.0, 50.0, 2.0, 0.0);
  EXPECT_EQ(canvas.count(0xFF000000u), 50 * 2);
  EXPECT_EQ(canvas.pixel(5, 19), 0xFF000000u);
  EXPECT_EQ(canvas.pixel(54, 20), 0xFF000000u);
  EXPECT_EQ(canvas.pixel(55, 20), 0xFFFFFFFFu);
}

}  // namespace
}  // namespace hapticell::ergonomics
