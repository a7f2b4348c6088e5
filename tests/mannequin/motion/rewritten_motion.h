// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "mannequin/motion/motion_clip.h"

namespace hapticell::test {

using mannequin::ClipFrame;
using mannequin::ClipJoint;
using mannequin::MotionClip;

/// Ways in which programs write one and the same motion. Joints stay where they are in every frame (but for
/// withoutJoint).

inline dmat3 turnAbout(int axis, double degrees) {
  dvec3 turn(0.0);
  turn[axis] = degrees * kDegree;
  return glm::mat3_cast(quaternionFromRotationVector(turn));
}

/// Each joint's frame turned by a constant of its own: a child's offset and all turns follow.
inline MotionClip reframed(MotionClip clip, const std::vector<dmat3>& turns) {
  const std::size_t n = clip.joints.size();
  std::vector<dquat> A;
  for (const dmat3& turn : turns) A.push_back(glm::quat_cast(turn));
  for (std::size_t j = 1; j < n; ++j)
    clip.joints[j].p_Parent =
        glm::conjugate(A[static_cast<std::size_t>(clip.joints[j].parent)]) * clip.joints[j].p_Parent;
  for (ClipFrame& frame : clip.frames) {
    std::vector<dquat> turned = frame.turns;
    for (std::size_t j = 0; j < n; ++j) {
      if (clip.joints[j].is_end) continue;
      turned[j] = frame.turns[j] * A[j];
      if (clip.joints[j].parent >= 0)
        turned[j] = glm::conjugate(A[static_cast<std::size_t>(clip.joints[j].parent)]) * turned[j];
    }
    frame.turns = turned;
  }
  return clip;
}

/// Bones along the x axis of their joint's frame, as Rokoko, Motive and LAFAN1 write them.
inline std::vector<dmat3> bonesAlongX(const MotionClip& clip) {
  std::vector<dmat3> turns(clip.joints.size(), dmat3(1.0));
  for (std::size_t j = 0; j < clip.joints.size(); ++j) {
    dvec3 bone(0.0);
    for (std::size_t k = clip.joints.size(); k-- > j + 1;) {
      if (clip.joints[k].parent == static_cast<int>(j) && glm::length(clip.joints[k].p_Parent) > 1e-6)
        bone = clip.joints[k].p_Parent;
    }
    if (clip.joints[j].is_end || clip.joints[j].parent < 0 || glm::length(bone) < 1e-6) continue;
    const dvec3 x = glm::normalize(bone), hint = std::abs(x.z) > 0.9 ? dvec3(1, 0, 0) : dvec3(0, 0, 1);
    const dvec3 y = glm::normalize(glm::cross(hint, x));
    turns[j] = dmat3(x, y, glm::cross(x, y));
  }
  return turns;
}

inline std::vector<dmat3> onlyFrameOf(const MotionClip& clip, const std::string& joint, const dmat3& turn) {
  std::vector<dmat3> turns(clip.joints.size(), dmat3(1.0));
  turns[static_cast<std::size_t>(clip.find(joint))] = turn;
  return turns;
}

/// The whole in other axes: Z up, facing another way at rest ...
inline MotionClip turnedWhole(MotionClip clip, const dmat3& M) {
  const dquat q = glm::quat_cast(M);
  for (ClipJoint& joint : clip.joints) joint.p_Parent = M * joint.p_Parent;
  for (ClipFrame& frame : clip.frames) {
    frame.p_root = M * frame.p_root;
    for (dquat& turn : frame.turns) turn = q * turn * glm::conjugate(q);
  }
  return clip;
}

/// A joint folded into its children: their offsets grow, their turns take its own.
inline MotionClip withoutJoint(MotionClip clip, const std::string& name) {
  const int gone = clip.find(name);
  if (gone <= 0) return clip;
  const std::size_t g = static_cast<std::size_t>(gone);
  const ClipJoint joint = clip.joints[g];
  bool leaf = true;
  for (std::size_t j = 0; j < clip.joints.size(); ++j) {
    if (clip.joints[j].parent != gone) continue;
    leaf = leaf && clip.joints[j].is_end;
    clip.joints[j].parent = joint.parent;
    clip.joints[j].p_Parent += joint.p_Parent;
    for (ClipFrame& frame : clip.frames) {
      if (!clip.joints[j].is_end) frame.turns[j] = frame.turns[g] * frame.turns[j];
    }
  }
  (void)leaf;
  clip.joints.erase(clip.joints.begin() + gone);
  for (ClipJoint& each : clip.joints) each.parent -= each.parent > gone ? 1 : 0;
  for (ClipFrame& frame : clip.frames) frame.turns.erase(frame.turns.begin() + gone);
  return clip;
}

inline MotionClip renamed(MotionClip clip, const std::function<std::string(const std::string&)>& name) {
  for (ClipJoint& joint : clip.joints) joint.name = joint.is_end ? joint.name : name(joint.name);
  return clip;
}

/// Rz Ry Rx in degrees.
inline dvec3 turnsZyx(const dquat& q) {
  const dmat3 R = glm::mat3_cast(q);
  const double y = std::asin(std::clamp(-R[0][2], -1.0, 1.0));
  if (std::abs(R[0][2]) < 1.0 - 1e-9)
    return dvec3(std::atan2(R[0][1], R[0][0]), y, std::atan2(R[1][2], R[2][2])) / kDegree;
  return dvec3(std::atan2(-R[1][0], R[1][1]), y, 0.0) / kDegree;
}

/// A clip as BVH. `unit`: metres a unit of the file; `places`: offsets 0, places of all joints in the channels.
class BvhText {
 public:
  explicit BvhText(const MotionClip& clip, double unit = 0.01, bool places = false)
      : clip_(clip), unit_(unit), places_(places) {
    text_ = "HIERARCHY\n";
    addJoint(0);
    text_ += "MOTION\nFrames: " + std::to_string(clip.frames.size()) + "\nFrame Time: 0.0333333\n";
    for (const ClipFrame& frame : clip.frames) addRow(frame);
  }
  const std::string& text() const { return text_; }

