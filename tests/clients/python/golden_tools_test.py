#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reads proto/golden/sandbox_tools.jmsg, writes its inputs again, and compares both with what proto/WIRE.md lists. Exit status 77: a
package is missing."""

import pathlib
import struct
import sys

try:
    import google.protobuf  # noqa: F401
    import grpc  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}; install python3-grpcio")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "examples/python_client"))

import stubs  # noqa: E402,F401  generates jostle.v1
from jostle.v1 import common_pb2, play_pb2, query_pb2, scene_pb2  # noqa: E402


def messages(data):
    magic, version, count = struct.unpack_from("<4sII", data)
    assert (magic, version) == (b"JMSG", 1)
    at = 12
    for _ in range(count):
        kind, size = struct.unpack_from("<II", data, at)
        yield kind, data[at + 8:at + 8 + size]
        at += 8 + size
    assert at == len(data)


def inputs():
    vec, quat = common_pb2.Vec3, common_pb2.Quat
    hinge = scene_pb2.HingeJoint(limit=scene_pb2.Limit(lower=-1, upper=1.25), motor_speed=2, motor_max_torque=300)
    joint = scene_pb2.Joint(frame=scene_pb2.JointFrame(position=vec(y=3), rotation=quat(x=1)), hinge=hinge, collide_connected=True,
                            break_force=5000)
    edit = play_pb2.EditInput(entity=12, position=vec(x=1.5, y=-2, z=0.25), rotation=quat(y=1), linear_velocity=vec(y=4),
                              angular_velocity=vec(x=-0.5), mass=20, friction=0, restitution=0.75, color=0xff8000, frozen=False,
                              gravity_scale=-0.5)
    room = play_pb2.RoomInput
    batch = play_pb2.InputBatch(first_sequence=7, inputs=[
        play_pb2.Input(edit=edit),
        play_pb2.Input(clone=play_pb2.CloneInput(entity=12, offset=vec(x=2, z=-1), jointed=True)),
        play_pb2.Input(create_joint=play_pb2.CreateJointInput(entity_b=12, joint=joint)),
        play_pb2.Input(delete_joint=play_pb2.DeleteJointInput(joint=300)),
        play_pb2.Input(undo=play_pb2.UndoInput()),
        play_pb2.Input(room=room(step=play_pb2.StepInput(steps=60))),
        play_pb2.Input(room=room(speed=play_pb2.SpeedInput(percent=25))),
        play_pb2.Input(room=room(rewind=play_pb2.RewindInput(tick=1234))),
    ])
    return play_pb2.ClientMessage(input=batch)


def main():
    found = list(messages((ROOT / "proto/golden/sandbox_tools.jmsg").read_bytes()))
    body = query_pb2.InspectResponse.FromString(found[1][1]).body
    joint = query_pb2.InspectResponse.FromString(found[2][1]).joint
    checks = [
        ([kind for kind, _ in found], [0, 1, 1]),
        (inputs().SerializeToString(), found[0][1]),
        ((body.entity, body.name, body.owner, body.mass, body.kinetic_energy), (12, "crate", 3, 20, 296)),
        ((body.inertia_x.x, body.inertia_y.y, body.inertia_z.z), (8, 16, 32)),
        ((body.contact_count, body.contacts[0].entity, body.contacts[0].points[0].impulse), (300, 4, 3.25)),
        ((body.joints[0].force, body.joints[0].torque, body.joints[0].coordinate), (5, 2, 0.5)),
        ((joint.id, joint.entity_a, joint.entity_b, joint.owner, joint.joint.break_force), (300, 0, 12, 3, 5000)),
        ((joint.joint.hinge.limit.upper, joint.joint.hinge.motor_speed), (1.25, 2)),
    ]
    faults = [f"{value} instead of {expected}" for value, expected in checks if value != expected]
    print("\n".join(faults) or "as expected")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
