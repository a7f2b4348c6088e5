// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/mesh_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

#include "workcell/meshes/mesh_pieces.h"

namespace hapticell::workcell {

namespace {

// Guards the tree against meshes of loose triangles. Half, twice: other files are taken as one solid, with a message.
constexpr std::size_t kMostSolids = 10'000;

using Solids = std::vector<std::uint32_t>;  // Of each piece.

/// Triangles in the order of their solids, and where each solid's begin; one more at the end.
struct Sorted {
  std::vector<std::uint32_t> triangles;
  std::vector<std::size_t> begin;
};

Sorted sortedBySolid(const MeshPieces& pieces, const Solids& solids, std::size_t count) {
  Sorted sorted;
  sorted.begin.assign(count + 1, 0);
  for (const std::uint32_t piece : pieces.piece) ++sorted.begin[solids[piece] + 1];
  for (std::size_t k = 1; k <= count; ++k) sorted.begin[k] += sorted.begin[k - 1];
  std::vector<std::size_t> next(sorted.begin.begin(), sorted.begin.end() - 1);
  sorted.triangles.resize(pieces.piece.size());
  for (std::uint32_t t = 0; t < pieces.piece.size(); ++t) sorted.triangles[next[solids[pieces.piece[t]]]++] = t;
  return sorted;
}

std::vector<MeshPart> cut(geometry::TriangleMesh mesh, const MeshPieces& pieces, const Solids& solids,
                          std::size_t count) {
  std::vector<MeshPart> parts(count);
  if (count == 1) {
    parts[0].mesh = std::move(mesh);
    return parts;
  }
  constexpr std::uint32_t kUnused = 0xFFFFFFFFu;
  const Sorted sorted = sortedBySolid(pieces, solids, count);
  std::vector<std::uint32_t> renamed(mesh.vertices.size(), kUnused);
  std::vector<std::uint32_t> used;
  for (std::size_t k = 0; k < count; ++k) {
    geometry::TriangleMesh& own = parts[k].mesh;
    for (std::size_t n = sorted.begin[k]; n < sorted.begin[k + 1]; ++n) {
      geometry::Triangle triangle = mesh.triangles[sorted.triangles[n]];
      for (std::uint32_t& index : triangle) {
        if (renamed[index] == kUnused) {
          renamed[index] = static_cast<std::uint32_t>(own.vertices.size());
          own.vertices.push_back(mesh.vertices[index]);
          used.push_back(index);
        }
        index = renamed[index];
      }
      own.triangles.push_back(triangle);
    }
    for (const std::uint32_t index : used) renamed[index] = kUnused;
    used.clear();
  }
  return parts;
}

void paintByMean(std::vector<MeshPart>& parts, const MeshPieces& pieces, const Solids& solids) {
  std::vector<MeshPiece> sums(parts.size());
  for (std::size_t k = 0; k < solids.size(); ++k) {
    MeshPiece& sum = sums[solids[k]];
    sum.colored_area += pieces.pieces[k].colored_area;
    for (std::size_t c = 0; c < 3; ++c) sum.color_sum[c] += pieces.pieces[k].color_sum[c];
  }
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (!(sums[k].colored_area > 0.0)) continue;
    parts[k].color.emplace();
    for (std::size_t c = 0; c < 3; ++c) {
      (*parts[k].color)[c] = static_cast<float>(sums[k].color_sum[c] / sums[k].colored_area);
    }
  }
}

void paint(std::vector<MeshPart>& parts, const MeshPieces& pieces, const Solids& solids, Diagnostics& diagnostics) {
  if (pieces.many_colors) {
    diagnostics.warn("the file has more than 64 colours; each solid is shown in their mean");
    return paintByMean(parts, pieces, solids);
  }
  std::vector<std::map<Color, double>> areas(parts.size());
  for (std::size_t k = 0; k < solids.size(); ++k) areas[solids[k]][pieces.pieces[k].color] += pieces.pieces[k].area;
  std::size_t mixed = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto most = std::max_element(areas[k].begin(), areas[k].end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (areas[k].size() > 1) ++mixed;
    if (isColor(most->first)) parts[k].color = most->first;
  }
  if (mixed > 0) {
    diagnostics.warn(mixed == 1
                         ? Text("1 solid has faces of several colours; shown in that of most of the area")
                         : Text("%1 solids have faces of several colours; shown in that of most of the area", mixed));
  }
}

std::string colorName(const Color& color) {
  const auto byte = [](float channel) { return static_cast<int>(std::lround(255.0f * channel)); };
  char text[16];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(color[0]), byte(color[1]), byte(color[2]));
  return text;
}

