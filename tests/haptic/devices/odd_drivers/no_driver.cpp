// SPDX-License-Identifier: Apache-2.0
// A shared library that is no driver.
extern "C" int somethingElse() {
  return 1;
}
