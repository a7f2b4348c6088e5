#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""hapticell-haptic-server from outside: its options, its line, its signals, its exit statuses."""
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile

from server_process import Server

PROGRAM = sys.argv[1]


def refused(*words, settings=None):
    """Runs it with bad words, and with the user's settings in another folder; what it says."""
    environment = dict(os.environ, XDG_CONFIG_HOME=settings) if settings else None
    done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=60, env=environment)
    assert done.returncode == 2, (words, done)
    assert done.stdout == "" and done.stderr.count("\n") == 1, (words, done)
    return done.stderr


def test_ends_by_signal():
    for number in (signal.SIGTERM, signal.SIGINT):
        with Server(PROGRAM) as server:
            assert "Phantom Desktop (simulated) at 1000 Hz" in server.line, server.line
            status, errors = server.end(number)
            assert status == 0, errors
            assert "Force loop:" in errors and "Lateness in ms: p50" in errors, errors


def test_ends_by_itself():
    with Server(PROGRAM, "--seconds", "0.3") as server:
        status, errors = server.finish()
        assert status == 0 and "ticks" in errors, errors


def test_prints_figures_when_asked():
    with Server(PROGRAM) as server:
        server.process.send_signal(signal.SIGUSR1)
        first = server.process.stderr.readline()
        assert first.startswith("Force loop:"), first
        status, errors = server.end()
        assert status == 0 and "Force loop:" in errors, errors


def test_takes_device_and_configuration():
    with Server(PROGRAM, "--device", "touch") as server:
        assert "Touch" in server.line, server.line
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "my.toml"
        file.write_text("[haptic]\nrate_hz = 500\n")
        with Server(PROGRAM, "--config", str(file)) as server:
            assert server.line.rstrip().endswith("at 500 Hz."), server.line
        file.write_text("[haptic]\nrate_hz = -1\n")
        said = refused("--port", "0", "--config", str(file))
        assert "rate_hz" in said and "my.toml" in said, said


def test_writes_its_log_in_the_state_folder():
    with tempfile.TemporaryDirectory() as folder:
        environment = dict(os.environ, XDG_STATE_HOME=folder)
        logs = pathlib.Path(folder) / "hapticell" / "logs"
        with Server(PROGRAM, environment=environment) as first, Server(PROGRAM, environment=environment) as second:
            for server in (first, second):
                status, errors = server.end()
                assert status == 0, errors
        for name in ("hapticell-haptic-server.log", "hapticell-haptic-server-2.log"):
            log = (logs / name).read_text()
            assert "commit: " in log and "listens on" in log and "Force loop:" in log and "server ends" in log, log
        with Server(PROGRAM, "--log-level", "error", environment=environment) as server:
            assert server.end()[0] == 0
        assert (logs / "hapticell-haptic-server.log").read_text().count("listens on") == 1


def test_serves_without_a_log_where_none_can_be_written():
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "hapticell").write_text("no folder")
        with Server(PROGRAM, environment=dict(os.environ, XDG_STATE_HOME=folder)) as server:
            status, errors = server.end()
            assert status == 0 and errors.count("There is no log file: ") == 1, errors


def privileges(process):
    """Users, groups and capabilities of a process, as the kernel tells them."""
    lines = pathlib.Path(f"/proc/{process}/status").read_text().splitlines()
    return [line for line in lines if line.split(":")[0] in ("Uid", "Gid", "Groups", "CapPrm", "CapEff", "CapAmb")]


def test_runs_as_the_user_and_for_this_machine_only():
    mode = pathlib.Path(PROGRAM).stat().st_mode
    assert not mode & 0o6000, oct(mode)
    assert "security.capability" not in os.listxattr(PROGRAM)
    with Server(PROGRAM) as server:
        assert privileges(server.process.pid) == privileges("self")
        listening = [line.split()[1] for table in ("tcp", "tcp6") for line in
                     pathlib.Path(f"/proc/net/{table}").read_text().splitlines()[1:]
                     if line.split()[3] == "0A" and line.split()[1].endswith(f":{server.port:04X}")]
        assert listening == [f"0100007F:{server.port:04X}"], listening


def test_pairs_and_serves_with_the_key():
    with tempfile.TemporaryDirectory() as folder:
        environment = dict(os.environ, XDG_CONFIG_HOME=folder)
        done = subprocess.run([PROGRAM, "--pair"], capture_output=True, text=True, timeout=60, env=environment)
        assert done.returncode == 0 and len(done.stdout.strip()) == 34, done
        key = pathlib.Path(folder) / "hapticell" / "server.key"
        assert key.read_text() == done.stdout and key.stat().st_mode & 0o777 == 0o600
        with Server(PROGRAM, "--key", str(key)) as server:
            with socket.create_connection(("127.0.0.1", server.port), timeout=30) as plain:
                plain.sendall(b"\x08\x00\x00\x00plain, no")
                rest = b"".join(iter(lambda: plain.recv(4096), b""))
                assert b"HCEL" not in rest, rest
            status, errors = server.end()
            assert status == 0 and "does not speak TLS" in errors, errors


def test_refuses_in_a_sentence():
    assert "--prot" in refused("--prot", "1")
    assert "--port" in refused("--port", "70000")
    assert "no_such_device" in refused("--port", "0", "--device", "no_such_device")
    with tempfile.TemporaryDirectory() as folder:
        assert "--pair" in refused("--port", "0", "--listen", "0.0.0.0", settings=folder)
    assert "nowhere" in refused("--port", "0", "--listen", "nowhere")
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = str(taken.getsockname()[1])
        assert port in refused("--port", port)


def test_helps():
    said = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True, timeout=60)
    assert said.returncode == 0 and "--listen ADDRESS" in said.stdout
    assert subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, timeout=60).returncode == 0


if __name__ == "__main__":
    for name, test in sorted(globals().items()):
        if name.startswith("test_"):
            test()
            print("passed", name)
