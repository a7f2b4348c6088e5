// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/mesh_pieces.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "geometry/shapes/vertex_merge.h"

namespace hapticell::workcell {

namespace {

// Colours of a part that are kept as pieces; more are a scan or a result of simulation. Half, twice: such become grey,
// or the mesh falls into many pieces.
constexpr std::size_t kMostColors = 64;

class PieceFinder {
 public:
  PieceFinder(const RawMesh& raw, const std::map<std::string, Color>& materials) : raw_(raw) {
    for (const MeshLabel& label : raw_.labels) {
      const auto found = materials.find(label.material);
      material_colors_.push_back(found == materials.end() ? kNoColor : found->second);
    }
    if (material_colors_.empty()) material_colors_.push_back(kNoColor);
    nameLabels();
  }

  MeshPieces find() {
    if (raw_.label.empty() && raw_.color.empty()) {
      result_.pieces.push_back({0, kNoColor, 0.0, 0.0, {}});
      return std::move(result_);
    }
    result_.many_colors = hasManyColors();
    const auto count = static_cast<std::uint32_t>(raw_.mesh.triangles.size());
    result_.piece.resize(count);
    for (std::uint32_t t = 0; t < count; ++t) {
      const Color color = colorOf(t);
      const std::uint32_t piece = pieceOf({names_[labelOf(t)], result_.many_colors ? kNoColor : color}, t);
      result_.piece[t] = piece;
      add(result_.pieces[piece], color, areaOf(t));
    }
    return std::move(result_);
  }

 private:
  using Key = std::pair<std::uint32_t, Color>;  // Name and colour.

  /// Labels that differ by material only have one name: they are told apart by colour.
  void nameLabels() {
    std::map<std::pair<std::size_t, std::string>, std::uint32_t> known;
    for (const MeshLabel& label : raw_.labels) {
      const auto number = static_cast<std::uint32_t>(known.size());
      names_.push_back(known.try_emplace({label.object_number, label.group}, number).first->second);
    }
    if (names_.empty()) names_.push_back(0);
  }

  bool hasManyColors() const {
    std::set<Color> colors;
    for (std::uint32_t t = 0; t < raw_.mesh.triangles.size() && colors.size() <= kMostColors; ++t) {
      colors.insert(colorOf(t));
    }
    return colors.size() > kMostColors;
  }

  std::uint32_t pieceOf(const Key& key, std::uint32_t triangle) {
    if (!result_.pieces.empty() && key == last_key_) return last_piece_;
    const auto number = static_cast<std::uint32_t>(result_.pieces.size());
    const auto [known, is_new] = known_.try_emplace(key, number);
    if (is_new) result_.pieces.push_back({labelOf(triangle), key.second, 0.0, 0.0, {}});
    last_key_ = key;
    return last_piece_ = known->second;
  }

  static void add(MeshPiece& piece, const Color& color, double area) {
    piece.area += area;
    if (!isColor(color)) return;
    piece.colored_area += area;
    for (std::size_t k = 0; k < 3; ++k) piece.color_sum[k] += area * static_cast<double>(color[k]);
  }

  std::uint32_t labelOf(std::uint32_t triangle) const { return raw_.label.empty() ? 0 : raw_.label[triangle]; }

  Color colorOf(std::uint32_t triangle) const {
    if (!raw_.color.empty() && isColor(raw_.color[triangle])) return raw_.color[triangle];
    return material_colors_[labelOf(triangle)];
  }

  double areaOf(std::uint32_t triangle) const {
    const dvec3 a = raw_.mesh.corner(triangle, 0);
    return 0.5 * glm::length(glm::cross(raw_.mesh.corner(triangle, 1) - a, raw_.mesh.corner(triangle, 2) - a));
  }

  const RawMesh& raw_;
  std::vector<Color> material_colors_;  // Of each label.
  std::vector<std::uint32_t> names_;    // Of each label.
  std::map<Key, std::uint32_t> known_;
  Key last_key_{0, kNoColor};
  std::uint32_t last_piece_ = 0;
  MeshPieces result_;
};

struct Border {
  std::uint32_t vertex = 0, piece = 0;
  auto operator<=>(const Border&) const = default;  // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0 here.
};

/// The ends of all edges that an odd number of a piece's triangles has, sorted.
std::vector<Border> openBorders(const geometry::TriangleMesh& mesh, const MeshPieces& pieces) {
  const std::vector<std::uint32_t> merged = geometry::mergedVertices(mesh.vertices, geometry::weldTolerance(mesh));
  std::vector<std::array<std::uint32_t, 3>> edges;  // Piece, vertex, vertex.
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = merged[mesh.triangles[t][k]], b = merged[mesh.triangles[t][(k + 1) % 3]];
      if (a != b) edges.push_back({pieces.piece[t], std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Border> borders;
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end] == edges[begin]) ++end;
    if ((end - begin) % 2 == 0) continue;
    borders.push_back({edges[begin][1], edges[begin][0]});
    borders.push_back({edges[begin][2], edges[begin][0]});
  }
  std::sort(borders.begin(), borders.end());
  return borders;
}

}  // namespace

MeshPieces piecesOf(const RawMesh& raw, const std::map<std::string, Color>& materials) {
  return PieceFinder(raw, materials).find();
}

std::vector<std::uint32_t> solidsOf(const geometry::TriangleMesh& mesh, const MeshPieces& pieces) {
  std::vector<std::uint32_t> root(pieces.pieces.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&root](std::uint32_t k) {
    while (root[k] != k) k = root[k] = root[root[k]];
    return k;
  };
  if (root.size() > 1) {
    const std::vector<Border> borders = openBorders(mesh, pieces);
    for (std::size_t k = 1; k < borders.size(); ++k) {
      if (borders[k].vertex != borders[k - 1].vertex) continue;
      const std::uint32_t a = find(borders[k].piece), b = find(borders[k - 1].piece);
      root[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<std::uint32_t> solids(root.size());
  std::uint32_t next = 0;
  for (std::uint32_t k = 0; k < root.size(); ++k) {
    const std::uint32_t first = find(k);
    solids[k] = first == k ? next++ : solids[first];
  }
  return solids;
}

}  // namespace hapticell::workcell
