// SPDX-License-Identifier: Apache-2.0
#include "fastdds_controller.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <fastdds/rtps/common/WriteParams.h>
#include <sstream>
#include <thread>
#include <vector>

#include "ros2_messagesPubSubTypes.h"

using namespace eprosima::fastdds::dds;
namespace act = control_msgs::action::dds_;
namespace srv = action_msgs::srv::dds_;
namespace num = hapticell::numbered;

namespace {

using Clock = std::chrono::steady_clock;
using Identity = eprosima::fastrtps::rtps::SampleIdentity;
using Uuid = unique_identifier_msgs::msg::dds_::UUID_;

enum Status : int { kAccepted = 1, kExecuting = 2, kCanceling = 3, kSucceeded = 4, kCanceled = 5, kAborted = 6 };

template <typename Support>
Topic* topicOf(DomainParticipant* participant, const std::string& topic, const std::string& type_name) {
  TypeSupport type(new Support());
  const std::string name = type_name.empty() ? type.get_type_name() : type_name;
  type.register_type(participant, name);
  return participant->create_topic(topic, name, TOPIC_QOS_DEFAULT);
}

DataWriter* writerOf(DomainParticipant* participant, Topic* topic, bool latched = false) {
  DataWriterQos qos = DATAWRITER_QOS_DEFAULT;
  qos.reliability().kind = RELIABLE_RELIABILITY_QOS;
  qos.durability().kind = latched ? TRANSIENT_LOCAL_DURABILITY_QOS : VOLATILE_DURABILITY_QOS;
  return participant->create_publisher(PUBLISHER_QOS_DEFAULT)->create_datawriter(topic, qos);
}

/// A service: the content of requests, and replies to them.
template <typename Request, typename RequestSupport, typename Response, typename ResponseSupport, typename NumberedRequest,
          typename NumberedRequestSupport, typename NumberedResponse, typename NumberedResponseSupport>
class Service {
 public:
  struct Asker {
    Identity identity;
    std::uint64_t client = 0;
    std::int64_t number = 0;
  };

  Service(DomainParticipant* participant, const std::string& service, bool numbered) : numbered_(numbered) {
    const std::string request = RequestSupport().getName(), response = ResponseSupport().getName();
    const std::string asked = "rq" + service + "Request", answered = "rr" + service + "Reply";
    Topic* const in = numbered ? topicOf<NumberedRequestSupport>(participant, asked, request)
                               : topicOf<RequestSupport>(participant, asked, request);
    Topic* const out = numbered ? topicOf<NumberedResponseSupport>(participant, answered, response)
                                : topicOf<ResponseSupport>(participant, answered, response);
    DataReaderQos qos = DATAREADER_QOS_DEFAULT;
    qos.reliability().kind = RELIABLE_RELIABILITY_QOS;
    reader_ = participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT)->create_datareader(in, qos);
    writer_ = writerOf(participant, out);
  }

  bool take(Request& request, Asker& asker) {
    SampleInfo info;
    if (!numbered_) {
      if (reader_->take_next_sample(&request, &info) != ReturnCode_t::RETCODE_OK || !info.valid_data) return false;
    } else {
      NumberedRequest whole;
      if (reader_->take_next_sample(&whole, &info) != ReturnCode_t::RETCODE_OK || !info.valid_data) return false;
      request = whole.content();
      asker.client = whole.client();
      asker.number = whole.number();
    }
    asker.identity = info.sample_identity;
    return true;
  }

  void answer(const Asker& asker, const Response& response) {
    eprosima::fastrtps::rtps::WriteParams parameters;
    parameters.related_sample_identity(asker.identity);
    if (!numbered_) {
      Response copy = response;
      writer_->write(&copy, parameters);
      return;
    }
    NumberedResponse whole;
    whole.client(asker.client);
    whole.number(asker.number);
    whole.content(response);
    writer_->write(&whole, parameters);
  }

 private:
  bool numbered_;
  DataReader* reader_ = nullptr;
  DataWriter* writer_ = nullptr;
};

using SendGoal = Service<act::FollowJointTrajectory_SendGoal_Request_, act::FollowJointTrajectory_SendGoal_Request_PubSubType,
                         act::FollowJointTrajectory_SendGoal_Response_, act::FollowJointTrajectory_SendGoal_Response_PubSubType,
                         num::SendGoalRequest, num::SendGoalRequestPubSubType, num::SendGoalResponse, num::SendGoalResponsePubSubType>;
