// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "workcell/meshes/raw_mesh.h"

namespace hapticell::workcell {

/// The triangles of a mesh file that have one name and one colour.
struct MeshPiece {
  std::uint32_t label = 0;  ///< Of its first triangle.
  Color color = kNoColor;
  double area = 0.0;          ///< In the file's unit, squared.
  double colored_area = 0.0;  ///< Of it, what has a colour; where there are too many to tell apart.
  std::array<double, 3> color_sum{0.0, 0.0, 0.0};  ///< Of these colours, by area.
};

struct MeshPieces {
  std::vector<MeshPiece> pieces;     ///< In the order of their first triangles.
  std::vector<std::uint32_t> piece;  ///< Of each triangle; empty where there is one piece.
  bool many_colors = false;          ///< More than 64: they are not separated.
};

/// Where nothing has a name or a colour, one piece.
MeshPieces piecesOf(const RawMesh& raw, const std::map<std::string, Color>& materials);

/// The solid that each piece belongs to, numbered in the order of their first triangles: pieces that share a corner at
/// an open border of both hang together.
std::vector<std::uint32_t> solidsOf(const geometry::TriangleMesh& mesh, const MeshPieces& pieces);

}  // namespace hapticell::workcell
