// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/system/error.h"

namespace hapticell::workcell {

/// Reads the keys of one TOML table with checks; the first fault is stored in `error`, and later calls have no effect.
/// Numbers must be finite. At the end, refuseOthers() names a key that was not read.
class TomlFields {
 public:
  TomlFields(const toml::table& table, std::string section, std::optional<Error>& error)
      : table_(table), section_(std::move(section)), error_(error) {}

  bool has(const char* key) const { return table_.contains(key); }
  void read(const char* key, std::string& target);
  void read(const char* key, bool& target);
  /// The number times `unit`; the number itself must be in [least, most].
  void read(const char* key, double& target, double unit = 1.0, double least = -1e6, double most = 1e6);
  void readList(const char* key, std::vector<double>& target, double unit = 1.0);
  void readList(const char* key, std::vector<std::string>& target);
  void readPoint(const char* key, dvec3& target, double unit);
  /// One of the words; `target` gets its index.
  void readWord(const char* key, const std::vector<std::string>& words, int& target);
  /// "#rrggbb".
  void readColor(const char* key, std::array<float, 4>& target);
  /// `position` (times `unit`) with `quaternion` [w, x, y, z] or `rpy` (degrees, URDF's order).
  void readPose(Pose& target, double unit);
  /// Rows of `count` numbers each.
  void readRows(const char* key, std::size_t count, std::vector<std::vector<double>>& rows);

  const toml::table* table(const char* key);
  const toml::array* tables(const char* key);  ///< An array of tables.

  void require(const char* key);
  void refuseOthers();
  void fail(const toml::node* node, Text found, Text expected, Text fix = {});
  void failKey(const char* key, Text found, Text expected) {
    fail(table_.get(key), std::move(found), std::move(expected));
  }
  const std::string& section() const { return section_; }
  const toml::table& raw() const { return table_; }
  bool failed() const { return error_.has_value(); }

 private:
  const toml::node* find(const char* key);
  std::optional<double> numberOf(const toml::node& node, const Text& what);

  const toml::table& table_;
  std::string section_;
  std::optional<Error>& error_;
  std::set<std::string> asked_;
};

}  // namespace hapticell::workcell
