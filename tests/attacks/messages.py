"""Jostle messages as bytes, with only the fields that attacks use. Field numbers are those of proto/jostle/v1."""

from .protobuf import double, fixed32, fixed64, nested, packed_uints, text, uint

PLAY = "/jostle.v1.PlayService/Play"
CREATE_WORLD = "/jostle.v1.WorldService/CreateWorld"
DELETE_WORLD = "/jostle.v1.WorldService/DeleteWorld"
GET_WORLD = "/jostle.v1.WorldService/GetWorld"
LIST_WORLDS = "/jostle.v1.WorldService/ListWorlds"
JOIN_WORLD = "/jostle.v1.WorldService/JoinWorld"
CAST_SHAPES = "/jostle.v1.QueryService/CastShapes"
DEBUG = "/jostle.v1.QueryService/Debug"
HEALTH = "/grpc.health.v1.Health/Check"
HEALTH_WATCH = "/grpc.health.v1.Health/Watch"
REFLECTION = "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo"

# Kinds of ServerMessage.
WELCOME, ENTITY_UPDATE, SNAPSHOT, PONG, NOTICE, GEOMETRY = 1, 2, 3, 5, 7, 9
# Fields of Snapshot and of ClientUpdate.
FRAME, CLIENT_UPDATE = 1, 15
RESULTS = 4


# --- messages from clients ---

def hello(world="", name="", ticket="", snapshot_hz=0, spectator=False, events=False):
    return nested(1, uint(1, 1) + text(2, world) + text(3, ticket) + text(4, name) + uint(5, snapshot_hz)
                  + uint(6, spectator) + uint(7, events))


def ack_body(frame, need_keyframe=False):
    return uint(1, frame) + uint(2, need_keyframe)


def ack(frame, need_keyframe=False):
    return nested(3, ack_body(frame, need_keyframe))


def ping(time_us=1):
    return nested(4, fixed64(1, time_us))


def leave():
    return nested(5, b"")


def batch(first_sequence, inputs, acknowledged=None):
    body = uint(1, first_sequence) + b"".join(nested(2, each) for each in inputs)
    if acknowledged is not None:
        body += nested(3, acknowledged)
    return nested(2, body + fixed32(4, 1))


def vector(x, y, z):
    return double(1, x) + double(2, y) + double(3, z)


def spawn(shape, position, velocity=(0, 0, 0)):
    return nested(1, nested(1, shape) + nested(2, vector(*position)) + nested(4, vector(*velocity)))


def impulse(entity, force):
    return nested(2, uint(1, entity) + nested(2, vector(*force)))


def grab(entity, point):
    return nested(3, uint(1, entity) + nested(2, vector(*point)))


def drag(target):
    return nested(4, nested(1, vector(*target)))


def release():
    return nested(5, b"")


def explode(center, radius, speed):
    return nested(7, nested(1, vector(*center)) + double(2, radius) + double(3, speed))


# --- shapes, bodies, scenes ---

def sphere(radius):
    return nested(1, double(1, radius))


def box(x, y, z):
    return nested(3, nested(1, vector(x, y, z)))


def plane():
    return nested(4, b"")


def hull(points):
    return nested(12, b"".join(nested(1, vector(*point)) for point in points))


def mesh(vertices, indices):
    return nested(13, b"".join(nested(1, vector(*vertex)) for vertex in vertices) + packed_uints(2, indices))


def compound(children):
    return nested(15, b"".join(nested(1, child) for child in children))


def no_self_collision():
    """A field of Shape. Bodies with this field do not collide with each other."""
    return nested(22, uint(3, 1))  # group -1


def grid_mesh(side, height=0.0):
    """A nearly flat square of side * side vertices: about 29 bytes per vertex and 14 per pair of triangles."""
    vertices = [(0.1 * i, height + 0.01 * ((i * 7 + j * 3) % 5), 0.1 * j) for i in range(side) for j in range(side)]
    indices = []
    for i in range(side - 1):
        for j in range(side - 1):
            a, b, c, d = i * side + j, i * side + j + 1, (i + 1) * side + j, (i + 1) * side + j + 1
            indices += [a, b, c, c, b, d]
    return mesh(vertices, indices)


STATIC, KINEMATIC, DYNAMIC = 1, 2, 3


def body(shape, name="", kind=DYNAMIC, position=None, repeat=(), velocity=None, spin=None, gravity_scale=None):
    """repeat: (count, (x, y, z)) for each axis along which the body is repeated."""
    out = text(1, name) if name else b""
    if kind != DYNAMIC:
        out += uint(2, kind)
    if position:
        out += nested(3, vector(*position))
    if velocity:
        out += nested(5, vector(*velocity))
    if spin:
        out += nested(6, vector(*spin))
    if gravity_scale is not None:
        out += double(9, gravity_scale)
    out += nested(11, shape)
    for count, offset in repeat:
        out += nested(13, uint(1, count) + (nested(2, vector(*offset)) if any(offset) else b""))
    return out


def floor():
    return body(plane(), "floor", STATIC)


def ball_joint(a, b, direct=False):
    return text(2, a) + text(3, b) + nested(7, b"") + (uint(25, 3) if direct else b"")


def scene(bodies, name="attack", joints=(), substeps=None, hz=None):
    settings = (uint(2, substeps) if substeps else b"") + (double(3, hz) if hz else b"")
    return (text(1, name) + (nested(3, settings) if settings else b"")
            + b"".join(nested(4, each) for each in bodies) + b"".join(nested(5, each) for each in joints))


def create_world(name, scene_bytes=None, scene_name=None):
    return text(1, name) + (text(2, scene_name) if scene_name else nested(3, scene_bytes))
