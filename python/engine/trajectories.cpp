// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <optional>

#include "cli/trajectory/motion_file.h"
#include "geometry/system/atomic_file.h"
#include "python/engine/bindings.h"
#include "python/engine/conversion.h"
#include "python/engine/long_work.h"
#include "trajectory/editing/editing.h"
#include "trajectory/editing/simplification.h"
#include "trajectory/editing/smoothing.h"
#include "trajectory/files/trajectory_io.h"
#include "trajectory/timing/retiming.h"

namespace hapticell::python {

namespace {

using trajectory::PathTolerance;
using trajectory::Trajectory;

Trajectory ofArrays(py::handle times, py::handle poses, py::handle joints, std::vector<std::string> joint_names,
                    std::string name, std::string entity) {
  const std::vector<double> t = numbersOf(times, -1, "times");
  const std::vector<Pose> X_WT = posesOf(poses);
  const Doubles q = joints.is_none() ? Doubles() : doublesOf(joints, "joints");
  const bool fits = joint_names.empty() ? joints.is_none()
                                        : q.ndim() == 2 && static_cast<std::size_t>(q.shape(0)) == t.size() &&
                                              static_cast<std::size_t>(q.shape(1)) == joint_names.size();
  if (X_WT.size() != t.size() || !fits) {
    raise({.place = "trajectory",
           .found = Text("%1 times, %2 poses, %3 joint names", t.size(), X_WT.size(), joint_names.size()),
           .expected = "as many poses as times, and joints of shape (times, joint names)"});
  }
  Trajectory made;
  made.name = std::move(name);
  made.entity = std::move(entity);
  made.joint_names = std::move(joint_names);
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double* const row = q.size() > 0 ? q.data() + i * made.joint_names.size() : nullptr;
    if (made.addFrame({.t = t[i], .X_WT = X_WT[i]}, {row, made.joint_names.size()})) continue;
    raise({.place = Text("times, index %1", i),
           .found = "a time that is not after the one before",
           .expected = "times that increase"});
  }
  return made;
}

py::array_t<double> timesOf(const Trajectory& self) {
  py::array_t<double> times(static_cast<py::ssize_t>(self.size()));
  for (std::size_t i = 0; i < self.size(); ++i) times.mutable_at(i) = self[i].t;
  return times;
}

py::array_t<double> posesOfFrames(const Trajectory& self) {
  std::vector<Pose> poses;
  for (const Trajectory::Frame& frame : self.frames()) poses.push_back(frame.X_WT);
  return arrayOf(poses);
}

/// (frames, columns) of what each frame has.
template <typename RowOf>
py::array_t<double> tableOf(const Trajectory& self, std::size_t columns, const RowOf& row_of) {
  py::array_t<double> table({static_cast<py::ssize_t>(self.size()), static_cast<py::ssize_t>(columns)});
  double* to = table.mutable_data();
  for (std::size_t i = 0; i < self.size(); ++i) to = std::copy_n(row_of(i).begin(), columns, to);
  return table;
}

void saveTrajectory(const Trajectory& self, py::object file) {
  const std::string path = pathOf(file);
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending != ".csv" && ending != ".htraj")
    raise({.file = path,
           .place = "the file's name",
           .found = Text::plain("'" + ending + "'"),
           .expected = ".htraj or .csv"});
  valueOf(writeFileAtomically(path, ending == ".csv" ? toCsvText(self) : toJsonText(self)));
}

Trajectory load(py::object file, const std::string& robot) {
  std::vector<Text> notes;
  const std::string path = pathOf(file);
  auto read = [&] {
    const py::gil_scoped_release unlocked;
    return cli::readMotionFile(path, robot, &notes);
  }();
  tellWarnings(notes);
  return valueOf(std::move(read));
}

PathTolerance toleranceOf(double position, double angle, double joint) {
  if (position > 0.0 && angle > 0.0 && joint > 0.0) return {position, angle, joint};
  raise({.place = "tolerance", .found = "a value that is not above 0", .expected = "metres and radians above 0"});
}

trajectory::Retimed retime(const Trajectory& self, py::handle velocity, py::handle acceleration, py::handle jerk,
                           std::optional<double> speed, double sample) {
  trajectory::RetimingOptions options;
  options.sample_s = sample;
  if (speed) {
    options.mode = trajectory::TimingMode::kConstantSpeed;
    options.speed = *speed;
    if (!acceleration.is_none()) options.acceleration = acceleration.cast<double>();
  } else {
    options.limits.velocity = numbersOf(velocity, -1, "velocity");
    options.limits.acceleration = numbersOf(acceleration, -1, "acceleration");
    if (!jerk.is_none()) options.limits.jerk = numbersOf(jerk, -1, "jerk");
  }
  std::optional<Expected<trajectory::Retimed>> made;
  std::atomic<bool> stop{false};
  options.stop = &stop;
  runLong([&] { made = trajectory::retimed(self, options); }, [&] { stop = true; });
  return valueOf(std::move(*made));
}

