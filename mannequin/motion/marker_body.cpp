// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/marker_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "mannequin/body/rotations.h"
#include "mannequin/motion/joint_centres.h"
#include "mannequin/motion/marker_ways.h"

namespace hapticell::mannequin {

namespace {

/// m; 14 mm markers, our choice as all of these (docs/dev/mannequin.md). Half, twice: joints are 3.5 or 7 mm farther in
/// or out.
constexpr double kMarkerRadius = 0.007;
/// m, half a joint's breadth of a grown person. Half, twice: joints lie beside the bones by as much as is missing;
/// MarkerBody allows 10 mm.
constexpr double kHalfKnee = 0.052, kHalfAnkle = 0.036, kHalfElbow = 0.040;
/// m, the shoulder's centre from the acromion. Half, twice: upper arms are 20 or 40 mm too long or short; MarkerBody
/// allows 10 mm.
constexpr double kBelowAcromion = 0.040, kInsideAcromion = 0.012;
/// m, over the line of the wrist's markers. Half, twice: hands are bent by 3 or 6 deg at a length of 0.1 m.
constexpr double kFingerHigher = 0.010;
/// m, half a wrist's thickness: its markers lie on its back. Half, twice: wrists 9 or 18 mm off.
constexpr double kHalfWrist = 0.018;
/// On the whole: nobody does; the markers lean. Half: heads that look up a little are put level; twice: leaning markers
/// stay.
constexpr double kLooksUp = 5.0 * kDegree;
/// Moments looked at, for medians. Half: less sure; twice: twice the time.
constexpr std::size_t kMostTilts = 500;
/// From C7 to the clavicles' notch. Our choice. Half: the neck's base at its back; twice: in its front.
constexpr double kIntoNeck = 0.35;

dmat3 between(const dmat3& a, const dmat3& b, double s) {
  return glm::mat3_cast(glm::slerp(glm::normalize(glm::quat_cast(a)), glm::normalize(glm::quat_cast(b)), s));
}

class MarkerBody {
 public:
  MarkerBody(const MarkerClip& clip, const MarkerSet& set) : clip_(clip), set_(set), ways_(clip, set) {}

  Expected<RecordedMotion> find() {
    motion_.frame_time = clip_.frame_time;
    motion_.metres_per_unit = clip_.metres_per_unit;
    motion_.up = clip_.up;
    motion_.marker_set = set_.name;
    motion_.assumptions = clip_.warnings;
    motion_.assumptions.push_back(
        Text("the markers are read as %1; joints are computed from them with HaptiCell's own offsets", set_.name));
    HAPTICELL_TRY(ways_.find());
    motion_.assumptions.insert(motion_.assumptions.end(), ways_.assumptions().begin(), ways_.assumptions().end());
    findTilts();
    tell();
    for (std::size_t f = 0; f < clip_.frames(); ++f) {
      frame_ = f;
      motion_.bodies.push_back(body());
      HAPTICELL_TRY(check(motion_.bodies.back()));
    }
    return std::move(motion_);
  }

 private:
  bool has(const std::string& landmark) const { return ways_.has(landmark); }
  dvec3 at(const std::string& landmark) const { return ways_.at(landmark, frame_); }
  static std::string sided(std::size_t i, const char* landmark) {
    return std::string(i == 0 ? "left_" : "right_") + landmark;
  }
  bool both(const char* landmark) const { return has(sided(0, landmark)) && has(sided(1, landmark)); }
  dvec3 middle(const char* landmark) const { return 0.5 * (at(sided(0, landmark)) + at(sided(1, landmark))); }

