// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "geometry/shapes/vector.h"

namespace hapticell::ergonomics {

// A page that says what a posture or a task was found to be, independent of how it is written.

/// One shape of the picture, in metres right and up; filled in a score's band (0 to 3, with its pattern) or plain (-1).
struct ReportShape {
  std::vector<glm::dvec2> outline{};
  int band = -1;
  std::size_t group = 0;  ///< Shapes of one group are one body: outlined together.
};

/// A few lines under a heading, or a table, or coloured strips along one scale.
struct ReportBlock {
  std::string heading;               ///< Empty: none is shown.
  std::vector<std::string> lines{};  ///< Text; wrapped.
  struct Cell {
    std::string text;
    int band = -1;  ///< A patch of the score's colour and pattern beside the text; -1: none.
  };
  std::vector<std::string> columns{};  ///< Of a table.
  bool flows = false;                  ///< Pages show the rows (name, value) as running text, without those at 0.0.
  std::vector<std::vector<Cell>> rows{};
  struct Strip {
    std::string name;
    std::vector<std::pair<double, int>> pieces{};  ///< Share of the whole, band; in order.
  };
  std::vector<Strip> strips{};
  std::string scale_first{}, scale_last{};  ///< At the ends of the strips.
};

/// A picture, premultiplied ARGB (0xAARRGGBB), rows from the top.
struct ReportPicture {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels{};
  bool isEmpty() const { return pixels.empty(); }
};

struct Report {
  std::string title, subtitle, date;
  std::string language = "en";  ///< "en" or "fr".
  std::string company{};        ///< In the head; may be empty.
  ReportPicture logo{};         ///< At the head's right end; may be empty.
  ReportPicture scene{};        ///< The figure in its cell; may be empty.
  std::vector<ReportShape> picture{};
  std::vector<ReportBlock> beside{};  ///< Blocks of lines to the picture's right.
  std::string result{};               ///< The one number, "6".
  int result_band = -1;
  std::string result_words{};               ///< "RULA, change soon"
  std::vector<ReportBlock> under_result{};  ///< Beside the picture too, under the one number.
  std::vector<ReportBlock> blocks{};
  std::vector<std::string> signatures{};  ///< Words under the lines at the foot.
};

/// Comma-separated: heading, then rows; text in quotes where it must be. UTF-8.
std::string reportCsv(const Report& report);
/// The same as JSON, "format":"hapticell-ergonomics-report","version":1 (docs/user/formats.md).
std::string reportJson(const Report& report);
/// One file with everything in it, the figure as SVG, the scene as PNG; prints on A4.
std::string reportHtml(const Report& report);

/// One A4 page, all drawn smaller (to two thirds) where it must be; what is longer takes several. Errors: a file that
/// cannot be written.
Expected<void> writeReportPdf(const Report& report, const std::filesystem::path& file);

/// A page as a picture, `width` pixels wide in A4's proportion. Any thread.
ReportPicture drawReportPage(const Report& report, int page, int width);
int reportPages(const Report& report);

/// A PNG file's bytes, and a picture out of a PNG file (refused: what is none, or larger than 8192 pixels).
std::string pngOf(const ReportPicture& picture);
Expected<ReportPicture> readPng(const std::filesystem::path& file);

/// By the file's ending: .pdf, .html, .csv, .json; another one is refused.
Expected<void> writeReport(const Report& report, const std::filesystem::path& file);

/// Colours of the bands 0 to 3, sRGB.
std::array<double, 3> bandColor(int band);

}  // namespace hapticell::ergonomics