void bindData(py::class_<Trajectory>& c) {
  c.def(py::init(&ofArrays), py::arg("times"), py::arg("poses"), py::arg("joints") = py::none(),
        py::arg("joint_names") = std::vector<std::string>(), py::arg("name") = "motion", py::arg("entity") = "")
      .def_static(
          "load", &load, py::arg("file"), py::arg("robot") = "",
          "From .htraj, .csv, a ROS .yaml, or a program (KRL, RAPID, FANUC LS, URScript, INFORM). `robot` (a file or "
          "library:NAME) gives the poses of a program's targets that are given by joints.")
      .def("save", &saveTrajectory, py::arg("file"), "Writes .htraj or .csv; a failure leaves the old file.")
      .def_readwrite("name", &Trajectory::name)
      .def_readwrite("entity", &Trajectory::entity, "Whose motion it is.")
      .def_readonly("joint_names", &Trajectory::joint_names)
      .def_readonly("channel_names", &Trajectory::channel_names)
      .def_readonly("has_poses", &Trajectory::has_poses, "False: only the joints are known.")
      .def_property_readonly("times", &timesOf, "Seconds, shape (frames,).")
      .def_property_readonly("poses", &posesOfFrames, "X_WT, shape (frames, 7).")
      .def_property_readonly(
          "joints",
          [](const Trajectory& self) {
            return tableOf(self, self.joint_names.size(), [&](std::size_t i) { return self.joints(i); });
          },
          "rad or m, shape (frames, joints).")
      .def_property_readonly(
          "channels",
          [](const Trajectory& self) {
            return tableOf(self, self.channel_names.size(), [&](std::size_t i) { return self.channels(i); });
          },
          "What was recorded besides (forces, contact), shape (frames, channels).")
      .def_property_readonly("duration", &Trajectory::duration, "Seconds.")
      .def("__len__", &Trajectory::size)
      .def(
          "pose_at", [](const Trajectory& self, double t) { return arrayOf(self.poseAt(t)); }, py::arg("t"),
          "X_WT at t (s), between frames.")
      .def(
          "joints_at", [](const Trajectory& self, double t) { return arrayOf(self.jointsAt(t)); }, py::arg("t"))
      .def("__repr__", [](const Trajectory& self) {
        return py::str("<Trajectory '{}': {} frames, {:.3f} s>").format(self.name, self.size(), self.duration());
      });
}

void bindCuts(py::class_<Trajectory>& c) {
  c.def(
       "trimmed", [](const Trajectory& s, double t0, double t1) { return valueOf(trajectory::trimmed(s, t0, t1)); },
       py::arg("t0"), py::arg("t1"), "From t0 to t1 (s).")
      .def(
          "split", [](const Trajectory& s, double t) { return valueOf(trajectory::splitAt(s, t)); }, py::arg("t"),
          "Before and after t (s).")
      .def(
          "joined",
          [](const Trajectory& s, const std::vector<Trajectory>& others, double speed) {
            std::vector<Trajectory> parts{s};
            parts.insert(parts.end(), others.begin(), others.end());
            return valueOf(trajectory::joined(parts, speed));
          },
          py::arg("others"), py::arg("speed") = 0.1,
          "This and the others, with straight ways between them at `speed` (m/s).")
      .def(
          "resampled", [](const Trajectory& s, double step) { return valueOf(trajectory::resampled(s, step)); },
          py::arg("step"), "A frame every `step` seconds.")
      .def("reversed", &trajectory::reversed, "Backwards in time.")
      .def(
          "mirrored",
          [](const Trajectory& s, py::handle point, py::handle normal) {
            const dvec3 n = pointOf(normal, "normal");
            if (!(glm::length(n) > 0.0)) raise({.place = "normal", .found = "zero", .expected = "a direction"});
            return trajectory::mirrored(s, pointOf(point, "point"), glm::normalize(n));
          },
          py::arg("point"), py::arg("normal"), "Mirrored on a plane; joints are lost.")
      .def(
          "transformed", [](const Trajectory& s, py::handle pose) { return trajectory::transformed(s, poseOf(pose)); },
          py::arg("pose"), "X_WN * X_WT; joints are lost.")
      .def(
          "without_frames",
          [](const Trajectory& s, std::size_t first, std::size_t last) {
            return valueOf(trajectory::withoutFrames(s, first, last));
          },
          py::arg("first"), py::arg("last"), "Without these frames, both included.");
}

