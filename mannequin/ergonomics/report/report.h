// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes/vector.h"
#include "geometry/system/error.h"

namespace hapticell::ergonomics {

// A page with the assessment of a posture or a task, independent of the file format.

/// One shape of the picture, in metres right and up; filled in the colour of a score's band (0 to 3, with its pattern)
/// or plain (-1).
struct ReportShape {
  std::vector<glm::dvec2> outline{};
  int band = -1;
  std::size_t group = 0;  ///< Shapes of one group are one body with a common outline.
};

/// Lines under a heading, or a table, or coloured strips on one scale.
struct ReportBlock {
  std::string heading;               ///< Empty: no heading.
  std::vector<std::string> lines{};  ///< Text; wrapped.
  struct Cell {
    std::string text;
    int band = -1;  ///< A patch of the score's colour and pattern next to the text; -1: no patch.
  };
  std::vector<std::string> columns{};  ///< Of a table.
  bool flows = false;  ///< The page shows the rows (name, value) as running text, without those that are 0.0.
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
  std::vector<ReportBlock> under_result{};  ///< Also beside the picture, under the large number.
  std::vector<ReportBlock> blocks{};
  std::vector<std::string> signatures{};  ///< Words under the lines at the bottom.
};

/// Comma-separated: heading, then rows; text is quoted if necessary. UTF-8.
std::string reportCsv(const Report& report);
/// The same as JSON, "format":"hapticell-ergonomics-report","version":1 (docs/user/formats.md).
std::string reportJson(const Report& report);
/// One self-contained file, the figure as SVG, the scene as PNG; prints on A4.
std::string reportHtml(const Report& report);

/// One A4 page, reduced (to two thirds) if necessary; longer reports take several pages. Errors: a file that cannot be
/// written.
Expected<void> writeReportPdf(const Report& report, const std::filesystem::path& file);

/// A page as a picture, `width` pixels wide in A4's proportion. Any thread.
ReportPicture drawReportPage(const Report& report, int page, int width);
int reportPages(const Report& report);

/// The bytes of a PNG file, and a picture from a PNG file (errors: not a PNG file, or larger than 8192 pixels).
std::string pngOf(const ReportPicture& picture);
Expected<ReportPicture> readPng(const std::filesystem::path& file);

/// Chosen by the extension: .pdf, .html, .csv, .json; any other is refused.
Expected<void> writeReport(const Report& report, const std::filesystem::path& file);

/// Colours of the bands 0 to 3, sRGB.
std::array<double, 3> bandColor(int band);

}  // namespace hapticell::ergonomics
