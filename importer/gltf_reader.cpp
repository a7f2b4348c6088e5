// SPDX-License-Identifier: Apache-2.0
#include "importer/gltf_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "geometry/system/unfolding.h"
#include "importer/damaged_file.h"
#include "importer/draco_mesh.h"
#include "importer/gltf_file.h"
#include "workcell/text/content_rules.h"

namespace hapticell::importer {

using nlohmann::json;

namespace {

constexpr std::size_t kNoIndex = static_cast<std::size_t>(-1);
// Guards time and memory of the tree. Half, twice: other files are refused with a message.
constexpr std::size_t kMostNodes = 200'000;
// Levels of nodes, as kDeepest of assimp_reader.cpp.
constexpr int kDeepestNode = 500;

std::vector<float> gltfFloats(const json& object, const char* key, std::vector<float> otherwise) {
  const json& list = gltfMember(object, key);
  if (!list.is_array() || list.size() != otherwise.size()) return otherwise;
  std::vector<float> numbers;
  for (const json& number : list) numbers.push_back(number.is_number() ? number.get<float>() : 0.0f);
  return numbers;
}

aiMatrix4x4 placement(const std::vector<float>& t, const std::vector<float>& r, const std::vector<float>& s) {
  aiQuaternion q(r[3], r[0], r[1], r[2]);
  q.Normalize();
  return {aiVector3D(s[0], s[1], s[2]), q, aiVector3D(t[0], t[1], t[2])};
}

aiMatrix4x4 placementOf(const json& node) {
  const json& matrix = gltfMember(node, "matrix");
  if (matrix.is_array() && matrix.size() == 16) {
    const std::vector<float> m = gltfFloats(node, "matrix", std::vector<float>(16));
    return {m[0], m[4], m[8], m[12], m[1], m[5], m[9], m[13], m[2], m[6], m[10], m[14], m[3], m[7], m[11], m[15]};
  }
  return placement(gltfFloats(node, "translation", {0, 0, 0}), gltfFloats(node, "rotation", {0, 0, 0, 1}),
                   gltfFloats(node, "scale", {1, 1, 1}));
}

class GltfReader {
 public:
  explicit GltfReader(GltfFile& file) : file_(file), report_("glTF") {}

  Expected<ModelScene> read() {
    HAPTICELL_TRY(checkRequired());
    const std::vector<std::size_t> indices = rootNodes();
    HAPTICELL_TRY(checkNodes(indices));
    meetFeatures();
    addMaterials();
    HAPTICELL_TRY(addMeshes());
    std::vector<std::unique_ptr<aiNode>> roots;
    for (const std::size_t index : indices) {
      auto node = nodeOf(index, 0);
      HAPTICELL_TRY(node);
      roots.push_back(std::move(*node));
    }
    if (roots.empty()) return makeError(damagedFile("", Text("a scene without nodes"), Text("nodes with meshes")));
    ModelScene result;
    std::unique_ptr<aiNode> root;
    if (roots.size() == 1) {
      root = std::move(roots.front());
    } else {
      root = newNode("ROOT");
      giveChildren(*root, std::move(roots));
    }
    result.scene = std::make_unique<aiScene>();
    fillScene(*result.scene, std::move(root), std::move(meshes_), std::move(materials_));
    report_.tell(result.warnings);
    return result;
  }

 private:
  Expected<void> checkRequired() {
    const json& required = gltfMember(file_.json(), "extensionsRequired");
    for (const json& name : required.is_array() ? required : json::array()) {
      if (!name.is_string()) continue;
      const auto* const rule = report_.rule(name.get<std::string>());
      using workcell::Treatment;
      if (rule && (rule->treatment == Treatment::kUsed || rule->treatment == Treatment::kNoted)) continue;
      return makeError({.place = "extensionsRequired",
                        .found = Text("the extension %1, which is not supported", name.get<std::string>()),
                        .expected = "extensions that docs/user/formats.md lists",
                        .fix = "Export it without this extension, or remove the extension with a conversion tool."});
    }
    return {};
  }

