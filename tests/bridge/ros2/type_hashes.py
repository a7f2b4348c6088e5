# SPDX-License-Identifier: Apache-2.0
"""Type hashes of ROS 2 (RIHS01 of REP 2011), calculated from the public .msg definitions, which share nothing with our IDL.

published: hashes that others have published: `ros2 topic info --verbose` of ROS 2 Jazzy, the code that rosidl generates for
moveit_msgs and control_msgs, and tables of other implementations.
"""
import hashlib
import json
import re

DEFINITIONS = """
unique_identifier_msgs/UUID: uint8[16] uuid
builtin_interfaces/Time: int32 sec, uint32 nanosec
builtin_interfaces/Duration: int32 sec, uint32 nanosec
std_msgs/Header: builtin_interfaces/Time stamp, string frame_id
std_msgs/ColorRGBA: float32 r, float32 g, float32 b, float32 a
std_msgs/String: string data
rosgraph_msgs/Clock: builtin_interfaces/Time clock
geometry_msgs/Point: float64 x, float64 y, float64 z
geometry_msgs/Point32: float32 x, float32 y, float32 z
geometry_msgs/Vector3: float64 x, float64 y, float64 z
geometry_msgs/Quaternion: float64 x, float64 y, float64 z, float64 w
geometry_msgs/Pose: Point position, Quaternion orientation
geometry_msgs/PoseStamped: std_msgs/Header header, Pose pose
geometry_msgs/Transform: Vector3 translation, Quaternion rotation
geometry_msgs/TransformStamped: std_msgs/Header header, string child_frame_id, Transform transform
geometry_msgs/Twist: Vector3 linear, Vector3 angular
geometry_msgs/Wrench: Vector3 force, Vector3 torque
geometry_msgs/WrenchStamped: std_msgs/Header header, Wrench wrench
geometry_msgs/Polygon: Point32[] points
tf2_msgs/TFMessage: geometry_msgs/TransformStamped[] transforms
sensor_msgs/JointState: std_msgs/Header header, string[] name, float64[] position, float64[] velocity, float64[] effort
sensor_msgs/MultiDOFJointState: std_msgs/Header header, string[] joint_names, geometry_msgs/Transform[] transforms, \
geometry_msgs/Twist[] twist, geometry_msgs/Wrench[] wrench
sensor_msgs/CompressedImage: std_msgs/Header header, string format, uint8[] data
trajectory_msgs/JointTrajectoryPoint: float64[] positions, float64[] velocities, float64[] accelerations, float64[] effort, \
builtin_interfaces/Duration time_from_start
trajectory_msgs/JointTrajectory: std_msgs/Header header, string[] joint_names, JointTrajectoryPoint[] points
shape_msgs/MeshTriangle: uint32[3] vertex_indices
shape_msgs/Mesh: MeshTriangle[] triangles, geometry_msgs/Point[] vertices
shape_msgs/Plane: float64[4] coef
shape_msgs/SolidPrimitive: uint8 type, float64[<=3] dimensions, geometry_msgs/Polygon polygon
visualization_msgs/UVCoordinate: float32 u, float32 v
visualization_msgs/MeshFile: string filename, uint8[] data
visualization_msgs/Marker: std_msgs/Header header, string ns, int32 id, int32 type, int32 action, geometry_msgs/Pose pose, \
geometry_msgs/Vector3 scale, std_msgs/ColorRGBA color, builtin_interfaces/Duration lifetime, bool frame_locked, \
geometry_msgs/Point[] points, std_msgs/ColorRGBA[] colors, string texture_resource, sensor_msgs/CompressedImage texture, \
UVCoordinate[] uv_coordinates, string text, string mesh_resource, MeshFile mesh_file, bool mesh_use_embedded_materials
visualization_msgs/MarkerArray: Marker[] markers
object_recognition_msgs/ObjectType: string key, string db
octomap_msgs/Octomap: std_msgs/Header header, bool binary, string id, float64 resolution, int8[] data
octomap_msgs/OctomapWithPose: std_msgs/Header header, geometry_msgs/Pose origin, Octomap octomap
moveit_msgs/AllowedCollisionEntry: bool[] enabled
moveit_msgs/AllowedCollisionMatrix: string[] entry_names, AllowedCollisionEntry[] entry_values, \
string[] default_entry_names, bool[] default_entry_values
moveit_msgs/LinkPadding: string link_name, float64 padding
moveit_msgs/LinkScale: string link_name, float64 scale
moveit_msgs/ObjectColor: string id, std_msgs/ColorRGBA color
moveit_msgs/CollisionObject: std_msgs/Header header, geometry_msgs/Pose pose, string id, \
object_recognition_msgs/ObjectType type, shape_msgs/SolidPrimitive[] primitives, geometry_msgs/Pose[] primitive_poses, \
shape_msgs/Mesh[] meshes, geometry_msgs/Pose[] mesh_poses, shape_msgs/Plane[] planes, geometry_msgs/Pose[] plane_poses, \
string[] subframe_names, geometry_msgs/Pose[] subframe_poses, byte operation
moveit_msgs/AttachedCollisionObject: string link_name, CollisionObject object, string[] touch_links, \
trajectory_msgs/JointTrajectory detach_posture, float64 weight
moveit_msgs/RobotState: sensor_msgs/JointState joint_state, sensor_msgs/MultiDOFJointState multi_dof_joint_state, \
AttachedCollisionObject[] attached_collision_objects, bool is_diff
moveit_msgs/PlanningSceneWorld: CollisionObject[] collision_objects, octomap_msgs/OctomapWithPose octomap
moveit_msgs/PlanningScene: string name, RobotState robot_state, string robot_model_name, \
geometry_msgs/TransformStamped[] fixed_frame_transforms, AllowedCollisionMatrix allowed_collision_matrix, \
LinkPadding[] link_padding, LinkScale[] link_scale, ObjectColor[] object_colors, PlanningSceneWorld world, bool is_diff
service_msgs/ServiceEventInfo: uint8 event_type, builtin_interfaces/Time stamp, uint8[16] client_gid, int64 sequence_number
action_msgs/GoalInfo: unique_identifier_msgs/UUID goal_id, builtin_interfaces/Time stamp
action_msgs/GoalStatus: GoalInfo goal_info, int8 status
action_msgs/GoalStatusArray: GoalStatus[] status_list
action_msgs/srv/CancelGoal_Request: action_msgs/GoalInfo goal_info
action_msgs/srv/CancelGoal_Response: int8 return_code, action_msgs/GoalInfo[] goals_canceling
trajectory_msgs/MultiDOFJointTrajectoryPoint: geometry_msgs/Transform[] transforms, geometry_msgs/Twist[] velocities, \
geometry_msgs/Twist[] accelerations, builtin_interfaces/Duration time_from_start
trajectory_msgs/MultiDOFJointTrajectory: std_msgs/Header header, string[] joint_names, MultiDOFJointTrajectoryPoint[] points
control_msgs/JointTolerance: string name, float64 position, float64 velocity, float64 acceleration
control_msgs/JointComponentTolerance: string joint_name, uint16 component, float64 position, float64 velocity, \
float64 acceleration
control_msgs/action/FollowJointTrajectory_Goal: trajectory_msgs/JointTrajectory trajectory, \
trajectory_msgs/MultiDOFJointTrajectory multi_dof_trajectory, control_msgs/JointTolerance[] path_tolerance, \
control_msgs/JointComponentTolerance[] component_path_tolerance, control_msgs/JointTolerance[] goal_tolerance, \
control_msgs/JointComponentTolerance[] component_goal_tolerance, builtin_interfaces/Duration goal_time_tolerance
control_msgs/action/FollowJointTrajectory_Result: int32 error_code, string error_string
control_msgs/action/FollowJointTrajectory_Feedback: std_msgs/Header header, string[] joint_names, \
trajectory_msgs/JointTrajectoryPoint desired, trajectory_msgs/JointTrajectoryPoint actual, \
trajectory_msgs/JointTrajectoryPoint error, string[] multi_dof_joint_names, \
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_desired, trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_actual, \
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_error
control_msgs/action/FollowJointTrajectory_SendGoal_Request: unique_identifier_msgs/UUID goal_id, \
control_msgs/action/FollowJointTrajectory_Goal goal
control_msgs/action/FollowJointTrajectory_SendGoal_Response: bool accepted, builtin_interfaces/Time stamp
control_msgs/action/FollowJointTrajectory_GetResult_Request: unique_identifier_msgs/UUID goal_id
control_msgs/action/FollowJointTrajectory_GetResult_Response: int8 status, control_msgs/action/FollowJointTrajectory_Result result
control_msgs/action/FollowJointTrajectory_FeedbackMessage: unique_identifier_msgs/UUID goal_id, \
control_msgs/action/FollowJointTrajectory_Feedback feedback
"""

