// SPDX-License-Identifier: Apache-2.0
// Reports as A4 pages, drawn with cairo: PDF, and pictures for a preview.
#include <cairo-pdf.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "geometry/system/atomic_file.h"
#include "mannequin/ergonomics/report/page_painter.h"
#include "mannequin/ergonomics/report/report.h"
#include "mannequin/ergonomics/report/report_canvas.h"

namespace hapticell::ergonomics {
namespace {

// Of the usual size: a text of 9 points becomes 6, the least that is read on paper. Half: unreadable; more: reports
// that fit on a page get two. With more pages, 0.85 keeps them few.
constexpr double kLeastDensity = 0.66, kManyPagesDensity = 0.85;

class PdfPainter final : public PagePainter {
 public:
  PdfPainter(const Report& report, double density, cairo_t* context)
      : PagePainter(report, density), context_(context) {}

 protected:
  cairo_t* contextOf(int) override { return context_; }
  void finishPage(int) override { cairo_show_page(context_); }

 private:
  cairo_t* context_;
};

/// One page onto `context`, the others nowhere.
class OnePagePainter final : public PagePainter {
 public:
  OnePagePainter(const Report& report, double density, int wanted, cairo_t* context)
      : PagePainter(report, density),
        wanted_(wanted),
        context_(context),
        surface_(cairo_recording_surface_create(CAIRO_CONTENT_COLOR, nullptr)),
        nowhere_(cairo_create(surface_.get())) {}

 protected:
  cairo_t* contextOf(int page) override { return page == wanted_ && context_ ? context_ : nowhere_.get(); }

 private:
  int wanted_;
  cairo_t* context_;
  Surface surface_;
  Context nowhere_;
};

/// As large as it fits on one page; where even the smallest is too long, readable on several.
double densityOf(const Report& report) {
  for (double density = 1.0; density >= kLeastDensity; density -= 0.02) {
    if (OnePagePainter(report, density, -1, nullptr).paint() == 1) return density;
  }
  return kManyPagesDensity;
}

}  // namespace

Expected<void> writeReportPdf(const Report& report, const std::filesystem::path& file) {
  std::string bytes;
  const auto append = [](void* to, const unsigned char* data, unsigned size) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
  };
  const Surface surface(cairo_pdf_surface_create_for_stream(append, &bytes, kPageWidth, kPageHeight));
  if (cairo_surface_status(surface.get()) == CAIRO_STATUS_SUCCESS) {
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, report.title.c_str());
    const Context context(cairo_create(surface.get()));
    PdfPainter(report, densityOf(report), context.get()).paint();
  }
  cairo_surface_finish(surface.get());
  const cairo_status_t status = cairo_surface_status(surface.get());
  if (status == CAIRO_STATUS_SUCCESS) return writeFileAtomically(file, bytes);
  return makeError({.file = file.string(),
                    .found = Text::plain(cairo_status_to_string(status)),
                    .expected = "a report that can be rendered"});
}

ReportPicture drawReportPage(const Report& report, int page, int width) {
  ReportPicture picture;
  picture.width = std::clamp(width, 1, 4000);
  picture.height = static_cast<int>(std::lround(picture.width * kPageHeight / kPageWidth));
  picture.pixels.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  auto* bytes = static_cast<unsigned char*>(static_cast<void*>(picture.pixels.data()));
  const Surface surface(cairo_image_surface_create_for_data(bytes, CAIRO_FORMAT_ARGB32, picture.width, picture.height,
                                                            4 * picture.width));
  const Context context(cairo_create(surface.get()));
  cairo_scale(context.get(), picture.width / kPageWidth, picture.width / kPageWidth);
  OnePagePainter(report, densityOf(report), page, context.get()).paint();
  cairo_surface_flush(surface.get());
  return picture;
}

int reportPages(const Report& report) {
  return OnePagePainter(report, densityOf(report), -1, nullptr).paint();
}

}  // namespace hapticell::ergonomics