using GetResult = Service<act::FollowJointTrajectory_GetResult_Request_, act::FollowJointTrajectory_GetResult_Request_PubSubType,
                          act::FollowJointTrajectory_GetResult_Response_, act::FollowJointTrajectory_GetResult_Response_PubSubType,
                          num::GetResultRequest, num::GetResultRequestPubSubType, num::GetResultResponse,
                          num::GetResultResponsePubSubType>;
using CancelGoal = Service<srv::CancelGoal_Request_, srv::CancelGoal_Request_PubSubType, srv::CancelGoal_Response_,
                           srv::CancelGoal_Response_PubSubType, num::CancelGoalRequest, num::CancelGoalRequestPubSubType,
                           num::CancelGoalResponse, num::CancelGoalResponsePubSubType>;

class Controller {
 public:
  Controller(DomainParticipant* participant, const std::string& action, bool numbered, const std::string& joints,
             std::string behaviour)
      : behaviour_(std::move(behaviour)),
        goals_(participant, action + "/_action/send_goal", numbered),
        results_(participant, action + "/_action/get_result", numbered),
        cancels_(participant, action + "/_action/cancel_goal", numbered),
        status_(writerOf(participant, topicOf<action_msgs::msg::dds_::GoalStatusArray_PubSubType>(
                                          participant, "rt" + action + "/_action/status", ""), true)),
        feedback_(writerOf(participant, topicOf<act::FollowJointTrajectory_FeedbackMessage_PubSubType>(
                                            participant, "rt" + action + "/_action/feedback", ""))),
        states_(writerOf(participant, topicOf<sensor_msgs::msg::dds_::JointState_PubSubType>(participant, "rt/joint_states", ""))) {
    std::stringstream list(joints);
    for (std::string joint; std::getline(list, joint, ',');) {
      names_.push_back(joint.substr(0, joint.find('=')));
      positions_.push_back(std::atof(joint.c_str() + joint.find('=') + 1));
    }
  }

  /// Every 10 ms.
  void step(int tick) {
    takeGoals();
    takeCancels();
    move();
    answerResults();
    const bool is_silent = behaviour_ == "silent" && running_ && elapsed() > 0.3;
    if (!is_silent) sayJoints();
    if (running_ && tick % 5 == 0) sayFeedback();
  }

 private:
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

