// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace hapticell::test {

/// The corners and triangles of a box from 0 to (x, y, z), as text.
inline std::string boxPoints(double x, double y, double z) {
  std::string text;
  for (int k = 0; k < 8; ++k) {
    const bool right = k % 4 == 1 || k % 4 == 2, back = k % 4 >= 2, top = k >= 4;
    text += std::to_string(right ? x : 0.0) + " " + std::to_string(back ? y : 0.0) + " " + std::to_string(top ? z : 0.0) + " ";
  }
  return text;
}
constexpr const char* kBoxTriangles =
    "0 2 1 0 3 2 4 5 6 4 6 7 0 1 5 0 5 4 1 2 6 1 6 5 2 3 7 2 7 6 3 0 4 3 4 7";

/// A Collada file with a box of 1 x 2 x 3 units; the parts of it that tests vary.
struct ColladaParts {
  std::string asset = "<asset><unit name='meter' meter='1'/><up_axis>Z_UP</up_axis></asset>";
  std::string libraries, geometries, effect_color = "1 0 0 1";
  std::string nodes = "<node id='n' name='box'><instance_geometry url='#g'/></node>";
};
inline std::string colladaOf(const ColladaParts& parts) {
  return "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'>" +
         parts.asset + parts.libraries +
         "<library_effects><effect id='e'><profile_COMMON><technique sid='t'><lambert><diffuse><color>" +
         parts.effect_color +
         "</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects><library_materials>"
         "<material id='m'><instance_effect url='#e'/></material></library_materials><library_geometries><geometry "
         "id='g' name='box'><mesh><source id='p'><float_array id='a' count='24'>" +
         boxPoints(1, 2, 3) +
         "</float_array><technique_common><accessor source='#a' count='8' stride='3'><param name='X' type='float'/>"
         "<param name='Y' type='float'/><param name='Z' type='float'/></accessor></technique_common></source><vertices "
         "id='v'><input semantic='POSITION' source='#p'/></vertices><triangles count='12'><input semantic='VERTEX' "
         "source='#v' offset='0'/><p>" +
         kBoxTriangles + "</p></triangles></mesh></geometry>" + parts.geometries +
         "</library_geometries><library_visual_scenes><visual_scene id='S'>" + parts.nodes +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#S'/></scene></COLLADA>";
}
inline std::string colladaBox(const std::string& libraries) {
  ColladaParts parts;
  parts.libraries = libraries;
  return colladaOf(parts);
}

inline std::string base64(const std::string& bytes) {
  static const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < 3; ++i) bits = bits << 8 | (k + i < bytes.size() ? static_cast<unsigned char>(bytes[k + i]) : 0u);
    for (std::size_t i = 0; i < 4; ++i) text += k + i > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * i) & 63u];
  }
  return text;
}

/// Little-endian bytes of numbers.
template <typename Number>
std::string bytesOf(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

inline std::string boxIndices() {
  return bytesOf(std::vector<std::uint16_t>{0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                            1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7});
}
inline std::vector<float> boxFloats(float x, float y, float z) {
  return {0, 0, 0, x, 0, 0, x, y, 0, 0, y, 0, 0, 0, z, x, 0, z, x, y, z, 0, y, z};
}

/// A glTF file of one box of 1 x 2 x 3 m (y up); `more` behind its last member, `in_mesh` in its mesh.
inline std::string gltfBox(const std::string& more, const std::string& in_mesh = "") {
  const std::string points = bytesOf(boxFloats(1, 2, 3)), data = points + boxIndices();
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"box","mesh":0}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}])" +
         in_mesh +
         R"(}],"accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3"},)"
         R"({"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72}],)"
         R"("buffers":[{"byteLength":168,"uri":"data:application/octet-stream;base64,)" +
         base64(data) + R"("}])" + more + "}";
}

}  // namespace hapticell::test