  /// What concerns the file as a whole.
  void meetFeatures() {
    const json& root = file_.json();
    if (!gltfMember(root, "animations").empty()) report_.meet("animations", "shown at rest");
    if (!gltfMember(root, "skins").empty()) report_.meet("skins", "shown as modelled");
    if (gltfMember(root, "scenes").size() > 1) report_.meet("further scenes", "only the main one is read");
  }

  void addMaterials() {
    const json& list = gltfMember(file_.json(), "materials");
    for (std::size_t k = 0; list.is_array() && k < list.size(); ++k) {
      std::vector<float> color = {1, 1, 1, 1};
      color = gltfFloats(gltfMember(gltfMember(list[k], "extensions"), "KHR_materials_pbrSpecularGlossiness"),
                         "diffuseFactor", color);
      color = gltfFloats(gltfMember(list[k], "pbrMetallicRoughness"), "baseColorFactor", color);
      materials_.push_back(newMaterial({color[0], color[1], color[2], color[3]}));
    }
    materials_.push_back(newMaterial({1, 1, 1, 1}));  // For what names none.
  }

  Expected<void> addMeshes() {
    const json& list = gltfMember(file_.json(), "meshes");
    for (std::size_t k = 0; list.is_array() && k < list.size(); ++k) {
      const json& primitives = gltfMember(list[k], "primitives");
      std::string name = gltfText(list[k], "name");
      if (name.empty()) name = "mesh_" + std::to_string(k);
      std::vector<unsigned> own;
      if (!gltfMember(list[k], "weights").empty()) report_.meet("morph targets", "'" + name + "'");
      for (std::size_t p = 0; primitives.is_array() && p < primitives.size(); ++p) {
        auto mesh = meshOf(primitives[p], primitives.size() > 1 ? name + "-" + std::to_string(p) : name);
        HAPTICELL_TRY(mesh);
        if (!*mesh) continue;
        own.push_back(static_cast<unsigned>(meshes_.size()));
        meshes_.push_back(std::move(*mesh));
      }
      of_mesh_.push_back(std::move(own));
    }
    return {};
  }

  /// Null where the primitive has no triangles.
  Expected<std::unique_ptr<aiMesh>> meshOf(const json& primitive, const std::string& name) {
    const std::size_t mode = gltfNumber(primitive, "mode", 4);
    if (mode < 4) {
      report_.meet("points and lines", "'" + name + "'");
      return nullptr;
    }
    const std::size_t material = gltfNumber(primitive, "material", kNoIndex);
    const auto used = static_cast<unsigned>(std::min(material, materials_.size() - 1));
    const json& draco = gltfMember(gltfMember(primitive, "extensions"), "KHR_draco_mesh_compression");
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;
    if (!draco.empty()) {
      const auto bytes = file_.view(gltfNumber(draco, "bufferView", kNoIndex));
      HAPTICELL_TRY(bytes);
      const std::size_t id = gltfNumber(gltfMember(draco, "attributes"), "POSITION", kNoIndex);
      auto unpacked = unpackDraco(*bytes, static_cast<std::uint32_t>(id));
      HAPTICELL_TRY(unpacked);
      positions = std::move(unpacked->positions);
      indices = std::move(unpacked->triangles);
    } else {
      const std::size_t accessor = gltfNumber(gltfMember(primitive, "attributes"), "POSITION", kNoIndex);
      if (accessor == kNoIndex) return nullptr;
      auto read = file_.floats(accessor, 3);
      HAPTICELL_TRY(read);
      positions = std::move(*read);
      auto triangles = trianglesOf(primitive, mode, positions.size() / 3);
      HAPTICELL_TRY(triangles);
      indices = std::move(*triangles);
    }
    const std::size_t vertices = positions.size() / 3;
    if (std::any_of(indices.begin(), indices.end(), [&](std::uint32_t i) { return i >= vertices; })) {
      return makeError(damagedFile(Text("mesh '%1'", name), Text("a vertex number beyond the last of %1", vertices),
                                   Text("numbers of vertices of the mesh")));
    }
    return indices.empty() ? nullptr : newMesh(name, positions, indices, used);
  }

