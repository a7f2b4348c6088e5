# SPDX-License-Identifier: Apache-2.0
"""What a Workcell does that is plain Python: steps, iteration, pictures."""
import contextlib

from ._engine import Workcell
from ._errors import Error
from ._pictures import render


@contextlib.contextmanager
def step(self, text):
    """Makes all that is changed within it one step of undo; an exception takes all of it back.

    >>> import hapticell
    >>> cell = hapticell.Workcell()
    >>> with cell.step("Two boxes"):
    ...     a = cell.add("box:1,1,1"); b = cell.add("box:1,1,1", pose=[2, 0, 0, 1, 0, 0, 0])
    >>> cell.history
    ['Two boxes']
    """
    self._begin_step(text)
    try:
        yield self
    except BaseException:
        self._cancel_step()
        raise
    self._end_step()


def _iterate(self):
    """The names of the entities."""
    return iter(self.names)


def _picture(self):
    """For Jupyter; without the program that draws, the cell is shown as text."""
    try:
        return render(self)
    except Error:
        return None


def extend():
    """Adds them to the class."""
    Workcell.step = step
    Workcell.render = render
    Workcell.__iter__ = _iterate
    Workcell._repr_png_ = _picture
