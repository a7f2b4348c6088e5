// SPDX-License-Identifier: Apache-2.0
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "geometry/system/text_case.h"
#include "mannequin/motion/motion_clip.h"
#include "mannequin/motion/word_reader.h"

namespace hapticell::mannequin {

namespace {

// Guards memory and time: ten times a full skeleton with fingers. Half, twice: no file of a person is refused.
constexpr std::size_t kMostBones = 1000;

dquat about(int axis, double degrees) {
  dvec3 turn(0.0);
  turn[axis] = degrees * std::numbers::pi / 180.0;
  return quaternionFromRotationVector(turn);
}

struct Bone {
  std::string name;
  dvec3 direction{0.0};
  double length = 0.0;
  dquat axes{1.0, 0.0, 0.0, 0.0};  ///< C.
  std::vector<int> dofs;           ///< 0 rx, 1 ry, 2 rz; 3 to 5 tx to tz; 6 l. As they stand in the motion's rows.
  std::string parent;
};

/// Skeleton and motion as they stand in their files, before they become a clip.
class AsfReader {
 public:
  AsfReader(std::string_view text, const std::string& name) : words_(text), text_(text), name_(name) {}

  Expected<void> read() {
    if (const Text why = whyNoText(text_); !why.empty())
      return makeError(
          {.file = name_, .found = why, .expected = "a skeleton in ASF", .fix = "Save it as plain text (UTF-8)."});
    while (!words_.atEnd()) {
      const std::string_view word = words_.next();
      Expected<void> done;
      if (word.starts_with('#')) words_.restOfLine();
      if (word == ":units") done = readUnits();
      if (word == ":root") done = readRoot();
      if (word == ":bonedata") done = readBones();
      if (word == ":hierarchy") done = readHierarchy();
      if (!done) return done;
    }
    if (order_.empty()) return fail(Text(":hierarchy is missing"), Text("a skeleton in ASF"));
    return {};
  }

  std::map<std::string, Bone> bones;
  std::vector<std::string> order_;  ///< Parents first; "root" is the first.
  double metres_per_unit = 0.0254;
  double degrees_per_unit = 1.0;

 private:
  tl::unexpected<Error> fail(Text found, Text expected) const {
    return makeError(
        {.file = name_, .place = words_.place(), .found = std::move(found), .expected = std::move(expected)});
  }

  Expected<void> readUnits() {
    while (!words_.atEnd() && !words_.peek().starts_with(':')) {
      const std::string_view word = words_.next();
      if (word == "length") {
        const auto value = words_.number();
        if (!value || !(*value > 0.0)) return fail(Text("the unit of length is missing"), Text("a number above 0"));
        metres_per_unit = 0.0254 / *value;
      } else if (word == "angle") {
        const std::string_view unit = words_.next();
        if (!unit.starts_with("deg") && !unit.starts_with("rad"))
          return fail(Text("the angle unit '%1'", unit.substr(0, 40)), Text("deg or rad"));
        degrees_per_unit = unit.starts_with("rad") ? 180.0 / std::numbers::pi : 1.0;
      }
    }
    return {};
  }

  /// "XYZ" turns about x first: Rz Ry Rx.
  Expected<dquat> axesOf(const dvec3& degrees, std::string_view order) const {
    dquat axes(1.0, 0.0, 0.0, 0.0);
    if (order.size() != 3) return fail(Text("the rotation order '%1'", order.substr(0, 40)), Text::plain("XYZ"));
    for (const char letter : order) {
      const int axis = std::toupper(static_cast<unsigned char>(letter)) - 'X';
      if (axis < 0 || axis > 2) return fail(Text("the rotation order '%1'", order), Text::plain("XYZ"));
      axes = about(axis, degrees[axis]) * axes;
    }
    return axes;
  }
  Expected<dvec3> three() {
    dvec3 values(0.0);
    for (int k = 0; k < 3; ++k) {
      const auto value = words_.number();
      if (!value) return fail(Text("not a number"), Text("three numbers"));
      values[k] = *value;
    }
    return values;
  }