 private:
  void add(const dvec3& v) {
    for (int k = 0; k < 3; ++k) {
      char number[40];
      std::snprintf(number, sizeof number, " %.9f", v[k]);
      text_ += number;
    }
  }
  void addJoint(int j) {
    const ClipJoint& joint = clip_.joints[static_cast<std::size_t>(j)];
    const std::string kind = j == 0 ? "ROOT " : "JOINT ";
    text_ += (joint.is_end ? "End Site" : kind + joint.name) + "\n{\n";
    text_ += "OFFSET";
    add(places_ && !joint.is_end && j > 0 ? dvec3(0.0) : joint.p_Parent / unit_);
    if (!joint.is_end) {
      const bool six = j == 0 || places_;
      text_ += six ? "\nCHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation\n"
                   : "\nCHANNELS 3 Zrotation Yrotation Xrotation\n";
      order_.push_back(j);
    }
    for (std::size_t k = 0; k < clip_.joints.size(); ++k) {
      if (clip_.joints[k].parent == j) addJoint(static_cast<int>(k));
    }
    text_ += "\n}\n";
  }
  void addRow(const ClipFrame& frame) {
    for (const int j : order_) {
      if (j == 0) add(frame.p_root / unit_);
      if (j > 0 && places_) add(clip_.joints[static_cast<std::size_t>(j)].p_Parent / unit_);
      add(turnsZyx(frame.turns[static_cast<std::size_t>(j)]));
    }
    text_ += "\n";
  }

