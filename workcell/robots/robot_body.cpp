// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/robot_body.h"

#include <algorithm>
#include <cmath>

namespace hapticell::workcell {

namespace {

using Detail = BodyMaker::Detail;
using kinematics::JointType;
using kinematics::RobotModel;

constexpr PaintColor kMetal{0.62f, 0.64f, 0.67f, 1.0f};

/// A serial chain as the body sees it: where each joint's axis stands in the link before, at position 0.
struct Station {
  int parent, child;
  Pose X_PJ;
  dvec3 axis_P;  ///< In the parent's frame.
  dvec3 axis_J;
  bool slides;
};

std::vector<Station> stationsOf(const RobotModel& model) {
  std::vector<Station> stations;
  for (const kinematics::Joint& joint : model.joints) {
    stations.push_back({joint.parent_link, joint.child_link, joint.X_PJ, joint.X_PJ.rotate(joint.axis_J), joint.axis_J,
                        joint.type == JointType::kPrismatic});
  }
  return stations;
}

double sizeOf(const RobotModel& model) {
  double size = 0.0;
  for (const kinematics::Joint& joint : model.joints) size += glm::length(joint.X_PJ.p);
  return size;
}

double valueAt(const std::vector<double>& values, std::size_t k, double otherwise) {
  return k < values.size() ? values[k] : otherwise;
}

void tube(BodyMaker& body, const PaintColor& color, const dvec3& from, const dvec3& to, double r0, double r1) {
  const double length = glm::length(to - from);
  if (length < 1e-4) return;
  body.add(color, solid::along(from, to - from),
           [&](const Detail& d) { return solid::capsule(r0, r1, 0.0, length, d.segments); });
}

void can(BodyMaker& body, const PaintColor& color, const Pose& at, double r, double z0, double z1) {
  body.add(color, at, [&](const Detail& d) { return solid::cylinder(r, z0, z1, 0.15 * r * d.chamfer, d.segments); });
}

}  // namespace

void addCobotBody(RobotModel& model, const RobotLook& look) {
  BodyMaker body(model);
  const std::vector<Station> stations = stationsOf(model);
  const std::size_t n = stations.size() - 1;  // The last one is the flange.
  const double size = sizeOf(model) * look.bulk;
  const auto radius = [&](std::size_t k) {
    return valueAt(look.radius, k, size * (0.058 - 0.022 * static_cast<double>(k) / static_cast<double>(n)));
  };
  body.link(0);
  const double foot = radius(0);
  can(body, look.second, {}, 1.35 * foot, 0.0, 0.12 * foot);
  const double height = std::max(0.4 * foot, stations[0].X_PJ.p.z);
  can(body, look.main, {}, 1.1 * foot, 0.1 * foot, std::max(0.9 * foot, height - 0.2 * foot));
  for (std::size_t k = 0; k < n; ++k) {
    body.link(stations[k].child);
    const double r = radius(k), next_r = radius(std::min(k + 1, n - 1));
    const dvec3 axis = stations[k].axis_J;
    const dvec3 start = valueAt(look.side, k, 0.0) * axis;
    const Station& next = stations[k + 1];
    const bool last = k + 1 == n;
    const double aside = valueAt(look.side, k, 0.0);
    const bool parallel = std::abs(glm::dot(glm::normalize(next.axis_P), axis)) > 0.99;
    dvec3 end = next.X_PJ.p;
    if (parallel && !last) end += aside * axis;
    // Its own housing, with a cap on the side that looks away from the arm.
    const double half = last ? std::max(0.3 * r, glm::dot(end, axis)) : 0.85 * r;
    if (last) {
      can(body, kMetal, solid::along({}, axis), 0.85 * r, std::min(0.0, half - 0.4 * r), half);
      continue;
    }
    can(body, look.main, solid::along(start, axis), r, -half, half);
    const double cap = aside >= 0.0 ? half : -half - 0.16 * r;
    body.decorate(look.second, solid::along(start, axis), [&](const Detail& d) {
      return solid::cylinder(0.92 * r, cap, cap + 0.16 * r, 0.05 * r, d.segments);
    });
    tube(body, look.main, start, end, 0.82 * r, 0.9 * next_r);
    if (!parallel) continue;
    can(body, look.main, solid::along(end, axis), next_r, -0.85 * next_r, 0.85 * next_r);
    body.decorate(look.second, solid::along(end, axis), [&](const Detail& d) {
      const double z = aside >= 0.0 ? 0.85 * next_r : -1.0 * next_r;
      return solid::cylinder(0.92 * next_r, z, z + 0.15 * next_r, 0.05 * next_r, d.segments);
    });
  }
}

void addScaraBody(RobotModel& model, const RobotLook& look) {
  BodyMaker body(model);
  const std::vector<Station> stations = stationsOf(model);
  const double l1 = glm::length(stations[1].X_PJ.p * dvec3(1, 1, 0)),
               l2 = glm::length(stations[2].X_PJ.p * dvec3(1, 1, 0));
  const double s = (l1 + l2) * look.bulk, top = std::max(stations[0].X_PJ.p.z, 0.2 * s);
  const double r = 0.12 * s, plate = 0.10 * s;  // Height of an arm.
  body.link(0);
  can(body, look.second, {}, 1.5 * r, 0.0, 0.03 * s);
  body.add(look.main, {}, [&](const Detail& d) {
    return solid::prism(solid::belt({-0.06 * s, 0}, 1.1 * r, {0, 0}, r, d.steps), 0.025 * s, top - 0.01 * s,
                        0.01 * s * d.chamfer);
  });
  body.link(stations[0].child);
  const dvec3 o1 = stations[1].X_PJ.p;
  body.add(look.main, {}, [&](const Detail& d) {
    return solid::prism(solid::belt({0, 0}, r, {o1.x, o1.y}, 0.8 * r, d.steps), 0.0, plate, 0.012 * s * d.chamfer);
  });
  body.link(stations[1].child);
  const dvec3 o2 = stations[2].X_PJ.p;
  const double low = plate + 0.01 * s - o1.z;
  body.add(look.main, {}, [&](const Detail& d) {
    return solid::prism(solid::belt({0, 0}, 0.8 * r, {o2.x, o2.y}, 0.7 * r, d.steps), low, low + 1.3 * plate,
                        0.015 * s * d.chamfer);
  });
  body.add(look.second, {}, [&](const Detail& d) {
    return solid::prism(solid::belt({0.15 * o2.x, 0.15 * o2.y}, 0.5 * r, {0.95 * o2.x, 0.95 * o2.y}, 0.5 * r, d.steps),
                        low + 1.25 * plate, low + 2.1 * plate, 0.02 * s * d.chamfer);
  });
  // The quill: on the first link of the last pair that slides, or on the last.
  double stroke = 0.2 * s;
  for (const kinematics::Joint& joint : model.joints) {
    if (joint.type == JointType::kPrismatic) stroke = joint.upper - joint.lower;
  }
  const Station& flange = stations.back();
  body.link(flange.parent);
  const double tip = flange.X_PJ.p.z, shaft = std::max(0.012, 0.16 * r);
  const double down = flange.axis_P.z < 0 || flange.X_PJ.rotate({0, 0, 1}).z < 0 ? 1.0 : -1.0;
  body.add(kMetal, {}, [&](const Detail& d) {
    const double other = tip + down * (stroke + 0.55 * s);
    return solid::cylinder(shaft, std::min(tip, other), std::max(tip, other), 0.1 * shaft * d.chamfer, d.segments);
  });
  body.add(look.second, {}, [&](const Detail& d) {
    const double other = tip + down * 0.03 * s;
    return solid::cylinder(1.9 * shaft, std::min(tip, other), std::max(tip, other), 0.1 * shaft * d.chamfer,
                           d.segments);
  });
}

void addGantryBody(RobotModel& model, const RobotLook& look) {
  BodyMaker body(model);
  const std::vector<Station> stations = stationsOf(model);
  const double size = sizeOf(model);
  double w = 0.06 * std::max(0.5, size * 0.5) * look.bulk;
  body.link(0);
  const kinematics::Joint& first = model.joints.front();
  const dvec3 p0 = stations[0].X_PJ.p + stations[0].axis_P * first.lower,
              p1 = stations[0].X_PJ.p + stations[0].axis_P * first.upper;
  // A second rail where the next axis runs across.
  double span = 0.0;
  dvec3 across(0.0);
  if (model.joints.size() > 1 && model.joints[1].type == JointType::kPrismatic) {
    across = stations[0].X_PJ.rotate(stations[1].axis_P);
    if (std::abs(across.z) < 0.5) span = model.joints[1].upper - model.joints[1].lower;
  }
  const dvec3 base_offset = span > 0.0 ? model.joints[1].lower * across : dvec3(0.0);
  for (const double side : {0.0, 1.0}) {
    if (side > 0.0 && span == 0.0) continue;
    const dvec3 shift = base_offset + (side * (span + 4.0 * w) - 2.0 * w * (span > 0 ? 1.0 : 0.0)) * across;
    const dvec3 a = p0 + shift - 2.0 * w * stations[0].axis_P, b = p1 + shift + 2.0 * w * stations[0].axis_P;
    body.add(look.main, solid::along(a, b - a), [&](const Detail& d) {
      return solid::prism(solid::roundedRectangle(1.6 * w, 1.6 * w, 0.15 * w, d.steps / 3 + 1), 0.0, glm::length(b - a),
                          0.1 * w * d.chamfer);
    });
    for (const dvec3& foot : {a, b}) {
      if (foot.z < 2.0 * w) continue;
      const dvec3 inside = foot + (foot == a ? 1.2 : -1.2) * w * stations[0].axis_P;
      body.add(look.second, Pose::translation({inside.x, inside.y, 0}), [&](const Detail& d) {
        return solid::prism(solid::roundedRectangle(1.5 * w, 1.5 * w, 0.15 * w, d.steps / 3 + 1), 0.0,
                            inside.z - 0.75 * w, 0.08 * w * d.chamfer);
      });
      body.add(look.second, Pose::translation({inside.x, inside.y, 0}), [&](const Detail& d) {
        return solid::cylinder(1.6 * w, 0.0, 0.2 * w, 0.05 * w * d.chamfer, d.segments);
      });
    }
  }
  for (std::size_t k = 0; k + 1 < stations.size(); ++k) {
    body.link(stations[k].child);
    const Station& next = stations[k + 1];
    const kinematics::Joint& follower = model.joints[k + 1];
    const dvec3 o = next.X_PJ.p;
    body.add(look.second, {},
             [&](const Detail& d) { return solid::box(dvec3(-1.1 * w), dvec3(1.1 * w), 0.15 * w * d.chamfer); });
    if (next.slides) {
      const bool upright = std::abs(next.axis_P.z) > 0.5;
      const dvec3 a = o + next.axis_P * (upright ? -1.0 * w : follower.lower - 2.0 * w);
      const dvec3 b = o + next.axis_P * (upright ? 1.5 * w : follower.upper + 2.0 * w);
      body.add(look.main, solid::along(a, b - a), [&](const Detail& d) {
        return solid::prism(solid::roundedRectangle(1.4 * w, 1.4 * w, 0.15 * w, d.steps / 3 + 1), 0.0,
                            glm::length(b - a), 0.1 * w * d.chamfer);
      });
    } else {
      tube(body, look.main, dvec3(0.0), o, 0.7 * w, 0.6 * w);
    }
    if (stations[k].slides && std::abs(stations[k].axis_P.z) > 0.5) {
      // A mast that slides through its carriage.
      const kinematics::Joint& own = model.joints[k];
      const double sign = stations[k].axis_P.z > 0 ? 1.0 : -1.0;
      const double up = sign > 0 ? -own.lower : own.upper;
      body.add(kMetal, {}, [&](const Detail& d) {
        return solid::prism(solid::roundedRectangle(0.9 * w, 0.9 * w, 0.1 * w, d.steps / 3 + 1), std::min(0.0, o.z),
                            up + 1.5 * w, 0.08 * w * d.chamfer);
      });
    }
  }
  body.link(stations.back().parent);
  body.add(kMetal, solid::along({}, stations.back().X_PJ.p + dvec3(0, 0, 1e-6)), [&](const Detail& d) {
    return solid::cylinder(0.45 * w, -0.5 * w, std::max(0.2 * w, glm::length(stations.back().X_PJ.p)),
                           0.05 * w * d.chamfer, d.segments);
  });
}

void addDeltaBody(RobotModel& model, const kinematics::DeltaGeometry& g, double tool_length, const RobotLook& look) {
  BodyMaker body(model);
  const double s = g.upper_arm, up = g.upward ? -1.0 : 1.0;
  const kinematics::DeltaKinematics delta(g);
  body.link(0);
  const double plate = g.base_radius + 0.16 * s;
  body.add(look.main, {}, [&](const Detail& d) {
    const double z0 = up > 0 ? 0.10 * s : -0.26 * s, z1 = up > 0 ? 0.26 * s : -0.10 * s;
    return solid::cylinder(plate, z0, z1, 0.04 * s * d.chamfer, d.segments);
  });
  body.add(look.second, {}, [&](const Detail& d) {
    const double z0 = up > 0 ? 0.24 * s : -0.42 * s, z1 = up > 0 ? 0.42 * s : -0.24 * s;
    return solid::cylinder(0.6 * plate, z0, z1, 0.05 * s * d.chamfer, d.segments);
  });
  for (int k = 0; k < 3; ++k) {
    const dvec3 out = delta.outward(k), side = glm::cross(dvec3(0, 0, 1), out), axle = g.base_radius * out;
    body.add(look.second, solid::along(axle, side), [&](const Detail& d) {
      return solid::cylinder(0.085 * s, -0.22 * s, 0.22 * s, 0.012 * s * d.chamfer, d.segments);
    });
    body.add(look.main, solid::along(axle - 0.02 * s * up * dvec3(0, 0, 1), up * dvec3(0, 0, 1)), [&](const Detail& d) {
      return solid::prism(solid::roundedRectangle(0.16 * s, 0.16 * s, 0.03 * s, d.steps / 3 + 1), 0.0, 0.14 * s, 0.0);
    });
    body.link("arm_" + std::to_string(k + 1));
    tube(body, look.main, {0.02 * s, 0, 0}, {s, 0, 0}, 0.065 * s, 0.04 * s);
    const double half = 0.5 * std::max(g.rod_spacing, 0.06 * s);
    body.add(look.second, solid::alongY({s, 0, 0}), [&](const Detail& d) {
      return solid::cylinder(0.028 * s, -half, half, 0.004 * s * d.chamfer, d.segments);
    });
    for (const char* rod : {"a", "b"}) {
      body.link("rod_" + std::to_string(k + 1) + rod);
      tube(body, look.second, {0.03 * s, 0, 0}, {g.lower_arm - 0.03 * s, 0, 0}, 0.014 * s, 0.014 * s);
      for (const double x : {0.0, g.lower_arm}) {
        body.add(kMetal, Pose::translation({x, 0, 0}),
                 [&](const Detail& d) { return solid::capsule(0.026 * s, 0.026 * s, -1e-4, 1e-4, d.segments); });
      }
    }
    body.link(0);
  }
  body.link("platform");
  for (int k = 0; k < 3; ++k) {
    const dvec3 out = delta.outward(k), side = glm::cross(dvec3(0, 0, 1), out);
    tube(body, kMetal, dvec3(0.0), g.platform_radius * out, 0.05 * s, 0.03 * s);
    const double half = 0.5 * std::max(g.rod_spacing, 0.06 * s);
    tube(body, kMetal, g.platform_radius * out - half * side, g.platform_radius * out + half * side, 0.022 * s,
         0.022 * s);
  }
  const double tip = up > 0 ? -tool_length : tool_length;
  body.add(look.second, {}, [&](const Detail& d) {
    const double far = std::abs(tip) < 0.04 * s ? tip : 0.9 * tip;
    const double z0 = std::min({far, -0.03 * s}), z1 = std::max({far, 0.03 * s});
    return solid::cylinder(std::min(0.09 * s, 0.8 * g.platform_radius), z0, z1, 0.01 * s * d.chamfer, d.segments);
  });
}

void addHexapodBody(RobotModel& model, const kinematics::HexapodGeometry& g, double tool_length,
                    const RobotLook& look) {
  BodyMaker body(model);
  double base = 0.0, top = 0.0, longest = 0.0, floor = 0.0, ceiling = 0.0;
  for (std::size_t i = 0; i < 6; ++i) {
    base = std::max(base, glm::length(g.p_BA[i] * dvec3(1, 1, 0)));
    top = std::max(top, glm::length(g.p_PC[i] * dvec3(1, 1, 0)));
    floor += g.p_BA[i].z / 6.0;
    ceiling += g.p_PC[i].z / 6.0;
  }
  for (const double length : model.home) longest = std::max(longest, length);
  const double w = 0.035 * longest * look.bulk;
  body.link(0);
  body.add(look.main, {}, [&](const Detail& d) {
    return solid::cylinder(1.12 * base, floor - 2.4 * w, floor - 1.2 * w, 0.2 * w * d.chamfer, d.segments);
  });
  for (const dvec3& p : g.p_BA) {
    body.add(look.second, Pose::translation(p), [&](const Detail& d) {
      return solid::cylinder(0.9 * w, -1.3 * w, -0.35 * w, 0.1 * w * d.chamfer, d.segments);
    });
  }
  for (std::size_t i = 0; i < 6; ++i) {
    const std::string leg = "leg_" + std::to_string(i + 1);
    const kinematics::Joint& slide = model.joints[static_cast<std::size_t>(model.moving[i])];
    const double sleeve = 0.62 * std::min(slide.lower, model.home[i]);
    body.link(leg + "_lower");
    body.add(kMetal, {}, [&](const Detail& d) { return solid::capsule(0.75 * w, 0.75 * w, -1e-4, 1e-4, d.segments); });
    body.add(look.second, {}, [&](const Detail& d) {
      return solid::cylinder(0.85 * w, 0.6 * w, sleeve, 0.1 * w * d.chamfer, d.segments);
    });
    body.link(leg + "_upper");
    body.add(kMetal, {}, [&](const Detail& d) {
      return solid::cylinder(0.5 * w,
                             -(slide.upper - 0.5 * sleeve) < -slide.lower + 0.7 * w ? -slide.lower + 0.7 * w
                                                                                    : -(slide.upper - 0.5 * sleeve),
                             0.0, 0.05 * w * d.chamfer, d.segments);
    });
    body.add(kMetal, {}, [&](const Detail& d) { return solid::capsule(0.75 * w, 0.75 * w, -1e-4, 1e-4, d.segments); });
  }
  body.link("platform");
  body.add(look.main, {}, [&](const Detail& d) {
    return solid::cylinder(1.12 * top, ceiling + 1.2 * w, std::max(ceiling + 2.2 * w, tool_length), 0.2 * w * d.chamfer,
                           d.segments);
  });
  for (const dvec3& p : g.p_PC) {
    body.add(look.second, Pose::translation(p), [&](const Detail& d) {
      return solid::cylinder(0.9 * w, 0.35 * w, 1.3 * w, 0.1 * w * d.chamfer, d.segments);
    });
  }
}

}  // namespace hapticell::workcell