  /// Lists, strips and fans (section 3.7.2.1) as a list.
  Expected<std::vector<std::uint32_t>> trianglesOf(const json& primitive, std::size_t mode, std::size_t vertices) {
    std::vector<std::uint32_t> corners;
    if (const std::size_t accessor = gltfNumber(primitive, "indices", kNoIndex); accessor != kNoIndex) {
      auto read = file_.indices(accessor);
      HAPTICELL_TRY(read);
      corners = std::move(*read);
    } else {
      for (std::size_t k = 0; k < vertices; ++k) corners.push_back(static_cast<std::uint32_t>(k));
    }
    if (mode == 4) {
      corners.resize(corners.size() / 3 * 3);
      return corners;
    }
    std::vector<std::uint32_t> triangles;
    for (std::size_t k = 2; k < corners.size(); ++k) {
      const bool odd = mode == 5 && k % 2 == 1;
      const std::uint32_t first = mode == 5 ? corners[k - 2] : corners[0], second = corners[k - 1];
      for (const std::uint32_t corner : {odd ? second : first, odd ? first : second, corners[k]}) {
        triangles.push_back(corner);
      }
    }
    return triangles;
  }

  std::vector<std::size_t> rootNodes() const {
    const json& root = file_.json();
    const json& scenes = gltfMember(root, "scenes");
    std::vector<std::size_t> roots;
    if (scenes.is_array() && !scenes.empty()) {
      const json& nodes = gltfMember(gltfElement(scenes, gltfNumber(root, "scene", 0)), "nodes");
      for (const json& index : nodes.is_array() ? nodes : json::array()) {
        if (index.is_number_unsigned()) roots.push_back(index.get<std::size_t>());
      }
      return roots;
    }
    const json& nodes = gltfMember(root, "nodes");
    std::set<std::size_t> children;
    for (const json& node : nodes.is_array() ? nodes : json::array()) {
      for (const json& child : gltfMember(node, "children")) {
        if (child.is_number_unsigned()) children.insert(child.get<std::size_t>());
      }
    }
    for (std::size_t k = 0; nodes.is_array() && k < nodes.size(); ++k) {
      if (!children.contains(k)) roots.push_back(k);
    }
    return roots;
  }

  /// Counted before one of them is made.
  Expected<void> checkNodes(const std::vector<std::size_t>& indices) const {
    const json& nodes = gltfMember(file_.json(), "nodes");
    std::vector<std::vector<std::uint32_t>> below(nodes.is_array() ? nodes.size() : 0);
    const auto known = [&](std::size_t index) { return index < below.size(); };
    for (std::size_t k = 0; k < below.size(); ++k) {
      for (const json& child : gltfMember(nodes[k], "children")) {
        if (!child.is_number_unsigned() || !known(child.get<std::size_t>())) continue;
        below[k].push_back(static_cast<std::uint32_t>(child.get<std::size_t>()));
      }
    }
    std::vector<std::uint32_t> roots;
    for (const std::size_t index : indices) {
      if (known(index)) roots.push_back(static_cast<std::uint32_t>(index));
    }
    return geometry::checkUnfolding(below, roots, {kDeepestNode + 1, kMostNodes},
                                    [](std::uint32_t node) { return Text("node %1", node); });
  }

