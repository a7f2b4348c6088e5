// SPDX-License-Identifier: Apache-2.0
#include "importer/gltf_file.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "geometry/system/nesting_limit.h"
#include "importer/damaged_file.h"
#include "workcell/text/file_content.h"
#include "workcell/text/package_path.h"

namespace hapticell::importer {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
// Guards memory. Half, twice: other files are refused with a message.
constexpr std::size_t kMostElements = 200'000'000;
/// That a sparse accessor starts from: guards memory, as no byte of the file holds them. Half, twice: other files are
/// refused with a message.
constexpr std::size_t kMostZeros = 1'000'000;

Error fault(Text place, Text found, Text expected = Text("the content of a glTF file")) {
  return damagedFile(std::move(place), std::move(found), std::move(expected));
}

std::uint32_t word(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = (value << 8) | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

/// JSON and binary chunk of a .glb (section 4.4); a .gltf is all JSON.
Expected<std::pair<std::string_view, std::string_view>> chunksOf(std::string_view content) {
  if (!content.starts_with("glTF")) return std::pair(content, std::string_view());
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
  std::string_view json, binary;
  std::size_t at = kHeader;
  while (at + kChunkHeader <= content.size()) {
    const std::size_t length = word(content, at);
    const std::uint32_t kind = word(content, at + 4);
    at += kChunkHeader;
    if (length > content.size() - at)
      return makeError(fault(Text("chunk"), Text("a length beyond the end of the file")));
    if (kind == 0x4E4F534A && json.empty()) json = content.substr(at, length);
    if (kind == 0x004E4942 && binary.empty()) binary = content.substr(at, length);
    at += length + (4 - length % 4) % 4;
  }
  return std::pair(json, binary);
}

/// 0 to 63 for a sign of base 64, its variant for addresses too; -1 for any other.
int valueOfBase64(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  return c == '/' || c == '_' ? 63 : -1;
}

std::string decodedBase64(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int value = valueOfBase64(c);
    if (value < 0) continue;
    bits = (bits << 6) | static_cast<std::uint32_t>(value);
    if ((count += 6) >= 8) bytes += static_cast<char>((bits >> (count -= 8)) & 0xffu);
  }
  return bytes;
}

std::size_t bytesOf(int kind) {
  switch (kind) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case 5125:
    case 5126:
      return 4;
    default:
      return 0;
  }
}

std::size_t componentsOf(const std::string& type) {
  static const std::map<std::string, std::size_t> kTypes = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  const auto found = kTypes.find(type);
  return found == kTypes.end() ? 0 : found->second;
}

template <typename Number>
double numberAt(const char* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return static_cast<double>(number);
}

double valueAt(const char* bytes, int kind, bool normalized) {
  switch (kind) {
    case 5120:
      return normalized ? std::max(numberAt<std::int8_t>(bytes) / 127.0, -1.0) : numberAt<std::int8_t>(bytes);
    case 5121:
      return numberAt<std::uint8_t>(bytes) / (normalized ? 255.0 : 1.0);
    case 5122:
      return normalized ? std::max(numberAt<std::int16_t>(bytes) / 32767.0, -1.0) : numberAt<std::int16_t>(bytes);
    case 5123:
      return numberAt<std::uint16_t>(bytes) / (normalized ? 65535.0 : 1.0);
    case 5125:
      return numberAt<std::uint32_t>(bytes);
    default:
      return numberAt<float>(bytes);
  }
}

}  // namespace

const Json& gltfMember(const Json& object, const char* key) {
  static const Json kEmpty = Json::object();
  if (!object.is_object()) return kEmpty;
  const auto found = object.find(key);
  return found == object.end() || !found->is_structured() ? kEmpty : *found;
}

const Json& gltfElement(const Json& list, std::size_t index) {
  static const Json kEmpty = Json::object();
  return list.is_array() && index < list.size() ? list[index] : kEmpty;
}

