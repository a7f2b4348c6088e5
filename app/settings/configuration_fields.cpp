// SPDX-License-Identifier: Apache-2.0
#include "app/settings/configuration_fields.h"

#include <QHash>
#include <QObject>

namespace hapticell::app {
namespace {

constexpr double kPerMetre = 1000.0, kPercent = 100.0;

QString materialName(const std::string& key) {
  const QHash<QString, QString> names{{"steel", QObject::tr("Steel")},
                                      {"aluminium", QObject::tr("Aluminium")},
                                      {"plastic", QObject::tr("Plastic")},
                                      {"foam", QObject::tr("Foam")},
                                      {"cable", QObject::tr("Cable")}};
  const QString plain = QString::fromStdString(key);
  return names.value(plain, plain);
}

ConfigurationGroup forces() {
  return {
      QObject::tr("Forces of the stylus"),
      {{"haptic.device", QObject::tr("Stylus at start"), {}},
       {"haptic.stiffness", QObject::tr("Stiffness (0: as the device)"), "N/m", 1.0, 0},
       {"haptic.damping", QObject::tr("Damping (0: as the device)"), "N s/m", 1.0, 1},
       {"haptic.force_ramp_s", QObject::tr("Force ramp-up time"), "s", 1.0, 2},
       {"manipulation.hold_to_move", QObject::tr("Keep the stylus button pressed to move"), {}},
       {"manipulation.gravity_compensation", QObject::tr("Gravity compensation of the held part"), "%", kPercent, 0},
       {"manipulation.felt_mass", QObject::tr("Largest mass with felt inertia"), "kg", 1.0, 2},
       {"manipulation.load_damping", QObject::tr("Damping of the held part (Dynamics)"), "N s/m", 1.0, 2},
       {"manipulation.plan_authority", QObject::tr("Authority of a planner beside the hand"), "%", kPercent, 0},
       {"manipulation.plan_clearance", QObject::tr("Clearance of its way"), "mm", kPerMetre, 1},
       {"manipulation.edge_drift", QObject::tr("Drift at the edge of the workspace (0: none)"), "mm/s", kPerMetre, 0},
       {"manipulation.zone_radius", QObject::tr("Prepare contacts within"), "mm", kPerMetre, 0}}};
}

ConfigurationGroup contacts() {
  return {QObject::tr("Contacts"),
          {{"manipulation.near_miss", QObject::tr("Near-miss distance: shown and heard below"), "mm", kPerMetre, 1},
           {"manipulation.safety_distance", QObject::tr("Safety distance: contact felt at"), "mm", kPerMetre, 2},
           {"manipulation.on_contact", QObject::tr("On contact, unless set for the part"), {}},
           {"manipulation.force_class", QObject::tr("Force, unless set for the part"), {}},
           {"robot.self_collision", QObject::tr("Check robots for self-collision"), {}},
           {"robot.at_singularity", QObject::tr("Robot near a singularity"), {}}}};
}

ConfigurationGroup scales() {
  return {QObject::tr("Scale: part motion for the same hand motion"),
          {{"scale.rough", QObject::tr("Rough"), "×", 1.0, 2},
           {"scale.medium", QObject::tr("Medium"), "×", 1.0, 2},
           {"scale.fine", QObject::tr("Fine"), "×", 1.0, 3},
           {"scale.screen", QObject::tr("Screen: widths of the view"), "×", 1.0, 2},
           {"scale.rotation", QObject::tr("Rotation"), "×", 1.0, 2}}};
}

ConfigurationGroup materials(const config::Configuration& configuration) {
  ConfigurationGroup group{QObject::tr("Materials: how a part feels in contact"), {}};
  for (const auto& [key, material] : configuration.materials) {
    const QString name = materialName(key);
    const std::string at = "materials." + key;
    group.fields.push_back({at + ".stiffness", QObject::tr("%1: stiffness").arg(name), "N/m", 1.0, 0});
    group.fields.push_back({at + ".damping", QObject::tr("%1: damping").arg(name), "N s/m", 1.0, 1});
    group.fields.push_back({at + ".friction", QObject::tr("%1: friction").arg(name), {}, 1.0, 2});
  }
  return group;
}

ConfigurationGroup simulatedHand() {
  return {QObject::tr("Hand on the simulated stylus"),
          {{"hand.mass", QObject::tr("Mass"), "kg", 1.0, 2},
           {"hand.stiffness", QObject::tr("Stiffness"), "N/m", 1.0, 0},
           {"hand.damping", QObject::tr("Damping (2 is a loose grip)"), "N s/m", 1.0, 1}}};
}

ConfigurationGroup program() {
  return {QObject::tr("Rates and connection"),
          {{"gui.sound", QObject::tr("Sound at start"), {}},
           {"haptic.rate_hz", QObject::tr("Force loop"), "Hz", 1.0, 0},
           {"manipulation.rate_hz", QObject::tr("Contact check, at most"), "Hz", 1.0, 0},
           {"gui.rate_hz", QObject::tr("Window"), "Hz", 1.0, 0},
           {"server.host", QObject::tr("Address of the haptic server"), {}},
           {"server.port", QObject::tr("Port"), {}, 1.0, 0}}};
}

}  // namespace

std::vector<ConfigurationGroup> configurationGroups(const config::Configuration& configuration) {
  return {contacts(), forces(), scales(), materials(configuration), simulatedHand(), program()};
}

QString choiceWords(const QString& choice) {
  const QHash<QString, QString> words{{"stop", QObject::tr("Stop")},
                                      {"slide", QObject::tr("Slide")},
                                      {"pass", QObject::tr("Pass")},
                                      {"constant", QObject::tr("Constant")},
                                      {"contact", QObject::tr("Contact")},
                                      {"dynamics", QObject::tr("Dynamics")},
                                      {"keep_position", QObject::tr("Keep position")},
                                      {"keep_orientation", QObject::tr("Keep orientation")},
                                      {"keep_joint_4", QObject::tr("Keep joint 4")}};
  return words.value(choice, choice);
}

}  // namespace hapticell::app
