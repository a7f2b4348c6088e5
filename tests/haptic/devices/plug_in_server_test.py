#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Server and command line with plug-ins from outside: the example driver is found, listed, driven, recorded and replayed."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "server"))
from server_process import Server  # noqa: E402

SERVER, CLI, EXAMPLES, STAND_IN = sys.argv[1:5]
os.environ["HAPTICELL_DRIVERS"] = EXAMPLES


def devices(configuration=""):
    """The listing, with a hapticell.toml of that text."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "my.toml"
        file.write_text(configuration)
        done = subprocess.run([CLI, "devices", "--config", str(file)], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done
    return json.loads(done.stdout)


def by_name(entries, name):
    found = [entry for entry in entries if entry["name"] == name]
    assert len(found) == 1, (name, entries)
    return found[0]


def test_lists_drivers_devices_permissions_versions():
    listing = devices()
    names = {driver["name"] for driver in listing["drivers"]}
    assert {"simulated", "orbit", "openhaptics", "cyberglove"} <= names, names
    for driver in listing["drivers"]:
        assert driver["usable"] or driver["problem"], driver
    broken = by_name(listing["drivers"], "lacks_library")
    assert not broken["usable"] and "a_function_that_nobody_has" in broken["problem"], broken
    orbit = [device for device in listing["devices"] if device["driver"] == "orbit"]
    assert len(orbit) == 1 and orbit[0]["usable"] and orbit[0]["kind"] == "stylus", orbit
    assert any(device["simulated"] for device in listing["devices"])
    for grant in listing["permissions"]:
        assert grant["granted"] or grant["fix"], grant
    assert listing["versions"]["driver_interface"] == 2


def test_says_what_is_missing_and_finds_what_is_configured():
    lacking = by_name(devices('[driver.openhaptics]\nlibrary = "/nowhere/libHD.so"\n')["drivers"], "openhaptics")
    assert lacking["reason"] == "missing_library" and "/nowhere/libHD.so" in lacking["problem"], lacking
    listing = devices(f'[driver.openhaptics]\nlibrary = "{STAND_IN}"\n')
    touch = [device for device in listing["devices"] if device["driver"] == "openhaptics"]
    assert [device["name"] for device in touch] == ["Stand-in Touch"] and touch[0]["usable"], touch
    assert touch[0]["firmware"] == "192", touch
    gloves = devices('[driver.cyberglove]\nport = "/dev/no_such_port"\n')["devices"]
    glove = [device for device in gloves if device["driver"] == "cyberglove"]
    assert len(glove) == 1 and not glove[0]["usable"] and glove[0]["reason"] == "not_found", glove
    assert glove[0]["kind"] == "glove", glove


class Watch:
    """`devices --watch` with a hapticell.toml of that text; each listing as it comes."""

    def __init__(self, configuration):
        self.folder = tempfile.TemporaryDirectory()
        file = pathlib.Path(self.folder.name) / "my.toml"
        file.write_text(configuration)
        self.process = subprocess.Popen([CLI, "devices", "--watch", "--config", str(file)], text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def listing(self):
        line = self.process.stdout.readline()
        assert line, "it ended"
        return json.loads(line)

    def ask(self):
        self.process.stdin.write("look\n")
        self.process.stdin.flush()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.stdin.close()
        assert self.process.wait(timeout=60) == 0
        self.folder.cleanup()


def test_watch_tells_what_comes_and_goes_and_asks_nobody_else():
    with tempfile.TemporaryDirectory() as folder:
        port, log = pathlib.Path(folder) / "glove", pathlib.Path(folder) / "log"
        settings = f'[driver.cyberglove]\nport = "{port}"\n[driver.counted]\nlog = "{log}"\n'

        def glove(listing):
            return [device for device in listing["devices"] if device["driver"] == "cyberglove"][0]

        master, slave = os.openpty()
        with Watch(settings) as watch:
            first = watch.listing()
            assert first["drivers"] and first["permissions"] and first["versions"], first
            assert glove(first)["reason"] == "not_found", first
            os.symlink(os.ttyname(slave), port)
            assert glove(watch.listing())["usable"]
            port.unlink()
            assert glove(watch.listing())["reason"] == "not_found"
            assert log.read_text() == "asked\n", "only who sees something else is asked"
            watch.ask()
            assert glove(watch.listing())["reason"] == "not_found"
            assert log.read_text() == "asked\nasked\n"
        os.close(master)
        os.close(slave)


def test_listing_survives_a_driver_that_crashes():
    settings = '[driver.counted]\ncrash = "yes"\n'
    with Watch(settings) as watch:
        for listing in (watch.listing(), devices(settings)):
            counted = by_name(listing["drivers"], "counted")
            assert not counted["usable"] and "it crashed" in counted["problem"], counted
            assert by_name(listing["drivers"], "orbit")["usable"], listing


def test_server_drives_records_and_replays_a_plug_in():
    with tempfile.TemporaryDirectory() as folder:
        recording = pathlib.Path(folder) / "session.hdev"
        with Server(SERVER, "--device", "orbit", "--seconds", "0.5", "--record", str(recording)) as server:
            assert "Orbit at 1000 Hz" in server.line, server.line
            status, errors = server.finish()
            assert status == 0, errors
        assert recording.read_bytes()[:8] == b"HCELDEV1"
        assert recording.stat().st_size > 1000
        with Server(SERVER, "--device", f"replay:{recording}", "--seconds", "0.2") as server:
            assert "Orbit at 1000 Hz" in server.line, server.line
            assert server.finish()[0] == 0


def test_server_refuses_in_a_sentence():
    for name, part in (("no_such", "phantom_desktop"), ("orbit:second", "no such device"),
                       ("lacks_library", "a_function_that_nobody_has"), ("replay:/nowhere.hdev", "/nowhere.hdev")):
        done = subprocess.run([SERVER, "--port", "0", "--device", name], capture_output=True, text=True, timeout=60)
        assert done.returncode == 2 and part in done.stderr, (name, done)


TESTS = [test for name, test in sorted(globals().items()) if name.startswith("test_")]
for run in TESTS:
    run()
print(f"{len(TESTS)} passed, 0 failed")