  Expected<void> readRoot() {
    Bone root;
    root.name = "root";
    dvec3 orientation(0.0);
    std::string order = "XYZ";
    while (!words_.atEnd() && !words_.peek().starts_with(':')) {
      const std::string_view key = words_.next();
      if (key == "orientation") {
        const Expected<dvec3> values = three();
        HAPTICELL_TRY(values);
        orientation = *values;
      }
      if (key == "axis") order = std::string(words_.next());
      if (key != "order") continue;
      for (int i = 0; i < 6; ++i) {
        const std::string_view word = words_.peek();
        const int axis = word.size() == 2 ? std::toupper(static_cast<unsigned char>(word[1])) - 'X' : -1;
        const int kind = word.empty() ? 0 : std::toupper(static_cast<unsigned char>(word[0]));
        if (axis < 0 || axis > 2 || (kind != 'T' && kind != 'R')) break;
        root.dofs.push_back(kind == 'T' ? 3 + axis : axis);
        words_.next();
      }
    }
    const Expected<dquat> axes = axesOf(degrees_per_unit * orientation, order);
    HAPTICELL_TRY(axes);
    root.axes = *axes;
    bones["root"] = root;
    return {};
  }

  Expected<void> readBones() {
    while (!words_.atEnd() && !words_.peek().starts_with(':')) {
      if (words_.next() != "begin") continue;
      Bone bone;
      if (auto done = readBone(bone); !done) return done;
      if (bones.size() > kMostBones) return fail(Text("more than 1000 bones"), Text("a skeleton"));
      bones[bone.name] = bone;
    }
    return {};
  }

  Expected<void> readBone(Bone& bone) {
    for (std::string_view word = words_.next(); word != "end"; word = words_.next()) {
      if (word.empty()) return fail(Text("the file ends inside a bone"), Text::plain("end"));
      if (word == "name") bone.name = std::string(words_.next());
      if (word == "length") {
        const auto value = words_.number();
        if (!value) return fail(Text("the length is missing"), Text("a number"));
        bone.length = *value;
      }
      if (word == "direction" || word == "axis") {
        const Expected<dvec3> values = three();
        HAPTICELL_TRY(values);
        if (word == "direction") bone.direction = *values;
        if (word == "axis") {
          const Expected<dquat> axes = axesOf(degrees_per_unit * *values, words_.next());
          HAPTICELL_TRY(axes);
          bone.axes = *axes;
        }
      }
      while (word == "dof") {
        const int dof = dofOf(words_.peek());
        if (dof < 0) break;
        bone.dofs.push_back(dof);
        words_.next();
      }
    }
    return {};
  }

  /// "rx" to "rz", "tx" to "tz", "l"; else -1.
  static int dofOf(std::string_view word) {
    if (word == "l") return 6;
    if (word.size() != 2 || (word[0] != 'r' && word[0] != 't') || word[1] < 'x' || word[1] > 'z') return -1;
    return (word[0] == 't' ? 3 : 0) + word[1] - 'x';
  }

  Expected<void> readHierarchy() {
    order_.push_back("root");
    if (words_.next() != "begin") return fail(Text("'begin' is missing"), Text::plain("begin"));
    words_.restOfLine();
    while (words_.peek() != "end") {
      if (words_.atEnd()) return fail(Text("the end of the file"), Text::plain("end"));
      const std::string parent(words_.next());
      WordReader children(words_.restOfLine());
      for (std::string_view child = children.next(); !child.empty(); child = children.next()) {
        const auto bone = bones.find(std::string(child));
        if (bone == bones.end() || !bone->second.parent.empty() || child == "root") {
          return fail(Text("the bone '%1'", child.substr(0, 40)), Text("each bone of :bonedata once"));
        }
        bone->second.parent = parent;
        order_.push_back(bone->first);
      }
    }
    return {};
  }

