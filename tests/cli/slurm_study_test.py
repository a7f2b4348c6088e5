#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A study on a Slurm of its own: two nodes on this machine, started here with their own munge. Rows equal to those of one
process; the kill of a chunk's process is made good. Skipped (exit status 77) with the reason where Slurm cannot run.

usage: slurm_study_test.py HAPTICELL_CLI
"""
import os
import pathlib
import pwd
import shutil
import signal
import socket
import sqlite3
import subprocess
import sys
import tempfile
import time

CLI = pathlib.Path(sys.argv[1])
ROOT = pathlib.Path(__file__).resolve().parents[2]
STUDIES = ROOT / "config/studies"
os.environ["PATH"] += ":/usr/sbin:/sbin"


def skip(reason):
    print("skipped:", reason)
    sys.exit(77)


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Cluster:
    """Controller and two nodes in a folder; all of it ends with it."""

    def __init__(self, folder):
        self.folder, self.children = folder, []
        for name in ("state", "spool1", "spool2", "log"):
            (folder / name).mkdir()
        self.start_munge()
        self.start_slurm()

    def start(self, *words):
        log = (self.folder / "log" / (pathlib.Path(words[0]).name + str(len(self.children)))).open("w")
        child = subprocess.Popen([str(w) for w in words], stdout=log, stderr=log, start_new_session=True)
        self.children.append(child)
        return child

    def start_munge(self):
        folder = self.folder / "munge"
        folder.mkdir(mode=0o700)
        key = folder / "key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        self.munge = folder / "socket"
        self.start("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={self.munge}", f"--pid-file={folder}/pid",
                   f"--log-file={folder}/log", f"--seed-file={folder}/seed", "--num-threads=2")
        self.wait(lambda: self.munge.exists(), "munged has no socket")

    def start_slurm(self):
        host = socket.gethostname().split(".")[0]
        controller, node1, node2 = free_ports(3)
        user = pwd.getpwuid(os.getuid()).pw_name
        conf = self.folder / "slurm.conf"
        conf.write_text(f"""ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={self.munge}
CryptoType=crypto/munge
StateSaveLocation={self.folder}/state
SlurmdSpoolDir={self.folder}/spool-%n
SlurmctldPidFile={self.folder}/slurmctld.pid
SlurmdPidFile={self.folder}/slurmd-%n.pid
SlurmctldLogFile={self.folder}/log/slurmctld.log
SlurmdLogFile={self.folder}/log/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/backfill
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
JobRequeue=1
MinJobAge=300
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SlurmdParameters=config_overrides
NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={node1} CPUs=2 State=UNKNOWN
NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port={node2} CPUs=2 State=UNKNOWN
PartitionName=all Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
""")
        os.environ["SLURM_CONF"] = str(conf)
        self.start("slurmctld", "-D", "-f", conf)
        for node in ("n1", "n2"):
            (self.folder / f"spool-{node}").mkdir()
            self.start("slurmd", "-D", "-N", node, "-f", conf)
        self.wait(self.are_nodes_idle, "the nodes of Slurm are not idle")

    def are_nodes_idle(self):
        said = subprocess.run(["sinfo", "--noheader", "-N", "-o", "%T"], capture_output=True, text=True)
        return said.returncode == 0 and said.stdout.split() == ["idle", "idle"]

    def wait(self, condition, reason, seconds=60):
        end = time.monotonic() + seconds
        while not condition():
            ended = [c for c in self.children if c.poll() is not None]
            if ended or time.monotonic() > end:
                logs = "".join(f"--- {p.name}\n{p.read_text(errors='replace')[-1500:]}" for p in sorted((self.folder / "log").iterdir()))
                self.stop()
                skip(f"{reason}\n{logs}")
            time.sleep(0.2)

    def stop(self):
        for child in reversed(self.children):
            if child.poll() is None:
                child.terminate()
        for child in self.children:
            try:
                child.wait(10)
            except subprocess.TimeoutExpired:
                child.kill()
        self.children = []


def run(*words):
    done = subprocess.run([CLI, *map(str, words)], capture_output=True, text=True, timeout=900)
    assert done.returncode == 0, (words, done.returncode, done.stderr[-3000:])
    return done


def rows(results):
    with sqlite3.connect(f"file:{results}?mode=ro", uri=True) as base:
        return base.execute("SELECT * FROM variants ORDER BY number").fetchall()


def chunk_processes(folder):
    """Numbers of the processes that evaluate a chunk of this folder."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            words = (entry / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if len(words) > 3 and words[1:3] == [b"study", b"run"] and any(str(folder).encode() in word for word in words):
            found.append(int(entry.name))
    return found


def submission(study, results):
    return ["study", "submit", study, "--slurm", "-o", results, "--chunks", 16, "--poll", 1]


def submit_and_kill_one(study, results):
    """Submits the study, kills the first chunk that is seen running, and returns what was told on standard error."""
    child = subprocess.Popen([CLI, *map(str, submission(study, results)), "--yes"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    killed = False
    end = time.monotonic() + 300
    while not killed and child.poll() is None and time.monotonic() < end:
        for chunk in chunk_processes(f"{results}.chunks"):
            try:
                os.kill(chunk, signal.SIGKILL)
                killed = True
                break
            except ProcessLookupError:
                continue  # it ended between the look and the signal
        time.sleep(0.01)
    said, told = child.communicate(timeout=900)
    assert killed, "no chunk was seen running"
    assert child.returncode == 0, told[-3000:]
    assert '"complete": true' in said, said
    return told


def main():
    for program in ("slurmctld", "slurmd", "sbatch", "squeue", "sinfo", "munged"):
        if shutil.which(program) is None:
            skip(f"{program} is not installed (Debian: slurm-wlm, munge)")
    if os.getuid() != 0:
        skip("the daemons of Slurm start jobs only as root here")
    folder = pathlib.Path(tempfile.mkdtemp(prefix="slurm-"))
    cluster = None
    try:
        for name in ("car-door.hcell", "car-door-welds.csv"):
            shutil.copy(STUDIES / name, folder)
        text = (STUDIES / "car-door-robot.hstudy").read_text().replace("steps = 7", "steps = 8").replace("turns = 8", "turns = 4")
        study = folder / "s.hstudy"
        study.write_text(text)
        run("study", "run", study, "-o", folder / "one", "--jobs", 1)
        run("study", "run", study, "-o", folder / "two", "--jobs", 2)
        expected = rows(folder / "one")
        assert len(expected) == 64 and rows(folder / "two") == expected

        cluster = Cluster(folder)
        shown = run(*submission(study, folder / "shown"))
        assert "#SBATCH" in shown.stderr and not (folder / "shown").exists()
        # A chunk takes a fifth of a second: the signal may come after its last row. Then it is tried once more.
        for attempt in range(8):
            results = folder / f"all{attempt}"
            told = submit_and_kill_one(study, results)
            assert rows(results) == expected
            if "submitted again" in told:
                break
        assert "submitted again" in told, told
        nodes = {line for log in (folder / "log").glob("slurmd-n*.log") for line in [log.name] if "task" in log.read_text() or "Launching" in log.read_text()}
        print("ok; nodes with work:", sorted(nodes))
    finally:
        if cluster:
            cluster.stop()
        shutil.rmtree(folder, ignore_errors=True)


main()
