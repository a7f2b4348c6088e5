// SPDX-License-Identifier: Apache-2.0
#include "importer/assimp_reader.h"

#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/DefaultIOSystem.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <cctype>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <string>

#include "geometry/system/nesting_limit.h"
#include "geometry/system/regular_file.h"
#include "geometry/system/text_case.h"
#include "importer/assimp_fault.h"
#include "importer/collada_text.h"
#include "importer/gltf_file.h"
#include "importer/gltf_reader.h"
#include "importer/three_mf_reader.h"

namespace hapticell::importer {

namespace {

using workcell::ImportedScene;
using workcell::SceneNode;
using workcell::UpAxis;
using dmat4 = glm::dmat4;

class Progress : public Assimp::ProgressHandler {
 public:
  explicit Progress(ParentLink& parent) : parent_(parent) {}
  bool Update(float share) override {
    if (share >= 0.0f) parent_.progress(0.8 * static_cast<double>(share), Text("reading"));
    return true;
  }

 private:
  ParentLink& parent_;
};

/// What assimp opens by itself, files that a file names among them, is a regular file.
class RegularFiles : public Assimp::DefaultIOSystem {
 public:
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    return geometry::checkRegularFile(file) ? DefaultIOSystem::Open(file, mode) : nullptr;
  }
};

std::string formatOf(const std::filesystem::path& file, const std::string& head) {
  if (head.starts_with("glTF")) return "gltf";
  if (head.find("<COLLADA") != std::string::npos) return "dae";
  const std::string extension = lowerExtension(file);
  if (extension == ".glb") return "gltf";
  return extension.empty() ? "unknown" : extension.substr(1);
}

/// glTF 1.0, which assimp reads.
bool isFirstGltf(const std::filesystem::path& file, const std::string& head) {
  if (head.starts_with("glTF")) return head.size() > 4 && head[4] == 1;
  const auto text = geometry::readRegularFile(file);
  if (!text || !geometry::checkNesting(*text, geometry::NestedText::kJson, "")) return false;
  const auto json = nlohmann::json::parse(*text, nullptr, false);
  return gltfText(gltfMember(json, "asset"), "version").starts_with("1");
}

// Bytes looked at for a format's first words, as kHead of workcell/files/claimed_content.cpp.
constexpr std::size_t kAssimpHead = 65536;

/// What the numbers of assimp's scene mean.
struct Convention {
  double metres_per_unit = 1.0;  ///< Of the file.
  double metres_in_scene = 1.0;  ///< Of the numbers as assimp hands them out.
  bool unit_is_stated = true;
  UpAxis up = UpAxis::kY;
};

Convention fbxConvention(const aiScene& scene) {
  double centimetres = 1.0;
  int up = 1;
  if (scene.mMetaData) {
    float narrow = 1.0f;
    if (scene.mMetaData->Get("UnitScaleFactor", narrow)) centimetres = static_cast<double>(narrow);
    scene.mMetaData->Get("UnitScaleFactor", centimetres);
    scene.mMetaData->Get("UpAxis", up);
  }
  Convention convention;
  convention.metres_per_unit = convention.metres_in_scene = 0.01 * centimetres;
  convention.up = UpAxis::kY;
  if (up == 0) convention.up = UpAxis::kX;
  if (up == 2) convention.up = UpAxis::kZ;
  return convention;
}

dmat4 toMatrix(const aiMatrix4x4& m) {
  dmat4 result(1.0);
  for (unsigned row = 0; row < 4; ++row) {
    for (unsigned column = 0; column < 4; ++column) {
      result[static_cast<int>(column)][static_cast<int>(row)] = static_cast<double>(m[row][column]);
    }
  }
  return result;
}

bool isFinite(const dmat4& m) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(m[column][row]) || std::abs(m[column][row]) > 1e9) return false;
    }
  }
  return true;
}

/// The rigid part of a node's matrix; what is left (scale, shear, mirror) is for its meshes.
Pose rigidPart(const dmat4& m) {
  Pose X;
  X.p = dvec3(m[3]);
  dvec3 x(m[0]), y(m[1]);
  const auto usable = [](const dvec3& v) { return glm::dot(v, v) > 1e-24; };
  if (!usable(x) || !usable(glm::cross(x, y))) return X;
  x = glm::normalize(x);
  const dvec3 z = glm::normalize(glm::cross(x, y));
  X.q = glm::normalize(glm::quat_cast(dmat3(x, glm::cross(z, x), z)));
  return X;
}

/// glTF's colours are linear, a screen's are not (IEC 61966-2-1).
float displayed(float linear) {
  const float c = std::clamp(linear, 0.0f, 1.0f);
  return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1.0f / 2.4f) - 0.055f;
}

