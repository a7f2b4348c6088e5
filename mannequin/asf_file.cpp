// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <map>

#include "mannequin/motion_clip.h"
#include "mannequin/word_reader.h"

namespace hapticell::mannequin {

namespace {

constexpr std::size_t kMostBones = 1000;

dquat about(int axis, double degrees) {
  dvec3 turn(0.0);
  turn[axis] = degrees * M_PI / 180.0;
  return quaternionFromRotationVector(turn);
}

struct Bone {
  std::string name;
  dvec3 direction{0.0};
  double length = 0.0;
  dquat axes{1.0, 0.0, 0.0, 0.0};  ///< C.
  std::vector<int> dofs;           ///< 0 rx, 1 ry, 2 rz; 3 to 5 tx to tz (the root's).
  std::string parent;
};

/// Skeleton and motion as they stand in their files, before they become a clip.
class AsfReader {
 public:
  AsfReader(std::string_view text, const std::string& name) : words_(text), name_(name) {}

  Expected<void> read() {
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
    if (order_.empty()) return fail("no :hierarchy", "a skeleton in ASF");
    return {};
  }

  std::map<std::string, Bone> bones;
  std::vector<std::string> order_;  ///< Parents first; "root" is the first.
  double metres_per_unit = 0.0254;
  double degrees_per_unit = 1.0;

 private:
  tl::unexpected<Error> fail(std::string found, std::string expected) const {
    return makeError({name_, words_.place(), std::move(found), std::move(expected), ""});
  }

  Expected<void> readUnits() {
    while (!words_.atEnd() && !words_.peek().starts_with(':')) {
      const std::string_view word = words_.next();
      if (word == "length") {
        const auto value = words_.number();
        if (!value || !(*value > 0.0)) return fail("no length unit", "a number above 0");
        metres_per_unit = 0.0254 / *value;
      } else if (word == "angle") {
        degrees_per_unit = words_.next() == "rad" ? 180.0 / M_PI : 1.0;
      }
    }
    return {};
  }

  Expected<void> readRoot() {
    Bone root;
    root.name = "root";
    while (!words_.atEnd() && !words_.peek().starts_with(':')) {
      if (words_.next() != "order") continue;
      for (int i = 0; i < 6; ++i) {
        const std::string_view word = words_.peek();
        const int axis = word.size() == 2 ? word[1] - 'X' : -1;
        if (axis < 0 || axis > 2 || (word[0] != 'T' && word[0] != 'R')) break;
        root.dofs.push_back(word[0] == 'T' ? 3 + axis : axis);
        words_.next();
      }
    }
    bones["root"] = root;
    return {};
  }

  Expected<void> readBones() {
    while (!words_.atEnd() && !words_.peek().starts_with(':')) {
      if (words_.next() != "begin") continue;
      Bone bone;
      if (auto done = readBone(bone); !done) return done;
      if (bones.size() > kMostBones) return fail("more than 1000 bones", "a skeleton");
      bones[bone.name] = bone;
    }
    return {};
  }

  Expected<void> readBone(Bone& bone) {
    for (std::string_view word = words_.next(); word != "end"; word = words_.next()) {
      if (word.empty()) return fail("the end of the file in a bone", "end");
      if (word == "name") bone.name = std::string(words_.next());
      if (word == "length") {
        const auto value = words_.number();
        if (!value) return fail("no length", "a number");
        bone.length = *value;
      }
      if (word == "direction" || word == "axis") {
        dvec3 values;
        for (int k = 0; k < 3; ++k) {
          const auto value = words_.number();
          if (!value) return fail("no number", "three numbers");
          values[k] = *value;
        }
        if (word == "direction") bone.direction = values;
        if (word == "axis") {
          values *= degrees_per_unit;
          bone.axes = about(2, values.z) * about(1, values.y) * about(0, values.x);
        }
      }
      while (word == "dof" && words_.peek().size() == 2 && words_.peek()[0] == 'r') {
        bone.dofs.push_back(std::min(2, std::max(0, words_.next()[1] - 'x')));
      }
    }
    return {};
  }

