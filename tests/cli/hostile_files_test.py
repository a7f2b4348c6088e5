#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Files that nest, unfold, wait or run: each ends in one sentence with exit status 2, in little time and memory.

usage: hostile_files_test.py HAPTICELL_CLI [NAME_PART]
"""
import base64
import json
import os
import pathlib
import re
import socket
import struct
import subprocess
import sys
import tempfile
import time
import zipfile

CLI = str(pathlib.Path(sys.argv[1]).resolve())
SANITIZED = b"__asan_init" in pathlib.Path(CLI).read_bytes()
MOST_SECONDS, MOST_BYTES = 1.0, 200e6  # Of the processor, of the program and what it starts; resident at once.
FORBIDDEN = re.compile(r"std::|terminate|Segmentation|Aborted|\bsto[ifdul]+\b|basic_string|bad_alloc|_M_|Standard_|Traceback")


class Run:
    """One call of the program, with what it took."""

    def __init__(self, *words, cwd=None, stdin=None):
        begin = time.monotonic()
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            child = subprocess.Popen([CLI, *map(str, words)], stdout=out, stderr=err, cwd=cwd,
                                     stdin=stdin or subprocess.DEVNULL)
            while True:
                pid, status, usage = os.wait4(child.pid, os.WNOHANG)
                if pid:
                    break
                if time.monotonic() - begin > 120:
                    child.kill()
                time.sleep(0.005)
            child.returncode = self.status = os.waitstatus_to_exitcode(status)
            self.seconds = usage.ru_utime + usage.ru_stime
            self.bytes = usage.ru_maxrss * 1024
            out.seek(0)
            err.seek(0)
            self.answer, self.said = out.read().decode(errors="replace"), err.read().decode(errors="replace")

    def check_means(self, what):
        assert not FORBIDDEN.search(self.said), (what, self.said)
        if SANITIZED:
            return
        assert self.seconds < MOST_SECONDS, (what, self.seconds, self.said)
        assert self.bytes < MOST_BYTES, (what, self.bytes, self.said)


def refused(what, *words, says=None, cwd=None):
    run = Run(*words, cwd=cwd)
    assert run.status == 2, (what, run.status, run.said[:500], run.answer[:200])
    lines = [line for line in run.said.splitlines() if line.startswith("hapticell-cli: ")]
    assert lines, (what, run.said)
    assert says is None or re.search(says, run.said), (what, run.said)
    run.check_means(what)
    return run


def cell(entities, **more):
    return json.dumps({"format": "hapticell-workcell", "version": 1, "entities": entities, **more})


BOX = {"name": "b", "kind": "solid", "source": {"file": "box:1,1,1"}}


# ---- deep and wide --------------------------------------------------------------------------------------------------

def test_parents_far_below_each_other(folder):
    for count in (2000, 50_000):
        for up in (1, -1):
            names = range(count)[::up]
            file = folder / "deep.hcell"
            file.write_text(cell([{"name": f"b{i}", "kind": "assembly", "parent": f"b{i + 1}"} for i in names]))
            refused(f"{count} parents", "inspect", file, says="nested assemblies")


def test_many_entities_side_by_side_are_read_in_linear_time(folder):
    for count in (20_000, 40_000):
        file = folder / "wide.hcell"
        file.write_text(cell([{"name": f"b{i}", "kind": "assembly", "parent": "top"} for i in range(count)]))
        run = Run("inspect", file)
        assert run.status == 0, run.said
        assert SANITIZED or run.seconds < 60e-6 * count + 0.5, (count, run.seconds)


def test_parents_in_a_circle_are_told_and_shown(folder):
    file = folder / "circle.hcell"
    file.write_text(cell([{"name": n, "kind": "assembly", "parent": p} for n, p in (("a", "b"), ("b", "c"), ("c", "a"), ("d", "d"))]))
    run = Run("inspect", file)
    assert run.status == 0, run.said
    result = json.loads(run.answer)
    assert len([w for w in result["warnings"] if "contains itself through" in w]) == 2, result["warnings"]
    found = []

    def walk(entities):
        for entity in entities:
            found.append(entity["name"])
            walk(entity["children"])

    walk(result["entities"])
    assert sorted(found) == ["a", "b", "c", "d"], found


def test_attachments_in_a_long_row(folder):
    row = [dict(BOX, name=f"b{i}", attached={"to": f"b{i + 1}", "link": ""}) for i in range(3000)]
    file = folder / "row.hcell"
    file.write_text(cell(row + [dict(BOX, name="b3000")]))
    refused("a row", "inspect", file, says="attached through a chain of more than")


def test_json_that_nests(folder):
    for count in (1000, 1_000_000):
        for name, text in {"lists": "[" * count, "closed lists": "[" * count + "]" * count, "objects": '{"a":' * count,
                           "both": '[{"a":' * count}.items():
            inside = json.dumps({"format": "hapticell-workcell", "version": 1})[:-1] + ',"entities":' + text
            for ending in (".hcell", ".hexercise"):
                file = folder / ("deep" + ending)
                file.write_text(inside)
                command = ("inspect", file) if ending == ".hcell" else ("session", "--exercise", file)
                if ending == ".hcell":
                    refused(name, *command, says="nested deeper")
            file = folder / "deep.htraj"
            file.write_text('{"format":"hapticell-trajectory","version":1,"frames":' + text)
            refused(name, "trajectory", "info", file, says="nested deeper")
            file = folder / "deep.json"
            file.write_text('{"scores":' + text)
            refused(name, "ergonomics", "rula", "--input", file, says="nested deeper")
            refused(name, "mannequin", "--sex", "male", "--percentile", "50", "--posture", file, says="nested deeper|MB")
            file = folder / "deep.gltf"
            file.write_text('{"asset":{"version":"2.0"},"nodes":' + text)
            refused(name, "inspect", file)
            file = folder / "deep.glb"
            data = ('{"asset":{"version":"2.0"},"nodes":' + text).encode()
            data += b" " * (-len(data) % 4)
            file.write_bytes(b"glTF" + struct.pack("<II", 2, 20 + len(data)) + struct.pack("<II", len(data), 0x4E4F534A) + data)
            refused(name, "inspect", file)


def test_objects_with_very_many_members(folder):
    file = folder / "wide.hcell"
    file.write_text('{"format":"hapticell-workcell","version":1,' + ",".join(f'"a{i}":1' for i in range(200_000)) + "}")
    refused("members", "inspect", file, says="members")


def test_toml_that_nests(folder):
    texts = {"dots": ".".join(["a"] * 500_000) + "=1", "spaces": " . ".join(["a"] * 200_000) + "=1",
             "header": "[" + ".".join(["a"] * 500_000) + "]", "headers": "[[" + ".".join(["a"] * 200_000) + "]]",
             "quoted": ".".join(["'a'"] * 200_000) + "=1", "lists": "a=" + "[" * 300_000,
             "tables": "a=" + "{a=" * 300_000, "closed": "a=" + "[" * 300_000 + "]" * 300_000,
             "in a list": "a=[{" + ".".join(["a"] * 200_000) + "=1}]"}
    scene = folder / "cell.hcell"
    scene.write_text(cell([BOX]))
    for name, text in texts.items():
        file = folder / "deep.toml"
        file.write_text(text + "\n")
        refused(name, "inspect", file, says="nested deeper|MB|at most")
        settings = folder / "settings"
        (settings / "hapticell").mkdir(parents=True, exist_ok=True)
        (settings / "hapticell" / "hapticell.toml").write_text(text + "\n")


def test_xml_that_nests(folder):
    for count in (1000, 300_000):
        deep = {"links": "<link>" * count, "closed": "<link>" * count + "</link>" * count,
                "models": "<model name='m'>" * count + "</model>" * count, "ended first": "</link>" * 500 + "<link>" * count,
                "hidden ends": "<link><!-- </link> -->" * count, "quoted ends": "<link a='/>'>" * count}
        for name, text in deep.items():
            for ending, before in (("urdf", "<robot name='r'>"), ("sdf", "<sdf version='1.7'>"), ("xacro", "<robot xmlns:xacro='x'>"),
                                   ("world", "<sdf version='1.7'><world name='w'>"), ("dae", "<COLLADA><library_visual_scenes>")):
                file = folder / f"deep.{ending}"
                file.write_text(before + text)
                refused((ending, name), "inspect", file)
    file = folder / "wide.urdf"
    file.write_text("<robot name='r'><link " + " ".join(f"a{i}=''" for i in range(200_000)) + "/></robot>")
    refused("attributes", "inspect", file, says="attributes")
    file = folder / "robot.urdf"
    file.write_text("<robot name='r'><link name='l'/></robot>")
    (folder / "robot.srdf").write_text("<robot name='r'>" + "<group name='g'>" * 100_000)
    refused("srdf", "inspect", file, says="srdf.*nested deeper")


def test_models_that_include_each_other(folder):
    def model(name, includes, inside=""):
        text = "".join(f"<include><uri>model://{other}</uri><name>i{k}</name></include>" for k, other in enumerate(includes))
        (folder / name).mkdir(exist_ok=True)
        (folder / name / "model.config").write_text(f"<model><name>{name}</name><sdf version='1.6'>model.sdf</sdf></model>")
        (folder / name / "model.sdf").write_text(f"<sdf version='1.6'><model name='{name}'>{inside}{text}</model></sdf>")

    box = "<link name='l'><visual name='v'><geometry><box><size>1 1 1</size></box></geometry></visual></link>"
    joint = "<link name='k'/><joint name='j' type='fixed'><parent>l</parent><child>k</child></joint>"
    for inside in (box, box + joint):
        for k in range(19):
            model(f"m{k}", [f"m{k + 1}"] * 8, inside)
        model("m19", [], inside)
        file = folder / "world.sdf"
        file.write_text("<sdf version='1.6'><world name='w'><include><uri>model://m0</uri></include></world></sdf>")
        refused("models many times over", "inspect", file, says="200 000 elements")
    model("c0", ["c1"], box)
    model("c1", ["c0"], box)
    file.write_text("<sdf version='1.6'><world name='w'><include><uri>model://c0</uri></include></world></sdf>")
    run = Run("inspect", file)
    assert run.status in (0, 2) and "Segmentation" not in run.said, run.said
    assert run.status == 2 or any("it includes itself" in w for w in json.loads(run.answer)["warnings"]), run.answer


def gltf(nodes, **more):
    points = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    uri = "data:application/octet-stream;base64," + base64.b64encode(points).decode()
    return json.dumps({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": nodes,
                       "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                       "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
                       "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"uri": uri, "byteLength": 36}], **more})


def test_nodes_that_unfold(folder):
    doubled = [{"children": [k + 1, k + 1], "mesh": 0} for k in range(60)] + [{"mesh": 0}]
    circle = [{"children": [1], "mesh": 0}, {"children": [2]}, {"children": [1]}]
    chain = [{"children": [k + 1]} for k in range(100_000)] + [{"mesh": 0}]
    for name, nodes, says in (("doubled", doubled, "expands to more than"), ("circle", circle, "contains itself"), ("chain", chain, "levels")):
        file = folder / f"{name}.gltf"
        file.write_text(gltf(nodes))
        refused(name, "inspect", file, says=says)
    file = folder / "instances.gltf"
    file.write_text(gltf([{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 1}}}}],
                         accessors=[{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                                    {"componentType": 5126, "count": 150_000_000, "type": "VEC3",
                                     "sparse": {"count": 1, "indices": {"bufferView": 0, "componentType": 5125}, "values": {"bufferView": 0}}}]))
    refused("instances", "inspect", file)
    file = folder / "packed.gltf"
    file.write_text(gltf([{"mesh": 0}], bufferViews=[{"buffer": 0, "byteLength": 2_400_000_000, "extensions": {"EXT_meshopt_compression": {
        "buffer": 0, "byteLength": 36, "byteStride": 12, "count": 200_000_000, "mode": "ATTRIBUTES"}}}]))
    refused("packed", "inspect", file)


MESH = ("<mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/><vertex x='0' y='1' z='0'/></vertices>"
        "<triangles><triangle v1='0' v2='1' v3='2'/></triangles></mesh>")


def three_mf(path, objects, items):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as package:
        package.writestr("3D/3dmodel.model", "<model unit='millimeter' xmlns='http://schemas.microsoft.com/3dmanufacturing/core/2015/02'>"
                         f"<resources>{objects}</resources><build>{items}</build></model>")


def test_components_that_unfold(folder):
    def uses(*ids):
        return "<components>" + "".join(f"<component objectid='{i}'/>" for i in ids) + "</components>"

    doubled = "".join(f"<object id='{k}'>{uses(k + 1, k + 1)}</object>" for k in range(60)) + f"<object id='60'>{MESH}</object>"
    circle = f"<object id='0'>{uses(1)}</object><object id='1'>{uses(0)}</object>"
    nested = "<object id='0'>" + "<components>" * 100_000
    for name, objects, says in (("doubled", doubled, "expands to more than"), ("circle", circle, "contains itself"), ("nested", nested, "nested")):
        three_mf(folder / f"{name}.3mf", objects, "<item objectid='0'/>")
        refused(name, "inspect", folder / f"{name}.3mf", says=says)
    three_mf(folder / "items.3mf", f"<object id='0'>{MESH}</object>", "<item objectid='0'/>" * 400_000)
    refused("items", "inspect", folder / "items.3mf", says="expands to more than")


def collada(nodes, scene):
    return ("<COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><asset><unit meter='1'/><up_axis>Z_UP</up_axis></asset>"
            "<library_geometries><geometry id='g'><mesh><source id='p'><float_array id='a' count='9'>0 0 0 1 0 0 0 1 0</float_array>"
            "<technique_common><accessor source='#a' count='3' stride='3'><param name='X' type='float'/><param name='Y' type='float'/>"
            "<param name='Z' type='float'/></accessor></technique_common></source><vertices id='v'><input semantic='POSITION' source='#p'/>"
            "</vertices><triangles count='1'><input semantic='VERTEX' source='#v' offset='0'/><p>0 1 2</p></triangles></mesh></geometry>"
            f"</library_geometries><library_nodes>{nodes}</library_nodes><library_visual_scenes><visual_scene id='s'>{scene}</visual_scene>"
            "</library_visual_scenes><scene><instance_visual_scene url='#s'/></scene></COLLADA>")


def test_instances_that_unfold(folder):
    def uses(k, *others):
        return f"<node id='n{k}'>" + "".join(f"<instance_node url='#n{o}'/>" for o in others) + "</node>"

    last = "<node id='n40'><instance_geometry url='#g'/></node>"
    doubled = "".join(uses(k, k + 1, k + 1) for k in range(40)) + last
    circle = uses(0, 1) + uses(1, 0)
    start = "<node id='root'><instance_node url='#n0'/></node>"
    for name, nodes, says in (("doubled", doubled, "expands to more than"), ("circle", circle, "contains itself")):
        file = folder / f"{name}.dae"
        file.write_text(collada(nodes, start))
        refused(name, "inspect", file, says=says)
    file = folder / "own.dae"
    file.write_text(collada("", "<node id='a'><instance_node url='#a'/><instance_geometry url='#g'/></node>"))
    refused("a node in itself", "inspect", file, says="contains itself")
    file = folder / "sound.dae"
    file.write_text(collada(uses(0, 40, 40) + last, start))
    assert Run("inspect", file).status == 0, "twice is harmless"


def test_programs_that_nest(folder):
    texts = {"deep.src": "DEF a()\n" + "X = " + "(" * 200_000 + "\nEND\n", "if.src": "DEF a()\n" + "IF TRUE THEN\n" * 50_000 + "END\n",
             "deep.mod": "MODULE m\nPROC main()\nx := " + "(" * 200_000 + ";\nENDPROC\nENDMODULE\n",
             "if.mod": "MODULE m\nPROC main()\n" + "IF TRUE THEN\n" * 50_000 + "ENDPROC\nENDMODULE\n",
             "deep.script": "def a():\n  x = " + "[" * 200_000 + "\nend\n",
             "deep.ls": "/PROG A\n/MN\n 1: R[1]=" + "(" * 200_000 + " ;\n/END\n"}
    calls = "".join(f"DEF r{k}()\n" + f"r{k + 1}()\n" * 20 + "END\n" for k in range(40)) + "DEF r40()\nEND\n"
    texts["calls.src"] = "DEF calls()\nIF $IN[1] THEN\nr0()\nENDIF\nEND\n" + calls
    for name, text in texts.items():
        file = folder / name
        file.write_text(text)
        run = Run("trajectory", "info", file)
        assert run.status in (0, 2), (name, run.status, run.said)
        run.check_means(name)


def test_recordings_and_lists_that_nest(folder):
    bvh = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    (folder / "deep.bvh").write_text(bvh + "JOINT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n" * 50_000)
    refused("bvh", "ergonomics", "rula", "--motion", folder / "deep.bvh")
    for name, text in {"flow": "[" * 200_000, "maps": "{a: " * 200_000, "dashes": "- " * 200_000, "keys": "? " * 200_000,
                       "block": "".join(" " * k + "a:\n" for k in range(3000)), "comma": ",", "commas": "a: 1\n,\n" * 10,
                       "anchors": "a: &a [1]\n" + "".join(f"b{k}: &b{k} [*a, *a]\n" for k in range(10_000)), "tags": "!!" * 100_000}.items():
        (folder / "deep.yaml").write_text(text)
        refused(name, "trajectory", "info", folder / "deep.yaml")


# ---- what is no file ------------------------------------------------------------------------------------------------

def odd_files(folder):
    """Pipes, devices, sockets, folders and links to them, by kind."""
    os.mkfifo(folder / "pipe")
    (folder / "zero").symlink_to("/dev/zero")
    (folder / "link").symlink_to("pipe")
    (folder / "folder").mkdir()
    listening = socket.socket(socket.AF_UNIX)
    before = os.getcwd()
    os.chdir(folder)  # Names of sockets are short.
    listening.bind("socket")
    os.chdir(before)
    return {"pipe": "a pipe", "zero": "a device", "link": "a pipe", "folder": "a folder", "socket": "a socket"}


def test_only_regular_files_are_opened(folder):
    scene = folder / "cell.hcell"
    scene.write_text(cell([BOX]))
    hand = folder / "hand.csv"
    hand.write_text("t,x,y,z,qw,qx,qy,qz,button\n0,0,0,0,1,0,0,0,0\n0.1,0,0,0,1,0,0,0,0\n")
    kinds = odd_files(folder)
    endings = ("hcell", "stl", "obj", "ply", "off", "step", "iges", "gltf", "glb", "dae", "3mf", "fbx", "3ds", "urdf", "xacro", "sdf", "world", "toml")
    for kind, word in kinds.items():
        commands = {}
        for ending in endings:
            named = folder / f"{kind}.{ending}"
            named.symlink_to(kind)
            commands["inspect " + ending] = ("inspect", named)
        odd = folder / kind
        named = {}
        for ending in ("csv", "htraj", "yaml", "src", "mod", "ls", "script", "bvh", "c3d", "json"):
            named[ending] = folder / f"as-{kind}.{ending}"
            named[ending].symlink_to(kind)
        for ending in ("csv", "htraj", "yaml", "src", "mod", "ls", "script"):
            commands["trajectory " + ending] = ("trajectory", "info", named[ending])
        for ending in ("bvh", "c3d"):
            commands["motion " + ending] = ("ergonomics", "rula", "--motion", named[ending])
        commands["posture"] = ("mannequin", "--sex", "male", "--percentile", "50", "--posture", named["json"])
        commands["targets"] = ("mannequin", "--sex", "male", "--percentile", "50", "--targets", named["csv"])
        commands["input"] = ("ergonomics", "rula", "--input", named["json"])
        commands["hand"] = ("session", "--workcell", scene, "--entity", "b", "--hand", named["csv"])
        commands["poses"] = ("distance", "--moving", "box:1,1,1", "--environment", "box:1,1,1", "--poses", named["csv"])
        commands["joints"] = ("fk", "--robot", "library:ur5e", "--joints", named["csv"])
        commands["ik"] = ("ik", "--robot", "library:ur5e", "--poses", named["csv"])
        commands["session's cell"] = ("session", "--workcell", folder / f"{kind}.hcell", "--entity", "b", "--hand", hand)
        commands["convert"] = ("convert", folder / f"{kind}.stl", "-o", folder / "out.stl")
        for name, words in commands.items():
            run = refused((kind, name), *words)
            assert word in run.said or "no such" in run.said or kind == "folder", (kind, name, run.said)
        odd.lstat()


def test_what_files_name_is_regular_too(folder):
    kinds = odd_files(folder)
    for kind in kinds:
        (folder / "m.mtl").unlink(missing_ok=True)
        (folder / "m.mtl").symlink_to(kind)
        named = {}
        for ending in ("stl", "dae", "gltf", "step", "xacro", "yaml", "obj", "sdf", "htraj", "csv", "srdf"):
            named[ending] = f"n-{kind}.{ending}"
            (folder / named[ending]).symlink_to(kind)
        urdf = "<robot name='r'><link name='l'><visual><geometry><mesh filename='{}'/></geometry></visual></link></robot>"
        texts = {
            "mesh.urdf": urdf.format(named["stl"]), "dae.urdf": urdf.format(named["dae"]), "step.urdf": urdf.format(named["step"]),
            "in.xacro": f"<robot name='r' xmlns:xacro='x'><xacro:include filename='{named['xacro']}'/><link name='l'/></robot>",
            "yaml.xacro": f"<robot name='r' xmlns:xacro='x'><link name=\"${{xacro.load_yaml('{named['yaml']}')}}\"/></robot>",
            "model.sdf": f"<sdf version='1.6'><model name='m'><link name='l'><visual name='v'><geometry><mesh><uri>{named['stl']}</uri></mesh></geometry></visual></link></model></sdf>",
            "in.sdf": f"<sdf version='1.6'><world name='w'><include><uri>{named['sdf']}</uri></include></world></sdf>",
            "buffer.gltf": gltf([{"mesh": 0}], buffers=[{"uri": kind, "byteLength": 36}]),
            "first.gltf": json.dumps({"asset": {"version": "1.0"}, "scene": "s", "scenes": {"s": {"nodes": []}}, "buffers": {"b": {"uri": kind, "byteLength": 36}}}),
            "cell.hcell": cell([{"name": "b", "kind": "solid", "source": {"file": named["stl"]}}]),
            "robot.hcell": cell([{"name": "b", "kind": "robot", "source": {"file": named["xacro"]}}]),
            "trajectory.hcell": cell([BOX], trajectories=[{"name": "t", "file": named["htraj"]}, {"name": "u", "file": named["csv"]}]),
            "materials.obj": "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
            "refs.step": "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('a','',(''),(''),'','','');\n"
                         f"FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n#1=DOCUMENT_FILE('{kind}','',$,#2,'',$);\nENDSEC;\nEND-ISO-10303-21;\n",
        }
        for name, text in texts.items():
            (folder / name).write_text(text)
            run = Run("inspect", folder / name)
            assert run.status in (0, 2), (kind, name, run.status, run.said)
            if run.status == 0:
                told = json.loads(run.answer)["warnings"]
                assert told or name == "materials.obj" or kind == "folder", (kind, name)
            run.check_means((kind, name))
        (folder / "robot.urdf").write_text("<robot name='r'><link name='l'/></robot>")
        (folder / "robot.srdf").unlink(missing_ok=True)
        (folder / "robot.srdf").symlink_to(kind)
        Run("inspect", folder / "robot.urdf").check_means((kind, "srdf"))


# ---- nothing that is opened runs ------------------------------------------------------------------------------------

def test_no_expression_runs_anything(folder):
    touch = "touch " + str(folder / "escaped")
    ways = [f"__import__('os').system('{touch}')", "().__class__.__base__.__subclasses__()",
            f"[c for c in ().__class__.__base__.__subclasses__() if c.__name__=='_wrap_close'][0].__init__.__globals__['system']('{touch}')",
            f"(lambda: [c for c in ().__class__.__base__.__subclasses__()][0].system('{touch}'))()",
            f"list(([c for c in y.__class__.__base__.__subclasses__()][0]('{touch}')) for y in [()])",
            "(lambda: 0).__globals__", "(i for i in [1]).gi_frame.f_globals", "f'{().__class__}'", "'{0.__class__}'.format(1)",
            "'%s'.__mod__(1)", "getattr(math, '__dict__')", f"eval('{touch}')", f"exec('{touch}')", "open('/etc/passwd').read()",
            "globals()", "math.__loader__", "load_yaml.__globals__", "xacro.load_yaml('/etc/passwd')", "9**9**9", "'a'*10**10",
            "[0]*10**10", "range(10**12)", "[i for i in range(99999) for j in range(99999)]", "(" * 5000 + "1" + ")" * 5000,
            "(lambda f: f(f))(lambda f: f(f))"]
    head = "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>"
    tail = "<link name='a'/></robot>"
    files = {f"way {k}": f'<xacro:property name="x" value="${{{way}}}"/><link name="l_${{x}}"/>' for k, way in enumerate(ways)}
    files |= {"$(eval)": f"<link name=\"$(eval __import__('os').system('{touch}'))\"/>", "$(command)": f"<link name='$(command {touch})'/>",
              "$(env)": "<link name='$(env HAPTICELL_NOT_SET)'/>", "$(dirname)": f"<link name='$(anon {touch})'/>",
              "macro": "<xacro:macro name='m'><xacro:m/></xacro:macro><xacro:m/>", "include": "<xacro:include filename='in.xacro'/>",
              "yaml": "<link name=\"${xacro.load_yaml('y.yaml')}\"/>", "yaml new": "<link name=\"${xacro.load_yaml('z.yaml')}\"/>"}
    (folder / "y.yaml").write_text(f"x: !!python/object/apply:os.system ['{touch}']\n")
    (folder / "z.yaml").write_text(f"x: !!python/object/new:subprocess.Popen [['touch', '{folder}/escaped']]\n")
    for name, text in files.items():
        (folder / "in.xacro").write_text(head + text + tail)
        (folder / "cell.hcell").write_text(cell([{"name": "r", "kind": "robot", "source": {"file": "in.xacro"}}]))
        for file in ("in.xacro", "cell.hcell"):
            run = Run("inspect", folder / file)
            assert run.status == 2 or name in ("$(dirname)",), (name, file, run.status, run.said, run.answer[:200])
            run.check_means((name, file))
        assert not (folder / "escaped").exists(), name


if __name__ == "__main__":
    wanted = sys.argv[2] if len(sys.argv) > 2 else ""
    failed = 0
    for test, function in [(n, f) for n, f in globals().items() if n.startswith("test_") and wanted in n]:
        with tempfile.TemporaryDirectory() as place:
            try:
                function(pathlib.Path(place))
                print("passed", test)
            except AssertionError as fault:
                failed += 1
                print("FAILED", test, *fault.args)
    sys.exit(1 if failed else 0)