void bindPoints(py::class_<Trajectory>& c) {
  c.def(
       "with_frame",
       [](const Trajectory& s, double t, py::handle pose) {
         return valueOf(trajectory::withFrame(s, t, poseOf(pose)));
       },
       py::arg("t"), py::arg("pose"), "A frame by hand at t (s); joints are lost.")
      .def(
          "with_frame_at",
          [](const Trajectory& s, std::size_t i, py::handle pose, double reach) {
            return valueOf(trajectory::withFrameAt(s, i, poseOf(pose), reach));
          },
          py::arg("frame"), py::arg("pose"), py::arg("reach") = 0.5,
          "Frame at another place; those within `reach` seconds go along.")
      .def(
          "with_frame_moved",
          [](const Trajectory& s, std::size_t from, std::size_t to) {
            return valueOf(trajectory::withFrameMoved(s, from, to));
          },
          py::arg("frame"), py::arg("place"), "Frame at another place of the order.")
      .def(
          "with_dwell",
          [](const Trajectory& s, std::size_t i, double seconds) {
            return valueOf(trajectory::withDwell(s, i, seconds));
          },
          py::arg("frame"), py::arg("seconds"), "Waits at a frame.")
      .def(
          "with_name",
          [](const Trajectory& s, std::size_t i, const std::string& name) {
            return valueOf(trajectory::withName(s, i, name));
          },
          py::arg("frame"), py::arg("name"), "A name for a frame; empty: none.")
      .def(
          "with_approach",
          [](const Trajectory& s, double length, py::handle direction, double speed) {
            return valueOf(trajectory::withApproach(s, {length, pointOf(direction, "direction"), speed}));
          },
          py::arg("length") = 0.05, py::arg("direction") = std::vector<double>{0.0, 0.0, -1.0}, py::arg("speed") = 0.1,
          "A straight way before it: `length` (m), `direction` of its far end in the frame's own axes.")
      .def(
          "with_retract",
          [](const Trajectory& s, double length, py::handle direction, double speed) {
            return valueOf(trajectory::withRetract(s, {length, pointOf(direction, "direction"), speed}));
          },
          py::arg("length") = 0.05, py::arg("direction") = std::vector<double>{0.0, 0.0, -1.0}, py::arg("speed") = 0.1,
          "A straight way after it.");
}

void bindCleaning(py::class_<Trajectory>& c) {
  c.def(
       "simplified",
       [](const Trajectory& s, double position, double angle, double joint) {
         const PathTolerance tolerance = toleranceOf(position, angle, joint);
         const py::gil_scoped_release unlocked;
         return trajectory::simplified(s, tolerance);
       },
       py::arg("position") = 0.001, py::arg("angle") = 0.0175, py::arg("joint") = 0.001,
       "Only the frames that are enough to stay within m, rad and rad (m) of every frame.")
      .def(
          "smoothed",
          [](const Trajectory& s, double position, double angle, double joint) {
            const PathTolerance tolerance = toleranceOf(position, angle, joint);
            const py::gil_scoped_release unlocked;
            return trajectory::smoothed(s, {tolerance}).trajectory;
          },
          py::arg("position") = 0.001, py::arg("angle") = 0.0175, py::arg("joint") = 0.001,
          "Without tremor: a cubic spline within the tolerance, at the same times.")
      .def(
          "retimed",
          [](const Trajectory& s, py::handle velocity, py::handle acceleration, py::handle jerk,
             std::optional<double> speed,
             double sample) { return retime(s, velocity, acceleration, jerk, speed, sample).trajectory; },
          py::arg("velocity") = py::none(), py::arg("acceleration") = py::none(), py::arg("jerk") = py::none(),
          py::arg("speed") = py::none(), py::arg("sample") = 0.01,
          "New times on the same path: as fast as the limits allow (an entry a joint; without joints six: x, y, z and "
          "the "
          "rotation about them), or at one `speed` (m/s) of the tool with `acceleration` (m/s2).")
      .def(
          "deviation_from",
          [](const Trajectory& s, const Trajectory& original) {
            const auto off = trajectory::largestDeviation(original, s);
            return py::make_tuple(off.pose.position, off.pose.angle, off.joint);
          },
          py::arg("original"), "Largest deviation of the original's frames: m, rad, rad (m).");
}

}  // namespace

void bindTrajectories(py::module_& module) {
  py::class_<Trajectory> c(module, "Trajectory",
                           "A motion: frames in time (s), each with the pose X_WT of the moved frame and, for a robot, "
                           "its joints. Edits return a "
                           "copy.\n\nTrajectory(times, poses, joints=None, joint_names=[]) takes arrays of shape (n,), "
                           "(n, 7) and (n, joints). "
                           "Commands take it in place of a file: hapticell.trajectory.check(motion, workcell=cell).");
  bindData(c);
  bindCuts(c);
  bindPoints(c);
  bindCleaning(c);
}

}  // namespace hapticell::python
