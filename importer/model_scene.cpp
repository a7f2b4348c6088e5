// SPDX-License-Identifier: Apache-2.0
// The makers of assimp's structures, which own plain arrays.
#include <assimp/material.h>

#include <algorithm>

#include "importer/gltf_reader.h"

namespace hapticell::importer {

namespace {

template <typename Thing>
Thing** handOver(std::vector<std::unique_ptr<Thing>>& things) {
  if (things.empty()) return nullptr;
  auto** const list = new Thing*[things.size()];
  for (std::size_t k = 0; k < things.size(); ++k) list[k] = things[k].release();
  return list;
}

}  // namespace

std::unique_ptr<aiNode> newNode(const std::string& name) {
  auto node = std::make_unique<aiNode>();
  constexpr std::size_t kLongest = 1000;
  std::string text = name.substr(0, kLongest);
  while (name.size() > kLongest && !text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0u) == 0x80u) {
    text.pop_back();
  }
  node->mName.Set(text);
  return node;
}

void giveChildren(aiNode& node, std::vector<std::unique_ptr<aiNode>> children) {
  for (const auto& child : children) child->mParent = &node;
  node.mNumChildren = static_cast<unsigned>(children.size());
  node.mChildren = handOver(children);
}

std::unique_ptr<aiMesh> newMesh(const std::string& name, const std::vector<float>& positions,
                                const std::vector<std::uint32_t>& triangles, unsigned material) {
  auto mesh = std::make_unique<aiMesh>();
  mesh->mName.Set(name.substr(0, 1000));
  mesh->mMaterialIndex = material;
  mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  mesh->mNumVertices = static_cast<unsigned>(positions.size() / 3);
  mesh->mVertices = new aiVector3D[std::max<std::size_t>(mesh->mNumVertices, 1)];
  for (unsigned k = 0; k < mesh->mNumVertices; ++k) {
    mesh->mVertices[k] = {positions[3 * k], positions[3 * k + 1], positions[3 * k + 2]};
  }
  mesh->mNumFaces = static_cast<unsigned>(triangles.size() / 3);
  mesh->mFaces = new aiFace[std::max<std::size_t>(mesh->mNumFaces, 1)];
  for (unsigned k = 0; k < mesh->mNumFaces; ++k) {
    mesh->mFaces[k].mNumIndices = 3;
    mesh->mFaces[k].mIndices = new unsigned[3]{triangles[3 * k], triangles[3 * k + 1], triangles[3 * k + 2]};
  }
  return mesh;
}

std::unique_ptr<aiMaterial> newMaterial(const aiColor4D& color) {
  auto material = std::make_unique<aiMaterial>();
  material->AddProperty(&color, 1, AI_MATKEY_BASE_COLOR);
  return material;
}

void fillScene(aiScene& scene, std::unique_ptr<aiNode> root, std::vector<std::unique_ptr<aiMesh>> meshes,
               std::vector<std::unique_ptr<aiMaterial>> materials) {
  scene.mRootNode = root.release();
  scene.mNumMeshes = static_cast<unsigned>(meshes.size());
  scene.mMeshes = handOver(meshes);
  scene.mNumMaterials = static_cast<unsigned>(materials.size());
  scene.mMaterials = handOver(materials);
}

}  // namespace hapticell::importer
