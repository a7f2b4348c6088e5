# SPDX-License-Identifier: Apache-2.0
"""Drags a part through a cell until it touches something, goes along the surface, and says where it ended."""
import hapticell

scene = hapticell.Scene()
part = scene.add(hapticell.Mesh.box(0.1, 0.1, 0.1), [-0.5, 0, 0.2, 1, 0, 0, 0])
wall = scene.add(hapticell.Mesh.box(0.01, 1, 1), [0, 0, 0.5, 1, 0, 0, 0])
scene.check([part], [wall])

swept = scene.sweep(part, [0.5, 0, 0.2, 1, 0, 0, 0], clearance=0.001)
scene.move(part, swept.pose)
gap = scene.distance(part, wall)
print(f"stopped at x = {swept.pose[0]:.4f} m, {1e3 * float(gap):.2f} mm before the wall")

along = scene.sweep(part, [swept.pose[0], 0.3, 0.2, 1, 0, 0, 0], clearance=0.001)
print("the way along the wall is free" if not along.stopped else "blocked")
