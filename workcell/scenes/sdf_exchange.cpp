// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/sdf_exchange.h"

#include <utility>

#include "workcell/scenes/packed_bytes.h"

namespace hapticell::workcell {

namespace {

constexpr std::string_view kSdfMagic("HCSDF\0\0\1", 8);
// Models within models: guards the stack. As many as elements may be nested (parseSdf()). Half, twice: no effect on
// real files.
constexpr int kDeepestModels = 200;

/// Writes what the functions below pass to it.
class Saver {
 public:
  template <typename T>
  void operator()(const T& value) {
    writer.number(value);
  }
  void operator()(const std::string& text) { writer.text(text); }
  void operator()(const Pose& X) { writer.pose(X); }
  template <typename T, typename Pass>
  void list(const std::vector<T>& values, const Pass& pass) {
    writer.number(std::uint64_t{values.size()});
    for (const T& value : values) pass(value);
  }
  template <typename T, typename Pass>
  void maybe(const std::optional<T>& value, const Pass& pass) {
    writer.number(std::uint8_t{value.has_value()});
    if (value) pass(*value);
  }
  template <typename T>
  void choice(const T& value, T) {
    writer.number(static_cast<std::uint8_t>(value));
  }
  bool enter() { return true; }
  void leave() {}

  PackedWriter writer;
};

/// Reads the same from bytes of any kind.
class Loader {
 public:
  explicit Loader(std::string_view bytes) : reader(bytes) {}

  template <typename T>
  void operator()(T& value) {
    value = reader.anyNumber<T>();
  }
  void operator()(bool& value) { value = reader.anyNumber<std::uint8_t>() != 0; }
  void operator()(std::string& text) { text = reader.text(); }
  void operator()(Pose& X) { X = reader.anyPose(); }
  template <typename T, typename Pass>
  void list(std::vector<T>& values, const Pass& pass) {
    for (std::size_t k = reader.count(1); k > 0 && !reader.failed; --k) {
      values.emplace_back();
      pass(values.back());
    }
  }
  template <typename T, typename Pass>
  void maybe(std::optional<T>& value, const Pass& pass) {
    if (reader.anyNumber<std::uint8_t>() != 0 && !reader.failed) pass(value.emplace());
  }
  template <typename T>
  void choice(T& value, T last) {
    const auto number = reader.anyNumber<std::uint8_t>();
    if (reader.require(number <= static_cast<std::uint8_t>(last))) value = static_cast<T>(number);
  }
  bool enter() { return reader.require(++depth_ <= kDeepestModels); }
  void leave() { --depth_; }

  PackedReader reader;

 private:
  int depth_ = 0;
};

template <typename Stream, typename Vector>
void passVector(Stream& stream, Vector& v) {
  stream(v.x);
  stream(v.y);
  stream(v.z);
}

template <typename Stream, typename Placed>
void passPose(Stream& stream, Placed& pose) {
  stream(pose.X);
  stream(pose.fault);
}

template <typename Stream, typename Color>
void passColor(Stream& stream, Color& color) {
  stream.maybe(color, [&](auto& parts) {
    for (auto& part : parts) stream(part);
  });
}

template <typename Stream, typename Shape>
void passShape(Stream& stream, Shape& shape) {
  stream(shape.name);
  passPose(stream, shape.X_LS);
  stream.choice(shape.kind, SdfShape::Kind::kEllipsoid);
  passVector(stream, shape.size);
  stream(shape.uri);
  stream(shape.submesh);
  stream(shape.center_submesh);
  passColor(stream, shape.diffuse);
  passColor(stream, shape.ambient);
}

template <typename Stream, typename Link>
void passLink(Stream& stream, Link& link) {
  stream(link.name);
  passPose(stream, link.X_ML);
  const auto pass = [&](auto& shape) { passShape(stream, shape); };
  stream.list(link.visuals, pass);
  stream.list(link.collisions, pass);
}

template <typename Stream, typename Axis>
void passAxis(Stream& stream, Axis& axis) {
  passVector(stream, axis.xyz_M);
  stream(axis.fault);
  stream(axis.lower);
  stream(axis.upper);
  stream(axis.velocity);
  stream.maybe(axis.mimic, [&](auto& mimic) {
    stream(mimic.joint);
    stream(mimic.second_axis);
    stream(mimic.multiplier);
    stream(mimic.offset);
    stream(mimic.reference);
  });
}

template <typename Stream, typename Joint>
void passJoint(Stream& stream, Joint& joint) {
  stream(joint.name);
  stream.choice(joint.type, SdfJoint::Type::kGearbox);
  stream(joint.parent);
  stream(joint.child);
  stream(joint.parent_fault);
  stream(joint.child_fault);
  passPose(stream, joint.X_MJ);
  stream.list(joint.axes, [&](auto& place) { stream.maybe(place, [&](auto& axis) { passAxis(stream, axis); }); });
  stream(joint.pitch);
}

template <typename Stream, typename Model>
void passModel(Stream& stream, Model& model) {
  if (!stream.enter()) return;
  stream(model.name);
  passPose(stream, model.X_P);
  passPose(stream, model.X_M);
  stream.list(model.links, [&](auto& link) { passLink(stream, link); });
  stream.list(model.joints, [&](auto& joint) { passJoint(stream, joint); });
  stream.list(model.models, [&](auto& inside) { passModel(stream, inside); });
  stream.leave();
}

template <typename Stream, typename Content>
void passContent(Stream& stream, Content& content) {
  stream(content.has_world);
  stream.list(content.models, [&](auto& model) { passModel(stream, model); });
  stream.list(content.complaints, [&](auto& words) { stream(words); });
  stream(content.first_complaint);
}

}  // namespace

std::string sdfBytes(const SdfContent& content) {
  Saver saver;
  saver.writer.bytes = kSdfMagic;
  passContent(saver, content);
  return std::move(saver.writer.bytes);
}

Expected<SdfContent> sdfFromBytes(std::string_view bytes) {
  const Error unsound{.found = "the importer sent invalid data",
                      .fix = "Please report this bug, with the file that caused it."};
  if (!bytes.starts_with(kSdfMagic)) return makeError(unsound);
  Loader loader(bytes.substr(kSdfMagic.size()));
  SdfContent content;
  passContent(loader, content);
  if (loader.reader.failed || loader.reader.left() != 0) return makeError(unsound);
  return content;
}

}  // namespace hapticell::workcell
