// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cairo.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "mannequin/ergonomics/report/report.h"

namespace hapticell::ergonomics {

struct SurfaceEnd {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct ContextEnd {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, SurfaceEnd>;
using Context = std::unique_ptr<cairo_t, ContextEnd>;

/// A copy of a picture as cairo has it; its status shows if memory ran out.
Surface surfaceOf(const ReportPicture& picture);

/// Text, rules and coloured patches of a report's page, drawn with cairo. Points, from the top left. One thread.
class ReportCanvas {
 protected:
  void ink() { cairo_set_source_rgb(cr_, 0.10, 0.125, 0.153); }
  void quiet() { cairo_set_source_rgb(cr_, 0.27, 0.32, 0.365); }

  void font(double size, bool bold = false) {
    cairo_select_font_face(cr_, "Roboto", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr_, size);
  }

  /// Letters are as wide on a small picture of a page as on paper, so that lines break at the same places.
  void exactWidths() {
    struct End {
      void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
    };
    const std::unique_ptr<cairo_font_options_t, End> options(cairo_font_options_create());
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_set_font_options(cr_, options.get());
  }

  double widthOf(const std::string& text) {
    cairo_text_extents_t extents;
    cairo_text_extents(cr_, text.c_str(), &extents);
    return extents.x_advance;
  }

  void show(double x, double y, const std::string& text) {
    cairo_move_to(cr_, x, y);
    cairo_show_text(cr_, text.c_str());
  }

  std::vector<std::string> wrapped(const std::string& text, double width) {
    std::vector<std::string> lines;
    std::string line;
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(' ', begin), text.size());
      const std::string next = text.substr(begin, end - begin);
      std::string longer = line;
      if (!line.empty()) longer += ' ';
      longer += next;
      if (!line.empty() && widthOf(longer) > width) {
        lines.push_back(line);
        line = next;
      } else {
        line = longer;
      }
      begin = end + 1;
    }
    if (!line.empty()) lines.push_back(line);
    return lines;
  }

  void rule(double x, double width, double thickness, double shade) {
    cairo_set_source_rgb(cr_, shade, shade, shade);
    cairo_set_line_width(cr_, thickness);
    cairo_move_to(cr_, x, y_);
    cairo_line_to(cr_, x + width, y_);
    cairo_stroke(cr_);
    ink();
  }

  void fill(int band) {
    if (band < 0) {
      cairo_set_source_rgb(cr_, 0.785, 0.805, 0.828);
    } else {
      const auto color = bandColor(band);
      cairo_set_source_rgb(cr_, color[0], color[1], color[2]);
    }
  }

  /// Fills the current path in the band's colour and pattern and clears the path.
  void fillPath(int band) {
    fill(band);
    cairo_fill_preserve(cr_);
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    cairo_path_extents(cr_, &x0, &y0, &x1, &y1);
    if (band >= 2) {
      cairo_save(cr_);
      cairo_clip(cr_);
      cairo_set_source_rgb(cr_, 0.35, 0.165, 0.063);
      cairo_set_line_width(cr_, 0.8);
      const double height = y1 - y0;
      for (double x = x0 - height; x < x1; x += 4.0) {
        cairo_move_to(cr_, x, y1);
        cairo_line_to(cr_, x + height, y0);
        if (band == 3) {
          cairo_move_to(cr_, x, y0);
          cairo_line_to(cr_, x + height, y1);
        }
      }
      cairo_stroke(cr_);
      cairo_restore(cr_);
    }
    cairo_new_path(cr_);
    ink();
  }

  void patch(double x, double y, double width, double height, int band) {
    cairo_rectangle(cr_, x, y, width, height);
    fillPath(band);
  }

  cairo_t* cr_ = nullptr;
  double y_ = 0.0;  ///< Position of the next line.
};

}  // namespace hapticell::ergonomics
