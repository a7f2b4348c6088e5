// SPDX-License-Identifier: Apache-2.0
#include "bench/kdl_peer.h"

#include <cstdio>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainiksolverpos_nr_jl.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>
#include <string>

#include "bench/kdl_chain.h"

namespace hapticell::bench {

using namespace kinematics;

void kdlFromMiddle(const char* robot, const RobotModel& model, int count) {
  const KDL::Chain chain = chainOf(model, model.defaultTip());
  const unsigned n = chain.getNrOfJoints();
  KDL::JntArray lower(n), upper(n), middle(n), q(n);
  for (unsigned i = 0; i < n; ++i) {
    const Joint& joint = model.joints[static_cast<std::size_t>(model.moving[i])];
    lower(i) = joint.lower;
    upper(i) = joint.upper;
    middle(i) = 0.5 * (joint.lower + joint.upper);
  }
  KDL::ChainFkSolverPos_recursive forward(chain);
  KDL::ChainIkSolverVel_pinv velocity(chain);
  KDL::ChainIkSolverPos_NR_JL newton(chain, lower, upper, forward, velocity, 100, 1e-6);
  KDL::ChainIkSolverPos_LMA levenberg(chain);
  const std::vector<ReachedPose> poses = reachedPoses(model, count);
  for (const bool lma : {false, true}) {
    std::vector<double> ns;
    int solved = 0;
    for (const ReachedPose& pose : poses) {
      const KDL::Frame target = frameOf(pose.X_BT);
      int status = 0;
      ns.push_back(
          timed([&] { status = lma ? levenberg.CartToJnt(middle, target, q) : newton.CartToJnt(middle, target, q); }));
      bool within = status >= 0;
      for (unsigned i = 0; i < n; ++i) within = within && q(i) >= lower(i) && q(i) <= upper(i);
      solved += within ? 1 : 0;
    }
    std::printf("%-8s KDL %s, one shot: %.3f %% within limits;  ", robot, lma ? "LMA" : "NR_JL",
                100.0 * solved / count);
    print("", "", ns);
  }
}

}  // namespace hapticell::bench