  /// How the markers of pelvis and head lie on them: where the trunk is upright the pelvis is in line with it; and a
  /// head does not look up on the whole.
  void findTilts() {
    const std::size_t every = std::max<std::size_t>(1, clip_.frames() / kMostTilts);
    std::vector<std::pair<double, std::array<double, 2>>> tilts;
    for (frame_ = 0; frame_ < clip_.frames(); frame_ += every) {
      const RecordedBody raw = body();
      const dvec3 trunk = unitOf(raw.neck - raw.p_root);
      const dvec3 in_pelvis = glm::transpose(raw.R_root) * trunk;
      tilts.push_back(
          {-trunk.z, {std::atan2(in_pelvis.x, in_pelvis.z), std::asin(std::clamp(raw.R_head[0].z, -1.0, 1.0))}});
    }
    std::sort(tilts.begin(), tilts.end());
    tilts.resize((tilts.size() + 1) / 2);  // The more upright half.
    const auto median = [&](std::size_t k) {
      std::vector<double> values;
      for (const auto& [up, both] : tilts) values.push_back(both[k]);
      std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
      return values[values.size() / 2];
    };
    if (tilts.empty()) return;
    pelvis_tilt_ = both("asis") ? median(0) : 0.0;
    if ((hasFourOfHead() || hasLineOfHead()) && median(1) > kLooksUp) head_tilt_ = median(1);
  }

  bool hasThorax() const { return has("c7") && has("t10") && has("clavicle") && has("sternum"); }
  bool hasFourOfHead() const { return both("head_front") && both("head_back"); }
  bool hasLineOfHead() const { return has("head_front") && has("head_back"); }

  void tell() {
    std::vector<Text>& said = motion_.assumptions;
    if (!hasThorax())
      said.push_back(
          Text("some of the markers C7, T10, CLAV and STRN are missing; the chest is derived from shoulders and hips"));
    if (hasFourOfHead() || hasLineOfHead()) {
      said.push_back(head_tilt_ > 0.0 ? Text("the head markers lean back by %1 deg on average; this is assumed to be "
                                             "how they were attached, with the head level on average",
                                             std::lround(head_tilt_ / kDegree))
                                      : Text("the head markers are assumed to be level when the head is upright"));
    } else {
      said.push_back(Text("there are no markers on the head; it follows the chest, which also affects the neck score"));
    }
    if (!both("finger")) said.push_back(Text("there are no markers on the fingers; straight wrists are assumed"));
    if (!both("heel")) said.push_back(Text("there are no markers on the heels; straight feet are assumed"));
    if (!both("toe")) said.push_back(Text("there are no markers on the toes; straight feet are assumed"));
    if (!both("wrist_thumb_side") || !both("wrist_little_finger_side"))
      said.push_back(Text("each wrist has one marker; neither pronation nor supination of the forearms is assumed"));
  }

  /// Hips by Harrington's regression, or as told.
  void pelvis(RecordedBody& body) const {
    if (both("asis") && (both("psis") || has("sacrum"))) {
      const dvec3 front = middle("asis"), back = both("psis") ? middle("psis") : at("sacrum");
      const dmat3 R = fromForward(square(front - back, unitOf(at("left_asis") - at("right_asis"))),
                                  at("left_asis") - at("right_asis"));
      const double width = glm::length(at("left_asis") - at("right_asis")), depth = glm::length(front - back);
      for (std::size_t i = 0; i < 2; ++i) {
        const double out = i == 0 ? 1.0 : -1.0;
        body.hip[i] = front + R * dvec3(-0.24 * depth - 0.0099, out * (0.33 * width + 0.0073), -0.30 * width - 0.0109);
      }
      body.R_root = R * aboutY(pelvis_tilt_);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      if (has(sided(i, "hip_joint"))) body.hip[i] = at(sided(i, "hip_joint"));
    }
    body.p_root = 0.5 * (body.hip[0] + body.hip[1]);
    if (!both("asis")) body.R_root = fromUp(shoulderMarks() - body.p_root, body.hip[0] - body.hip[1]);
  }
  dvec3 shoulderMark(std::size_t i) const {
    return has(sided(i, "shoulder")) ? at(sided(i, "shoulder")) : at(sided(i, "shoulder_joint"));
  }
  dvec3 shoulderMarks() const { return 0.5 * (shoulderMark(0) + shoulderMark(1)); }

  void thorax(RecordedBody& body) const {
    const dvec3 left = shoulderMark(0) - shoulderMark(1);
    if (hasThorax()) {
      const dvec3 up = at("c7") + at("clavicle") - at("t10") - at("sternum");
      const dvec3 ahead = at("clavicle") + at("sternum") - at("c7") - at("t10");
      body.R_thorax = fromUp(up, glm::cross(up, ahead));
    } else {
      body.R_thorax = fromUp(shoulderMarks() - body.p_root, left);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const double out = i == 0 ? 1.0 : -1.0;
      body.shoulder[i] =
          has(sided(i, "shoulder_joint"))
              ? at(sided(i, "shoulder_joint"))
              : shoulderMark(i) - body.R_thorax * dvec3(0.0, out * kInsideAcromion, kBelowAcromion + kMarkerRadius);
    }
    body.neck = shoulderMarks();
    if (has("c7"))
      body.neck = at("c7") + (has("clavicle") ? kIntoNeck * (at("clavicle") - at("c7")) : 0.045 * body.R_thorax[0]);
  }

