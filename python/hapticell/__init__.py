# SPDX-License-Identifier: Apache-2.0
"""HaptiCell: exact collision checks, robots, workcells, trajectories, mannequins and haptic sessions.

Lengths are metres, angles radians, forces newtons, times seconds. A pose X_AB of a frame B in a frame A is None (identity),
seven numbers x, y, z, qw, qx, qy, qz, or a 4 x 4 matrix; arrays of poses have the shape (n, 7) or (n, 4, 4). Results have
seven numbers.

Classes: Mesh, Pair, Scene; Robot; Workcell, JointCheck; Trajectory; Figure, Posture; HapticClient, HapticServer. Besides,
every command of hapticell-cli is a function of the same name: hapticell.inspect(), hapticell.trajectory.retime() and so on.
What is wrong with what you gave raises Error.

>>> import hapticell
>>> plate, ball = hapticell.Mesh.box(0.4, 0.4, 0.02), hapticell.Mesh.sphere(0.05)
>>> round(ball.distance(plate, pose=[0, 0, 0.11, 1, 0, 0, 0]).distance, 6)
0.05
"""
from . import _engine, _workcells
from ._commands import all_commands as _all_commands
from ._engine import (Distance, Entity, Felt, Figure, HapticClient, HapticServer, IkAlternative, IkSolution, JointCheck, Mesh,
                      Pair, PartDistance, Posture, Robot, Scene, Sweep, Trajectory, Workcell, __version__)
from ._errors import Error, Notice
from ._results import Records, Result

for _class in (Distance, Entity, Felt, Figure, HapticClient, HapticServer, IkAlternative, IkSolution, JointCheck, Mesh, Pair,
               PartDistance, Posture, Robot, Scene, Sweep, Trajectory, Workcell):
    _class.__module__ = "hapticell"
_workcells.extend()


class ForceLoop:
    """Refused: a force loop in Python.

    A force must be computed a thousand times a second, whatever happens; Python stops for garbage, locks and imports, and the
    hand would feel each stop. Run hapticell-haptic-server and drive it with HapticClient, or write a device in C++
    (docs/library/drivers.md).
    """

    def __init__(self, *args, **kwargs):
        raise Error(place="ForceLoop", found="a force loop in Python", expected="hapticell-haptic-server, driven by HapticClient",
                    message="A force loop in Python is refused: it cannot keep 1 kHz. Drive a haptic server with HapticClient.")


_functions = _all_commands()
globals().update(_functions)
__all__ = ["Distance", "Entity", "Error", "Felt", "Figure", "ForceLoop", "HapticClient", "HapticServer", "IkAlternative",
           "IkSolution", "JointCheck", "Mesh", "Notice", "Pair", "PartDistance", "Posture", "Records", "Result", "Robot", "Scene",
           "Sweep", "Trajectory", "Workcell", *_functions]
