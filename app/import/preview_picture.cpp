// SPDX-License-Identifier: Apache-2.0
#include "app/import/preview_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/viewport/scene/part_colors.h"

namespace hapticell::app {
namespace {

constexpr int kFiner = 2;  // Samples a pixel, each way.

/// World to picture: x right, y down, z towards the eye.
struct View {
  dvec3 right_W{}, up_W{}, back_W{};
  double scale = 1.0;
  dvec3 p_WCenter{0.0};
  double half_width = 0.0, half_height = 0.0;

  dvec3 project(const dvec3& p_W) const {
    const dvec3 d = p_W - p_WCenter;
    return {half_width + scale * glm::dot(d, right_W), half_height - scale * glm::dot(d, up_W), glm::dot(d, back_W)};
  }
};

View viewOf(const geometry::Bounds& bounds_W, QSize samples) {
  View view;
  view.back_W = glm::normalize(dvec3(0.62, -0.9, 0.6));
  view.right_W = glm::normalize(glm::cross(dvec3(0.0, 0.0, 1.0), view.back_W));
  view.up_W = glm::cross(view.back_W, view.right_W);
  view.p_WCenter = bounds_W.center();
  view.half_width = 0.5 * samples.width();
  view.half_height = 0.5 * samples.height();
  const dvec3 half = 0.5 * bounds_W.size();
  const auto reach = [&](const dvec3& axis) { return glm::dot(glm::abs(axis), half); };
  constexpr double kFilled = 0.9;
  view.scale = kFilled * std::min(view.half_width / std::max(reach(view.right_W), 1e-12),
                                  view.half_height / std::max(reach(view.up_W), 1e-12));
  return view;
}

class Canvas {
 public:
  explicit Canvas(QSize samples)
      : image(samples, QImage::Format_ARGB32_Premultiplied),
        depth_(static_cast<std::size_t>(samples.width()) * static_cast<std::size_t>(samples.height()),
               -std::numeric_limits<float>::infinity()) {
    image.fill(Qt::transparent);
  }

  void fill(const dvec3 (&p)[3], QRgb color) {
    const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
    if (!(std::abs(area) > 1e-9)) return;
    const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
    const int x0 = std::max(0, static_cast<int>(std::floor(left))), y0 = std::max(0, static_cast<int>(std::floor(top)));
    const int x1 = std::min(image.width() - 1, static_cast<int>(std::ceil(right)));
    const int y1 = std::min(image.height() - 1, static_cast<int>(std::ceil(bottom)));
    for (int y = y0; y <= y1; ++y) {
      auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
      for (int x = x0; x <= x1; ++x) {
        const double u = ((p[1].x - x) * (p[2].y - y) - (p[2].x - x) * (p[1].y - y)) / area;
        const double v = ((p[2].x - x) * (p[0].y - y) - (p[0].x - x) * (p[2].y - y)) / area;
        if (u < 0.0 || v < 0.0 || u + v > 1.0) continue;
        const auto depth = static_cast<float>(u * p[0].z + v * p[1].z + (1.0 - u - v) * p[2].z);
        float& nearest =
            depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width()) + static_cast<std::size_t>(x)];
        if (depth <= nearest) continue;
        nearest = depth;
        line[x] = color;
      }
    }
  }

  QImage image;

 private:
  std::vector<float> depth_;
};

QRgb shaded(const std::array<float, 3>& color, double light) {
  const auto part = [light](float value) {
    return static_cast<int>(std::lround(255.0 * std::clamp(static_cast<double>(value) * light, 0.0, 1.0)));
  };
  return qRgb(part(color[0]), part(color[1]), part(color[2]));
}

void paint(const workcell::Entity& entity, const View& view, Canvas& canvas) {
  const std::array<float, 3> color = partColor(entity.color);
  const dvec3 light_W = glm::normalize(dvec3(0.3, -0.5, 0.9));
  for (const geometry::Triangle& triangle : entity.mesh()->triangles) {
    dvec3 p_W[3], p[3];
    for (std::size_t k = 0; k < 3; ++k) {
      p_W[k] = entity.X_WE * entity.mesh()->vertices[triangle[k]];
      p[k] = view.project(p_W[k]);
    }
    const dvec3 across = glm::cross(p_W[1] - p_W[0], p_W[2] - p_W[0]);
    const double length = glm::length(across);
    if (!(length > 0.0)) continue;
    dvec3 nhat_W = across / length;
    if (glm::dot(nhat_W, view.back_W) < 0.0) nhat_W = -nhat_W;  // Two-sided, as the scene is.
    canvas.fill(
        p, shaded(color, 0.45 + 0.4 * std::max(0.0, glm::dot(nhat_W, light_W)) + 0.25 * glm::dot(nhat_W, view.back_W)));
  }
}

}  // namespace

geometry::Bounds exactBounds_W(const std::vector<workcell::Entity>& entities) {
  geometry::Bounds bounds_W;
  for (const workcell::Entity& entity : entities)
    if (entity.mesh())
      for (const dvec3& vertex : entity.mesh()->vertices) bounds_W.add(entity.X_WE * vertex);
  return bounds_W;
}

double previewPixelsPerMetre(const dvec3& size, QSize picture) {
  return viewOf({-0.5 * size, 0.5 * size}, picture).scale;
}

QImage previewPicture(const std::vector<workcell::Entity>& entities, QSize size) {
  const geometry::Bounds bounds_W = exactBounds_W(entities);
  if (bounds_W.isEmpty() || size.isEmpty()) return {};
  const QSize samples = size * kFiner;
  const View view = viewOf(bounds_W, samples);
  Canvas canvas(samples);
  for (const workcell::Entity& entity : entities)
    if (entity.mesh()) paint(entity, view, canvas);
  return canvas.image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

}  // namespace hapticell::app
