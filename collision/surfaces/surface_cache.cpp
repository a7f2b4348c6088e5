// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/surface_cache.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <system_error>
#include <vector>

namespace hapticell::collision {

namespace {

/// Raised whenever recognition gives other surfaces.
constexpr std::uint32_t kSurfaceVersion = 2;
constexpr char kSurfaceMagic[8] = {'H', 'C', 'S', 'U', 'R', 'F', '\r', '\n'};

struct Header {
  char magic[8];
  std::uint32_t version;
  std::uint32_t byte_order;
  ContentHash mesh;
  std::uint64_t triangles, regions;
  ContentHash payload;
};

/// SurfaceShape as eleven numbers.
struct StoredShape {
  double type;
  double p[3], axis[3];
  double radius, major_radius, half_angle, side;
};

StoredShape stored(const SurfaceShape& s) {
  return {static_cast<double>(s.type),
          {s.p_M.x, s.p_M.y, s.p_M.z},
          {s.axis_M.x, s.axis_M.y, s.axis_M.z},
          s.radius,
          s.major_radius,
          s.half_angle,
          s.side};
}

SurfaceShape shapeOf(const StoredShape& s) {
  SurfaceShape shape;
  shape.type = static_cast<SurfaceType>(static_cast<int>(s.type));
  shape.p_M = {s.p[0], s.p[1], s.p[2]};
  shape.axis_M = {s.axis[0], s.axis[1], s.axis[2]};
  shape.radius = s.radius;
  shape.major_radius = s.major_radius;
  shape.half_angle = s.half_angle;
  shape.side = s.side;
  return shape;
}

ContentHash payloadHash(const std::vector<StoredShape>& shapes, const std::vector<std::uint32_t>& region_of) {
  ContentHash hash{5, 6};
  addToHash(hash, std::as_bytes(std::span(shapes)));
  addToHash(hash, std::as_bytes(std::span(region_of)));
  return hash;
}

bool isSound(const std::vector<StoredShape>& shapes, const std::vector<std::uint32_t>& region_of) {
  for (const StoredShape& shape : shapes) {
    if (!(shape.type >= 0.0 && shape.type <= static_cast<double>(SurfaceType::kFreeForm))) return false;
  }
  std::vector<std::uint8_t> used(shapes.size(), 0);
  for (const auto region : region_of) {
    if (region >= shapes.size()) return false;
    used[region] = 1;
  }
  for (const auto one : used) {
    if (one == 0) return false;
  }
  return true;
}

}  // namespace

bool SurfaceCache::load(const ContentHash& mesh, RecognisedSurface& surface) const {
  if (folder_.empty()) return false;
  const std::filesystem::path path = fileOf(mesh);
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(path, none);
  std::ifstream file(path, std::ios::binary);
  Header header{};
  if (none || !file.read(reinterpret_cast<char*>(&header), sizeof(header))) return false;
  if (std::memcmp(header.magic, kSurfaceMagic, sizeof(kSurfaceMagic)) != 0 || header.version != kSurfaceVersion ||
      header.byte_order != 0x01020304u || header.mesh != mesh || header.triangles != surface.mesh.triangles.size() ||
      header.regions > header.triangles ||
      size != sizeof(header) + header.regions * sizeof(StoredShape) + header.triangles * sizeof(std::uint32_t)) {
    return false;
  }
  std::vector<StoredShape> shapes(header.regions);
  std::vector<std::uint32_t> region_of(header.triangles);
  const auto read = [&file](void* into, std::size_t bytes) {
    return static_cast<bool>(file.read(static_cast<char*>(into), static_cast<std::streamsize>(bytes)));
  };
  if (!read(shapes.data(), shapes.size() * sizeof(StoredShape)) ||
      !read(region_of.data(), region_of.size() * sizeof(std::uint32_t)) ||
      payloadHash(shapes, region_of) != header.payload || !isSound(shapes, region_of)) {
    return false;
  }
  surface.regions.assign(shapes.size(), {});
  for (std::size_t i = 0; i < shapes.size(); ++i) surface.regions[i].shape = shapeOf(shapes[i]);
  for (std::uint32_t t = 0; t < region_of.size(); ++t) surface.regions[region_of[t]].triangles.push_back(t);
  surface.region_of = std::move(region_of);
  return true;
}

void SurfaceCache::store(const ContentHash& mesh, const RecognisedSurface& surface) const {
  if (folder_.empty() || surface.mesh.triangles.empty()) return;
  std::vector<StoredShape> shapes;
  for (const SurfaceRegion& region : surface.regions) shapes.push_back(stored(region.shape));
  Header header{};
  std::memcpy(header.magic, kSurfaceMagic, sizeof(kSurfaceMagic));
  header.version = kSurfaceVersion;
  header.byte_order = 0x01020304u;
  header.mesh = mesh;
  header.triangles = surface.mesh.triangles.size();
  header.regions = shapes.size();
  header.payload = payloadHash(shapes, surface.region_of);
  writeWhole(fileOf(mesh), {std::as_bytes(std::span(&header, 1)), std::as_bytes(std::span(shapes)),
                            std::as_bytes(std::span(surface.region_of))});
}

}  // namespace hapticell::collision
