// SPDX-License-Identifier: MIT
#include "scenes/src/joint_message.h"

#include <cmath>
#include <optional>

#include "jostle/physics/joint_fields.h"
#include "jostle/physics/limits.h"
#include "jostle/scenes/joint_definition.h"
#include "jostle/scenes/joint_form.h"
#include "jostle/v1/scene.pb.h"
#include "scenes/src/body_name.h"
#include "scenes/src/message_fields.h"

namespace jostle::scenes {

using namespace physics;

namespace {

// The rotation is not normalized: normalizing twice may change the last bit, and the world
// normalizes it once.
Transform read_frame(FieldReader& in, const std::string& path, const v1::JointFrame& m) {
    return {in.vector(path + ".position", m.position(), limits::max_coordinate),
            in.rotation(path + ".rotation", m.has_rotation(), m.rotation())};
}

// The fields of the oneof are named like the joint kinds.
JointKind read_kind(FieldReader& in, const std::string& path, const v1::Joint& m) {
    const auto* kind = m.GetDescriptor()->FindOneofByName("kind");
    const auto* given = m.GetReflection()->GetOneofFieldDescriptor(m, kind);
    std::optional<JointKind> found;
    std::string names;
    for_each_joint_kind([&]<class Kind>(Kind joint) {
        const char* name = JointFields<Kind>::name;
        names += (names.empty() ? "" : ", ") + std::string(name);
        if (given == nullptr || given->name() != name) return;
        MessageFieldReader fields = MessageFieldReader(in, path, m).inside(name);
        JointFields<Kind>::visit(fields, joint);
        found = joint;
    });
    if (!found) in.report_error(path, "has no kind; it must have one of " + names);
    return found.value_or(BallJoint{});
}

void write_kind(v1::Joint& out, const JointKind& kind) {
    std::visit(
        [&]<class Kind>(const Kind& joint) {
            MessageFieldWriter fields = MessageFieldWriter(out).inside(JointFields<Kind>::name);
            JointFields<Kind>::visit(fields, joint);
        },
        kind);
}

// Converts a frame in the world to the frame of a body.
Transform local(const SceneBody& body, const Transform& world) {
    const Transform& pose = body.body.pose;
    const Quat turn = unit(pose.rotation);
    return {inverse_rotate(turn, world.position - pose.position),
            unit(conjugate(turn) * world.rotation)};
}

double rounded(double value, double units) {
    return std::round(value * units) / units + 0.0;  // no negative zero
}

Transform rounded(const Transform& frame) {
    constexpr double meters = 65536, turns = 16384;
    const auto [p, q] = frame;
    return {{rounded(p.x, meters), rounded(p.y, meters), rounded(p.z, meters)},
            {rounded(q.x, turns), rounded(q.y, turns), rounded(q.z, turns), rounded(q.w, turns)}};
}

void write(v1::JointFrame& out, const Transform& frame) {
    set(*out.mutable_position(), frame.position);
    if (!(frame.rotation == Quat{})) set(*out.mutable_rotation(), frame.rotation);
}

}  // namespace

std::optional<JointSolver> read_solver(FieldReader& in, const std::string& path,
                                       v1::JointSolver solver) {
    switch (solver) {
        case v1::JOINT_SOLVER_UNSPECIFIED:
            return {};
        case v1::JOINT_SOLVER_AUTOMATIC:
            return JointSolver::automatic;
        case v1::JOINT_SOLVER_ITERATIVE:
            return JointSolver::iterative;
        case v1::JOINT_SOLVER_DIRECT:
            return JointSolver::direct;
        default:
            in.report_error(path,
                            "is " + std::to_string(solver) +
                                "; it must be JOINT_SOLVER_AUTOMATIC, JOINT_SOLVER_ITERATIVE or "
                                "JOINT_SOLVER_DIRECT");
    }
    return {};
}

v1::JointSolver message_of(JointSolver solver) {
    switch (solver) {
        case JointSolver::automatic:
            return v1::JOINT_SOLVER_AUTOMATIC;
        case JointSolver::iterative:
            return v1::JOINT_SOLVER_ITERATIVE;
        case JointSolver::direct:
            return v1::JOINT_SOLVER_DIRECT;
    }
    return v1::JOINT_SOLVER_UNSPECIFIED;
}

void read_joint(FieldReader& in, SceneDescription& scene, const std::string& path,
                const v1::Joint& m) {
    SceneJoint joint{.name = m.name(),
                     .body_a = m.body_a().empty()
                                   ? world_body
                                   : find_body(in, scene, path + ".body_a", m.body_a()),
                     .body_b = find_body(in, scene, path + ".body_b", m.body_b()),
                     .joint = {}};
    if (m.name().size() > 64)
        in.report_error(path + ".name", "must be a string of at most 64 bytes");
    if (m.has_frame() && (m.has_frame_a() || m.has_frame_b()))
        in.report_error(
            path + ".frame",
            "conflicts with frame_a and frame_b; use either frame, or frame_a and frame_b");
    if (in.failed()) return;
    JointDef& def = joint.joint;
    def.kind = read_kind(in, path, m);
    def.collide_connected = m.collide_connected();
    def.break_force = in.number(path + ".break_force", m.break_force(), 0, 1e15);
    def.break_torque = in.number(path + ".break_torque", m.break_torque(), 0, 1e15);
    def.solver = read_solver(in, path + ".solver", m.solver());
    const Transform frame = read_frame(in, path + ".frame", m.frame());
    def.frame_a = read_frame(in, path + ".frame_a", m.frame_a());
    def.frame_b = read_frame(in, path + ".frame_b", m.frame_b());
    const auto count = m.has_repeat() ? static_cast<std::size_t>(in.number(
                                            path + ".repeat.count", m.repeat().count(), 1, 100000))
                                      : 1;
    const Vec3 step = in.vector(path + ".repeat.offset", m.repeat().offset(), 1e6);
    if (in.failed()) return;
    if (scene.joints.size() + count > joints_max)
        return in.report_error(
            path, "creates more than " + std::to_string(joints_max) + " joints in total");
    for (std::size_t k = 0; k < count; k++) {
        SceneJoint copy = joint;
        if (copy.body_a != world_body) copy.body_a += k;
        copy.body_b += k;
        if ((copy.body_a != world_body && copy.body_a >= scene.bodies.size()) ||
            copy.body_b >= scene.bodies.size())
            return in.report_error(
                path + ".repeat.count",
                "exceeds the last body; copy i joins the bodies whose indices are "
                "larger by i");
        if (m.has_frame()) {
            Transform copy_frame = frame;
            copy_frame.position += step * static_cast<double>(k);
            copy.joint.frame_a = copy.body_a == world_body
                                     ? copy_frame
                                     : local(scene.bodies[copy.body_a], copy_frame);
            copy.joint.frame_b = local(scene.bodies[copy.body_b], copy_frame);
        }
        scene.joints.push_back(copy);
    }
}

void write_joint_form(v1::Joint& out, const JointDef& def) {
    write(*out.mutable_frame_a(), rounded(def.frame_a));
    write(*out.mutable_frame_b(), rounded(def.frame_b));
    write_kind(out, def.kind);
}

void write_joint(v1::Joint& out, const SceneDescription& scene, const SceneJoint& joint) {
    out.set_name(joint.name);
    if (joint.body_a != world_body) out.set_body_a(name_of(scene, joint.body_a));
    out.set_body_b(name_of(scene, joint.body_b));
    write(*out.mutable_frame_a(), joint.joint.frame_a);
    write(*out.mutable_frame_b(), joint.joint.frame_b);
    write_kind(out, joint.joint.kind);
    out.set_collide_connected(joint.joint.collide_connected);
    out.set_break_force(joint.joint.break_force);
    out.set_break_torque(joint.joint.break_torque);
    if (joint.joint.solver) out.set_solver(message_of(*joint.joint.solver));
}

// --- joints outside of scene files ---

physics::Result<JointDefinition> joint_from_message(const v1::Joint& m, const std::string& path) {
    FieldReader in;
    JointDefinition out;
    if (!m.name().empty() || !m.body_a().empty() || !m.body_b().empty() || m.has_repeat())
        in.report_error(path,
                        "has a name, body_a, body_b or repeat; only joints of scenes have them");
    if (m.has_frame() && (m.has_frame_a() || m.has_frame_b()))
        in.report_error(
            path + ".frame",
            "conflicts with frame_a and frame_b; use either frame, or frame_a and frame_b");
    JointDef& def = out.joint;
    def.kind = read_kind(in, path, m);
    def.collide_connected = m.collide_connected();
    def.break_force = in.number(path + ".break_force", m.break_force(), 0, 1e15);
    def.break_torque = in.number(path + ".break_torque", m.break_torque(), 0, 1e15);
    def.solver = read_solver(in, path + ".solver", m.solver());
    if (m.has_frame()) out.frame = read_frame(in, path + ".frame", m.frame());
    def.frame_a = read_frame(in, path + ".frame_a", m.frame_a());
    def.frame_b = read_frame(in, path + ".frame_b", m.frame_b());
    if (in.errors().empty()) return out;
    const FieldError& first = in.errors().front();
    return physics::Error{physics::ErrorCode::invalid_argument, first.path + ": " + first.what};
}

void write_joint_definition(v1::Joint& out, const JointDef& def) {
    write(*out.mutable_frame_a(), def.frame_a);
    write(*out.mutable_frame_b(), def.frame_b);
    write_kind(out, def.kind);
    out.set_collide_connected(def.collide_connected);
    out.set_break_force(def.break_force);
    out.set_break_torque(def.break_torque);
    if (def.solver) out.set_solver(message_of(*def.solver));
}

std::string joint_bytes(const JointDefinition& joint) {
    v1::Joint message;
    write_joint_definition(message, joint.joint);
    if (joint.frame) {
        message.clear_frame_a();
        message.clear_frame_b();
        write(*message.mutable_frame(), *joint.frame);
    }
    return message.SerializeAsString();
}

physics::Result<JointDefinition> joint_from_bytes(std::string_view bytes, const std::string& path) {
    v1::Joint message;
    if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
        return physics::Error{physics::ErrorCode::corrupt_data,
                              path + ": the bytes are not a jostle.v1.Joint"};
    return joint_from_message(message, path);
}

}  // namespace jostle::scenes