  WordReader words_;
  std::string_view text_;
  const std::string& name_;
};

class ClipBuilder {
 public:
  explicit ClipBuilder(const AsfReader& skeleton) : skeleton_(skeleton) {}

  Expected<void> build(const std::string& name) {
    clip.metres_per_unit = skeleton_.metres_per_unit;
    if (!skeleton_.bones.contains("root"))
      return makeError({.file = name, .found = ":root is missing", .expected = "a skeleton with a root"});
    for (const std::string& bone_name : skeleton_.order_) {
      const Bone& bone = skeleton_.bones.at(bone_name);
      ClipJoint joint;
      joint.name = bone_name;
      if (bone_name != "root") {
        const auto parent = index.find(bone.parent);
        if (parent == index.end())
          return makeError({.file = name,
                            .place = Text::plain(":hierarchy"),
                            .found = Text("'%1' comes before its parent", bone.parent),
                            .expected = "parents before their children"});
        joint.parent = static_cast<int>(parent->second);
        joint.p_Parent = endOf(skeleton_.bones.at(bone.parent));
      }
      index[bone_name] = clip.joints.size();
      clip.joints.push_back(joint);
    }
    const std::size_t bones = clip.joints.size();
    for (std::size_t i = 1; i < bones; ++i) {
      bool leaf = true;
      for (std::size_t k = 0; k < bones; ++k) leaf = leaf && clip.joints[k].parent != static_cast<int>(i);
      if (!leaf) continue;
      const ClipJoint& joint = clip.joints[i];
      clip.joints.push_back({joint.name + "_end", static_cast<int>(i), endOf(skeleton_.bones.at(joint.name)), true});
    }
    return {};
  }

  dvec3 endOf(const Bone& bone) const { return bone.direction * bone.length * skeleton_.metres_per_unit; }

  MotionClip clip;
  std::map<std::string, std::size_t> index;

 private:
  const AsfReader& skeleton_;
};

class AmcReader {
 public:
  AmcReader(const AsfReader& skeleton, ClipBuilder& builder, std::string_view text, const std::string& name)
      : skeleton_(skeleton), builder_(builder), words_(text), text_(text), name_(name) {}

  Expected<void> read() {
    if (const Text why = whyNoText(text_); !why.empty())
      return makeError(
          {.file = name_, .found = why, .expected = "a motion in AMC", .fix = "Save it as plain text (UTF-8)."});
    if (auto done = readHead(); !done) return done;
    std::optional<double> last;
    while (!words_.atEnd()) {
      const std::string_view word = words_.next();
      const auto number = WordReader::numberOf(word);
      if (!number) return fail(Text("'%1' instead of a frame number", word.substr(0, 40)), Text("a number"));
      if (last && *number != *last + 1.0) {
        return fail(Text("frame %1 after frame %2", word, std::llround(*last)), Text("consecutive frame numbers"),
                    Text("Frames are missing or repeated: export the file again."));
      }
      last = number;
      if (auto done = readFrame(); !done) return done;
    }
    for (const auto& [bone, frames] : missing_) {
      builder_.clip.warnings.push_back(
          Text("the bone '%1' has no values in %2 of %3 frames; its rest pose is used there", bone, frames,
               builder_.clip.frames.size()));
    }
    if (stretched_)
      builder_.clip.warnings.push_back(Text("bones that slide or change length are kept as in the rest pose"));
    return {};
  }

 private:
  tl::unexpected<Error> fail(Text found, Text expected, Text fix = {}) const {
    return makeError({.file = name_,
                      .place = words_.place(),
                      .found = std::move(found),
                      .expected = std::move(expected),
                      .fix = std::move(fix)});
  }

