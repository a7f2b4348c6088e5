#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The example client of docs/library/protocol.md feels the floor of a real server. Skipped (77) without its two tools."""
import shutil
import subprocess
import sys

from server_process import Server

try:
    import flatbuffers  # noqa: F401
except ImportError:
    print("skipped: python3-flatbuffers is not installed")
    sys.exit(77)
if shutil.which("flatc") is None:
    print("skipped: flatc (flatbuffers-compiler) is not installed")
    sys.exit(77)

SERVER, CLIENT = sys.argv[1:3]

with Server(SERVER) as server:
    done = subprocess.run([sys.executable, CLIENT, "--port", str(server.port)], capture_output=True, text=True, timeout=90)
    print(done.stdout, done.stderr, sep="")
    assert done.returncode == 0, "the client failed"
    assert "Phantom Desktop (simulated)" in done.stdout
    forces = [float(line.split("force")[1].split("N")[0]) for line in done.stdout.splitlines() if " force " in line]
    assert len(forces) >= 10, forces
    assert forces[0] == 0.0, "free above the floor"
    assert 1.5 < forces[-1] < 3.0, "10 mm below the floor: 300 N/m of hand against 1000 N/m of device"
    status, errors = server.end()
    assert status == 0 and "HaptiCell example" in errors, errors
