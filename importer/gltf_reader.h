// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <assimp/scene.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::importer {

/// The content of a file in assimp's structures, made by our own reader.
struct ModelScene {
  std::unique_ptr<aiScene> scene;
  std::vector<Text> warnings;
};

/// Reads the nodes, triangles and base colours of a glTF 2.0 file, .gltf or .glb; checks first what it requires
/// (extensionsRequired). Reads quantised and compressed meshes (KHR_mesh_quantization, EXT_meshopt_compression,
/// KHR_draco_mesh_compression) and instances (EXT_mesh_gpu_instancing); docs/user/formats.md lists the rest. Errors:
/// see GltfFile::open(); a required extension that is not supported, by its name; a cycle of nodes.
Expected<ModelScene> readGltf(const std::filesystem::path& file);

/// Helper functions for readers that make such scenes.
std::unique_ptr<aiNode> newNode(const std::string& name);
/// Gives children to a node; it owns them.
void giveChildren(aiNode& node, std::vector<std::unique_ptr<aiNode>> children);
/// A triangle mesh; indices must be within the vertices.
std::unique_ptr<aiMesh> newMesh(const std::string& name, const std::vector<float>& positions,
                                const std::vector<std::uint32_t>& triangles, unsigned material);
std::unique_ptr<aiMaterial> newMaterial(const aiColor4D& color);
/// Passes the lists to the scene, which then owns them.
void fillScene(aiScene& scene, std::unique_ptr<aiNode> root, std::vector<std::unique_ptr<aiMesh>> meshes,
               std::vector<std::unique_ptr<aiMaterial>> materials);

}  // namespace hapticell::importer