  Expected<void> readHierarchy() {
    order_.push_back("root");
    if (words_.next() != "begin") return fail("no begin", "begin");
    words_.restOfLine();
    while (words_.peek() != "end") {
      if (words_.atEnd()) return fail("the end of the file", "end");
      const std::string parent(words_.next());
      WordReader children(words_.restOfLine());
      for (std::string_view child = children.next(); !child.empty(); child = children.next()) {
        const auto bone = bones.find(std::string(child));
        if (bone == bones.end() || !bone->second.parent.empty() || child == "root") {
          return fail("the bone '" + std::string(child.substr(0, 40)) + "'", "a bone of :bonedata, once");
        }
        bone->second.parent = parent;
        order_.push_back(bone->first);
      }
    }
    return {};
  }

  WordReader words_;
  const std::string& name_;
};

class ClipBuilder {
 public:
  explicit ClipBuilder(const AsfReader& skeleton) : skeleton_(skeleton) {}

  Expected<void> build(const std::string& name) {
    clip.metres_per_unit = skeleton_.metres_per_unit;
    if (!skeleton_.bones.contains("root")) return makeError({name, "", "no :root", "a skeleton with its root", ""});
    for (const std::string& bone_name : skeleton_.order_) {
      const Bone& bone = skeleton_.bones.at(bone_name);
      ClipJoint joint;
      joint.name = bone_name;
      if (bone_name != "root") {
        const auto parent = index.find(bone.parent);
        if (parent == index.end())
          return makeError({name, ":hierarchy", "'" + bone.parent + "' before its parent", "parents first", ""});
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
      : skeleton_(skeleton), builder_(builder), words_(text), name_(name) {}

  Expected<void> read() {
    while (words_.peek().starts_with('#') || words_.peek().starts_with(':')) {
      words_.next();
      words_.restOfLine();
    }
    while (!words_.atEnd()) {
      if (!words_.number()) return fail("no frame number", "a number");
      if (auto done = readFrame(); !done) return done;
    }
    return {};
  }

 private:
  tl::unexpected<Error> fail(std::string found, std::string expected) const {
    return makeError({name_, words_.place(), std::move(found), std::move(expected), ""});
  }

  static bool beginsName(std::string_view word) {
    return !word.empty() && (std::isalpha(static_cast<unsigned char>(word[0])) != 0 || word[0] == '_');
  }

  Expected<void> readFrame() {
    ClipFrame frame;
    frame.turns.assign(builder_.clip.joints.size(), dquat(1.0, 0.0, 0.0, 0.0));
    while (beginsName(words_.peek())) {
      const std::string word(words_.next());
      const auto bone = skeleton_.bones.find(word);
      if (bone == skeleton_.bones.end()) return fail("the bone '" + word.substr(0, 40) + "'", "a bone of the skeleton");
      std::array<double, 6> values{};
      for (const int dof : bone->second.dofs) {
        const auto value = words_.number();
        if (!value)
          return fail("no number for '" + word.substr(0, 40) + "'",
                      std::to_string(bone->second.dofs.size()) + " numbers");
        values[static_cast<std::size_t>(dof)] = *value;
      }
      const auto joint = builder_.index.find(word);
      if (joint == builder_.index.end()) continue;
      const double unit = skeleton_.degrees_per_unit;
      const dquat M = about(2, unit * values[2]) * about(1, unit * values[1]) * about(0, unit * values[0]);
      const dquat C = bone->second.axes;
      frame.turns[joint->second] = glm::normalize(C * M * glm::conjugate(C));
      if (joint->second == 0) frame.p_root = dvec3(values[3], values[4], values[5]) * skeleton_.metres_per_unit;
    }
    builder_.clip.frames.push_back(std::move(frame));
    return {};
  }

  const AsfReader& skeleton_;
  ClipBuilder& builder_;
  WordReader words_;
  const std::string& name_;
};

}  // namespace

Expected<MotionClip> readAsfAmc(std::string_view asf, const std::string& asf_name, std::string_view amc,
                                const std::string& amc_name) {
  AsfReader skeleton(asf, asf_name);
  if (auto read = skeleton.read(); !read) return makeError(read.error());
  ClipBuilder builder(skeleton);
  if (auto built = builder.build(asf_name); !built) return makeError(built.error());
  if (auto read = AmcReader(skeleton, builder, amc, amc_name).read(); !read) return makeError(read.error());
  return std::move(builder.clip);
}

}  // namespace hapticell::mannequin
