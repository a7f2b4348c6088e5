// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "workcell/robots/robot_body.h"

namespace hapticell::workcell {

namespace {

using Detail = BodyMaker::Detail;
using kinematics::OpwParameters;

/// The proportions of one arm; s is half its stretched length.
struct ArmMaker {
  BodyMaker& body;
  const OpwParameters& p;
  const RobotLook& look;
  double s, base, waist;
  PaintColor metal{0.55f, 0.57f, 0.60f, 1.0f};

  ArmMaker(BodyMaker& maker, const OpwParameters& parameters, const RobotLook& wanted)
      : body(maker), p(parameters), look(wanted), s(0.5 * (p.c2 + p.c3) * wanted.bulk) {
    base = std::min(0.30 * s, 0.75 * p.c1);
    waist = std::clamp(p.c1 - 0.34 * s, 0.25 * p.c1, 0.6 * p.c1);
  }

  void plate() {
    body.link("base_link");
    body.add(look.second, {}, [&](const Detail& d) {
      return solid::prism(solid::roundedRectangle(2.5 * base, 2.3 * base, 0.25 * base, d.steps / 2 + 1), 0.0, 0.05 * s,
                          0.008 * s * d.chamfer);
    });
    body.add(look.round ? look.main : look.second, {}, [&](const Detail& d) {
      const double top = waist - 0.008 * s;
      return solid::lathe({{0, 0.045 * s},
                           {1.08 * base, 0.045 * s},
                           {0.98 * base, 0.35 * top},
                           {0.88 * base, 0.75 * top},
                           {0.95 * base, 0.9 * top},
                           {0.95 * base, top},
                           {0, top}},
                          d.segments);
    });
    body.add(look.second, {}, [&](const Detail& d) {
      return solid::box({-1.45 * base, -0.42 * base, 0.06 * s},
                        {-0.7 * base, 0.42 * base, std::min(0.8 * waist, 0.24 * s)}, 0.012 * s * d.chamfer);
    });
    for (const double x : {-1.05, 1.05}) {
      for (const double y : {-0.95, 0.95}) {
        body.decorate(metal, Pose::translation({x * base, y * base, 0.048 * s}), [&](const Detail& d) {
          return solid::cylinder(0.075 * base, 0.0, 0.03 * s, 0.004 * s, d.segments / 2);
        });
      }
    }
    for (const double y : {-0.22, 0.0, 0.22}) {
      body.decorate(metal, solid::alongX({-1.45 * base - 0.02 * s, y * base, 0.13 * s}), [&](const Detail& d) {
        return solid::cylinder(0.07 * base, 0.0, 0.03 * s, 0.003 * s, d.segments / 2);
      });
    }
  }

  void column() {
    body.link("link_1");
    const double shoulder = 0.21 * s;
    body.add(look.main, {}, [&](const Detail& d) {
      return solid::lathe(
          {{0, waist}, {base, waist}, {base, waist + 0.07 * s}, {0.86 * base, waist + 0.12 * s}, {0, waist + 0.12 * s}},
          d.segments);
    });
    body.add(look.main, solid::upright(), [&](const Detail& d) {
      return solid::prism(solid::belt({-0.02 * s, waist + 0.12 * s}, 0.72 * base, {p.a1, p.c1}, shoulder, d.steps),
                          -0.07 * s, 0.15 * s, 0.018 * s * d.chamfer);
    });
    // Motor of axis 2, and that of axis 1 upright behind the column.
    body.add(look.second, solid::alongY({p.a1, 0, p.c1}), [&](const Detail& d) {
      return solid::cylinder(0.72 * shoulder, -0.33 * s, -0.13 * s, 0.012 * s * d.chamfer, d.segments);
    });
    if (!look.round) {
      body.add(look.second, Pose::translation({-0.62 * base, -0.3 * base, 0}), [&](const Detail& d) {
        return solid::cylinder(0.26 * base, waist + 0.06 * s, waist + 0.42 * s, 0.01 * s * d.chamfer, d.segments);
      });
      body.decorate(metal, Pose::translation({-0.62 * base, -0.3 * base, 0}), [&](const Detail& d) {
        return solid::cylinder(0.2 * base, waist + 0.41 * s, waist + 0.45 * s, 0.008 * s, d.segments);
      });
    }
    body.decorate(metal, solid::alongY({p.a1, 0, p.c1}), [&](const Detail& d) {
      return solid::cylinder(0.5 * shoulder, -0.355 * s, -0.32 * s, 0.008 * s, d.segments);
    });
    if (look.balanced) {
      body.add(look.main, solid::along({p.a1 - 0.30 * s, -0.17 * s, p.c1 + 0.05 * s}, {-0.94, 0, 0.34}),
               [&](const Detail& d) {
                 return solid::cylinder(0.085 * s, -0.12 * s, 0.48 * s, 0.02 * s * d.chamfer, d.segments);
               });
    }
  }

  void upperArm() {
    body.link("link_2");
    const double low = 0.19 * s, high = 0.155 * s;
    body.add(look.main, solid::upright(), [&](const Detail& d) {
      return solid::prism(solid::belt({0, 0}, low, {0, p.c2}, high, d.steps), -0.215 * s, -0.09 * s,
                          0.022 * s * d.chamfer);
    });
    // The hubs that reach inwards to the column and the elbow.
    for (const double z : {0.0, p.c2}) {
      body.add(look.second, solid::alongY({0, 0, z}), [&](const Detail& d) {
        return solid::cylinder(z > 0 ? 0.82 * high : 0.82 * low, 0.068 * s, 0.1 * s, 0.0, d.segments);
      });
      body.decorate(look.second, solid::alongY({0, 0, z}), [&](const Detail& d) {
        return solid::cylinder(z > 0 ? 0.62 * high : 0.62 * low, 0.21 * s, 0.235 * s, 0.008 * s, d.segments);
      });
    }
    if (!look.round) {
      body.decorate(look.second, solid::upright(), [&](const Detail& d) {
        return solid::prism(solid::belt({0, 0.27 * p.c2}, 0.38 * low, {0, 0.74 * p.c2}, 0.38 * high, d.steps),
                            -0.2225 * s, -0.21 * s, 0.003 * s);
      });
    }
  }

