// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/head_flesh.h"

namespace hapticell::mannequin {

namespace {

// m, a man of 1.755 m: the measures for which the places below are given, scaled by the figure's own. Not tuned.
constexpr double kHeadLength = 0.1994, kHeadBreadth = 0.1544, kEyesBelowVertex = 0.1137;
// m, over which what is small flows into the head; our choice. Half: a nose with a seam; twice: a nose that melts.
constexpr double kFine = 0.013;

class HeadSculptor {
 public:
  explicit HeadSculptor(const Figure& figure) : m_(figure) { head_ = {{}, 0.030 * m_.size(), -1e9, kSkinColor, {}}; }

  Flesh make() {
    skull();
    jaw();
    nose();
    for (const double side : {1.0, -1.0}) cheekAndEar(side);
    return std::move(head_);
  }

 private:
  void add(const dvec3& a, const dvec3& b, double ra, double rb, const dvec3& stretch, double blend) {
    head_.blobs.push_back({a, b, m_.size() * ra, m_.size() * rb, stretch, blend});
  }

  void skull() {
    const double length = m_.scale.x / m_.scale.y, height = m_.scale.z / m_.scale.y;
    const dvec3 middle = m_.at(-0.004, 0.0, 0.0167);
    add(middle, middle, 0.0772, 0.0772, {1.275 * length, 1.0, 1.256 * height}, -1.0);
    // The face, narrower downwards.
    add(m_.at(0.032, 0.0, 0.004), m_.at(0.044, 0.0, -0.060), 0.0590, m_.female ? 0.0465 : 0.0495, {1.02, 1.04, 1.0},
        -1.0);
    // The brows' ridge.
    const double ridge = m_.female ? 0.0085 : 0.0110;
    add(m_.at(0.0800, -0.030, 0.0150), m_.at(0.0800, 0.030, 0.0150), ridge, ridge, dvec3(1.0), 0.016);
  }

  void jaw() {
    const double wide = m_.female ? 0.047 : 0.053, chin = m_.female ? 0.010 : 0.016;
    for (const double side : {1.0, -1.0})
      add(m_.at(0.004, side * wide, -0.050), m_.at(0.064, side * chin, -0.097), 0.0185, 0.0160, dvec3(1.0), 0.034);
    const dvec3 tip = m_.at(0.0700, 0.0, -0.0960);
    add(tip, tip, 0.0150, 0.0150, {1.0, 1.35, 1.0}, 0.014);
    // About the mouth.
    const dvec3 mouth = m_.at(0.0640, 0.0, -0.0640);
    add(mouth, mouth, 0.0265, 0.0265, {1.0, 1.12, 1.0}, 0.014);
  }

  void nose() {
    add(m_.at(0.0880, 0.0, 0.0060), m_.at(0.1050, 0.0, -0.0360), 0.0062, 0.0088, dvec3(1.0), kFine);
    for (const double side : {1.0, -1.0})
      add(m_.at(0.0950, side * 0.0105, -0.0395), m_.at(0.0900, side * 0.0130, -0.0395), 0.0068, 0.0060, dvec3(1.0),
          0.006);
  }

  void cheekAndEar(double side) {
    add(m_.at(0.0640, side * 0.0360, -0.0250), m_.at(0.0380, side * 0.0530, -0.0210), 0.0150, 0.0120, dvec3(1.0),
        0.034);
    add(m_.at(-0.0090, side * 0.0800, 0.0080), m_.at(-0.0020, side * 0.0735, -0.0270), 0.0190, 0.0110, {1.0, 0.34, 1.0},
        0.004);
    // The shell of the ear.
    head_.hollows.push_back({m_.at(-0.0060, side * 0.0880, 0.0070),
                             m_.at(-0.0010, side * 0.0830, -0.0120),
                             m_.size() * 0.0110,
                             m_.size() * 0.0075,
                             {1.0, 0.42, 1.0},
                             0.004});
    head_.hollows.push_back({m_.at(0.0985, side * 0.0290, -0.0010),
                             m_.at(0.0940, side * 0.0400, -0.0010),
                             m_.size() * 0.0158,
                             m_.size() * 0.0138,
                             {0.95, 1.0, 0.80},
                             0.012});
  }

  HeadMeasures m_;
  Flesh head_;
};

}  // namespace

HeadMeasures::HeadMeasures(const Figure& figure)
    : origin(figure.p_HeadVertex.x, 0.0, figure.p_HeadEyes.z),
      scale(figure.body[Dimension::kHeadLength] / kHeadLength, figure.body[Dimension::kHeadBreadth] / kHeadBreadth,
            (figure.p_HeadVertex.z - figure.p_HeadEyes.z) / kEyesBelowVertex),
      female(figure.sex == Sex::kFemale) {}

Flesh headFlesh(const Figure& figure) {
  return HeadSculptor(figure).make();
}

}  // namespace hapticell::mannequin
