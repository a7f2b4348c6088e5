// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/motion_writer.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/body/rotations.h"

namespace hapticell::mannequin {

namespace {

/// The world's axes (Z up, facing X) in the file's (Y up, facing Z).
dvec3 inFile(const dvec3& v) {
  return {v.y, v.z, v.x};
}

std::string numbers(std::initializer_list<double> values, const char* format = "%.6f") {
  std::string text;
  for (const double value : values) {
    char number[40];
    // No "-0.000000", and the locale's decimal point back to a point.
    std::snprintf(number, sizeof number, format, std::abs(value) < 5e-7 ? 0.0 : value);
    for (char& c : number) c = c == ',' ? '.' : c;
    text += (text.empty() ? "" : " ") + std::string(number);
  }
  return text;
}

std::array<std::vector<Segment>, kSegmentCount> childrenOf() {
  std::array<std::vector<Segment>, kSegmentCount> children;
  for (std::size_t i = 1; i < kSegmentCount; ++i) {
    children[indexOf(*segmentInfo(static_cast<Segment>(i)).parent)].push_back(static_cast<Segment>(i));
  }
  return children;
}

/// Where a segment without children ends, in its frame.
dvec3 endOf(const Figure& figure, Segment segment) {
  if (segment == Segment::kHead) return figure.p_HeadVertex;
  if (segment == Segment::kLeftHand || segment == Segment::kRightHand) {
    return {0.0, 0.0, -figure.body[Dimension::kHandLength]};
  }
  return {figure.sole.toe_x - figure.sole.ball_x, 0.0, 0.0};
}

class BvhWriter {
 public:
  explicit BvhWriter(const Figure& figure) : figure_(figure), children_(childrenOf()) {}

  std::string write(std::span<const Posture> postures, double frame_time) {
    text_ = "HIERARCHY\n";
    addJoint(Segment::kPelvis, 0);
    text_ +=
        "MOTION\nFrames: " + std::to_string(postures.size()) + "\nFrame Time: " + numbers({frame_time}, "%.9f") + "\n";
    for (const Posture& posture : postures) addFrame(posture);
    return std::move(text_);
  }

 private:
  void addJoint(Segment segment, std::size_t depth) {
    const std::string in(2 * depth, ' ');
    const bool root = segment == Segment::kPelvis;
    const dvec3 p = root ? dvec3(0.0) : 100.0 * inFile(figure_.p_PS[indexOf(segment)]);
    text_ += in + (root ? "ROOT " : "JOINT ") + segmentInfo(segment).joint + "\n" + in + "{\n";
    text_ += in + "  OFFSET " + numbers({p.x, p.y, p.z}) + "\n" + in + "  CHANNELS ";
    text_ += root ? "6 Xposition Yposition Zposition " : "3 ";
    text_ += "Xrotation Zrotation Yrotation\n";
    order_.push_back(segment);
    for (const Segment child : children_[indexOf(segment)]) addJoint(child, depth + 1);
    if (children_[indexOf(segment)].empty()) {
      const dvec3 end = 100.0 * inFile(endOf(figure_, segment));
      text_ += in + "  End Site\n" + in + "  {\n" + in + "    OFFSET " + numbers({end.x, end.y, end.z}) + "\n" + in +
               "  }\n";
    }
    text_ += in + "}\n";
  }

  /// R = Ry Rx Rz of the world is, in the file's axes, a turn about x, then z, then y.
  void addFrame(const Posture& posture) {
    const FigurePose pose = forwardKinematics(figure_, posture);
    const dvec3 p = 100.0 * inFile(posture.X_WR.p);
    text_ += numbers({p.x, p.y, p.z});
    for (const Segment segment : order_) {
      const auto parent = segmentInfo(segment).parent;
      const dmat3 R = parent ? glm::transpose(pose[*parent].R_WS) * pose[segment].R_WS : pose[segment].R_WS;
      const dvec3 angles = anglesYXZ(R) / kDegree;
      text_ += " " + numbers({angles.y, angles.x, angles.z});
    }
    text_ += "\n";
  }

  const Figure& figure_;
  std::array<std::vector<Segment>, kSegmentCount> children_;
  std::vector<Segment> order_;
  std::string text_;
};

class HAnimWriter {
 public:
  HAnimWriter(const Figure& figure, const Posture& posture)
      : figure_(figure),
        pose_(forwardKinematics(figure, posture)),
        rest_(forwardKinematics(figure, restOf(figure))),
        children_(childrenOf()) {}

  std::string write(const std::string& name) {
    text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<X3D profile=\"Full\" version=\"4.0\">\n  <Scene>\n";
    text_ += "    <HAnimHumanoid DEF=\"" + name + "\" name=\"" + name + "\" version=\"2.0\" loa=\"1\">\n";
    addJoint(Segment::kPelvis, 3);
    for (std::size_t i = 0; i < kSegmentCount; ++i) {
      text_ += "      <HAnimJoint USE=\"" + std::string(segmentInfo(static_cast<Segment>(i)).joint) +
               "\" containerField=\"joints\"/>\n";
    }
    return text_ + "    </HAnimHumanoid>\n  </Scene>\n</X3D>\n";
  }

 private:
  static Posture restOf(const Figure& figure) {
    Posture rest;
    rest.X_WR.p = figure.p_PS[0];
    return rest;
  }

  void addJoint(Segment segment, std::size_t depth) {
    const std::string in(2 * depth, ' ');
    const SegmentInfo& info = segmentInfo(segment);
    const dvec3 centre = inFile(rest_[segment].p_WS);
    const dmat3 R = info.parent ? glm::transpose(pose_[*info.parent].R_WS) * pose_[segment].R_WS : pose_[segment].R_WS;
    const dvec3 turn = inFile(rotationVector(glm::quat_cast(R)));
    const double angle = glm::length(turn);
    const dvec3 axis = angle > 1e-9 ? turn / angle : dvec3(0.0, 0.0, 1.0);
    text_ += in + "<HAnimJoint DEF=\"" + info.joint + "\" name=\"" + info.joint + "\" center=\"" +
             numbers({centre.x, centre.y, centre.z}) + "\" rotation=\"" + numbers({axis.x, axis.y, axis.z, angle}) +
             "\"";
    if (!info.parent) {
      const dvec3 moved = inFile(pose_[segment].p_WS - rest_[segment].p_WS);
      text_ += " translation=\"" + numbers({moved.x, moved.y, moved.z}) + "\" containerField=\"skeleton\"";
    }
    text_ += ">\n" + in + "  <HAnimSegment name=\"" + info.name + "\" mass=\"" +
             numbers({figure_.mass[indexOf(segment)]}) + "\"/>\n";
    for (const Segment child : children_[indexOf(segment)]) addJoint(child, depth + 1);
    text_ += in + "</HAnimJoint>\n";
  }

  const Figure& figure_;
  FigurePose pose_, rest_;
  std::array<std::vector<Segment>, kSegmentCount> children_;
  std::string text_;
};

}  // namespace

std::string bvhText(const Figure& figure, std::span<const Posture> postures, double frame_time) {
  return BvhWriter(figure).write(postures, frame_time);
}

std::string hanimText(const Figure& figure, const Posture& posture, const std::string& name) {
  return HAnimWriter(figure, posture).write(name);
}

}  // namespace hapticell::mannequin