  /// Comments and keywords; those of the angles' unit count, others ("FULLY-SPECIFIED") say nothing that is needed.
  Expected<void> readHead() {
    std::optional<double> degrees;
    while (words_.peek().starts_with('#') || words_.peek().starts_with(':')) {
      const std::string word = upperCase(words_.next());
      words_.restOfLine();
      if (word != ":RADIANS" && word != ":DEGREES") continue;
      const double said = word == ":RADIANS" ? 180.0 / std::numbers::pi : 1.0;
      if (degrees && *degrees != said) return fail(Text(":RADIANS and :DEGREES"), Text("one of the two"));
      degrees = said;
    }
    unit_ = degrees.value_or(skeleton_.degrees_per_unit);
    if (degrees && *degrees != skeleton_.degrees_per_unit) {
      builder_.clip.warnings.push_back(
          *degrees > 1.0
              ? Text("angles of the motion are in radians, as the AMC states; angles of the skeleton are in degrees")
              : Text("angles of the motion are in degrees, as the AMC states; angles of the skeleton are in radians"));
    }
    return {};
  }

  static bool beginsName(std::string_view word) {
    return !word.empty() && (std::isalpha(static_cast<unsigned char>(word[0])) != 0 || word[0] == '_');
  }

  Expected<void> readFrame() {
    ClipFrame frame;
    frame.turns.assign(builder_.clip.joints.size(), dquat(1.0, 0.0, 0.0, 0.0));
    std::set<std::string> there;
    while (beginsName(words_.peek())) {
      const std::string word(words_.next());
      const auto bone = skeleton_.bones.find(word);
      if (bone == skeleton_.bones.end())
        return fail(Text("the bone '%1'", word.substr(0, 40)), Text("a bone of the skeleton"));
      if (!there.insert(word).second)
        return fail(Text("the bone '%1' twice in a frame", word.substr(0, 40)), Text("each bone once"));
      if (auto done = readBone(bone->second, frame); !done) return done;
    }
    for (const auto& [name, bone] : skeleton_.bones) {
      if (!bone.dofs.empty() && builder_.index.contains(name) && !there.contains(name)) ++missing_[name];
    }
    builder_.clip.frames.push_back(std::move(frame));
    return {};
  }

  /// The turns in the order in which they stand: the first is made first.
  Expected<void> readBone(const Bone& bone, ClipFrame& frame) {
    dquat M(1.0, 0.0, 0.0, 0.0);
    dvec3 p(0.0);
    for (const int dof : bone.dofs) {
      const std::string_view word = words_.next();
      const auto value = WordReader::numberOf(word);
      if (!value) {
        return fail(Text("invalid number for '%1': '%2'", bone.name.substr(0, 40), word.substr(0, 40)),
                    Text("%1 numbers", bone.dofs.size()));
      }
      if (dof < 3) M = about(dof, unit_ * *value) * M;
      if (dof >= 3 && dof < 6) p[dof - 3] = *value * skeleton_.metres_per_unit;
      stretched_ = stretched_ || (dof >= 3 && bone.name != "root" && *value != 0.0);
    }
    const auto joint = builder_.index.find(bone.name);
    if (joint == builder_.index.end()) return {};
    frame.turns[joint->second] = glm::normalize(bone.axes * M * glm::conjugate(bone.axes));
    if (joint->second != 0) return {};
    frame.turns[0] = glm::normalize(bone.axes * M);
    frame.p_root = p;
    return {};
  }

  const AsfReader& skeleton_;
  ClipBuilder& builder_;
  WordReader words_;
  std::string_view text_;
  const std::string& name_;
  double unit_ = 1.0;                   ///< Degrees.
  std::map<std::string, int> missing_;  ///< Frames without a bone that has turns, by bone.
  bool stretched_ = false;
};

}  // namespace

Expected<MotionClip> readAsfAmc(std::string_view asf, const std::string& asf_name, std::string_view amc,
                                const std::string& amc_name) {
  AsfReader skeleton(asf, asf_name);
  HAPTICELL_TRY(skeleton.read());
  ClipBuilder builder(skeleton);
  HAPTICELL_TRY(builder.build(asf_name));
  HAPTICELL_TRY(AmcReader(skeleton, builder, amc, amc_name).read());
  return std::move(builder.clip);
}

}  // namespace hapticell::mannequin