  void head(RecordedBody& body) const {
    body.R_head = body.R_thorax;
    if (hasFourOfHead()) {
      body.R_head =
          fromForward(middle("head_front") - middle("head_back"),
                      at("left_head_front") + at("left_head_back") - at("right_head_front") - at("right_head_back"));
    } else if (hasLineOfHead()) {
      const dvec3 x = at("head_front") - at("head_back");
      const dvec3 up = has("head_top") ? at("head_top") - 0.5 * (at("head_front") + at("head_back")) : body.R_thorax[2];
      body.R_head = fromForward(x, glm::cross(up, x));
    }
    if (hasFourOfHead() || hasLineOfHead()) body.R_head = body.R_head * aboutY(head_tilt_);
  }

  /// The centre of a knee or an elbow, and its axis to the left.
  struct Hinge {
    dvec3 centre, left;
  };
  Hinge hingeOf(std::size_t i, const char* name, double half, const dvec3& from, const dvec3& to, double bends,
                const dvec3& otherwise) const {
    const double out = i == 0 ? 1.0 : -1.0;
    const std::string outer = sided(i, name), inner = outer + "_inside", centre = outer + "_joint";
    if (has(centre)) return {at(centre), hingeAxis(from, at(centre), to, bends, otherwise)};
    if (has(inner)) {
      const dvec3 middle = 0.5 * (at(outer) + at(inner));
      return {middle, square(out * (at(outer) - at(inner)), unitOf(middle - from))};
    }
    const dvec3 n = hingeOutward(from, at(outer), to, half + kMarkerRadius, -bends * out);
    return {at(outer) - (half + kMarkerRadius) * n, out * n};
  }
  dvec3 joint(std::size_t i, const char* name, double half, const dvec3& left) const {
    const std::string outer = sided(i, name);
    if (has(outer + "_joint")) return at(outer + "_joint");
    if (has(outer + "_inside")) return 0.5 * (at(outer) + at(outer + "_inside"));
    return at(outer) - (i == 0 ? 1.0 : -1.0) * (half + kMarkerRadius) * left;
  }
  dvec3 mark(std::size_t i, const char* name) const {
    const std::string plain = sided(i, name);
    return has(plain) ? at(plain) : at(plain + "_joint");
  }

  void leg(std::size_t i, RecordedBody& body) const {
    const double out = i == 0 ? 1.0 : -1.0;
    dvec3 foot = mark(i, "ankle");
    Hinge knee = hingeOf(i, "knee", kHalfKnee, body.hip[i], foot, -1.0, body.R_root[1]);
    // The ankle's own centre lies inside its marker too.
    foot = joint(i, "ankle", kHalfAnkle, knee.left);
    knee = hingeOf(i, "knee", kHalfKnee, body.hip[i], foot, -1.0, body.R_root[1]);
    body.knee[i] = knee.centre;
    dvec3 left = knee.left;
    const bool inner = has(sided(i, "knee_inside")) || has(sided(i, "knee_joint"));
    if (!inner && has(sided(i, "thigh"))) {
      body.knee[i] = centreInside(body.hip[i], at(sided(i, "knee")), at(sided(i, "thigh")), kHalfKnee + kMarkerRadius);
      left = square(out * (at(sided(i, "knee")) - body.knee[i]), unitOf(body.hip[i] - body.knee[i]));
    }
    body.ankle[i] = joint(i, "ankle", kHalfAnkle, left);
    const bool inner_ankle = has(sided(i, "ankle_inside")) || has(sided(i, "ankle_joint"));
    if (!inner_ankle && has(sided(i, "shank")))
      body.ankle[i] = centreInside(body.knee[i], at(sided(i, "ankle")), at(sided(i, "shank")), kHalfAnkle + kMarkerRadius);
    body.thigh_forward[i] = glm::cross(left, unitOf(body.hip[i] - body.knee[i]));
    const dvec3 shank = unitOf(body.knee[i] - body.ankle[i]);
    body.R_foot[i] = fromUp(shank, left);
    if (has(sided(i, "heel")) && has(sided(i, "toe")))
      body.R_foot[i] = fromForward(at(sided(i, "toe")) - at(sided(i, "heel")), left);
  }

