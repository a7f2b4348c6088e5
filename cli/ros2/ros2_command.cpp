// SPDX-License-Identifier: Apache-2.0
#include "cli/ros2/ros2_command.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/kit/result_writer.h"
#include "cli/ros2/package_command.h"
#include "cli/ros2/ros_words.h"
#include "cli/ros2/send_command.h"
#include "haptic/client/server_address.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;

struct PublishWords {
  RosWords ros;
  double seconds = 10.0;
  std::string workcell, entity, motion, server, trajectory, meshes;
  double rate = 100.0, wait = 5.0;
  bool clock = false, repeat = false, contacts = false;
};

struct ListenWords {
  RosWords ros;
  double seconds = 10.0;
  std::string output, trajectory, description, workcell, entity, mirror;
  bool objects = false;
  std::string joint_topic = "/joint_states", trajectory_topic = "/joint_trajectory";
  std::string description_topic = "/robot_description";
};

struct TopicsWords {
  RosWords ros;
  double seconds = 3.0;
};

ExitStatus runBridge(ordered_json job, const RosWords& words, double seconds, const ResultWriter& writer) {
  job["seconds"] = seconds;
  const auto answer = bridgeResult(std::move(job), words);
  if (!answer) {
    report(answer.error());
    return ExitStatus::kBadInput;
  }
  if (!*answer) return ExitStatus::kBadInput;  // Its sentence is on standard error already.
  if (const auto written = writer.write(**answer); !written) {
    report(written.error());
    return ExitStatus::kBadInput;
  }
  return ExitStatus::kDone;
}

ExitStatus runPublish(const PublishWords& words, const ResultWriter& writer) {
  if (!words.server.empty()) {
    if (const auto address = haptic::parseServerAddress(words.server, "--server"); !address) {
      report(address.error());
      return ExitStatus::kBadInput;
    }
  }
  return runBridge({{"do", "publish"},
                    {"workcell", words.workcell},
                    {"entity", words.entity},
                    {"motion", words.motion},
                    {"server", words.server},
                    {"trajectory", words.trajectory},
                    {"meshes", words.meshes},
                    {"rate", words.rate},
                    {"wait", words.wait},
                    {"clock", words.clock},
                    {"contacts", words.contacts},
                    {"repeat", words.repeat}},
                   words.ros, words.seconds, writer);
}

ExitStatus runListen(const ListenWords& words, const ResultWriter& writer) {
  const bool has_content = !words.entity.empty() || words.objects;
  if (words.mirror.empty() != words.workcell.empty() || words.mirror.empty() == has_content) {
    report({"", "--mirror", "--workcell, --mirror and --entity or --objects are not all given", "all of them, or none", ""});
    return ExitStatus::kBadInput;
  }
  return runBridge({{"do", "listen"},
                    {"output", words.output},
                    {"trajectory", words.trajectory},
                    {"description", words.description},
                    {"workcell", words.workcell},
                    {"entity", words.entity},
                    {"mirror", words.mirror},
                    {"objects", words.objects},
                    {"joint_topic", words.joint_topic},
                    {"trajectory_topic", words.trajectory_topic},
                    {"description_topic", words.description_topic}},
                   words.ros, words.seconds, writer);
}

ExitStatus runPackage(const PackageWords& words, const ResultWriter& writer) {
  const auto result = writeRosPackage(words);
  const auto written = result ? writer.write(*result) : tl::unexpected(result.error());
  if (written) return ExitStatus::kDone;
  report(written.error());
  return ExitStatus::kBadInput;
}

}  // namespace