PUBLISHED = {
    "std_msgs/msg/String": "df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18",
    "std_msgs/msg/Header": "f49fb3ae2cf070f793645ff749683ac6b06203e41c891e17701b1cb597ce6a01",
    "rosgraph_msgs/msg/Clock": "692f7a66e93a3c83e71765d033b60349ba68023a8c689a79e48078bcb5c58564",
    "sensor_msgs/msg/JointState": "a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e",
    "tf2_msgs/msg/TFMessage": "e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087",
    "geometry_msgs/msg/PoseStamped": "10f3786d7d40fd2b54367835614bff85d4ad3b5dab62bf8bca0cc232d73b4cd8",
    "geometry_msgs/msg/WrenchStamped": "8dc3deaf06b2ab281f9f9a742a8961c328ca7cec16e3fd6586d3a5c83fa78f77",
    "trajectory_msgs/msg/JointTrajectory": "179b33eba59d676f6d967ac71fe35e7ca2f64b2f3928f4a018cec115e213796e",
    "visualization_msgs/msg/MarkerArray": "86cb8800b6fb05b5eff1abd7a56f62a5641d3ae9a1c29e78e67e704f1d067dcf",
    "shape_msgs/msg/SolidPrimitive": "2802a15190aadc3f496584df4b0b4c5824d8a0b31aaef839faa75bc34dda38ac",
    "action_msgs/msg/GoalStatusArray": "6c1684b00f177d37438febe6e709fc4e2b0d4248dca4854946f9ed8b30cda83e",
    "action_msgs/srv/CancelGoal": "573d8b0a534451d7bc2ac8c5ffde8ac14b8593b7001175d0cd6516dcbeb8689a",
    "control_msgs/action/FollowJointTrajectory_SendGoal": "b13789dddc325a7a962825c45e28c77d37237ec129dd0c34dc5994562938c57f",
    "control_msgs/action/FollowJointTrajectory_GetResult": "e3ceb38e3e1867c8dc0f46014df26e90eb93422f27e9e97f936e07f94be4bc8b",
    "control_msgs/action/FollowJointTrajectory_FeedbackMessage":
        "80398fcb9674a79081a9906e2ccf0c804dd7cb15e22e362e606ee87186beab71",
    "moveit_msgs/msg/CollisionObject": "74b0acd6d56be032bf4f764b2c2633f50588b5fb2bd71e97206c59052747cf7e",
    "moveit_msgs/msg/PlanningSceneWorld": "e08e6a4a81ca6b6a6953ac758dadc2c949555093efea6a9a22d9accf62c2c099",
}