std::size_t gltfNumber(const Json& object, const char* key, std::size_t otherwise) {
  if (!object.is_object()) return otherwise;
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return otherwise;
  const double number = found->get<double>();
  return number >= 0.0 && number < 9e15 ? static_cast<std::size_t>(number) : otherwise;
}

std::string gltfText(const Json& object, const char* key) {
  if (!object.is_object()) return {};
  const auto found = object.find(key);
  return found == object.end() || !found->is_string() ? std::string() : found->get<std::string>();
}

Expected<GltfFile> GltfFile::open(const fs::path& file) {
  const auto content = workcell::readFileContent(file);
  HAPTICELL_TRY(content);
  const auto chunks = chunksOf(*content);
  HAPTICELL_TRY(chunks);
  GltfFile result;
  const std::string_view text = chunks->first;
  HAPTICELL_TRY(geometry::checkNesting(text, geometry::NestedText::kJson, ""));
  try {
    result.json_ = Json::parse(text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text);
  } catch (const Json::parse_error& problem) {
    return makeError(fault(Text("JSON content, byte %1", problem.byte), Text("text that is not JSON")));
  } catch (const Json::exception&) {
    return makeError(fault(Text("JSON content"), Text("a number that is too large")));
  }
  if (!result.json_.is_object()) return makeError(fault("", Text("not a JSON object")));
  HAPTICELL_TRY(result.loadBuffers(file, std::string(chunks->second)));
  return result;
}

Expected<void> GltfFile::loadBuffers(const fs::path& file, std::string binary) {
  const Json& list = gltfMember(json_, "buffers");
  for (std::size_t k = 0; list.is_array() && k < list.size(); ++k) {
    const Text place("buffer %1", k);
    const std::string uri = gltfText(list[k], "uri");
    const std::size_t length = gltfNumber(list[k], "byteLength", 0);
    std::string bytes;
    if (uri.empty()) {
      if (k == 0) bytes = std::move(binary);  // Further ones without a URI are for EXT_meshopt_compression to fill.
    } else if (uri.starts_with("data:")) {
      const std::size_t comma = uri.find(',');
      if (comma == std::string::npos) return makeError(fault(place, Text("a data URI without data")));
      bytes = decodedBase64(std::string_view(uri).substr(comma + 1));
    } else {
      fs::path path = file.parent_path() / uri;
      std::error_code ignored;
      if (!fs::exists(path, ignored)) path = file.parent_path() / workcell::percentDecoded(uri);
      auto content = workcell::readFileContent(path);
      if (!content) {
        return makeError({.place = place,
                          .found = Text("file %1: %2", uri.substr(0, 100), content.error().found),
                          .expected = "a file in the same folder",
                          .fix = "Copy the file to this folder. A .gltf needs its .bin files."});
      }
      bytes = std::move(*content);
    }
    if (!bytes.empty() && bytes.size() < length) {
      return makeError(fault(place, Text("%1 bytes", bytes.size()), Text("%1 bytes", length)));
    }
    buffers_.push_back(std::move(bytes));
  }
  return {};
}

Expected<std::string_view> GltfFile::view(std::size_t index) {
  const Json& view = gltfElement(gltfMember(json_, "bufferViews"), index);
  const Text place("buffer view %1", index);
  const Json& compressed = gltfMember(gltfMember(view, "extensions"), "EXT_meshopt_compression");
  if (!compressed.empty()) return compressedView(index, compressed);
  const std::size_t buffer = gltfNumber(view, "buffer", kNone), offset = gltfNumber(view, "byteOffset", 0);
  const std::size_t length = gltfNumber(view, "byteLength", kNone);
  if (buffer >= buffers_.size()) return makeError(fault(place, Text("it or its buffer does not exist")));
  const std::string_view bytes = buffers_[buffer];
  if (offset > bytes.size() || length > bytes.size() - offset) {
    return makeError(fault(place, Text("more bytes than its buffer has")));
  }
  return bytes.substr(offset, length);
}

