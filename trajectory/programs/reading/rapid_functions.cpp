// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/reading/rapid_functions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trajectory/motion/csv_table.h"
#include "trajectory/programs/reading/rapid_records.h"
#include "trajectory/programs/reading/robot_angles.h"

namespace hapticell::trajectory {

namespace {

Value unknownResult(const std::string& name, const std::vector<Argument>& given) {
  for (const Argument& argument : given)
    if (Text why = argument.value.whyUnknown(); !why.empty() && !argument.value.isKnown()) return Value::unknown(why);
  return Value::unknown(Text("the result of '%1'", name));
}

Value ofNumber(const std::string& name, double a, const std::vector<Argument>& given) {
  if (name == "abs") return Value::of(std::abs(a));
  if (name == "sqrt" && a >= 0.0) return Value::of(std::sqrt(a));
  if (name == "sin") return Value::of(std::sin(a * kRapidDegree));
  if (name == "cos") return Value::of(std::cos(a * kRapidDegree));
  if (name == "tan") return Value::of(std::tan(a * kRapidDegree));
  if (name == "acos") return Value::of(std::acos(std::clamp(a, -1.0, 1.0)) / kRapidDegree);
  if (name == "asin") return Value::of(std::asin(std::clamp(a, -1.0, 1.0)) / kRapidDegree);
  if (name == "atan") return Value::of(std::atan(a) / kRapidDegree);
  if (name == "atan2" && rapidNumberAt(given, 1))
    return Value::of(std::atan2(a, *rapidNumberAt(given, 1)) / kRapidDegree);
  if (name == "pow" && rapidNumberAt(given, 1)) return Value::of(std::pow(a, *rapidNumberAt(given, 1)));
  if (name == "trunc" && given.size() == 1) return Value::of(std::trunc(a));
  if (name == "round" && given.size() == 1) return Value::of(std::round(a));
  return unknownResult(name, given);
}

}  // namespace

Value rapidWord(const std::string& name) {
  if (name == "tool0" || name == "wobj0") {
    const Value none =
        Value::list("pose", {Value::list("pos", {0.0, 0.0, 0.0}), Value::list("orient", {1.0, 0.0, 0.0, 0.0})});
    if (name == "tool0") return Value::list("tooldata", {Value::truth(true), none});
    return Value::list("wobjdata", {Value::truth(false), Value::truth(true), Value::word(""), none, none});
  }
  if (name == "pi") return Value::of(std::numbers::pi);
  if (name == "vmax") return Value::list("speeddata", {7000.0, 500.0, 5000.0, 1000.0});
  if (name.size() > 1 && name.front() == 'v' && name.find_first_not_of("0123456789", 1) == std::string::npos)
    return Value::list("speeddata", {parseNumber(name.substr(1)).value_or(0.0), 500.0, 5000.0, 1000.0});
  return Value::unknown(Text("'%1', which the file does not define", name));
}

std::optional<double> rapidNumberAt(const std::vector<Argument>& given, std::size_t i) {
  if (i >= given.size() || !given[i].value.isNumber()) return std::nullopt;
  return given[i].value.number;
}

Value rapidFunction(const std::string& name, const std::vector<Argument>& given, const std::optional<Pose>& here) {
  if (name == "crobt") {
    return here ? rapidTarget(*here, {}) : Value::unknown(Text("the current position of the robot"));
  }
  if (given.empty()) return unknownResult(name, given);
  const Value& first = given.front().value;
  const auto x = rapidNumberAt(given, 1), y = rapidNumberAt(given, 2), z = rapidNumberAt(given, 3);
  if (name == "offs" || name == "reltool") {
    const auto X = rapidPose(first);
    if (!X || !x || !y || !z) return unknownResult(name, given);
    const dvec3 step = kRapidMillimetre * dvec3(*x, *y, *z);
    if (name == "offs") return rapidTarget({X->p + step, X->q}, first);
    dvec3 turn(0.0);
    for (const Argument& argument : given) {
      if (argument.name.size() != 2 || argument.name[0] != 'r' || argument.name[1] < 'x' || argument.name[1] > 'z')
        continue;
      if (!argument.value.isNumber()) return unknownResult(name, given);
      turn[argument.name[1] - 'x'] = argument.value.number;
    }
    // About x, then the new y, then the new z of the tool.
    return rapidTarget(*X * Pose{step, fromStaubliAngles(turn)}, first);
  }
  if (name == "orientzyx" && rapidNumberAt(given, 0) && x && y) {
    const dquat q = fromKukaAngles({first.number, *x, *y});
    return Value::list("orient", {q.w, q.x, q.y, q.z});
  }
  if (name == "posemult" || name == "poseinv") {
    const auto A = rapidPose(first);
    const auto B = given.size() > 1 ? rapidPose(given[1].value) : std::optional<Pose>(Pose::identity());
    if (!A || !B) return unknownResult(name, given);
    Value pose = rapidTarget(name == "posemult" ? *A * *B : A->inverse(), Value::list("pose", std::vector<Value>(2)));
    pose.text = "pose";
    return pose;
  }
  if (name == "dim" && first.kind == Value::Kind::kList) return Value::of(static_cast<double>(first.items.size()));
  if (first.isNumber()) return ofNumber(name, first.number, given);
  return unknownResult(name, given);
}

}  // namespace hapticell::trajectory
