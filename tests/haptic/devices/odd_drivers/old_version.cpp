// SPDX-License-Identifier: Apache-2.0
// A driver of another version of the interface.
extern "C" void* hapticell_driver(unsigned) {
  return nullptr;
}