class AssimpSceneBuilder {
 public:
  AssimpSceneBuilder(const aiScene& source, const Reading& reading, const std::string& format,
                     const Convention& convention)
      : source_(source), reading_(reading) {
    scene_.format = format;
    scene_.unit_is_stated = convention.unit_is_stated;
    scene_.metres_per_unit = reading.metres_per_unit.value_or(convention.metres_per_unit);
    scene_.up_axis = convention.up;
    scale_ = convention.metres_in_scene * scene_.metres_per_unit / convention.metres_per_unit;
  }

  ImportedScene build() {
    add(*source_.mRootNode, dmat4(1.0), Pose::identity(), -1, 0);
    if (dropped_ > 0) {
      scene_.warnings.push_back(Text("%1 triangles with an invalid corner were removed", dropped_));
    }
    if (too_deep_) scene_.warnings.push_back(Text("nodes below the 500th level were left out"));
    return std::move(scene_);
  }

 private:
  struct KnownMesh {
    unsigned source;
    dmat3 form;
    int index;
  };

  void add(const aiNode& source, const dmat4& M_FP, const Pose& X_FP, int parent, int depth) {
    // Levels of nodes: guards the stack; trees are far flatter (reliability.md tests deep ones). Half, twice: no effect
    // on real files.
    constexpr int kDeepest = 500;
    too_deep_ = too_deep_ || depth > kDeepest;
    if (depth > kDeepest) return;
    dmat4 M_FN = M_FP * toMatrix(source.mTransformation);
    if (!isFinite(M_FN)) {
      scene_.warnings.push_back(
          Text("'%1' has an invalid placement; it is placed at its parent", source.mName.C_Str()));
      M_FN = M_FP;
    }
    const Pose X_FN = rigidPart(M_FN);
    const dmat3 form = glm::transpose(X_FN.R()) * dmat3(M_FN) * scale_;
    SceneNode node;
    node.name = parent < 0 ? reading_.file.stem().string() : "node";
    if (source.mName.length > 0) node.name = source.mName.C_Str();
    node.parent = parent;
    node.X_PN = X_FP.inverse() * X_FN;
    node.X_PN.p *= scale_;
    const auto index = static_cast<int>(scene_.nodes.size());
    if (source.mNumMeshes == 1) giveMesh(source.mMeshes[0], form, node);
    scene_.nodes.push_back(node);
    for (unsigned k = 0; source.mNumMeshes > 1 && k < source.mNumMeshes; ++k) {
      const aiString& name = source_.mMeshes[source.mMeshes[k]]->mName;
      SceneNode part;
      part.name = name.length > 0 ? name.C_Str() : node.name + " " + std::to_string(k + 1);
      part.parent = index;
      giveMesh(source.mMeshes[k], form, part);
      scene_.nodes.push_back(std::move(part));
    }
    for (unsigned k = 0; k < source.mNumChildren; ++k) add(*source.mChildren[k], M_FN, X_FN, index, depth + 1);
  }

  void giveMesh(unsigned source, const dmat3& form, SceneNode& node) {
    node.color = colorOf(*source_.mMeshes[source]);
    for (const KnownMesh& known : known_) {
      if (known.source != source || !sameForm(known.form, form)) continue;
      node.mesh = known.index;
      return;
    }
    geometry::TriangleMesh mesh = meshOf(*source_.mMeshes[source], form);
    if (!mesh.triangles.empty()) {
      node.mesh = static_cast<int>(scene_.meshes.size());
      scene_.meshes.push_back(std::move(mesh));
    }
    known_.push_back({source, form, node.mesh});
  }

  static bool sameForm(const dmat3& a, const dmat3& b) {
    double difference = 0.0, size = 0.0;
    for (int column = 0; column < 3; ++column) {
      difference += glm::dot(a[column] - b[column], a[column] - b[column]);
      size += glm::dot(a[column], a[column]);
    }
    return difference <= 1e-12 * size;  // A millionth: matrices in files are single precision.
  }

  geometry::TriangleMesh meshOf(const aiMesh& source, const dmat3& form) {
    geometry::TriangleMesh mesh;
    mesh.vertices.reserve(source.mNumVertices);
    std::vector<bool> sound(source.mNumVertices);
    for (unsigned k = 0; k < source.mNumVertices; ++k) {
      const aiVector3D& v = source.mVertices[k];
      const dvec3 p = form * dvec3(v.x, v.y, v.z);
      sound[k] = std::isfinite(p.x + p.y + p.z) && std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < 1e12;
      mesh.vertices.push_back(sound[k] ? p : dvec3(0.0));
    }
    const bool mirrored = glm::determinant(form) < 0.0;
    for (unsigned k = 0; k < source.mNumFaces; ++k) {
      const aiFace& face = source.mFaces[k];
      if (face.mNumIndices != 3) continue;
      geometry::Triangle t{face.mIndices[0], face.mIndices[1], face.mIndices[2]};
      const bool good = std::all_of(t.begin(), t.end(), [&](std::uint32_t i) { return i < sound.size() && sound[i]; });
      dropped_ += good ? 0 : 1;
      if (mirrored) std::swap(t[1], t[2]);
      if (good) mesh.triangles.push_back(t);
    }
    return mesh;
  }

