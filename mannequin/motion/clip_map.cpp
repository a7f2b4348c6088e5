// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/clip_map.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>

#include "mannequin/body/joint_names.h"

namespace hapticell::mannequin {

namespace {

using Of = JointName::Of;

class JointFinder {
 public:
  explicit JointFinder(const MotionClip& clip) : clip_(clip), children_(clip.joints.size()) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < clip.joints.size(); ++i) {
      names.push_back(clip.joints[i].name);
      if (clip.joints[i].parent >= 0)
        children_[static_cast<std::size_t>(clip.joints[i].parent)].push_back(static_cast<int>(i));
    }
    names_ = jointNames(names);
  }

  /// By the first of the parts that there is on that side.
  int find(Of side, std::initializer_list<const char*> parts) const {
    for (const char* part : parts) {
      for (std::size_t i = 0; i < names_.size(); ++i) {
        if (!clip_.joints[i].is_end && names_[i].side == side && names_[i].part == part) return static_cast<int>(i);
      }
    }
    return -1;
  }
  /// The first below `above` whose part has one of the words in it.
  int below(int above, std::initializer_list<const char*> words) const {
    if (above < 0) return -1;
    for (std::size_t i = static_cast<std::size_t>(above) + 1; i < names_.size(); ++i) {
      if (!isBelow(static_cast<int>(i), above)) continue;
      for (const char* word : words) {
        if (names_[i].part.find(word) != std::string::npos) return static_cast<int>(i);
      }
    }
    return -1;
  }
  bool isBelow(int joint, int above) const {
    while (joint > above) joint = clip_.joints[static_cast<std::size_t>(joint)].parent;
    return joint == above;
  }
  int commonParent(std::initializer_list<int> joints) const {
    int common = -1;
    for (const int joint : joints) {
      if (joint < 0) continue;
      if (common < 0) {
        common = joint;
        continue;
      }
      int a = common, b = joint;
      while (a != b) (a > b ? a : b) = clip_.joints[static_cast<std::size_t>(std::max(a, b))].parent;
      common = a;
    }
    return common;
  }
  /// Joints from below `above` down to before `joint`, from above.
  std::vector<int> between(int above, int joint) const {
    std::vector<int> chain;
    for (joint = clip_.joints[static_cast<std::size_t>(joint)].parent; joint > above;
         joint = clip_.joints[static_cast<std::size_t>(joint)].parent)
      chain.insert(chain.begin(), joint);
    return chain;
  }
  double length(int joint) const { return glm::length(clip_.joints[static_cast<std::size_t>(joint)].p_Parent); }
  /// Of the bones from above down to a joint.
  double lengthFrom(int above, int joint) const {
    double sum = 0.0;
    for (; joint > above; joint = clip_.joints[static_cast<std::size_t>(joint)].parent) sum += length(joint);
    return sum;
  }
  bool isEnd(int joint) const { return clip_.joints[static_cast<std::size_t>(joint)].is_end; }
  const std::vector<int>& children(int joint) const { return children_[static_cast<std::size_t>(joint)]; }
  const std::string& part(int joint) const { return names_[static_cast<std::size_t>(joint)].part; }

 private:
  const MotionClip& clip_;
  std::vector<std::vector<int>> children_;
  std::vector<JointName> names_;
};

void findLimbs(const JointFinder& joints, ClipMap& map) {
  for (std::size_t i = 0; i < 2; ++i) {
    const Of side = i == 0 ? Of::kLeft : Of::kRight;
    map.hip[i] = joints.find(side, {"femur", "upleg", "upperleg", "uleg", "thigh", "thighbend", "hip", "hipjoint"});
    map.knee[i] = joints.find(side, {"tibia", "knee", "lowerleg", "lowleg", "shin", "calf", "shank", "leg"});
    map.ankle[i] = joints.find(side, {"ankle", "talocrural", "foot"});
    map.toe[i] = joints.find(side, {"toebase", "toe", "toes", "ball", "metatarsal"});
    if (const int foot = joints.find(side, {"foot"}); map.toe[i] < 0 && foot != map.ankle[i]) map.toe[i] = foot;
    map.shoulder[i] =
        joints.find(side, {"humerus", "arm", "upperarm", "uparm", "uarm", "shldr", "shldrbend", "shoulder"});
    map.collar[i] = joints.find(side, {"clavicle", "collar", "sternoclavicular", "shoulder"});
    if (map.collar[i] == map.shoulder[i]) map.collar[i] = -1;
    const int elbow = joints.find(side, {"elbow"});
    map.elbow[i] = elbow >= 0
                       ? elbow
                       : joints.find(side, {"radius", "forearm", "lowerarm", "lowarm", "farm", "forearmbend", "ulna"});
    // "wrist" is half way down CMU's forearm.
    map.hand[i] = elbow >= 0 ? joints.find(side, {"wrist", "hand"}) : joints.find(side, {"hand", "wrist"});
  }
  map.head = joints.find(Of::kMiddle, {"head", "skullbase", "skull"});
}