void addRos2Command(Subcommand app, Action& chosen) {
  Subcommand command = app.add("ros2", "Exchange robots and motions with programs of ROS 2, without ROS installed");
  command.mustGoOn();
  const auto out = std::make_shared<PublishWords>();
  Subcommand publish = command.add("publish", "Publish a robot of a cell: description, joints, frames, scene, motion");
  publish.option("--workcell", out->workcell, "Workcell document, *.hcell").takes(ValueKind::kWorkcell).required();
  publish.option("--entity", out->entity, "Robot of the cell (default: the only one)");
  publish.option("--motion", out->motion, "Motion of the robot, in any format that is read").takes(ValueKind::kMotion);
  publish.option("--server", out->server, "HOST:PORT of a haptic server; its stylus is published live");
  publish.option("--trajectory", out->trajectory, "Topic that gets the motion once, as a JointTrajectory");
  publish.option("--wait", out->wait, "How long to wait for a reader of that topic, s (5)").within(0.0, 3600.0);
  publish.option("--meshes", out->meshes, "Folder for the robot's meshes (default: removed at the end)")
      .takes(ValueKind::kFolder);
  publish.option("--rate", out->rate, "Messages a second, Hz (100)").within(1.0, 1000.0);
  publish.flag("--repeat", out->repeat, "Play the motion again and again");
  publish.flag("--contacts", out->contacts, "Publish the contacts of the motion as markers");
  publish.flag("--clock", out->clock, "Publish /clock and stamp with times from 0 (use_sim_time)");
  addRosWords(publish, out->ros);
  publish.option("--seconds", out->seconds, "Shortest duration, s (10); 0: until the motion ends or Ctrl+C").within(0.0, 86400.0);
  publish.onChosen([out, &chosen] { chosen = [out](ResultWriter& writer) { return runPublish(*out, writer); }; });

  const auto package = std::make_shared<PackageWords>();
  Subcommand write = command.add("package", "Write a robot of a cell as a package: URDF, SRDF, limits, launch file");
  write.option("--workcell", package->workcell, "Workcell document, *.hcell").takes(ValueKind::kWorkcell).required();
  write.option("--entity", package->entity, "Robot of the cell (default: the only one)");
  write.option("-o,--output", package->output, "New folder; its name is that of the package")
      .takes(ValueKind::kFolder)
      .required();
  write.option("--samples", package->samples, "Random positions for the pairs that need no check (100000)")
      .withinWhole(1, 10'000'000);
  write.onChosen([package, &chosen] { chosen = [package](ResultWriter& writer) { return runPackage(*package, writer); }; });

  const auto in = std::make_shared<ListenWords>();
  Subcommand listen = command.add("listen", "Take joints, motions or a robot's description from ROS 2");
  listen.option("-o,--output", in->output, "Motion to write from the joint states that come: .htraj or .csv")
      .takes(ValueKind::kMotion);
  listen.option("--trajectory", in->trajectory, "Motion to write from the first JointTrajectory: .htraj or .csv")
      .takes(ValueKind::kMotion);
  listen.option("--description", in->description, "URDF to write from /robot_description").takes(ValueKind::kFile);
  listen.option("--workcell", in->workcell, "Workcell whose robot takes the last joint states")
      .takes(ValueKind::kWorkcell);
  listen.option("--entity", in->entity, "That robot");
  listen.flag("--objects", in->objects, "Take the collision objects of /planning_scene and /collision_object");
  listen.option("--mirror", in->mirror, "Workcell to write with the received joints and objects").takes(ValueKind::kWorkcell);
  listen.option("--joint-topic", in->joint_topic, "Topic of the joint states (/joint_states)");
  listen.option("--trajectory-topic", in->trajectory_topic, "Topic of the motion (/joint_trajectory)");
  listen.option("--description-topic", in->description_topic, "Topic of the description (/robot_description)");
  addRosWords(listen, in->ros);
  listen.option("--seconds", in->seconds, "How long to listen, s (10)").within(0.0, 86400.0);
  listen.onChosen([in, &chosen] { chosen = [in](ResultWriter& writer) { return runListen(*in, writer); }; });

  const auto search = std::make_shared<TopicsWords>();
  Subcommand topics = command.add("topics", "List the topics of other programs");
  addRosWords(topics, search->ros);
  topics.option("--seconds", search->seconds, "How long to look for them, s (3)").within(0.0, 3600.0);
  topics.onChosen([search, &chosen] {
    chosen = [search](ResultWriter& writer) { return runBridge({{"do", "topics"}}, search->ros, search->seconds, writer); };
  });
  addSendCommand(command, chosen);
}

}  // namespace hapticell::cli
