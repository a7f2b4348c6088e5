# SPDX-License-Identifier: Apache-2.0
# FreeCAD reads this at its start, without a window too. There is nothing to register.
