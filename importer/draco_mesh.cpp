// SPDX-License-Identifier: Apache-2.0
#include "importer/draco_mesh.h"

#include <draco/compression/decode.h>

namespace hapticell::importer {

Expected<UnpackedMesh> unpackDraco(std::string_view bytes, std::uint32_t attribute) {
  const auto refused = [](const Text& found) {
    return makeError(Error{.place = "KHR_draco_mesh_compression",
                           .found = found,
                           .expected = "an undamaged mesh",
                           .fix = "Export it again."});
  };
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) return refused(Text("data that cannot be decompressed (%1)", decoded.status().error_msg_string()));
  const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
  const draco::PointAttribute* positions = mesh->GetAttributeByUniqueId(attribute);
  if (!positions) positions = mesh->GetNamedAttribute(draco::GeometryAttribute::POSITION);
  if (!positions || positions->num_components() != 3) return refused(Text("the positions are missing"));
  UnpackedMesh result;
  result.positions.reserve(3 * static_cast<std::size_t>(mesh->num_points()));
  for (draco::PointIndex k(0); k < mesh->num_points(); ++k) {
    float p[3] = {};
    if (!positions->ConvertValue<float, 3>(positions->mapped_index(k), p)) return refused(Text("invalid positions"));
    result.positions.insert(result.positions.end(), p, p + 3);
  }
  result.triangles.reserve(3 * static_cast<std::size_t>(mesh->num_faces()));
  for (draco::FaceIndex k(0); k < mesh->num_faces(); ++k) {
    for (int corner = 0; corner < 3; ++corner) result.triangles.push_back(mesh->face(k)[corner].value());
  }
  return result;
}

}  // namespace hapticell::importer
