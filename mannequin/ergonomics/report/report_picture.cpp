// SPDX-License-Identifier: Apache-2.0
// Pictures in reports: to and from cairo's surfaces and PNG files.
#include <cairo.h>

#include <cstring>
#include <string>

#include "mannequin/ergonomics/report/report.h"
#include "mannequin/ergonomics/report/report_canvas.h"

namespace hapticell::ergonomics {

Surface surfaceOf(const ReportPicture& picture) {
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, picture.width, picture.height));
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) return surface;
  cairo_surface_flush(surface.get());
  unsigned char* row = cairo_image_surface_get_data(surface.get());
  const std::size_t width = static_cast<std::size_t>(picture.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y) {
    std::memcpy(row, picture.pixels.data() + y * width, 4 * width);
    row += cairo_image_surface_get_stride(surface.get());
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

std::string pngOf(const ReportPicture& picture) {
  std::string bytes;
  const auto append = [](void* to, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(to)->append(data, data + length);
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_write_to_png_stream(surfaceOf(picture).get(), append, &bytes);
  return bytes;
}

Expected<ReportPicture> readPng(const std::filesystem::path& file) {
  // Pixels: guards memory (256 MB). Half, twice: other logos are refused with a message.
  constexpr int kMost = 8192;
  const Surface read(cairo_image_surface_create_from_png(file.c_str()));
  const int width = cairo_image_surface_get_width(read.get()), height = cairo_image_surface_get_height(read.get());
  if (cairo_surface_status(read.get()) != CAIRO_STATUS_SUCCESS || width < 1 || height < 1)
    return makeError({.file = file.string(), .found = "it cannot be read as a picture", .expected = "a PNG file"});
  if (width > kMost || height > kMost)
    return makeError({.file = file.string(),
                      .found = Text("%1 x %2 pixels", width, height),
                      .expected = "at most 8192 pixels in width and height"});
  ReportPicture picture{width, height, {}};
  picture.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  auto* bytes = static_cast<unsigned char*>(static_cast<void*>(picture.pixels.data()));
  const Surface copy(cairo_image_surface_create_for_data(bytes, CAIRO_FORMAT_ARGB32, width, height, 4 * width));
  const Context context(cairo_create(copy.get()));
  cairo_set_source_surface(context.get(), read.get(), 0, 0);
  cairo_paint(context.get());
  cairo_surface_flush(copy.get());
  return picture;
}

}  // namespace hapticell::ergonomics