  void elbow() {
    body.link("link_3");
    const double r = 0.145 * s;
    const glm::dvec2 middle(p.a2, 0.10 * s);
    body.add(look.main, solid::upright(), [&](const Detail& d) {
      return solid::prism(solid::belt({0, 0}, r, middle, 0.92 * r, d.steps), -0.085 * s, 0.13 * s,
                          0.018 * s * d.chamfer);
    });
    const double neck = std::min(0.30 * p.c3, 0.36 * s);
    body.add(look.main, Pose::translation({p.a2, p.b, 0}), [&](const Detail& d) {
      return solid::lathe({{0, 0.02 * s},
                           {0.125 * s, 0.02 * s},
                           {0.125 * s, 0.7 * neck},
                           {0.112 * s, neck - 0.004 * s},
                           {0, neck - 0.004 * s}},
                          d.segments);
    });
    if (look.round) {
      body.add(look.main, Pose::translation({p.a2, p.b, 0}),
               [&](const Detail& d) { return solid::capsule(0.12 * s, 0.12 * s, -0.06 * s, 0.05 * s, d.segments); });
      return;
    }
    const double motor = 0.056 * s;
    for (const auto& [x, y] : {std::pair{0.02, -0.07}, std::pair{0.02, 0.07}, std::pair{-0.075, 0.0}}) {
      body.add(look.second, Pose::translation({p.a2 + x * s, p.b + y * s, 0}), [&](const Detail& d) {
        return solid::cylinder(motor, -0.36 * s, -0.02 * s, 0.008 * s * d.chamfer, d.segments);
      });
      body.decorate(metal, Pose::translation({p.a2 + x * s, p.b + y * s, 0}), [&](const Detail& d) {
        return solid::cylinder(0.75 * motor, -0.385 * s, -0.35 * s, 0.006 * s, d.segments);
      });
    }
  }

  void forearm() {
    body.link("link_4");
    const double neck = std::min(0.30 * p.c3, 0.36 * s), r = 0.105 * s;
    const double fork = 0.065 * s + 0.5 * wristRadius(), start = p.c3 - 2.6 * wristRadius();
    body.add(look.main, {}, [&](const Detail& d) {
      return solid::lathe(
          {{0, neck}, {r, neck}, {r, neck + 0.1 * s}, {0.82 * r, 0.5 * (neck + start)}, {0.86 * r, start}, {0, start}},
          d.segments);
    });
    const double thick = 0.42 * wristRadius();
    for (const double side : {-1.0, 1.0}) {
      body.add(look.main, solid::upright({0, side * fork, 0}), [&](const Detail& d) {
        return solid::prism(solid::belt({0, start - 0.02 * s}, 0.95 * wristRadius(), {0, p.c3}, wristRadius(), d.steps),
                            -0.5 * thick, 0.5 * thick, 0.1 * thick * d.chamfer);
      });
      body.decorate(look.second, solid::alongY({0, side * (fork + 0.5 * thick), p.c3}), [&](const Detail& d) {
        return solid::cylinder(0.75 * wristRadius(), -0.08 * thick, 0.3 * thick, 0.05 * thick, d.segments);
      });
    }
    body.decorate(look.second, {}, [&](const Detail& d) {
      return solid::cylinder(1.03 * r, neck + 0.02 * s, neck + 0.05 * s, 0.004 * s, d.segments);
    });
  }

  double wristRadius() const { return std::clamp(0.088 * s, 0.2 * p.c4, 0.8 * p.c4); }

  void wrist() {
    body.link("link_5");
    const double r = wristRadius(), half = 0.065 * s + 0.25 * r;
    body.add(look.second, solid::alongY(),
             [&](const Detail& d) { return solid::cylinder(0.9 * r, -half, half, 0.1 * r * d.chamfer, d.segments); });
    body.add(look.second, {}, [&](const Detail& d) {
      return solid::cylinder(0.8 * r, 0.0, std::max(0.75 * p.c4, p.c4 - 0.035 * s), 0.06 * r * d.chamfer, d.segments);
    });
    body.link("link_6");
    const double start = std::max(0.75 * p.c4, p.c4 - 0.035 * s);
    body.add(metal, {},
             [&](const Detail& d) { return solid::cylinder(0.72 * r, start, p.c4, 0.05 * r * d.chamfer, d.segments); });
    for (int k = 0; k < 6; ++k) {
      const double angle = std::numbers::pi / 3.0 * k;
      body.decorate(look.second, Pose::translation({0.52 * r * std::cos(angle), 0.52 * r * std::sin(angle), p.c4}),
                    [&](const Detail&) { return solid::cylinder(0.07 * r, -0.01 * s, 0.001, 0.0, 10); });
    }
  }
};

}  // namespace

void addArmBody(kinematics::RobotModel& model, const OpwParameters& parameters, const RobotLook& look) {
  BodyMaker body(model);
  ArmMaker arm(body, parameters, look);
  arm.plate();
  arm.column();
  arm.upperArm();
  arm.elbow();
  arm.forearm();
  arm.wrist();
}

}  // namespace hapticell::workcell