NUMBERS = dict(zip("int8 uint8 int16 uint16 int32 uint32 int64 uint64 float32 float64".split(), range(2, 12)), bool=15, byte=16,
               string=17)


def full_name(name):
    """sensor_msgs/JointState as sensor_msgs/msg/JointState; others have their kind in the name."""
    return name if name.count("/") == 2 else name.replace("/", "/msg/")


def add_services(types):
    """A service is described as its three messages; the event repeats request and response, at most one of each."""
    def part(name, kind, count=0):
        return {"name": name, "type": {"type_id": 97 if count else 1, "capacity": count, "string_capacity": 0, "nested_type_name": kind}}
    for name in [name[:-len("_Request")] for name in types if name.endswith("_Request")]:
        types[name + "_Event"] = [part("info", "service_msgs/msg/ServiceEventInfo"), part("request", name + "_Request", 1),
                                  part("response", name + "_Response", 1)]
        types[name] = [part(f"{kind.lower()}_message", f"{name}_{kind}") for kind in ("Request", "Response", "Event")]


def fields_of(package, text):
    fields = []
    for part in text.split(","):
        kind, name = part.split()
        base, bracket, bound, count = re.fullmatch(r"([\w/]+)(\[(<=)?(\d*)\])?", kind).groups()
        offset = 0 if not bracket else 96 if bound else 48 if count else 144
        nested = ""
        if base not in NUMBERS:
            nested = full_name(base if "/" in base else f"{package}/{base}")
        fields.append({"name": name, "type": {"type_id": NUMBERS.get(base, 1) + offset, "capacity": int(count or 0),
                                              "string_capacity": 0, "nested_type_name": nested}})
    return fields


def calculated():
    types = {}
    for line in DEFINITIONS.strip().splitlines():
        name, text = line.split(":", 1)
        types[full_name(name)] = fields_of(name.split("/")[0], text)
    add_services(types)

    def below(name):
        nested = {field["type"]["nested_type_name"] for field in types[name]} - {""}
        return nested.union(*(below(other) for other in nested))

    def entry(name):
        return {"type_name": name, "fields": types[name]}
    return {name: hashlib.sha256(json.dumps({"type_description": entry(name), "referenced_type_descriptions":
                                             [entry(other) for other in sorted(below(name))]}).encode()).hexdigest()
            for name in types}


def check(project):
    """The hashes of the source against the calculated ones, and these against published ones. Returns them by DDS name."""
    hashes = calculated()
    for name, published in PUBLISHED.items():
        assert hashes[name] == published, (name, hashes[name])
    source = dict(re.findall(r'\{"(\S+_)", "RIHS01_([0-9a-f]{64})"\}', (project / "bridge/ros2/type_hashes.cpp").read_text()))
    topics = set(re.findall(r"@topic struct (\w+)_", (project / "bridge/ros2/ros2_messages.idl").read_text()))
    assert len(source) == len(topics) and {name.split("::")[-1].rstrip("_") for name in source} == topics, (source, topics)
    for name, value in source.items():
        announced = re.sub("_(Request|Response)_$", "_", name)  # Both parts of a service announce its hash.
        assert hashes[announced.replace("::dds_", "").replace("::", "/")[:-1]] == value, name
    return source
