// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/entry_rows.h"
#include "haptic/rendering/entry_rows_body.h"

namespace hapticell::haptic {

void rowsByAvx2(const EntryArrays& entries, const double* xi, double age, EntryRows& rows);
void rowsByAvx2(const EntryArrays& entries, const double* xi, double age, EntryRows& rows) {
  rowsOfAll(entries, xi, age, rows);
}

}  // namespace hapticell::haptic
