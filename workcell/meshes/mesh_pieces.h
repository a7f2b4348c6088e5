// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "workcell/meshes/raw_mesh.h"

namespace hapticell::workcell {

/// The triangles of a mesh file with the same name and colour.
struct MeshPiece {
  std::uint32_t label = 0;  ///< Of its first triangle.
  Color color = kNoColor;
  double area = 0.0;          ///< In the squared unit of the file.
  double colored_area = 0.0;  ///< The part of it that has a colour, if there are too many colours to separate.
  std::array<double, 3> color_sum{0.0, 0.0, 0.0};  ///< Sum of these colours, weighted by area.
};

struct MeshPieces {
  std::vector<MeshPiece> pieces;     ///< In the order of their first triangles.
  std::vector<std::uint32_t> piece;  ///< Index for each triangle; empty if there is only one piece.
  bool many_colors = false;          ///< More than 64 colours: they are not separated.
};

/// One piece if nothing has a name or a colour.
MeshPieces piecesOf(const RawMesh& raw, const std::map<std::string, Color>& materials);

/// The solid of each piece, numbered in the order of their first triangles: pieces that share a corner at an open
/// border of both are connected.
std::vector<std::uint32_t> solidsOf(const geometry::TriangleMesh& mesh, const MeshPieces& pieces);

}  // namespace hapticell::workcell
