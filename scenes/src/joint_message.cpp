// SPDX-License-Identifier: MIT
#include "joint_message.h"

#include "body_name.h"
#include "jostle/physics/limits.h"
#include "jostle/v1/scene.pb.h"

namespace jostle::scenes {

using namespace physics;

namespace {

// The rotation stays as it is given: made unit length twice it may differ in the last bit, and the
// world does it once.
Transform read_frame(FieldReader& in, const std::string& path, const v1::Frame& m) {
    return {in.vector(path + ".position", m.position(), limits::max_coordinate),
            in.rotation(path + ".rotation", m.has_rotation(), m.rotation())};
}

JointSpring read_spring(FieldReader& in, const std::string& path, const v1::Spring& m) {
    JointSpring out{in.number(path + ".hertz", m.hertz(), 0, 1e4), 1};
    if (m.has_damping_ratio())
        out.damping_ratio = in.number(path + ".damping_ratio", m.damping_ratio(), 0, 1e4);
    return out;
}

JointLimit read_limit(FieldReader& in, const std::string& path, const v1::Limit& m) {
    JointLimit out{true, in.number(path + ".lower", m.lower(), -pi, pi),
                   in.number(path + ".upper", m.upper(), -pi, pi)};
    if (out.lower > out.upper) in.note(path + ".lower", "is above the upper limit");
    return out;
}

JointKind read_kind(FieldReader& in, const std::string& path, const v1::Joint& m) {
    switch (m.kind_case()) {
        case v1::Joint::kBall:
            return BallJoint{};
        case v1::Joint::kHinge: {
            const v1::HingeJoint& h = m.hinge();
            const std::string at = path + ".hinge";
            HingeJoint out;
            if (h.has_limit()) out.limit = read_limit(in, at + ".limit", h.limit());
            if (h.has_motor_speed())
                out.motor = {true,
                             in.number(at + ".motor_speed", h.motor_speed(), -limits::max_speed,
                                       limits::max_speed),
                             in.number(at + ".motor_max_torque", h.motor_max_torque(), 0, 1e12)};
            if (h.has_spring()) out.spring = read_spring(in, at + ".spring", h.spring());
            out.spring_angle = in.number(at + ".spring_angle", h.spring_angle(), -pi, pi);
            return out;
        }
        case v1::Joint::kConeTwist: {
            const v1::ConeTwistJoint& c = m.cone_twist();
            const std::string at = path + ".cone_twist";
            ConeTwistJoint out{.swing = in.number(at + ".swing", c.swing(), 0, pi)};
            out.twist = c.has_twist() ? read_limit(in, at + ".twist", c.twist()) : JointLimit{};
            out.friction_torque = in.number(at + ".friction_torque", c.friction_torque(), 0, 1e12);
            return out;
        }
        case v1::Joint::kFixed: {
            FixedJoint out;
            if (m.fixed().has_linear())
                out.linear = read_spring(in, path + ".fixed.linear", m.fixed().linear());
            if (m.fixed().has_angular())
                out.angular = read_spring(in, path + ".fixed.angular", m.fixed().angular());
            return out;
        }
        case v1::Joint::kDistance: {
            const v1::DistanceJoint& d = m.distance();
            const std::string at = path + ".distance";
            DistanceJoint out{
                .min_length = in.number(at + ".min_length", d.min_length(), 0, 1e6),
                .max_length = in.number(at + ".max_length", d.max_length(), 0, 1e6),
                .spring = read_spring(in, at + ".spring", d.spring()),
                .rest_length = in.number(at + ".rest_length", d.rest_length(), 0, 1e6)};
            if (out.max_length < out.min_length)
                in.note(at + ".max_length", "is less than min_length");
            return out;
        }
        case v1::Joint::KIND_NOT_SET:
            break;
    }
    in.note(path, "has no kind; give one of ball, hinge, cone_twist, fixed, distance");
    return BallJoint{};
}

// A frame in the world, as a body sees it.
Transform local(const SceneBody& body, const Transform& world) {
    const Transform& pose = body.body.pose;
    const Quat turn = unit(pose.rotation);
    return {inverse_rotate(turn, world.position - pose.position),
            unit(conjugate(turn) * world.rotation)};
}

void write(v1::Spring& out, const JointSpring& spring) {
    out.set_hertz(spring.hertz);
    out.set_damping_ratio(spring.damping_ratio);
}
void write(v1::Limit& out, const JointLimit& limit) {
    out.set_lower(limit.lower);
    out.set_upper(limit.upper);
}
void write(v1::Frame& out, const Transform& frame) {
    set(*out.mutable_position(), frame.position);
    if (!(frame.rotation == Quat{})) set(*out.mutable_rotation(), frame.rotation);
}

struct WriteKind {
    v1::Joint& to;