  Expected<std::unique_ptr<aiNode>> nodeOf(std::size_t index, int depth) {
    const json& nodes = gltfMember(file_.json(), "nodes");
    const Text place("node %1", index);
    if (!nodes.is_array() || index >= nodes.size()) {
      return makeError(damagedFile(place, Text("a node that does not exist"), Text("a node of the file")));
    }
    if (depth > kDeepestNode)
      return makeError(damagedFile(place, Text("more than 500 nested levels"), Text("a tree without cycles")));
    const json& source = nodes[index];
    const std::size_t number = gltfNumber(source, "mesh", kNoIndex);
    const json& mesh = gltfElement(gltfMember(file_.json(), "meshes"), number);
    if (number != kNoIndex && number >= of_mesh_.size()) {
      return makeError(damagedFile(place, Text("mesh %1, which does not exist", number), Text("a mesh of the file")));
    }
    std::string name = gltfText(source, "name");
    if (name.empty()) name = gltfText(mesh, "name");
    if (name.empty()) name = "node_" + std::to_string(index);
    auto node = newNode(name);
    node->mTransformation = placementOf(source);
    std::vector<std::unique_ptr<aiNode>> children;
    const json& instancing = gltfMember(gltfMember(source, "extensions"), "EXT_mesh_gpu_instancing");
    if (number != kNoIndex && instancing.empty()) giveMeshes(*node, number);
    if (number != kNoIndex && !instancing.empty()) {
      if (auto put = addInstances(gltfMember(instancing, "attributes"), name, number, children); !put) {
        return makeError(put.error());
      }
    }
    for (const json& child : gltfMember(source, "children")) {
      if (!child.is_number_unsigned()) continue;
      auto below = nodeOf(child.get<std::size_t>(), depth + 1);
      HAPTICELL_TRY(below);
      children.push_back(std::move(*below));
    }
    giveChildren(*node, std::move(children));
    return node;
  }

  void giveMeshes(aiNode& node, std::size_t mesh) const {
    const std::vector<unsigned>& own = of_mesh_[mesh];
    node.mNumMeshes = static_cast<unsigned>(own.size());
    if (own.empty()) return;
    node.mMeshes = new unsigned[own.size()];
    std::copy(own.begin(), own.end(), node.mMeshes);
  }

  /// EXT_mesh_gpu_instancing: the mesh once for each element of the attributes, in the node's frame.
  Expected<void> addInstances(const json& attributes, const std::string& name, std::size_t mesh,
                              std::vector<std::unique_ptr<aiNode>>& children) {
    std::vector<float> lists[3];
    constexpr const char* kNames[] = {"TRANSLATION", "ROTATION", "SCALE"};
    const std::size_t sizes[] = {3, 4, 3};
    std::size_t count = 0;
    for (int k = 0; k < 3; ++k) {
      const std::size_t accessor = gltfNumber(attributes, kNames[k], kNoIndex);
      if (accessor == kNoIndex) continue;
      auto read = file_.floats(accessor, sizes[k]);
      HAPTICELL_TRY(read);
      lists[k] = std::move(*read);
      count = std::max(count, lists[k].size() / sizes[k]);
    }
    if ((made_ += count) > kMostNodes)
      return makeError(damagedFile(Text("node '%1'", name), Text("more than %1 instances", kMostNodes), Text("fewer")));
    for (std::size_t k = 0; k < count; ++k) {
      const auto element = [&](int list, std::vector<float> otherwise) {
        const std::size_t at = k * otherwise.size();
        if (at + otherwise.size() > lists[list].size()) return otherwise;
        const auto from = lists[list].begin() + static_cast<std::ptrdiff_t>(at);
        return std::vector<float>(from, from + static_cast<std::ptrdiff_t>(otherwise.size()));
      };
      auto node = newNode(name + " " + std::to_string(k + 1));
      node->mTransformation = placement(element(0, {0, 0, 0}), element(1, {0, 0, 0, 1}), element(2, {1, 1, 1}));
      giveMeshes(*node, mesh);
      children.push_back(std::move(node));
    }
    return {};
  }

  GltfFile& file_;
  workcell::ContentReport report_;
  std::vector<std::unique_ptr<aiMesh>> meshes_;
  std::vector<std::unique_ptr<aiMaterial>> materials_;
  std::vector<std::vector<unsigned>> of_mesh_;
  std::size_t made_ = 0;
};

}  // namespace

Expected<ModelScene> readGltf(const std::filesystem::path& file) {
  auto opened = GltfFile::open(file);
  HAPTICELL_TRY(opened);
  return GltfReader(*opened).read();
}

}  // namespace hapticell::importer