Expected<std::string_view> GltfFile::compressedView(std::size_t index, const Json& how) {
  if (const auto known = unpacked_.find(index); known != unpacked_.end()) return std::string_view(known->second);
  const Text place("buffer view %1", index);
  const std::size_t buffer = gltfNumber(how, "buffer", kNone), offset = gltfNumber(how, "byteOffset", 0);
  const std::size_t length = gltfNumber(how, "byteLength", kNone), stride = gltfNumber(how, "byteStride", 0);
  const std::size_t count = gltfNumber(how, "count", kNone);
  const bool there =
      buffer < buffers_.size() && offset <= buffers_[buffer].size() && length <= buffers_[buffer].size() - offset;
  // A packed block of 256 elements has at least a header of four bytes for each of their bytes.
  // A packed block of 256 elements has at least a header of four bytes for each of their bytes: 64 fold, and 64 KB for
  // short ones. Follows from the format; half: sound ones are refused; twice: more memory for broken ones.
  constexpr std::size_t kPackedFold = 64, kAlways = 65536;
  if (!there || stride == 0 || stride > 256 || count > kMostElements ||
      count * stride > kPackedFold * length + kAlways) {
    return makeError(fault(place, Text("more bytes than its buffer has")));
  }
  const auto* const source = reinterpret_cast<const unsigned char*>(buffers_[buffer].data() + offset);
  std::string bytes(count * stride, '\0');
  const std::string mode = gltfText(how, "mode"), filter = gltfText(how, "filter");
  int status = -1;
  if (mode == "ATTRIBUTES" && stride % 4 == 0) {
    status = meshopt_decodeVertexBuffer(bytes.data(), count, stride, source, length);
  } else if (mode == "TRIANGLES" && (stride == 2 || stride == 4) && count % 3 == 0) {
    status = meshopt_decodeIndexBuffer(bytes.data(), count, stride, source, length);
  } else if (mode == "INDICES" && (stride == 2 || stride == 4)) {
    status = meshopt_decodeIndexSequence(bytes.data(), count, stride, source, length);
  }
  if (status != 0) return makeError(fault(place, Text("data of EXT_meshopt_compression that cannot be decompressed")));
  if (filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes.data(), count, stride);
  if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) meshopt_decodeFilterOct(bytes.data(), count, stride);
  if (filter == "QUATERNION" && stride == 8) meshopt_decodeFilterQuat(bytes.data(), count, stride);
  return std::string_view(unpacked_[index] = std::move(bytes));
}

Expected<GltfFile::Layout> GltfFile::layoutOf(std::size_t index, const Json& accessor, std::size_t components) {
  const Text place("accessor %1", index);
  Layout layout;
  layout.kind = static_cast<int>(gltfNumber(accessor, "componentType", 0));
  layout.count = gltfNumber(accessor, "count", kNone);
  layout.components = componentsOf(gltfText(accessor, "type"));
  const auto normalized = accessor.is_object() ? accessor.find("normalized") : accessor.end();
  layout.normalized = normalized != accessor.end() && normalized->is_boolean() && normalized->get<bool>();
  const std::size_t size = bytesOf(layout.kind) * layout.components;
  if (size == 0 || layout.components != components || layout.count > kMostElements) {
    return makeError(fault(place, Text("the type is wrong or missing")));
  }
  layout.stride = size;
  const std::size_t number = gltfNumber(accessor, "bufferView", kNone);
  if (number == kNone) {  // Zeros, for a sparse one to fill.
    const bool sparse = !gltfMember(accessor, "sparse").empty();
    if (!sparse && layout.count > 0) return makeError(fault(place, Text("the data is missing")));
    if (layout.count > kMostZeros)
      return makeError(fault(place, Text("%1 elements without data", layout.count), Text("fewer than a million")));
    return layout;
  }
  const auto bytes = view(number);
  HAPTICELL_TRY(bytes);
  const Json& own_view = gltfElement(gltfMember(json_, "bufferViews"), number);
  layout.stride = gltfNumber(own_view, "byteStride", size);
  const Json& compressed = gltfMember(gltfMember(own_view, "extensions"), "EXT_meshopt_compression");
  if (!compressed.empty()) layout.stride = gltfNumber(compressed, "byteStride", size);
  const std::size_t offset = gltfNumber(accessor, "byteOffset", 0);
  const std::size_t needed = layout.count == 0 ? 0 : (layout.count - 1) * layout.stride + size;
  if (layout.stride < size || layout.stride > 4096 || offset > bytes->size() || needed > bytes->size() - offset) {
    return makeError(fault(place, Text("%1 elements, more than its buffer view has", layout.count)));
  }
  layout.bytes = bytes->substr(offset);
  return layout;
}

