// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::config {

/// How a material feels when a held part touches it.
struct Material {
  double stiffness = 1000.0;  ///< N/m wanted; the server lowers it to what is stable on the device.
  double damping = 2.0;       ///< N s/m.
  double friction = 0.15;     ///< Coulomb coefficient.
};

/// Every setting of hapticell.toml, with the values that are shipped. SI units; a value type.
struct Configuration {
  struct Haptic {
    double rate_hz = 1000.0;                 ///< Force loop.
    std::string device = "phantom_desktop";  ///< Profile in config/devices/, or a driver's name.
    double stiffness = 0.0;                  ///< N/m of the virtual coupling; 0: the device's own.
    double damping = 0.0;                    ///< N s/m; 0: the device's own.
    double force_ramp_s = 0.8;               ///< From forces on to full force.
  } haptic;
  struct Server {
    std::string host = "127.0.0.1";
    int port = 4747;
  } server;
  struct Manipulation {
    double rate_hz = 1000.0;              ///< As fast as the query allows, up to this.
    double zone_radius = 0.060;           ///< Hand space, metres: how far ahead a constraint set is complete.
    bool hold_to_move = false;            ///< True: the button must stay pressed while an entity is held.
    std::string on_contact = "slide";     ///< stop, slide, pass: for entities that do not say.
    std::string force_class = "contact";  ///< constant, contact, dynamics: for entities that do not say.
    double safety_distance = 0.001;       ///< Metres; felt as the boundary where no pair set says otherwise.
    double near_miss = 0.010;             ///< Metres; shown and heard.
    double gravity_compensation = 1.0;    ///< Share of a held part's weight that is not felt; 1: none is felt.
    double edge_drift = 0.0;              ///< m/s of hand at the edge of the device's workspace; 0: none.
    double plan_authority = 0.7;          ///< 0 .. 1: how strongly the path of the live planner is felt.
    double plan_clearance = 0.002;        ///< Metres: clearance of that path.
    double felt_mass = 0.5;               ///< kg whose inertia is felt at most, for the class dynamics.
    double load_damping = 0.5;            ///< N s/m against the motion of what is held, for the class dynamics.
  } manipulation;
  struct Robot {
    /// keep_position, keep_orientation, keep_joint_4: what an arm does at a wrist singularity faster than its joints
    /// can turn; stop: singularities are walls.
    std::string at_singularity = "keep_position";
    bool self_collision = true;  ///< A robot's links are checked against each other.
  } robot;
  struct Scale {  ///< Metres in the cell per metre of hand motion.
    double rough = 4.0;
    double medium = 1.0;
    double fine = 0.25;
    double rotation = 1.0;  ///< Radians of the entity a radian of the wrist.
    double screen = 1.0;    ///< Widths of the view a width of the device's workspace.
  } scale;
  struct Gui {
    double rate_hz = 60.0;
    std::string theme = "dark";  ///< dark, light.
    bool motion = true;          ///< False: views turn at once.
    bool sound = true;
    bool original_colors = false;  ///< The files' own colours instead of quiet ones.
  } gui;
  struct Hand {                ///< The hand that holds a simulated stylus.
    double mass = 0.1;         ///< kg.
    double stiffness = 300.0;  ///< N/m.
    double damping = 5.0;      ///< N s/m; 2 is a loose grip.
  } hand;
  std::map<std::string, Material> materials{{"steel", {1000.0, 2.0, 0.15}},
                                            {"aluminium", {900.0, 2.0, 0.20}},
                                            {"plastic", {700.0, 2.0, 0.30}},
                                            {"foam", {250.0, 3.0, 0.60}},
                                            {"cable", {400.0, 3.0, 0.40}}};
  /// [driver.NAME] of the file: settings for a device's driver, as text; docs/library/drivers.md lists the keys of
  /// each.
  std::map<std::string, std::map<std::string, std::string>> drivers;
};

/// One setting as text, for listing and documentation.
struct Setting {
  std::string key;    ///< "manipulation.rate_hz"
  std::string value;  ///< As written in the file.
  std::string range;  ///< "10 .. 1000" or "stop, slide, pass"
};

/// Reads a hapticell.toml over `base`: keys that it lacks keep base's values. An unknown key, a value of the wrong type
/// or out of range is an error naming line, key and range; `base` then stays in force. The key `preset = "classic"` sets
/// manipulation and window to the paper's 10 Hz before the other keys are read.
Expected<Configuration> readConfiguration(const std::string& path, const Configuration& base = {});

/// Sets one key from text, as `--set manipulation.rate_hz=100` does.
Expected<void> setValue(Configuration& configuration, std::string_view key, std::string_view text);

/// All settings in the order of the shipped file.
std::vector<Setting> settings(const Configuration& configuration);

/// Finds shipped files: in the folder named by HAPTICELL_CONFIG_DIR, else share/hapticell beside the folders of
/// program_folders.h, else the source tree's config/. The path of `relative` in the first of them that has it.
Expected<std::string> findShippedFile(const std::string& relative);

/// The configuration in force: the shipped hapticell.toml, then the user's ($XDG_CONFIG_HOME/hapticell/hapticell.toml)
/// where there is one, then the file `extra` if it is not empty.
Expected<Configuration> loadConfiguration(const std::string& extra = {});

}  // namespace hapticell::config
