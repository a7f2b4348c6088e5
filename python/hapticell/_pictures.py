# SPDX-License-Identifier: Apache-2.0
"""Pictures of cells, drawn without a window by the program hapticell."""
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile

from . import _engine
from ._errors import Error


def _run(words):
    """(exit status, what it said): Ctrl+C ends it with all that it started."""
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True) as process:
        try:
            text, _ = process.communicate()
        except BaseException:
            os.killpg(process.pid, signal.SIGTERM)
            raise
    return process.returncode, text


def render(cell, file=None, *, size=(960, 600), view="iso", theme="light"):
    """Draws the cell without a window and returns the PNG as bytes; with `file` also writes it there.

    Args:
        file: A path that ends in .png, or None.
        size: Width and height, pixels.
        view: front, back, right, left, top, bottom, iso or saved.
        theme: light or dark.

    Raises:
        Error: the program hapticell is not installed, or cannot draw.
    """
    program = _engine.program_path("hapticell")
    if not program:
        raise Error(place="hapticell", found="the program is not installed", expected="hapticell, which draws cells",
                    fix="Install the package hapticell.", message="hapticell: the program is not installed. Install the package hapticell.")
    with tempfile.TemporaryDirectory(prefix="hapticell-") as folder:
        path = pathlib.Path(folder)
        cell._write_copy(path / "cell.hcell")
        width, height = size
        words = [program, "--render", str(path / "cell.hcell"), "-o", str(path / "picture.png"), "--view", view,
                 "--size", f"{int(width)}x{int(height)}", "--theme", theme]
        if not os.environ.get("DISPLAY") and not os.environ.get("WAYLAND_DISPLAY") and shutil.which("xvfb-run"):
            words = ["xvfb-run", "-a", "-s", "-screen 0 640x480x24 +extension GLX", *words]  # It needs OpenGL, no screen.
        status, text = _run(words)
        picture = path / "picture.png"
        if status != 0 or not picture.exists():
            said = text.strip().splitlines()[-1:] or ["it drew nothing"]
            raise Error(file=program, found=said[0], message=f"{program}: {said[0]}")
        content = picture.read_bytes()
    if file is not None:
        pathlib.Path(file).write_bytes(content)
    return content
