#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the meshes of the built-in robot HC-6 and of the demonstration workcell, and the robot's URDF.

usage: make_demo_workcell.py CONFIG_FOLDER     (the project's config/)

Everything is made from the dimensions below; the files it writes are part of the project, so that nobody needs to run
this to use the program. The workcell document itself (config/workcells/demo.hcell) is written by write_demo_document.py.
"""
import math
import pathlib
import sys

from solid_kit import Solid, belt, box, cylinder, prism, rectangle, revolve, upright

# HC-6: six axes, spherical wrist, 12 kg, 1.4 m. Metres.
A1_HEIGHT, A2_HEIGHT, A2_FORWARD = 0.22, 0.23, 0.15
UPPER_ARM, FOREARM, FOREARM_RISE = 0.60, 0.66, 0.04
A4_FORWARD, WRIST_TO_FLANGE, JAW_CENTRE = 0.25, 0.09, 0.235
LIMITS_DEG = [(-170, 170), (-95, 135), (-120, 155), (-200, 200), (-115, 115), (-350, 350)]
SPEED_DEG = [200, 175, 190, 430, 430, 630]


def along_x(solid):
    """A solid turned about Z becomes one turned about X."""
    return solid.turned("y", 90)


def along_y(solid):
    return solid.turned("x", -90)


def base(fine):
    plate = prism(rectangle(0.46, 0.42, 0.05), 0.0, 0.035, 0.006 if fine else 0)
    n = 56 if fine else 20
    body = revolve([(0, 0.03), (0.19, 0.03), (0.185, 0.06), (0.165, 0.16), (0.172, 0.20), (0.165, 0.212), (0, 0.212)], n)
    light = plate + body
    socket = box(-0.27, -0.12, -0.075, 0.075, 0.05, 0.16, 0.008 if fine else 0)
    dark = socket
    if fine:
        for x in (-0.19, 0.19):
            for y in (-0.17, 0.17):
                dark = dark + cylinder(0.016, 0.034, 0.046, 0.003, 16).moved(x, y)
        for y in (-0.04, 0.0, 0.04):
            dark = dark + along_x(cylinder(0.014, 0, 0.03, 0.003, 16)).moved(-0.295, y, 0.105)
    return light, dark


def column(fine):
    n, c = (56, 0.008) if fine else (20, 0)
    steps = 18 if fine else 6
    light = cylinder(0.18, 0.0, 0.055, c, n)
    light += upright(prism(belt((0.0, 0.03), 0.15, (A2_FORWARD, A2_HEIGHT), 0.125, steps), -0.08, 0.08, c))
    dark = along_y(cylinder(0.095, -0.24, -0.07, c, n)).moved(A2_FORWARD, 0, A2_HEIGHT)
    dark += cylinder(0.07, 0.05, 0.26, c, n).moved(-0.12, -0.02, 0)
    if fine:
        dark += along_y(cylinder(0.075, -0.265, -0.235, 0.004, n)).moved(A2_FORWARD, 0, A2_HEIGHT)
        dark += cylinder(0.05, 0.255, 0.285, 0.004, n).moved(-0.12, -0.02, 0)
    return light, dark


def upper_arm(fine):
    c, steps = (0.012, 20) if fine else (0, 6)
    n = 48 if fine else 16
    light = upright(prism(belt((0, 0), 0.125, (0, UPPER_ARM), 0.105, steps), -0.18, -0.088, c))
    dark = Solid()
    if fine:
        dark += upright(prism(belt((0, 0.17), 0.052, (0, 0.45), 0.045, steps), -0.186, -0.17, 0.004))
        for z, r in ((0.0, 0.088), (UPPER_ARM, 0.075)):
            dark += along_y(cylinder(r, 0.17, 0.196, 0.006, n)).moved(0, 0, z)
    # Seen from +Y the arm is in front of the column; its hubs reach inwards to it.
    light += along_y(cylinder(0.1, 0.078, 0.1, 0, n)) + along_y(cylinder(0.085, 0.078, 0.1, 0, n)).moved(0, 0, UPPER_ARM)
    return light, dark


def elbow(fine):
    c, steps, n = (0.012, 16, 48) if fine else (0, 6, 16)
    light = upright(prism(belt((-0.10, 0.035), 0.098, (0.07, FOREARM_RISE), 0.088, steps), -0.083, 0.078, c))
    light += along_x(revolve([(0, 0.05), (0.088, 0.05), (0.086, 0.16), (0.08, A4_FORWARD - 0.004), (0, A4_FORWARD - 0.004)], n)).moved(
        0, 0, FOREARM_RISE)
    dark = Solid()
    for y, z in ((-0.048, 0.075), (0.048, 0.075), (0.0, -0.012)):
        dark += along_x(cylinder(0.041, -0.33, -0.13, c * 0.5, n // 2)).moved(0, y, z)
        if fine:
            dark += along_x(cylinder(0.03, -0.352, -0.325, 0.004, n // 2)).moved(0, y, z)
    if fine:
        dark += along_y(cylinder(0.06, -0.092, -0.075, 0.005, n)).moved(0, 0, 0)
    return light, dark


def forearm(fine):
    c, steps, n = (0.006, 14, 48) if fine else (0, 6, 16)
    reach = FOREARM - A4_FORWARD
    light = along_x(revolve([(0, 0.0), (0.078, 0.0), (0.078, 0.05), (0.062, 0.22), (0.062, 0.30), (0.056, 0.306), (0, 0.306)], n))
    cheek = upright(prism(belt((0.265, 0), 0.052, (reach, 0), 0.056, steps), 0.046, 0.078, c))
    light += cheek + cheek.mirrored_y()
    dark = Solid()
    if fine:
        for side in (1, -1):
            cap = along_y(cylinder(0.042, 0.075, 0.088, 0.004, n)).moved(reach, 0, 0)
            dark += cap if side > 0 else cap.mirrored_y()
        dark += along_x(cylinder(0.082, 0.012, 0.03, 0.003, n))
    return light, dark


def wrist(fine):
    n, c = (40, 0.006) if fine else (16, 0)
    dark = along_y(cylinder(0.051, -0.044, 0.044, c, n))
    dark += along_x(cylinder(0.044, 0.0, WRIST_TO_FLANGE - 0.025, c, n))
    return Solid(), dark


def flange(fine):
    n, c = (40, 0.002) if fine else (16, 0)
    light = along_x(cylinder(0.04, 0.0, 0.025, c, n))
    return light, Solid()


def gripper(fine):
    c = 0.006 if fine else 0
    dark = cylinder(0.042, 0.0, 0.022, 0.002 if fine else 0, 40 if fine else 16)
    dark += box(-0.075, 0.075, -0.045, 0.045, 0.02, 0.115, c)
    light = Solid()
    for side in (1, -1):
        jaw = box(0.045, 0.062, -0.02, 0.02, 0.13, 0.25, 0.002 if fine else 0) + box(0.04, 0.075, -0.026, 0.026, 0.112, 0.135, 0.003 if fine else 0)
        light += jaw if side > 0 else jaw.turned("z", 180)
    if fine:
        dark += along_y(cylinder(0.018, 0.04, 0.07, 0.003, 24)).moved(0.03, 0, 0.07)
        dark += along_y(cylinder(0.018, 0.04, 0.07, 0.003, 24)).moved(-0.03, 0, 0.07)
    return light, dark


HOUSING_GRIP = 0.055  # of the housing's underside below the jaw centre


def housing(fine):
    """Frame at the middle of its underside, Z up."""
    part = prism(rectangle(0.12, 0.09, 0.012 if fine else 0, 4), 0.0, 0.012, 0.0015 if fine else 0)
    part += prism(rectangle(0.088, 0.06, 0.006 if fine else 0, 4), 0.011, 0.068, 0.004 if fine else 0)
    n = 40 if fine else 16
    part += cylinder(0.024, 0.066, 0.082, 0.003 if fine else 0, n)
    part += along_y(cylinder(0.020, 0.028, 0.044, 0.002 if fine else 0, n)).moved(0, 0, 0.04)
    if fine:
        part += along_y(revolve([(0.0, 0.0), (0.012, 0.0), (0.012, 0.006), (0, 0.006)], n)).moved(0, 0.042, 0.04)
        for x in (-0.05, 0.05):
            for y in (-0.035, 0.035):
                part += cylinder(0.007, 0.011, 0.017, 0.0015, 16).moved(x, y)
    return part


def write_robot(folder):
    meshes = folder / "meshes"
    meshes.mkdir(parents=True, exist_ok=True)
    links = [("base_link", base), ("link_1", column), ("link_2", upper_arm), ("link_3", elbow), ("link_4", forearm),
             ("link_5", wrist), ("link_6", flange), ("gripper", gripper)]
    joints = [("joint_1", "base_link", "link_1", (0, 0, A1_HEIGHT), "0 0 1"),
              ("joint_2", "link_1", "link_2", (A2_FORWARD, 0, A2_HEIGHT), "0 1 0"),
              ("joint_3", "link_2", "link_3", (0, 0, UPPER_ARM), "0 1 0"),
              ("joint_4", "link_3", "link_4", (A4_FORWARD, 0, FOREARM_RISE), "1 0 0"),
              ("joint_5", "link_4", "link_5", (FOREARM - A4_FORWARD, 0, 0), "0 1 0"),
              ("joint_6", "link_5", "link_6", (WRIST_TO_FLANGE - 0.025, 0, 0), "1 0 0")]
    lines = ['<?xml version="1.0"?>',
             "<!-- HC-6: HaptiCell's own demonstration robot, 12 kg, 1.4 m, with gripper G2 holding housing 4711.",
             "     Made by tools/demo/make_demo_workcell.py. Licence: Apache-2.0. -->",
             '<robot name="HC-6">',
             '  <material name="light"><color rgba="0.80 0.81 0.82 1"/></material>',
             '  <material name="dark"><color rgba="0.22 0.25 0.29 1"/></material>',
             '  <material name="tan"><color rgba="0.66 0.56 0.42 1"/></material>']

    def mesh(kind, name, material=None):
        lines.append(f'    <{kind}><geometry><mesh filename="meshes/{name}"/></geometry>' +
                     (f'<material name="{material}"/>' if material else "") + f"</{kind}>")

    for name, make in links:
        lines.append(f'  <link name="{name}">')
        for material, solid in zip(("light", "dark"), make(True)):
            if solid.triangles:
                solid.write_stl(meshes / f"{name}_{material}.stl")
                mesh("visual", f"{name}_{material}.stl", material)
        light, dark = make(False)
        (light + dark).write_stl(meshes / f"{name}_collision.stl")
        mesh("collision", f"{name}_collision.stl")
        lines.append("  </link>")
    housing(True).write_stl(meshes / "housing.stl")
    housing(False).write_stl(meshes / "housing_collision.stl")
    lines.append('  <link name="housing_4711">')
    mesh("visual", "housing.stl", "tan")
    mesh("collision", "housing_collision.stl")
    lines += ["  </link>", '  <link name="tool0"/>', '  <link name="tcp"/>']
    for (name, parent, child, origin, axis), (low, high), speed in zip(joints, LIMITS_DEG, SPEED_DEG):
        xyz = " ".join(f"{v:g}" for v in origin)
        lines += [f'  <joint name="{name}" type="revolute">', f'    <parent link="{parent}"/><child link="{child}"/>',
                  f'    <origin xyz="{xyz}"/><axis xyz="{axis}"/>',
                  f'    <limit lower="{math.radians(low):.6f}" upper="{math.radians(high):.6f}" '
                  f'velocity="{math.radians(speed):.4f}" effort="0"/>', "  </joint>"]
    quarter = f"{math.pi / 2:.15f}"
    half = f"{math.pi:.15f}"
    for name, parent, child, xyz, rpy in (("flange_tool0", "link_6", "tool0", "0.025 0 0", f"0 {quarter} 0"),
                                          ("tool0_gripper", "tool0", "gripper", "0 0 0", "0 0 0"),
                                          ("gripper_tcp", "gripper", "tcp", f"0 0 {JAW_CENTRE:g}", "0 0 0"),
                                          ("tcp_housing", "tcp", "housing_4711", f"0 0 {HOUSING_GRIP:g}", f"{half} 0 0")):
        lines += [f'  <joint name="{name}" type="fixed">', f'    <parent link="{parent}"/><child link="{child}"/>',
                  f'    <origin xyz="{xyz}" rpy="{rpy}"/>', "  </joint>"]
    lines.append("</robot>")
    (folder / "robot.urdf").write_text("\n".join(lines) + "\n")
    (folder / "LICENSE").write_text("SPDX-License-Identifier: Apache-2.0\n\nMade for HaptiCell by tools/demo/make_demo_workcell.py.\n")


# The cell. X forward from the robot, Y to its left, Z up; heights in world metres.
TABLE_TOP, PLATE_TOP, SEAT = 0.70, 0.725, 0.75
FIXTURE_X, FIXTURE_Y = 0.99, 0.0


def table():
    top = box(0.58, 1.46, -0.62, 0.62, TABLE_TOP - 0.05, TABLE_TOP, 0.006)
    frame = Solid()
    for x in (0.64, 1.40):
        for y in (-0.56, 0.56):
            frame += box(x - 0.035, x + 0.035, y - 0.035, y + 0.035, 0.02, TABLE_TOP - 0.05, 0.004)
            frame += cylinder(0.04, 0.0, 0.02, 0.004, 24).moved(x, y)
    for y in (-0.56, 0.56):
        frame += box(0.67, 1.37, y - 0.02, y + 0.02, 0.18, 0.24, 0.004)
    for x in (0.64, 1.40):
        frame += box(x - 0.02, x + 0.02, -0.53, 0.53, 0.18, 0.24, 0.004)
    return top + frame


def base_plate():
    plate = prism(rectangle(0.50, 0.62, 0.02), TABLE_TOP, PLATE_TOP, 0.004)
    for x in (-0.21, 0.21):
        for y in (-0.27, -0.09, 0.09, 0.27):
            plate += cylinder(0.011, PLATE_TOP - 0.002, PLATE_TOP + 0.004, 0.0015, 16).moved(x, y)
    return plate.moved(FIXTURE_X, FIXTURE_Y)


def locator(x, y):
    return (prism(rectangle(0.036, 0.036, 0.004, 3), PLATE_TOP, SEAT, 0.002)).moved(FIXTURE_X + x, FIXTURE_Y + y)


def stop_rail():
    rail = box(0.105, 0.13, -0.13, 0.13, PLATE_TOP, PLATE_TOP + 0.055, 0.003)
    for y in (-0.11, 0.11):
        rail += box(0.125, 0.17, y - 0.012, y + 0.012, PLATE_TOP, PLATE_TOP + 0.035, 0.002)
    return rail.moved(FIXTURE_X, FIXTURE_Y)


def clamp_tower(x, y, facing):
    """A toggle clamp on a post; its arm is swung open, away from the part."""
    tower = box(-0.045, 0.045, -0.045, 0.045, 0.0, 0.018, 0.003)
    tower += box(-0.028, 0.028, -0.03, 0.03, 0.016, 0.15, 0.004)
    tower += along_x(cylinder(0.026, -0.036, 0.036, 0.003, 32)).moved(0, 0, 0.155)
    lean = math.radians(58)
    end = (0.12 * math.cos(lean), 0.12 * math.sin(lean))
    arm = upright(prism(belt((0, 0), 0.016, end, 0.011, 10), -0.012, 0.012, 0.003))
    spindle = cylinder(0.008, -0.012, 0.045, 0.002, 20) + cylinder(0.013, 0.04, 0.052, 0.003, 20)
    arm += spindle.turned("y", -32).moved(end[0] * 0.93, 0, end[1] * 0.93)
    tower += arm.turned("z", -90).moved(0, 0, 0.155)
    tower += cylinder(0.017, 0.018, 0.12, 0.003, 24).moved(0.0, 0.052, 0)
    return tower.turned("z", facing).moved(FIXTURE_X + x, FIXTURE_Y + y, PLATE_TOP)


def conveyor():
    bed = Solid()
    for y in (-0.235, 0.235):
        bed += box(-1.6, 1.6, y - 0.02, y + 0.02, 0.74, 0.86, 0.004)
    for x in (-1.35, -0.45, 0.45, 1.35):
        for y in (-0.235, 0.235):
            bed += box(x - 0.03, x + 0.03, y - 0.025, y + 0.025, 0.0, 0.74, 0.003)
        bed += box(x - 0.02, x + 0.02, -0.21, 0.21, 0.30, 0.36, 0.003)
    for k in range(27):
        bed += along_y(cylinder(0.032, -0.215, 0.215, 0.003, 24)).moved(-1.56 + 0.12 * k, 0, 0.835)
    return bed.moved(0.75, 1.18)


WIRE = 0.0025  # 14 sides: no facet edge is sharp enough to be drawn, so that the fence stays quiet


def fence():
    panels = Solid()

    def panel(x0, x1, y, posts_at):
        length = x1 - x0
        part = box(x0, x1, y - 0.012, y + 0.012, 0.15, 0.18) + box(x0, x1, y - 0.012, y + 0.012, 1.92, 1.95)
        count = int(length / 0.1)
        for k in range(1, count):
            x = x0 + k * length / count
            part += cylinder(WIRE, 0.18, 1.92, 0, 14).moved(x, y)
        for k in range(1, 9):
            z = 0.18 + k * 1.74 / 9
            part += along_x(cylinder(WIRE, x0, x1, 0, 14)).moved(0, y, z)
        for x in posts_at:
            part += box(x - 0.025, x + 0.025, y - 0.025, y + 0.025, 0.0, 2.0, 0.003)
        return part

    for k in range(3):
        x0, x1 = -1.05 + k * 1.2, 0.15 + k * 1.2
        panels += panel(x0, x1, 1.72, (x0, x1) if k == 0 else (x1,))
    side = panel(-1.72, -0.1, 0, (-1.72,)).turned("z", 90).moved(-1.05, 1.72 + 0.1) + panel(-1.6, -0.15, 0, (-1.6, -0.15)).turned("z", 90).moved(-1.05, 0.1)
    return panels + side


def posts():
    part = Solid()
    for x, y in ((0.42, -0.78), (0.86, -0.86)):
        part += cylinder(0.075, 0.0, 0.015, 0.004, 32).moved(x, y) + cylinder(0.03, 0.01, 1.55, 0.004, 28).moved(x, y)
    return part


def cabinet():
    part = box(-0.82, -0.32, 0.62, 0.85, 0.08, 1.55, 0.006) + box(-0.79, -0.35, 0.64, 0.83, 0.0, 0.08)
    part += box(-0.79, -0.35, 0.612, 0.622, 0.14, 1.49, 0.003)
    part += box(-0.40, -0.38, 0.60, 0.614, 0.75, 0.92, 0.002)
    return part


def pedestal():
    return cylinder(0.34, 0.0, 0.03, 0.005, 56) + cylinder(0.21, 0.03, 0.32, 0.0, 56) + cylinder(0.28, 0.32, 0.35, 0.005, 56)


def write_cell(folder):
    folder.mkdir(parents=True, exist_ok=True)
    parts = {"table": table(), "base_plate": base_plate(), "locator_2": locator(0.042, -0.027), "stop_rail": stop_rail(),
             "locators_1_3_4": locator(-0.042, -0.027) + locator(-0.042, 0.027) + locator(0.042, 0.027),
             "clamp_tower_a": clamp_tower(-0.02, 0.17, 180), "clamp_tower_b": clamp_tower(-0.02, -0.17, 0),
             "clamp_tower_c": clamp_tower(-0.19, 0.0, -90), "conveyor": conveyor(), "fence": fence(), "posts": posts(),
             "cabinet": cabinet(), "pedestal": pedestal(), "housing": housing(True)}
    total = 0
    for name, solid in parts.items():
        solid.write_stl(folder / f"{name}.stl")
        total += len(solid.triangles)
        print(f"{name}: {len(solid.triangles)} triangles")
    print(f"cell: {total} triangles")


if __name__ == "__main__":
    config = pathlib.Path(sys.argv[1])
    write_robot(config / "robots" / "hc6")
    write_cell(config / "workcells" / "demo")
