// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/gltf_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "workcell/scenes/scene_exchange.h"
#include "workcell/text/base64.h"

namespace hapticell::workcell {

namespace {

using Json = nlohmann::ordered_json;

/// A screen's colour as a linear one (IEC 61966-2-1).
double linear(float displayed) {
  const double c = std::clamp(static_cast<double>(displayed), 0.0, 1.0);
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

template <typename T>
void appendRaw(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

class GltfBuilder {
 public:
  explicit GltfBuilder(const ImportedScene& scene) : scene_(scene) {
    json_["asset"] = {{"version", "2.0"}, {"generator", "HaptiCell"}};
    json_["scene"] = 0;
    json_["scenes"] = Json::array({{{"nodes", Json::array()}}});
    for (const char* list : {"nodes", "meshes", "materials", "accessors", "bufferViews"}) json_[list] = Json::array();
  }

  std::string build(bool binary) {
    for (const SceneNode& node : scene_.nodes) addNode(node);
    for (const char* list : {"nodes", "meshes", "materials", "accessors", "bufferViews"}) {
      if (json_[list].empty()) json_.erase(list);  // The standard forbids empty lists.
    }
    Json buffer{{"byteLength", data_.size()}};
    if (!binary) buffer["uri"] = "data:application/octet-stream;base64," + base64(data_);
    if (!data_.empty()) json_["buffers"] = Json::array({std::move(buffer)});
    const std::string text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
    return binary ? container(text) : text + "\n";
  }

 private:
  void addNode(const SceneNode& node) {
    const auto index = json_["nodes"].size();
    Json json{{"name", node.name}};
    const Pose X = node.parent < 0 ? turnedUp(UpAxis::kY).inverse() * node.X_PN : node.X_PN;
    if (X.p != dvec3(0.0)) json["translation"] = {X.p.x, X.p.y, X.p.z};
    if (std::abs(X.q.w) < 1.0) json["rotation"] = {X.q.x, X.q.y, X.q.z, X.q.w};
    if (node.mesh >= 0) json["mesh"] = meshOf(node);
    json_["nodes"].push_back(std::move(json));
    Json& siblings = node.parent < 0 ? json_["scenes"][0]["nodes"]
                                     : json_["nodes"][static_cast<std::size_t>(node.parent)]["children"];
    siblings.push_back(index);
  }

  std::size_t meshOf(const SceneNode& node) {
    const int material = materialOf(node);
    const auto [known, is_new] = meshes_.try_emplace({node.mesh, material}, json_["meshes"].size());
    if (!is_new) return known->second;
    const auto [accessors, new_data] = data_of_.try_emplace(node.mesh);
    if (new_data) accessors->second = store(scene_.meshes[static_cast<std::size_t>(node.mesh)]);
    Json primitive{{"attributes", {{"POSITION", accessors->second.first}}}, {"indices", accessors->second.second}};
    if (material >= 0) primitive["material"] = material;
    json_["meshes"].push_back({{"name", node.name}, {"primitives", Json::array({std::move(primitive)})}});
    return known->second;
  }

  int materialOf(const SceneNode& node) {
    if (!node.color) return -1;
    const auto [known, is_new] = materials_.try_emplace(*node.color, static_cast<int>(materials_.size()));
    if (is_new) {
      const auto [r, g, b] = *node.color;
      json_["materials"].push_back({{"pbrMetallicRoughness",
                                     {{"baseColorFactor", {linear(r), linear(g), linear(b), 1.0}},
                                      {"metallicFactor", 0.1},
                                      {"roughnessFactor", 0.6}}},
                                    {"doubleSided", true}});
    }
    return known->second;
  }

  std::size_t addView(std::size_t begin, int target) {
    json_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", data_.size() - begin}, {"target", target}});
    return json_["bufferViews"].size() - 1;
  }

  /// The accessors of positions and indices.
  std::pair<std::size_t, std::size_t> store(const geometry::TriangleMesh& mesh) {
    constexpr int kFloat = 5126, kUnsigned = 5125, kVertices = 34962, kIndices = 34963;
    std::array<float, 3> low{}, high{};
    std::size_t begin = data_.size();
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto value = static_cast<float>(mesh.vertices[v][static_cast<int>(k)]);
        low[k] = v == 0 ? value : std::min(low[k], value);
        high[k] = v == 0 ? value : std::max(high[k], value);
        appendRaw(data_, value);
      }
    }
    const std::size_t positions = addView(begin, kVertices);
    begin = data_.size();
    for (const geometry::Triangle& t : mesh.triangles) {
      for (std::uint32_t index : t) appendRaw(data_, index);
    }
    const std::size_t indices = addView(begin, kIndices);
    json_["accessors"].push_back({{"bufferView", positions},
                                  {"componentType", kFloat},
                                  {"count", mesh.vertices.size()},
                                  {"type", "VEC3"},
                                  {"min", low},
                                  {"max", high}});
    json_["accessors"].push_back({{"bufferView", indices},
                                  {"componentType", kUnsigned},
                                  {"count", 3 * mesh.triangles.size()},
                                  {"type", "SCALAR"}});
    const std::size_t count = json_["accessors"].size();
    return {count - 2, count - 1};
  }

  std::string container(std::string text) const {
    constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJson = 0x4E4F534A, kBinary = 0x004E4942;
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string bytes;
    const std::size_t length = 12 + 8 + text.size() + (data_.empty() ? 0 : 8 + data_.size());
    for (std::uint32_t word :
         {kMagic, kVersion, static_cast<std::uint32_t>(length), static_cast<std::uint32_t>(text.size()), kJson}) {
      appendRaw(bytes, word);
    }
    bytes += text;
    if (data_.empty()) return bytes;
    appendRaw(bytes, static_cast<std::uint32_t>(data_.size()));
    appendRaw(bytes, kBinary);
    return bytes + data_;
  }

  const ImportedScene& scene_;
  Json json_;
  std::string data_;                                   // Only numbers of four bytes go in, so everything is aligned.
  std::map<std::pair<int, int>, std::size_t> meshes_;  // By mesh and material.
  std::map<std::array<float, 3>, int> materials_;
  std::map<int, std::pair<std::size_t, std::size_t>> data_of_;
};

}  // namespace

std::string gltfBytes(const ImportedScene& scene, bool binary) {
  return GltfBuilder(scene).build(binary);
}

}  // namespace hapticell::workcell