/// What tells how a hand lies: its fingers and thumb, or its end.
void findHand(const JointFinder& joints, std::size_t side, ClipMap& map) {
  const int hand = map.hand[side];
  map.thumb[side] = joints.below(hand, {"thumb"});
  map.index[side] = joints.below(hand, {"index"});
  map.little[side] = joints.below(hand, {"pinky", "little"});
  map.fingers[side] = joints.below(hand, {"middle", "fingers"});
  // Of some hands the bones within them are joints too; the knuckle tells more.
  const double palm = 0.25 * joints.length(hand);
  for (int next = map.fingers[side]; next >= 0 && joints.lengthFrom(hand, next) < palm;) {
    next = joints.children(next).empty() ? -1 : joints.children(next).front();
    if (next >= 0 && !joints.isEnd(next)) map.fingers[side] = next;
  }
  if (map.fingers[side] < 0) map.fingers[side] = map.index[side];
  for (const int child : joints.children(hand)) {
    if (map.fingers[side] < 0 && child != map.thumb[side] && joints.length(child) > 1e-6) map.fingers[side] = child;
  }
}

void findTrunk(const JointFinder& joints, ClipMap& map) {
  map.thorax = joints.commonParent({map.shoulder[0], map.shoulder[1], map.head});
  map.root = joints.commonParent({map.hip[0], map.hip[1], map.thorax});
  map.spine[2] = map.thorax;
  if (map.thorax > map.root) {
    const std::vector<int> lower = joints.between(map.root, map.thorax);
    if (!lower.empty()) map.spine[0] = lower.front();
    if (lower.size() > 1) map.spine[1] = lower[lower.size() / 2];
  }
  const std::vector<int> neck = joints.between(map.thorax, map.head);
  if (!neck.empty()) map.neck = map.neck_joints[0] = neck.front();
  if (neck.size() > 1) map.neck_joints[1] = neck.back();
  double longest = 1e-6;
  for (const int child : joints.children(map.head)) {
    const bool face =
        joints.part(child).find("eye") != std::string::npos || joints.part(child).find("jaw") != std::string::npos;
    if (face || joints.length(child) <= longest) continue;
    longest = joints.length(child);
    map.head_end = child;
  }
}

std::string namesIn(const MotionClip& clip) {
  std::string text;
  for (const ClipJoint& joint : clip.joints) {
    if (joint.is_end) continue;
    if (text.size() > 160) return text + ", ...";
    text += (text.empty() ? "" : ", ") + joint.name.substr(0, 40);
  }
  return text;
}

}  // namespace

Expected<ClipMap> mapJoints(const MotionClip& clip) {
  const JointFinder joints(clip);
  ClipMap map;
  findLimbs(joints, map);
  const std::pair<Text, int> needed[] = {HAPTICELL_TRANSLATED(
      {"head", map.head}, {"left hip", map.hip[0]}, {"right hip", map.hip[1]}, {"left knee", map.knee[0]},
      {"right knee", map.knee[1]}, {"left ankle", map.ankle[0]}, {"right ankle", map.ankle[1]},
      {"left shoulder", map.shoulder[0]}, {"right shoulder", map.shoulder[1]}, {"left elbow", map.elbow[0]},
      {"right elbow", map.elbow[1]}, {"left wrist", map.hand[0]}, {"right wrist", map.hand[1]})};
  for (const auto& [what, joint] : needed) {
    if (joint >= 0) continue;
    return makeError(
        {.found = Text("a skeleton without a joint for the %1 (its joints are %2)", what, namesIn(clip)),
         .expected =
             "joint names of CMU, H-Anim, Biovision, Mixamo, Rokoko, Motive, LAFAN1, Unreal, Biped, Xsens or SMPL",
         .fix = "Rename the joint in the program that wrote the file."});
  }
  findTrunk(joints, map);
  for (std::size_t side = 0; side < 2; ++side) findHand(joints, side, map);
  return map;
}

}  // namespace hapticell::mannequin
