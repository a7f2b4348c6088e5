// SPDX-License-Identifier: Apache-2.0
// Reports as text: CSV, JSON, HTML.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "geometry/system/atomic_file.h"
#include "geometry/system/markup.h"
#include "geometry/system/plain_number.h"
#include "mannequin/ergonomics/report/report.h"

namespace hapticell::ergonomics {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

std::string hex(int band) {
  const auto color = bandColor(band);
  char text[16];
  const auto byte = [&](std::size_t channel) { return static_cast<unsigned>(std::lround(255.0 * color[channel])); };
  std::snprintf(text, sizeof text, "#%02X%02X%02X", byte(0), byte(1), byte(2));
  return text;
}

std::string fillOf(int band) {
  if (band < 0) return "#C8CDD3";
  return "url(#band" + std::to_string(band) + ") " + hex(band);  // Plain where patterns are not known.
}

/// Colour and pattern of the four bands: hatched from 5 on, cross-hatched at 7.
std::string patterns() {
  std::string text = "<svg width=\"0\" height=\"0\" style=\"position:absolute\"><defs>";
  for (int band = 0; band < 4; ++band) {
    text += "<pattern id=\"band" + std::to_string(band) +
            "\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\"><rect width=\"6\" height=\"6\" fill=\"" +
            hex(band) + "\"/>";
    if (band >= 2) text += "<path d=\"M-1 1L1 -1M0 6L6 0M5 7L7 5\" stroke=\"#5A2A10\" stroke-width=\"1.1\"/>";
    if (band == 3) text += "<path d=\"M5 -1L7 1M0 0L6 6M-1 5L1 7\" stroke=\"#5A2A10\" stroke-width=\"1.1\"/>";
    text += "</pattern>";
  }
  return text + "</defs></svg>";
}

std::string patch(int band) {
  if (band < 0) return {};
  return "<svg class=\"patch\" viewBox=\"0 0 22 12\"><rect width=\"22\" height=\"12\" rx=\"2\" fill=\"" + fillOf(band) +
         "\"/></svg> ";
}

std::string pictureSvg(const std::vector<ReportShape>& shapes) {
  if (shapes.empty()) return {};
  glm::dvec2 low(1e9), high(-1e9);
  for (const ReportShape& shape : shapes) {
    for (const auto& p : shape.outline) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  constexpr double kScale = 200.0;  // Units a metre.
  const double margin = 0.06;
  const auto units = [](double metres) { return plainNumber(kScale * metres, std::chars_format::fixed, 1); };
  std::string svg = "<svg class=\"figure\" viewBox=\"0 0 " + units(high.x - low.x + 2.0 * margin) + " " +
                    units(high.y - low.y + 2.0 * margin) + "\">";
  const auto path = [&](const ReportShape& shape) {
    std::string d;
    for (std::size_t i = 0; i < shape.outline.size(); ++i) {
      const auto& p = shape.outline[i];
      d += (i == 0 ? "M" : "L") + units(p.x - low.x + margin) + " " + units(high.y - p.y + margin);
    }
    return d + "Z";
  };
  for (std::size_t first = 0; first < shapes.size();) {
    std::size_t last = first;
    while (last < shapes.size() && shapes[last].group == shapes[first].group) ++last;
    std::string d;
    for (std::size_t i = first; i < last; ++i) d += path(shapes[i]);
    svg += "<path d=\"" + d + "\" fill=\"none\" stroke=\"#20262D\" stroke-width=\"3\"/>";
    svg += "<path d=\"" + d + "\" fill=\"" + fillOf(shapes[first].band) + "\"/>";
    first = last;
  }
  return svg + "</svg>";
}

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[three >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

std::string pictureHtml(const ReportPicture& picture, const std::string& kind) {
  if (picture.isEmpty()) return {};
  return "<img class=\"" + kind + "\" alt=\"\" src=\"data:image/png;base64," + base64(pngOf(picture)) + "\">";
}

std::string stripHtml(const ReportBlock::Strip& strip) {
  std::string text = "<tr><td>" + escapedMarkup(strip.name) +
                     "</td><td><svg class=\"strip\" viewBox=\"0 0 1000 24\" preserveAspectRatio=\"none\">";
  double at = 0.0;
  const auto units = [](double part) { return plainNumber(1000.0 * part, std::chars_format::fixed, 1); };
  for (const auto& [share, band] : strip.pieces) {
    text += "<rect x=\"" + units(at) + "\" width=\"" + units(share) + "\" height=\"24\" fill=\"" + fillOf(band) +
            "\" stroke=\"#20262D\" stroke-width=\"0.6\"/>";
    at += share;
  }
  return text + "</svg></td></tr>";
}

/// Rows as running text, "name value", what is 0 left out: as on the pages.
std::string flowHtml(const ReportBlock& block) {
  std::string text;
  for (const auto& row : block.rows) {
    if (row.size() < 2 || row[1].text == "0.0") continue;
    text += (text.empty() ? "" : ", ") + escapedMarkup(row[0].text) + "&nbsp;" + escapedMarkup(row[1].text);
  }
  return "<p>" + text + "</p>";
}

std::string blockHtml(const ReportBlock& block) {
  std::string text = block.heading.empty() ? "<section>" : "<section><h2>" + escapedMarkup(block.heading) + "</h2>";
  for (const std::string& line : block.lines) text += "<p>" + escapedMarkup(line) + "</p>";
  if (block.flows) {
    text += flowHtml(block);
  } else if (!block.rows.empty()) {
    text += "<table>";
    if (!block.columns.empty()) {
      text += "<tr>";
      for (const std::string& column : block.columns) text += "<th>" + escapedMarkup(column) + "</th>";
      text += "</tr>";
    }
    for (const auto& row : block.rows) {
      text += "<tr>";
      for (const auto& cell : row) text += "<td>" + patch(cell.band) + escapedMarkup(cell.text) + "</td>";
      text += "</tr>";
    }
    text += "</table>";
  }
  if (!block.strips.empty()) {
    text += "<table class=\"strips\">";
    for (const auto& strip : block.strips) text += stripHtml(strip);
    text += "<tr><td></td><td class=\"scale\"><span>" + escapedMarkup(block.scale_first) + "</span><span>" +
            escapedMarkup(block.scale_last) + "</span></td></tr></table>";
  }
  return text + "</section>";
}

constexpr const char* kStyle =
    "body{font:10pt Roboto,'Noto Sans','DejaVu Sans',sans-serif;color:#1A2027;max-width:180mm;margin:10mm auto}"
    "h1{font-size:16pt;margin:0}h2{font-size:10.5pt;margin:4mm 0 1mm}p{margin:0 0 1mm}"
    "header{display:flex;justify-content:space-between;border-bottom:1.5pt solid #1A2027;padding-bottom:2mm}"
    ".logo{max-width:46mm;max-height:12mm;vertical-align:top}"
    ".top{display:flex;gap:8mm;margin-top:4mm}.scene{display:block;width:62mm;margin-bottom:2mm}.figure{width:62mm;max-"
    "height:88mm;background:#EEF1F4}"
    ".result{font-size:22pt;font-weight:700}.patch{width:22px;height:12px;vertical-align:-1px}"
    "table{border-collapse:collapse;width:100%}td,th{text-align:left;padding:.8mm 2mm .8mm 0;border-bottom:.5pt solid "
    "#BCC5CE;vertical-align:top}.strips td{border:0;padding:.6mm 2mm .6mm 0}.strip{width:100%;height:5mm}"
    ".scale{display:flex;justify-content:space-between;color:#45515D}footer{display:flex;gap:12mm;margin-top:16mm}"
    "footer div{flex:1;border-top:.8pt solid #1A2027;padding-top:1mm}@page{size:A4;margin:12mm}"
    ".pictures{display:flex;gap:2mm;align-items:flex-start}.top>div:last-child{flex:1}"
    "@media print{body{font-size:6.8pt;margin:0 auto}h1{font-size:13pt}h2{font-size:7.8pt;margin:1.4mm 0 .3mm}td,th{"
    "padding:.2mm 2mm .2mm 0}.top{margin-top:2mm;gap:5mm}.scene{width:40mm}.figure{width:22mm;max-height:50mm}.patch{"
    "width:16px;height:9px}p{margin:0 0 .3mm}footer{margin-top:7mm}section{break-inside:avoid}.result{font-size:17pt}}";

nlohmann::ordered_json jsonOf(const ReportBlock& block) {
  nlohmann::ordered_json json{{"heading", block.heading}};
  if (!block.lines.empty()) json["lines"] = block.lines;
  if (!block.columns.empty()) json["columns"] = block.columns;
  for (const auto& row : block.rows) {
    auto cells = nlohmann::ordered_json::array();
    for (const auto& cell : row) cells.push_back(cell.text);
    json["rows"].push_back(std::move(cells));
  }
  for (const auto& strip : block.strips) {
    nlohmann::ordered_json pieces = nlohmann::ordered_json::array();
    for (const auto& [share, band] : strip.pieces) pieces.push_back({{"share", share}, {"band", band}});
    json["strips"].push_back({{"name", strip.name}, {"pieces", std::move(pieces)}});
  }
  return json;
}

}  // namespace

std::array<double, 3> bandColor(int band) {
  constexpr std::array<std::array<double, 3>, 4> kColors{{{0x8F / 255.0, 0xB4 / 255.0, 0xD6 / 255.0},
                                                          {0xF2 / 255.0, 0xD3 / 255.0, 0x5E / 255.0},
                                                          {0xF0 / 255.0, 0x90 / 255.0, 0x38 / 255.0},
                                                          {0xDB / 255.0, 0x44 / 255.0, 0x17 / 255.0}}};
  return kColors[static_cast<std::size_t>(std::clamp(band, 0, 3))];
}

std::string reportCsv(const Report& report) {
  std::string text = report.company.empty() ? std::string() : quoted(report.company) + "\n";
  text += quoted(report.title) + "\n" + quoted(report.subtitle) + "\n" + quoted(report.date) + "\n";
  text += quoted(report.result_words) + "," + quoted(report.result) + "\n";
  const auto add = [&](const ReportBlock& block) {
    text += "\n" + quoted(block.heading) + "\n";
    for (const std::string& line : block.lines) text += quoted(line) + "\n";
    const auto row = [&](const auto& cells, auto&& text_of) {
      for (std::size_t i = 0; i < cells.size(); ++i) text += (i == 0 ? "" : ",") + quoted(text_of(cells[i]));
      if (!cells.empty()) text += "\n";
    };
    row(block.columns, [](const std::string& name) { return name; });
    for (const auto& cells : block.rows) row(cells, [](const ReportBlock::Cell& cell) { return cell.text; });
    for (const auto& strip : block.strips) {
      text += quoted(strip.name);
      for (const auto& [share, band] : strip.pieces) {
        text += "," + plainNumber(share, std::chars_format::fixed, 5) + "," + std::to_string(band);
      }
      text += "\n";
    }
  };
  for (const auto* blocks : {&report.beside, &report.under_result, &report.blocks}) {
    for (const ReportBlock& block : *blocks) add(block);
  }
  return text;
}

std::string reportJson(const Report& report) {
  nlohmann::ordered_json json{{"format", "hapticell-ergonomics-report"},
                              {"version", 1},
                              {"title", report.title},
                              {"subtitle", report.subtitle},
                              {"date", report.date},
                              {"language", report.language},
                              {"result", report.result},
                              {"result_words", report.result_words}};
  if (!report.company.empty()) json["company"] = report.company;
  json["blocks"] = nlohmann::ordered_json::array();
  for (const auto* blocks : {&report.beside, &report.under_result, &report.blocks}) {
    for (const ReportBlock& block : *blocks) json["blocks"].push_back(jsonOf(block));
  }
  return json.dump(2) + "\n";
}

std::string reportHtml(const Report& report) {
  std::string text = "<!DOCTYPE html>\n<html lang=\"" + report.language + "\"><head><meta charset=\"utf-8\"><title>" +
                     escapedMarkup(report.title) + "</title><style>" + kStyle + "</style></head><body>" + patterns();
  const std::string company = report.company.empty() ? "" : "<b>" + escapedMarkup(report.company) + "</b>";
  text += "<header><div>" + company + "<h1>" + escapedMarkup(report.title) + "</h1>" + escapedMarkup(report.subtitle) +
          "</div><div>" + escapedMarkup(report.date) + " " + pictureHtml(report.logo, "logo") +
          "</div></header><div class=\"top\"><div class=\"pictures\">" + pictureHtml(report.scene, "scene") +
          pictureSvg(report.picture) + "</div><div>";
  for (const ReportBlock& block : report.beside) text += blockHtml(block);
  text += "<p><span class=\"result\">" + escapedMarkup(report.result) + "</span> " + patch(report.result_band) +
          escapedMarkup(report.result_words) + "</p>";
  for (const ReportBlock& block : report.under_result) text += blockHtml(block);
  text += "</div></div>";
  for (const ReportBlock& block : report.blocks) text += blockHtml(block);
  text += "<footer>";
  for (const std::string& name : report.signatures) text += "<div>" + escapedMarkup(name) + "</div>";
  return text + "</footer></body></html>\n";
}

Expected<void> writeReport(const Report& report, const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".pdf") return writeReportPdf(report, file);
  if (ending == ".html" || ending == ".htm") return writeFileAtomically(file, reportHtml(report));
  if (ending == ".csv") return writeFileAtomically(file, reportCsv(report));
  if (ending == ".json") return writeFileAtomically(file, reportJson(report));
  return makeError({.file = file.string(),
                    .found = ending.empty() ? Text("no extension") : Text("the extension %1", ending),
                    .expected = ".pdf, .html, .csv or .json"});
}

}  // namespace hapticell::ergonomics
