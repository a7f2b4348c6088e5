// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::test {

// Writers of small mesh files, for tests of the readers: what each format says, in its plainest form.
std::string stlAscii(const geometry::TriangleMesh& mesh);
std::string stlBinary(const geometry::TriangleMesh& mesh, const std::string& header = "made by a test");
std::string objText(const geometry::TriangleMesh& mesh);
std::string offText(const geometry::TriangleMesh& mesh);
std::string plyAscii(const geometry::TriangleMesh& mesh);
/// With a colour and a list on each vertex, that a reader has to step over.
std::string plyBinary(const geometry::TriangleMesh& mesh, bool big_endian);

}  // namespace hapticell::test
