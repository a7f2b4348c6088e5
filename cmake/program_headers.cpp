// SPDX-License-Identifier: Apache-2.0
// Nothing but the owner of the programs' precompiled header (HaptiCell.cmake).
int main() {}
