// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::app {

/// A vertex for the graphics card: position relative to the mesh's centre, unit normal.
struct DisplayVertex {
  fvec3 position;
  fvec3 normal;
};

/// An edge for the graphics card: ends relative to the centre, and the unit normals of its two faces. Creases are
/// always drawn; others only while one face is turned to the eye and the other away. A border has opposite normals.
struct DisplayEdge {
  fvec3 from;
  fvec3 to;
  fvec3 normal_a;
  fvec3 normal_b;
};

/// A range of a display mesh's indices: all its triangles, or fewer that replace them.
struct DetailStep {
  std::size_t first = 0, count = 0;  ///< Indices.
  double error = 0.0;                ///< Approximate distance of its surface from the mesh's, metres.
};

/// A mesh prepared for drawing. No OpenGL here.
struct DisplayMesh {
  dvec3 center{0.0};        ///< p_MC; positions are relative to it, so that large coordinates do not lose digits.
  geometry::Bounds bounds;  ///< In M.
  std::vector<DisplayVertex> vertices;
  std::vector<std::uint32_t> indices;  ///< Three per triangle; those of all steps, one after the other.
  std::vector<DetailStep> steps;       ///< The first is the mesh itself; addDetailSteps() adds coarser ones.
  std::vector<DisplayEdge> edges;      ///< Creases and borders first, then the smooth ones.
  std::size_t creases = 0;             ///< How many of `edges` are creases or borders.
  bool closed = true;                  ///< Each edge has two triangles: the mesh bounds a solid.
};

/// rad, 28 degrees between triangles that make an edge: facets of usual quality turn by less. Half: coarse cylinders
/// show their facets; twice: chamfers of 45 degrees look round.
inline constexpr double kPartCrease = 0.48869219;
/// rad, 109 degrees: only where a surface folds back on itself. Half: folds of cloth become edges; twice: no edges.
inline constexpr double kSkinCrease = 1.9;

/// Smooths normals over faces that meet at less than `crease_angle` (rad); corners at the same point count as one. Once
/// `given_up` is set, returns soon, with a mesh that must not be used.
DisplayMesh makeDisplayMesh(const geometry::TriangleMesh& mesh, double crease_angle = kPartCrease,
                            const std::atomic<bool>* given_up = nullptr);

/// Appends the triangles of `mesh` (in M) with their own vertices to those of `display`, smoothed in the same way.
void addSmoothed(const geometry::TriangleMesh& mesh, double crease_angle, DisplayMesh& display);

}  // namespace hapticell::app