  std::optional<std::array<float, 3>> colorOf(const aiMesh& mesh) const {
    if (mesh.mMaterialIndex >= source_.mNumMaterials) return std::nullopt;
    const aiMaterial& material = *source_.mMaterials[mesh.mMaterialIndex];
    aiColor4D color;
    const bool gltf = scene_.format == "gltf";
    if (material.Get(AI_MATKEY_BASE_COLOR, color) != AI_SUCCESS &&
        material.Get(AI_MATKEY_COLOR_DIFFUSE, color) != AI_SUCCESS) {
      return std::nullopt;
    }
    std::array<float, 3> parts{color.r, color.g, color.b};
    for (float& part : parts) {
      if (!std::isfinite(part)) return std::nullopt;
      part = gltf ? displayed(part) : std::clamp(part, 0.0f, 1.0f);
    }
    return parts;
  }

  const aiScene& source_;
  const Reading& reading_;
  ImportedScene scene_;
  double scale_ = 1.0;
  std::vector<KnownMesh> known_;
  std::uint64_t dropped_ = 0;
  bool too_deep_ = false;
};

/// assimp with what all formats need set; the importer owns the scene.
const aiScene* load(Assimp::Importer& importer, const Reading& reading, const std::string& collada,
                    ParentLink& parent) {
  importer.SetProgressHandler(new Progress(parent));  // The importer deletes both.
  importer.SetIOHandler(new RegularFiles);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_CAMERAS, false);  // Two of one name, and assimp refuses all.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_LIGHTS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);  // It would invent one for an empty file.
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                              aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS |
                                  aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
                                  aiComponent_TEXTURES | aiComponent_LIGHTS | aiComponent_CAMERAS);
  constexpr unsigned kSteps =
      aiProcess_ValidateDataStructure | aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_SortByPType;
  const auto read = [&](unsigned steps) {
    if (collada.empty()) return importer.ReadFile(reading.file.string(), steps);
    return importer.ReadFileFromMemory(collada.data(), collada.size(), steps, "dae");
  };
  const aiScene* const scene = read(kSteps);
  const std::string complaint = scene ? "" : importer.GetErrorString();
  const bool plays_no_part = complaint.find("aiScene::mCameras") != std::string::npos ||
                             complaint.find("aiScene::mLights") != std::string::npos;
  return plays_no_part ? read(kSteps & ~static_cast<unsigned>(aiProcess_ValidateDataStructure)) : scene;
}

ImportedScene built(const aiScene& source, const Reading& reading, const std::string& format,
                    const Convention& convention, const std::vector<Text>& warnings) {
  ImportedScene scene = AssimpSceneBuilder(source, reading, format, convention).build();
  scene.warnings.insert(scene.warnings.begin(), warnings.begin(), warnings.end());
  return scene;
}

Expected<ImportedScene> readOwnGltf(const Reading& reading, const std::string& head) {
  const auto model = readGltf(reading.file);
  if (model) return built(*model->scene, reading, "gltf", {}, model->warnings);
  Error error = model.error();
  if (head.starts_with("glTF")) {  // A file that is cut off says so, whatever was missed first.
    if (auto cut_off = binaryGltfFault(reading.file, head)) error = *cut_off;
  }
  return makeError(std::move(error));
}

Expected<ImportedScene> readOwnThreeMf(const Reading& reading) {
  const auto read = readThreeMf(reading.file);
  HAPTICELL_TRY(read);
  Convention convention;
  convention.metres_per_unit = convention.metres_in_scene = read->metres_per_unit;
  convention.up = UpAxis::kZ;
  return built(*read->model.scene, reading, "3mf", convention, read->model.warnings);
}

}  // namespace

Expected<ImportedScene> readWithAssimp(const Reading& reading, ParentLink& parent) {
  const std::string head = geometry::headOfFile(reading.file, kAssimpHead), format = formatOf(reading.file, head);
  if (format == "gltf" && !isFirstGltf(reading.file, head)) return readOwnGltf(reading, head);
  if (format == "3mf") return readOwnThreeMf(reading);
  ColladaText collada;
  if (format == "dae") {
    auto text = readColladaText(reading.file);
    HAPTICELL_TRY(text);
    collada = std::move(*text);
  }
  Assimp::Importer importer;
  const aiScene* scene = load(importer, reading, collada.text, parent);
  if (!scene || !scene->mRootNode) return makeError(assimpFault(reading.file, head, importer.GetErrorString()));
  Convention convention;
  if (format == "fbx") convention = fbxConvention(*scene);
  if (format == "3ds") convention.unit_is_stated = false;
  if (format == "dae") {  // assimp has scaled the root node to metres.
    convention.metres_per_unit = collada.metres_per_unit;
    convention.unit_is_stated = collada.unit_is_stated;
    convention.up = collada.up;
  }
  return built(*scene, reading, format, convention, collada.warnings);
}

}  // namespace hapticell::importer