  dvec3 wrist(std::size_t i) const {
    if (has(sided(i, "wrist_joint"))) return at(sided(i, "wrist_joint"));
    const std::string a = sided(i, "wrist_thumb_side"), b = sided(i, "wrist_little_finger_side");
    if (has(a) && has(b)) return 0.5 * (at(a) + at(b));
    if (has(sided(i, "wrist"))) return at(sided(i, "wrist"));
    return at(has(a) ? a : b);
  }

  void arm(std::size_t i, RecordedBody& body) const {
    const double out = i == 0 ? 1.0 : -1.0;
    body.hand[i] = wrist(i);  // The middle of its markers first, then inside the wrist.
    dvec3 left, thumb, back;
    for (int pass = 0; pass < 2; ++pass) {
      const Hinge elbow = hingeOf(i, "elbow", kHalfElbow, body.shoulder[i], body.hand[i], 1.0, body.R_thorax[1]);
      body.elbow[i] = elbow.centre;
      left = elbow.left;
      const dvec3 fore = unitOf(body.hand[i] - body.elbow[i]);
      const std::string a = sided(i, "wrist_thumb_side"), b = sided(i, "wrist_little_finger_side");
      thumb = has(a) && has(b) ? square(at(a) - at(b), fore) : glm::cross(left, -fore);
      back = out * glm::cross(-fore, thumb);
      if (!has(sided(i, "wrist_joint"))) body.hand[i] = wrist(i) - (kHalfWrist + kMarkerRadius) * back;
    }
    body.arm_forward[i] = glm::cross(left, unitOf(body.shoulder[i] - body.elbow[i]));
    dvec3 along = unitOf(body.hand[i] - body.elbow[i]);
    // Both the wrist's markers and the finger's lie on the back of the hand, the finger's a little higher.
    if (has(sided(i, "finger"))) along = unitOf(at(sided(i, "finger")) - kFingerHigher * back - wrist(i));
    body.R_hand[i] = fromUp(-along, glm::cross(-along, thumb));
  }

  RecordedBody body() const {
    RecordedBody body;
    pelvis(body);
    thorax(body);
    head(body);
    body.R_spine = {between(body.R_root, body.R_thorax, 1.0 / 3.0), between(body.R_root, body.R_thorax, 2.0 / 3.0),
                    body.R_thorax};
    body.R_neck = {between(body.R_thorax, body.R_head, 1.0 / 3.0), between(body.R_thorax, body.R_head, 2.0 / 3.0)};
    for (std::size_t i = 0; i < 2; ++i) {
      leg(i, body);
      arm(i, body);
    }
    return body;
  }

  Expected<void> check(const RecordedBody& body) const {
    for (std::size_t i = 0; i < 2; ++i) {
      const double least = std::min({glm::length(body.knee[i] - body.hip[i]), glm::length(body.ankle[i] - body.knee[i]),
                                     glm::length(body.elbow[i] - body.shoulder[i]),
                                     glm::length(body.hand[i] - body.elbow[i]), glm::length(body.neck - body.p_root)});
      if (!(least > 0.01))
        return makeError({.place = Text("frame %1", frame_ + 1),
                          .found = "markers at the same point",
                          .expected = "arms, legs and a trunk with lengths above 0"});
    }
    return {};
  }

  const MarkerClip& clip_;
  const MarkerSet& set_;
  MarkerWays ways_;
  RecordedMotion motion_;
  std::size_t frame_ = 0;
  double pelvis_tilt_ = 0.0, head_tilt_ = 0.0;  ///< rad, forwards.
};

}  // namespace

Expected<RecordedMotion> recordedMotion(const MarkerClip& clip, const MarkerSet& set) {
  return MarkerBody(clip, set).find();
}

}  // namespace hapticell::mannequin