/// Nothing is joined in silence.
void warnOfJoined(const std::vector<std::vector<const MeshLabel*>>& used, Diagnostics& diagnostics) {
  std::size_t objects = 0, solids = 0;
  for (const auto& labels : used) {
    std::set<std::pair<std::size_t, std::string>> names;
    for (const MeshLabel* label : labels) names.insert({label->object_number, label->group});
    if (names.size() < 2) continue;
    objects += names.size();
    ++solids;
  }
  if (solids == 0) return;
  diagnostics.warn(
      solids == 1
          ? Text("%1 objects or groups that hang together at their open borders are 1 solid", objects)
          : Text("%1 objects or groups that hang together at their open borders are %2 solids", objects, solids));
}

/// What all pieces of a solid have in common.
MeshLabel commonLabel(const std::vector<const MeshLabel*>& labels) {
  MeshLabel common = *labels.front();
  for (const MeshLabel* label : labels) {
    if (label->object_number != common.object_number) {
      common.object_number = 0;
      common.object.clear();
    }
    if (label->group != common.group) common.group.clear();
    if (label->material != common.material) common.material.clear();
  }
  return common;
}

void name(std::vector<MeshPart>& parts, const std::vector<std::vector<const MeshLabel*>>& used) {
  using Key = std::pair<std::size_t, std::string>;  // Of an object, or of a group outside of objects.
  std::map<Key, std::vector<std::size_t>> owners;
  std::vector<MeshLabel> common;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    common.push_back(commonLabel(used[k]));
    const MeshLabel& label = common.back();
    owners[label.object_number > 0 ? Key{label.object_number, ""} : Key{0, label.group}].push_back(k);
  }
  std::size_t assemblies = 0;
  for (const auto& [key, solids_of_it] : owners) {
    const bool several = solids_of_it.size() > 1;
    if (several) ++assemblies;
    for (const std::size_t k : solids_of_it) {
      const MeshLabel& label = common[k];
      const std::string whole = label.object_number > 0 ? label.object : label.group;
      parts[k].name = whole;
      if (!several) continue;
      parts[k].assembly = whole;
      parts[k].assembly_number = assemblies;
      if (label.object_number > 0 && !label.group.empty()) {
        parts[k].name = label.group;
      } else if (!label.material.empty()) {
        parts[k].name = label.material;
      } else if (parts[k].color) {
        parts[k].name = colorName(*parts[k].color);
      }
    }
  }
}

}  // namespace

std::vector<MeshPart> partsOf(RawMesh raw, const std::map<std::string, Color>& materials, bool split,
                              Diagnostics& diagnostics) {
  if (raw.mesh.triangles.empty()) return {};
  if (raw.labels.empty()) raw.labels.emplace_back();
  const MeshPieces pieces = piecesOf(raw, materials);
  Solids solids = split ? solidsOf(raw.mesh, pieces) : Solids(pieces.pieces.size(), 0);
  std::size_t count = *std::max_element(solids.begin(), solids.end()) + std::size_t{1};
  const bool too_many = count > kMostSolids;
  if (too_many) {
    diagnostics.warn(Text("the file has %1 solids; they were taken as one", count));
    solids.assign(solids.size(), 0);
    count = 1;
  }
  std::vector<MeshPart> parts = cut(std::move(raw.mesh), pieces, solids, count);
  paint(parts, pieces, solids, diagnostics);
  std::vector<std::vector<const MeshLabel*>> used(count);
  for (std::size_t k = 0; k < solids.size(); ++k) used[solids[k]].push_back(&raw.labels[pieces.pieces[k].label]);
  name(parts, used);
  if (split && !too_many) warnOfJoined(used, diagnostics);
  return parts;
}

}  // namespace hapticell::workcell
