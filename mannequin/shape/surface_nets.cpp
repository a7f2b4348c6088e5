// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/surface_nets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hapticell::mannequin {

namespace {

// Cells of a block that is skipped where no surface is. Half: more blocks to ask; twice: fewer can be skipped.
constexpr int kBlock = 8;

class Nets {
 public:
  explicit Nets(const GridField& field) : field_(field) {
    origin_ = field.bounds.min - dvec3(2.0 * field.cell);
    for (int k = 0; k < 3; ++k) {
      n_[static_cast<std::size_t>(k)] =
          4 + static_cast<int>(std::ceil((field.bounds.max[k] - field.bounds.min[k]) / field.cell)) + 1;
    }
    values_.assign(static_cast<std::size_t>(n_[0]) * static_cast<std::size_t>(n_[1]) * static_cast<std::size_t>(n_[2]),
                   1.0f);
  }

  geometry::TriangleMesh make() {
    sample();
    placeVertices();
    connect();
    return std::move(mesh_);
  }

 private:
  std::size_t at(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(n_[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(n_[0]) +
           static_cast<std::size_t>(x);
  }
  dvec3 point(int x, int y, int z) const { return origin_ + field_.cell * dvec3(x, y, z); }

  void sample() {
    std::vector<dvec3> points;
    std::vector<double> values;
    const double radius = 0.5 * kBlock * field_.cell * std::sqrt(3.0);
    for (int z = 0; z < n_[2]; z += kBlock) {
      for (int y = 0; y < n_[1]; y += kBlock) {
        for (int x = 0; x < n_[0]; x += kBlock) {
          const dvec3 centre = point(x, y, z) + dvec3(0.5 * kBlock * field_.cell);
          points.assign(1, centre);
          field_.evaluate(centre, radius, points, values);
          sampleBlock(x, y, z, centre, radius, values[0], points, values);
        }
      }
    }
  }

  void sampleBlock(int x, int y, int z, const dvec3& centre, double radius, double middle, std::vector<dvec3>& points,
                   std::vector<double>& values) {
    const int x1 = std::min(x + kBlock, n_[0]), y1 = std::min(y + kBlock, n_[1]), z1 = std::min(z + kBlock, n_[2]);
    const bool far = std::abs(middle) > 1.6 * radius;
    if (!far) {
      points.clear();
      for (int k = z; k < z1; ++k)
        for (int j = y; j < y1; ++j)
          for (int i = x; i < x1; ++i) points.push_back(point(i, j, k));
      field_.evaluate(centre, radius, points, values);
    }
    std::size_t next = 0;
    for (int k = z; k < z1; ++k)
      for (int j = y; j < y1; ++j)
        for (int i = x; i < x1; ++i) values_[at(i, j, k)] = static_cast<float>(far ? middle : values[next++]);
  }

  void placeVertices() {
    vertex_.assign(values_.size(), 0);
    for (int z = 0; z + 1 < n_[2]; ++z)
      for (int y = 0; y + 1 < n_[1]; ++y)
        for (int x = 0; x + 1 < n_[0]; ++x) placeVertex(x, y, z);
  }

  void placeVertex(int x, int y, int z) {
    std::array<double, 8> corner{};
    int inside = 0;
    for (std::size_t c = 0; c < 8; ++c) {
      corner[c] = static_cast<double>(
          values_[at(x + static_cast<int>(c & 1), y + static_cast<int>((c >> 1) & 1), z + static_cast<int>(c >> 2))]);
      inside += corner[c] < 0.0 ? 1 : 0;
    }
    if (inside == 0 || inside == 8) return;
    dvec3 sum(0.0);
    double count = 0.0;
    for (std::size_t c = 0; c < 8; ++c) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t d = c | (std::size_t{1} << axis);
        if (d == c || (corner[c] < 0.0) == (corner[d] < 0.0)) continue;
        dvec3 crossing(static_cast<double>(c & 1), static_cast<double>((c >> 1) & 1), static_cast<double>(c >> 2));
        crossing[static_cast<int>(axis)] = corner[c] / (corner[c] - corner[d]);
        sum += crossing;
        count += 1.0;
      }
    }
    mesh_.vertices.push_back(point(x, y, z) + field_.cell * sum / count);
    vertex_[at(x, y, z)] = static_cast<std::uint32_t>(mesh_.vertices.size());
  }

  void connect() {
    for (int z = 1; z + 1 < n_[2]; ++z)
      for (int y = 1; y + 1 < n_[1]; ++y)
        for (int x = 1; x + 1 < n_[0]; ++x) {
          const bool here = values_[at(x, y, z)] < 0.0f;
          if (here != (values_[at(x + 1, y, z)] < 0.0f))
            quad({at(x, y - 1, z - 1), at(x, y, z - 1), at(x, y, z), at(x, y - 1, z)}, here);
          if (here != (values_[at(x, y + 1, z)] < 0.0f))
            quad({at(x - 1, y, z - 1), at(x - 1, y, z), at(x, y, z), at(x, y, z - 1)}, here);
          if (here != (values_[at(x, y, z + 1)] < 0.0f))
            quad({at(x - 1, y - 1, z), at(x, y - 1, z), at(x, y, z), at(x - 1, y, z)}, here);
        }
  }

  /// Four cells about an edge of the grid, counter-clockwise seen from its far end.
  void quad(const std::array<std::size_t, 4>& cells, bool outward) {
    std::array<std::uint32_t, 4> v{};
    for (std::size_t i = 0; i < 4; ++i) v[i] = vertex_[cells[i]] - 1;
    if (!outward) std::swap(v[1], v[3]);
    mesh_.triangles.push_back({v[0], v[1], v[2]});
    mesh_.triangles.push_back({v[0], v[2], v[3]});
  }

  const GridField& field_;
  dvec3 origin_;
  std::array<int, 3> n_{};
  std::vector<float> values_;
  std::vector<std::uint32_t> vertex_;
  geometry::TriangleMesh mesh_;
};

}  // namespace

geometry::TriangleMesh surfaceOf(const GridField& field) {
  return Nets(field).make();
}

void smoothSkin(geometry::TriangleMesh& mesh) {
  // Pairs of smoothing (Taubin 1995: inwards, then a little farther outwards, so that nothing shrinks). Half: facets of
  // the grid are seen; twice: noses get flat.
  constexpr int kPasses = 6;
  constexpr double kInward = 0.55, kOutward = -0.58;
  std::vector<dvec3> sum(mesh.vertices.size());
  std::vector<double> count(mesh.vertices.size());
  for (int pass = 0; pass < 2 * kPasses; ++pass) {
    std::fill(sum.begin(), sum.end(), dvec3(0.0));
    std::fill(count.begin(), count.end(), 0.0);
    for (const geometry::Triangle& t : mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        sum[t[i]] += mesh.vertices[t[(i + 1) % 3]] + mesh.vertices[t[(i + 2) % 3]];
        count[t[i]] += 2.0;
      }
    }
    const double share = pass % 2 == 0 ? kInward : kOutward;
    for (std::size_t v = 0; v < sum.size(); ++v) {
      if (count[v] > 0.0) mesh.vertices[v] += share * (sum[v] / count[v] - mesh.vertices[v]);
    }
  }
}

}  // namespace hapticell::mannequin
