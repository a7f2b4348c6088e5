// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::importer {

/// A glTF 2.0 file: its JSON, and the numbers behind its accessors (glTF 2.0 specification, section 3.6). All claims of
/// the file are checked against the existing bytes.
class GltfFile {
 public:
  /// Reads .gltf and .glb with their buffers: in the file itself, next to it (percent-encoded names are decoded, RFC
  /// 3986), or in a data URI. Errors are sentences without the file's name.
  static Expected<GltfFile> open(const std::filesystem::path& file);

  const nlohmann::json& json() const { return json_; }

  /// The numbers of an accessor as floats: `components` for each element. Integers are unchanged or, if the file says
  /// normalized, divided by the largest value (section 3.6.2.2). Reads sparse accessors and EXT_meshopt_compression.
  /// Errors: no such accessor, another type, more than the buffer contains.
  Expected<std::vector<float>> floats(std::size_t accessor, std::size_t components);
  /// The same for whole numbers.
  Expected<std::vector<std::uint32_t>> indices(std::size_t accessor);
  /// The bytes of a buffer view.
  Expected<std::string_view> view(std::size_t index);

 private:
  nlohmann::json json_;
  std::vector<std::string> buffers_;
  std::map<std::size_t, std::string> unpacked_;  // Views that were compressed.

  struct Layout {
    std::string_view bytes;
    std::size_t count = 0, components = 1, stride = 1;
    int kind = 0;
    bool normalized = false;
  };

  Expected<void> loadBuffers(const std::filesystem::path& file, std::string binary);
  Expected<std::string_view> compressedView(std::size_t index, const nlohmann::json& how);
  Expected<Layout> layoutOf(std::size_t index, const nlohmann::json& accessor, std::size_t components);
  Expected<std::vector<double>> numbers(std::size_t accessor, std::size_t components);
  Expected<void> putSparse(const nlohmann::json& accessor, const Layout& layout, std::vector<double>& values);
};

/// A member as a whole number >= 0, or `otherwise`.
std::size_t gltfNumber(const nlohmann::json& object, const char* key, std::size_t otherwise);
/// A member that is an object or list; an empty one if it does not exist or is of another kind.
const nlohmann::json& gltfMember(const nlohmann::json& object, const char* key);
/// An element of a list, or an empty object.
const nlohmann::json& gltfElement(const nlohmann::json& list, std::size_t index);
std::string gltfText(const nlohmann::json& object, const char* key);

}  // namespace hapticell::importer