Expected<std::vector<double>> GltfFile::numbers(std::size_t index, std::size_t components) {
  const Json& accessor = gltfElement(gltfMember(json_, "accessors"), index);
  const auto layout = layoutOf(index, accessor, components);
  HAPTICELL_TRY(layout);
  std::vector<double> values(layout->count * components, 0.0);
  const std::size_t size = bytesOf(layout->kind);
  for (std::size_t k = 0; !layout->bytes.empty() && k < layout->count; ++k) {
    const char* const element = layout->bytes.data() + k * layout->stride;
    for (std::size_t c = 0; c < components; ++c) {
      values[k * components + c] = valueAt(element + c * size, layout->kind, layout->normalized);
    }
  }
  HAPTICELL_TRY(putSparse(accessor, *layout, values));
  return values;
}

Expected<void> GltfFile::putSparse(const Json& accessor, const Layout& layout, std::vector<double>& values) {
  const Json& sparse = gltfMember(accessor, "sparse");
  if (sparse.empty()) return {};
  const Json& places = gltfMember(sparse, "indices");
  const Json& replaced = gltfMember(sparse, "values");
  const std::size_t count = gltfNumber(sparse, "count", 0), offset = gltfNumber(places, "byteOffset", 0);
  const std::size_t value_offset = gltfNumber(replaced, "byteOffset", 0), size = bytesOf(layout.kind);
  const int kind = static_cast<int>(gltfNumber(places, "componentType", 0));
  const auto where = view(gltfNumber(places, "bufferView", kNone)),
             what = view(gltfNumber(replaced, "bufferView", kNone));
  if (!where || !what) return makeError(where ? what.error() : where.error());
  const std::size_t element = size * layout.components;
  if (bytesOf(kind) == 0 || kind == 5126 || count > kMostElements || offset > where->size() ||
      count * bytesOf(kind) > where->size() - offset || value_offset > what->size() ||
      count * element > what->size() - value_offset) {
    return makeError(fault(Text("sparse accessor"), Text("more elements than its buffer views have")));
  }
  for (std::size_t k = 0; k < count; ++k) {
    const auto at = static_cast<std::size_t>(valueAt(where->data() + offset + k * bytesOf(kind), kind, false));
    if (at >= layout.count)
      return makeError(fault(Text("sparse accessor"), Text("the number of an element that does not exist")));
    for (std::size_t c = 0; c < layout.components; ++c) {
      values[at * layout.components + c] =
          valueAt(what->data() + value_offset + k * element + c * size, layout.kind, layout.normalized);
    }
  }
  return {};
}

Expected<std::vector<float>> GltfFile::floats(std::size_t accessor, std::size_t components) {
  const auto values = numbers(accessor, components);
  HAPTICELL_TRY(values);
  return std::vector<float>(values->begin(), values->end());
}

Expected<std::vector<std::uint32_t>> GltfFile::indices(std::size_t accessor) {
  const auto values = numbers(accessor, 1);
  HAPTICELL_TRY(values);
  std::vector<std::uint32_t> result;
  result.reserve(values->size());
  for (const double value : *values) {
    result.push_back(value >= 0.0 && value < 4294967295.0 ? static_cast<std::uint32_t>(value) : 0xffffffffu);
  }
  return result;
}

}  // namespace hapticell::importer