  void takeGoals() {
    act::FollowJointTrajectory_SendGoal_Request_ request;
    SendGoal::Asker asker;
    if (!goals_.take(request, asker)) return;
    goal_ = request;
    say(request);
    act::FollowJointTrajectory_SendGoal_Response_ response;
    if (behaviour_ == "noise") {
      SendGoal::Asker other = asker;
      other.client += 1;
      other.identity.sequence_number().low += 1000;
      goals_.answer(other, response);  // No, to somebody else.
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    response.accepted(behaviour_ != "reject");
    goals_.answer(asker, response);
    if (!response.accepted()) return;
    setStatus(kAccepted);
    if (behaviour_ == "idle") return;
    running_ = true;
    begin_ = Clock::now();
    setStatus(kExecuting);
  }

  void takeCancels() {
    srv::CancelGoal_Request_ request;
    CancelGoal::Asker asker;
    if (!cancels_.take(request, asker)) return;
    const bool is_ours = request.goal_info().goal_id().uuid() == goal_.goal_id().uuid();
    std::printf("{\"cancel\":%d,\"stamp\":%d}\n", int(is_ours), int(request.goal_info().stamp().sec()));
    std::fflush(stdout);
    if (behaviour_ == "deaf" || !is_ours) return;
    srv::CancelGoal_Response_ response;
    response.goals_canceling().push_back(request.goal_info());
    cancels_.answer(asker, response);
    if (number_ != kAccepted && number_ != kExecuting) return;
    setStatus(kCanceling);
    finish(kCanceled, 0, "");
  }

  void move() {
    if (!running_) return;
    const double t = elapsed();
    if (behaviour_ == "abort" && t > 0.3) return finish(kAborted, -4, "A2 left its path");
    const auto& points = goal_.goal().trajectory().points();
    const auto timeOf = [&](std::size_t i) { return points[i].time_from_start().sec() + 1e-9 * points[i].time_from_start().nanosec(); };
    std::size_t i = 0;
    while (i + 2 < points.size() && timeOf(i + 1) < t) ++i;
    const double share = std::min(1.0, std::max(0.0, (t - timeOf(i)) / (timeOf(i + 1) - timeOf(i))));
    for (std::size_t j = 0; j < goal_.goal().trajectory().joint_names().size(); ++j)
      for (std::size_t k = 0; k < names_.size(); ++k)
        if (names_[k] == goal_.goal().trajectory().joint_names()[j])
          positions_[k] = points[i].positions()[j] + share * (points[i + 1].positions()[j] - points[i].positions()[j]);
    if (behaviour_ == "stray" && t > 0.3) positions_[0] += 0.3;
    if (t > timeOf(points.size() - 1) + 0.05) finish(kSucceeded, 0, "");
  }

  void finish(int status, int code, const std::string& error) {
    running_ = false;
    result_.status(static_cast<std::int8_t>(status));
    result_.result().error_code(code);
    result_.result().error_string(error);
    setStatus(status);
  }

  void answerResults() {
    act::FollowJointTrajectory_GetResult_Request_ request;
    GetResult::Asker asker;
    if (!results_.take(request, asker)) return;
    if (request.goal_id().uuid() == goal_.goal_id().uuid()) results_.answer(asker, result_);
  }

  void setStatus(int number) {
    number_ = number;
    action_msgs::msg::dds_::GoalStatusArray_ statuses;
    if (behaviour_ == "noise") {
      action_msgs::msg::dds_::GoalStatus_ other;
      other.goal_info().goal_id().uuid()[3] = 7;
      other.status(kAborted);
      statuses.status_list().push_back(other);
    }
    action_msgs::msg::dds_::GoalStatus_ own;
    own.goal_info().goal_id(goal_.goal_id());
    own.status(static_cast<std::int8_t>(number));
    statuses.status_list().push_back(own);
    status_->write(&statuses);
    std::printf("{\"state\":%d}\n", number);
    std::fflush(stdout);
  }

  void sayJoints() {
    sensor_msgs::msg::dds_::JointState_ state;
    state.name(names_);
    state.position(positions_);
    states_->write(&state);
  }

  void sayFeedback() {
    act::FollowJointTrajectory_FeedbackMessage_ message;
    message.goal_id(goal_.goal_id());
    message.feedback().joint_names(names_);
    message.feedback().actual().positions(positions_);
    feedback_->write(&message);
  }

  void say(const act::FollowJointTrajectory_SendGoal_Request_& request) {
    const auto& goal = request.goal();
    std::printf("{\"goal\":{\"joints\":[");
    for (std::size_t j = 0; j < goal.trajectory().joint_names().size(); ++j)
      std::printf("%s\"%s\"", j ? "," : "", goal.trajectory().joint_names()[j].c_str());
    std::printf("],\"rest\":%zu,\"version\":%d,\"points\":[",
                goal.multi_dof_trajectory().points().size() + goal.path_tolerance().size() + goal.goal_tolerance().size() +
                    goal.component_path_tolerance().size() + goal.component_goal_tolerance().size() +
                    std::size_t(goal.goal_time_tolerance().sec()) + goal.trajectory().header().stamp().nanosec(),
                request.goal_id().uuid()[6] >> 4);
    for (std::size_t i = 0; i < goal.trajectory().points().size(); ++i) {
      const auto& point = goal.trajectory().points()[i];
      std::printf("%s[%.9f", i ? "," : "", point.time_from_start().sec() + 1e-9 * point.time_from_start().nanosec());
      for (const double q : point.positions()) std::printf(",%.17g", q);
      for (const double v : point.velocities()) std::printf(",%.17g", v);
      std::printf("]");
    }
    std::printf("]}}\n");
    std::fflush(stdout);
  }

  std::string behaviour_;
  SendGoal goals_;
  GetResult results_;
  CancelGoal cancels_;
  DataWriter *status_, *feedback_, *states_;
  std::vector<std::string> names_;
  std::vector<double> positions_;
  act::FollowJointTrajectory_SendGoal_Request_ goal_;
  act::FollowJointTrajectory_GetResult_Response_ result_;
  Clock::time_point begin_;
  bool running_ = false;
  int number_ = 0;
};

}  // namespace

int playController(DomainParticipant* participant, const std::string& action, const std::string& form, double seconds,
                   const std::string& joints, const std::string& behaviour) {
  Controller controller(participant, action, form == "numbered", joints, behaviour);
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  for (int tick = 0; Clock::now() < end; ++tick) {
    controller.step(tick);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return 0;
}