  const MotionClip& clip_;
  double unit_;
  bool places_;
  std::string text_;
  std::vector<int> order_;
};

/// A person who bends, reaches, turns and looks about: 120 frames, Y up, T-pose at rest, facing Z. CMU's names.
inline MotionClip workingPerson() {
  MotionClip clip;
  const auto joint = [&](const char* name, const char* parent, const dvec3& p, bool end = false) {
    clip.joints.push_back({name, *parent ? clip.find(parent) : -1, p, end});
  };
  joint("root", "", {0, 0, 0});
  for (const auto& [side, out] : {std::pair{"l", 1.0}, {"r", -1.0}}) {
    const std::string s(side);
    joint((s + "femur").c_str(), "root", {0.09 * out, -0.08, 0});
    joint((s + "tibia").c_str(), (s + "femur").c_str(), {0, -0.42, 0});
    joint((s + "foot").c_str(), (s + "tibia").c_str(), {0, -0.41, 0});
    joint((s + "toes").c_str(), (s + "foot").c_str(), {0, -0.04, 0.13});
    joint((s + "toes_end").c_str(), (s + "toes").c_str(), {0, 0, 0.06}, true);
  }
  joint("lowerback", "root", {0, 0.0, 0});
  joint("upperback", "lowerback", {0, 0.15, 0});
  joint("thorax", "upperback", {0, 0.13, 0});
  joint("lowerneck", "thorax", {0, 0.16, 0});
  joint("head", "lowerneck", {0, 0.12, 0});
  joint("head_end", "head", {0, 0.15, 0}, true);
  for (const auto& [side, out] : {std::pair{"l", 1.0}, {"r", -1.0}}) {
    const std::string s(side);
    joint((s + "clavicle").c_str(), "thorax", {0.02 * out, 0.13, 0.02});
    joint((s + "humerus").c_str(), (s + "clavicle").c_str(), {0.16 * out, 0, -0.02});
    joint((s + "radius").c_str(), (s + "humerus").c_str(), {0.29 * out, 0, 0});
    joint((s + "hand").c_str(), (s + "radius").c_str(), {0.25 * out, 0, 0});
    joint((s + "fingers").c_str(), (s + "hand").c_str(), {0.08 * out, 0, 0});
    joint((s + "fingers_end").c_str(), (s + "fingers").c_str(), {0.08 * out, 0, 0}, true);
    joint((s + "thumb").c_str(), (s + "hand").c_str(), {0.03 * out, 0, 0.03});
    joint((s + "thumb_end").c_str(), (s + "thumb").c_str(), {0.03 * out, 0, 0.03}, true);
  }
  for (int f = 0; f < 120; ++f) {
    const double t = f / 119.0, wave = std::sin(2.0 * std::numbers::pi * t),
                 slow = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * t);
    ClipFrame frame;
    frame.p_root = {0.3 * t, 0.9, 0.5 * t};
    frame.turns.assign(clip.joints.size(), dquat(1.0, 0.0, 0.0, 0.0));
    const auto turn = [&](const std::string& name, double x, double y, double z) {
      frame.turns[static_cast<std::size_t>(clip.find(name))] =
          glm::quat_cast(turnAbout(1, y) * turnAbout(0, x) * turnAbout(2, z));
    };
    turn("root", 8.0 * slow, 40.0 * wave, 2.0 * wave);
    turn("lowerback", 15.0 * slow, 4.0 * wave, 3.0 * wave);
    turn("upperback", 12.0 * slow, 5.0 * wave, 4.0 * wave);
    turn("thorax", 8.0 * slow, 6.0 * wave, 2.0 * wave);
    turn("lowerneck", 6.0 + 10.0 * slow, 10.0 * wave, 5.0 * wave);
    turn("head", 4.0 + 12.0 * slow, 14.0 * wave, 0.0);
    for (const auto& [side, out] : {std::pair{"l", 1.0}, {"r", -1.0}}) {
      const std::string s(side);
      turn(s + "femur", -20.0 - 35.0 * slow * (out > 0 ? 1.0 : 0.7), 4.0 * wave, 3.0 * out);
      turn(s + "tibia", 25.0 + 45.0 * slow, 0.0, 0.0);
      turn(s + "foot", -8.0, 3.0 * wave, 0.0);
      turn(s + "clavicle", 0.0, 2.0 * wave, 3.0 * out * slow);
      // Down from the T-pose, then forwards and up.
      const dmat3 arm = turnAbout(0, -15.0 - 60.0 * slow) * turnAbout(2, -out * (78.0 - 25.0 * slow));
      frame.turns[static_cast<std::size_t>(clip.find(s + "humerus"))] = glm::quat_cast(arm);
      turn(s + "radius", 20.0 + 30.0 * slow, -out * (35.0 + 40.0 * slow), 0.0);
      turn(s + "hand", 10.0 * wave, -out * 8.0 * slow, out * 12.0 * wave);
    }
    clip.frames.push_back(std::move(frame));
  }
  clip.frame_time = 0.0333333;
  return clip;
}

}  // namespace hapticell::test