    void operator()(const BallJoint&) const { to.mutable_ball(); }
    void operator()(const HingeJoint& h) const {
        v1::HingeJoint& out = *to.mutable_hinge();
        if (h.limit.enabled) write(*out.mutable_limit(), h.limit);
        if (h.motor.enabled) {
            out.set_motor_speed(h.motor.speed);
            out.set_motor_max_torque(h.motor.max_torque);
        }
        if (h.spring.hertz > 0) write(*out.mutable_spring(), h.spring);
        out.set_spring_angle(h.spring_angle);
    }
    void operator()(const ConeTwistJoint& c) const {
        v1::ConeTwistJoint& out = *to.mutable_cone_twist();
        out.set_swing(c.swing);
        if (c.twist.enabled) write(*out.mutable_twist(), c.twist);
        out.set_friction_torque(c.friction_torque);
    }
    void operator()(const FixedJoint& f) const {
        v1::FixedJoint& out = *to.mutable_fixed();
        if (f.linear.hertz > 0) write(*out.mutable_linear(), f.linear);
        if (f.angular.hertz > 0) write(*out.mutable_angular(), f.angular);
    }
    void operator()(const DistanceJoint& d) const {
        v1::DistanceJoint& out = *to.mutable_distance();
        out.set_min_length(d.min_length);
        out.set_max_length(d.max_length);
        if (d.spring.hertz > 0) write(*out.mutable_spring(), d.spring);
        out.set_rest_length(d.rest_length);
    }
};

}  // namespace

void read_joint(FieldReader& in, SceneDescription& scene, const std::string& path,
                const v1::Joint& m) {
    SceneJoint joint{.name = m.name(),
                     .body_a = find_body(in, scene, path + ".body_a", m.body_a()),
                     .body_b = find_body(in, scene, path + ".body_b", m.body_b()),
                     .joint = {}};
    if (m.name().size() > 64) in.note(path + ".name", "must be a text of at most 64 bytes");
    if (m.has_frame() && (m.has_frame_a() || m.has_frame_b()))
        in.note(path + ".frame", "is given beside frame_a or frame_b; give the one or the others");
    if (in.failed()) return;
    JointDef& def = joint.joint;
    def.kind = read_kind(in, path, m);
    def.collide_connected = m.collide_connected();
    def.break_force = in.number(path + ".break_force", m.break_force(), 0, 1e15);
    def.break_torque = in.number(path + ".break_torque", m.break_torque(), 0, 1e15);
    const Transform frame = read_frame(in, path + ".frame", m.frame());
    def.frame_a = read_frame(in, path + ".frame_a", m.frame_a());
    def.frame_b = read_frame(in, path + ".frame_b", m.frame_b());
    const auto count = m.has_repeat() ? static_cast<std::size_t>(in.number(
                                            path + ".repeat.count", m.repeat().count(), 1, 100000))
                                      : 1;
    const Vec3 step = in.vector(path + ".repeat.offset", m.repeat().offset(), 1e6);
    if (in.failed()) return;
    if (scene.joints.size() + count > joints_max)
        return in.note(path, "makes more than " + std::to_string(joints_max) + " joints in all");
    for (std::size_t k = 0; k < count; k++) {
        SceneJoint copy = joint;
        copy.body_a += k;
        copy.body_b += k;
        if (copy.body_a >= scene.bodies.size() || copy.body_b >= scene.bodies.size())
            return in.note(path + ".repeat.count",
                           "goes beyond the last body; copy number i joins the bodies i places "
                           "further on");
        if (m.has_frame()) {
            Transform there = frame;
            there.position += step * static_cast<double>(k);
            copy.joint.frame_a = local(scene.bodies[copy.body_a], there);
            copy.joint.frame_b = local(scene.bodies[copy.body_b], there);
        }
        scene.joints.push_back(copy);
    }
}

void write_joint(v1::Joint& out, const SceneDescription& scene, const SceneJoint& joint) {
    out.set_name(joint.name);
    out.set_body_a(name_of(scene, joint.body_a));
    out.set_body_b(name_of(scene, joint.body_b));
    write(*out.mutable_frame_a(), joint.joint.frame_a);
    write(*out.mutable_frame_b(), joint.joint.frame_b);
    std::visit(WriteKind{out}, joint.joint.kind);
    out.set_collide_connected(joint.joint.collide_connected);
    out.set_break_force(joint.joint.break_force);
    out.set_break_torque(joint.joint.break_torque);
}

}  // namespace jostle::scenes
