// SPDX-License-Identifier: MIT
#include "server/limits/admission.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "jostle/base/check.h"
#include "jostle/physics/hull.h"
#include "server/world/players.h"

namespace jostle::server {

using physics::Vec3;

namespace {

constexpr double coordinate_max = 1e4;           // m
constexpr double size_min = 0.05, size_max = 2;  // m
// kg: roughly the range that sizes and densities allow
constexpr double mass_min = 1e-3, mass_max = 1e6;
constexpr double spawn_speed_max = 50;   // m/s and rad/s
constexpr double impulse_max = 1e7;      // N s; the world limits it to a speed change of 20 m/s
constexpr double aim_length_max = 2000;  // m
constexpr double motor_speed_max = 100, motor_force_max = 1e6;  // m/s or rad/s; N or N m
constexpr double joint_spring_hertz_max = 60;
constexpr double explosion_radius_max = 20, explosion_speed_max = 20;  // m, m/s

// Written so that NaN fails.
bool within(double x, double low, double high) {
    return low <= x && x <= high;
}
bool within(Vec3 v, double limit) {
    return within(v.x, -limit, limit) && within(v.y, -limit, limit) && within(v.z, -limit, limit);
}

Status check_point(const char* what, Vec3 p) {
    if (within(p, coordinate_max)) return {};
    return invalid_argument(fmt::format("{} ({:g}, {:g}, {:g}) is not within {:g} m of the origin",
                                        what, p.x, p.y, p.z, coordinate_max));
}

Status check_length(const char* what, Vec3 v, double limit) {
    ASSERT(limit >= 0);
    const double size = length(v);
    if (within(size, 0, limit)) return {};
    return invalid_argument(
        fmt::format("{} is {:g} long; at most {:g} is allowed", what, size, limit));
}

Status check_number(const char* what, double x, double low, double high) {
    ASSERT(low <= high);
    if (within(x, low, high)) return {};
    return invalid_argument(
        fmt::format("{} is {:g}; it must be from {:g} to {:g}", what, x, low, high));
}

Status check_size(const char* what, double size) {
    return check_number(what, size, size_min, size_max);
}

Status check_aim(const Aim& aim) {
    if (Status s = check_point("aim.origin", aim.origin); !s.ok()) return s;
    if (Status s = check_length("aim.motion", aim.motion, aim_length_max); !s.ok()) return s;
    if (aim.motion == Vec3{}) return invalid_argument("aim.motion is zero; it must have a length");
    return aim.view_time ? check_number("aim.view_time.fraction", aim.view_time->fraction, 0, 1)
                         : Status();
}

struct Check {
    Status operator()(const SpawnCommand& c) const {
        if (Status s = check_shape(c.shape.geometry); !s.ok()) return s;
        if (Status s = check_point("position", c.pose.position); !s.ok()) return s;
        if (Status s = check_material(c.shape); !s.ok()) return s;
        if (Status s = check_length("linear_velocity", c.linear_velocity, spawn_speed_max); !s.ok())
            return s;
        return check_length("angular_velocity", c.angular_velocity, spawn_speed_max);
    }
    Status operator()(const ImpulseCommand& c) const {
        if (Status s = check_length("impulse", c.impulse, impulse_max); !s.ok()) return s;
        if (c.aim) return check_aim(*c.aim);
        return c.point ? check_point("point", *c.point) : Status();
    }
    Status operator()(const GrabCommand& c) const {
        return c.aim ? check_aim(*c.aim) : check_point("point", c.point);
    }
    Status operator()(const DragCommand& c) const { return check_point("target", c.target); }
    Status operator()(const CutCommand& c) const {
        return c.aim ? check_aim(*c.aim) : check_point("point", c.point);
    }
    Status operator()(const ReleaseCommand&) const { return {}; }
    Status operator()(const DeleteCommand&) const { return {}; }
    Status operator()(const ExplodeCommand& c) const {
        if (Status s = c.aim ? check_aim(*c.aim) : check_point("center", c.center); !s.ok())
            return s;
        if (Status s = check_number("radius", c.radius, 0.1, explosion_radius_max); !s.ok())
            return s;
        return check_number("speed", c.speed, 0, explosion_speed_max);
    }
    Status operator()(const PossessCommand&) const { return {}; }
    Status operator()(const ControlCommand& c) const {
        for (const double axis : c.controls.axes)
            if (Status s = check_number("axes", axis, -1, 1); !s.ok()) return s;
        return {};
    }
    Status operator()(const LeaveCommand&) const { return {}; }
    Status operator()(const DisconnectCommand&) const { return {}; }
    Status operator()(const JoinCommand&) const { return {}; }
    Status operator()(const SetRoleCommand&) const { return {}; }
    Status operator()(const RenameCommand& c) const {
        return check_player_name(c.name, "rename.name");
    }
    Status operator()(const SetAttributesCommand& c) const {
        if (c.changes.empty() || c.changes.size() > attributes_per_input_max)
            return invalid_argument(
                fmt::format("set_attributes.set.attributes has {} entries; 1 to {} are allowed",
                            c.changes.size(), attributes_per_input_max));
        for (std::size_t k = 0; k < c.changes.size(); k++)
            if (Status s = check_attribute_change(
                    c.changes[k], fmt::format("set_attributes.set.attributes[{}].", k));
                !s.ok())
                return s;
        return {};
    }
    Status operator()(const SendMessageCommand& c) const {
        if (!is_key(c.topic))
            return invalid_argument(
                "send_message.topic is invalid; it must be 1 to 32 of the characters a-z, 0-9, "
                "'_' and '.'");
        if (c.to.size() > message_recipients_max)
            return invalid_argument(
                fmt::format("send_message.to has {} entries; at most {} are allowed", c.to.size(),
                            message_recipients_max));
        if (c.to_server && !c.to.empty())
            return invalid_argument(
                "send_message.to and send_message.to_server are both set; set one of them");
        return {};
    }
    Status operator()(const RoomCommand& c) const { return check_room_command(c); }
    Status operator()(const EditCommand& c) const {
        if (c.position)
            if (Status s = check_point("edit.position", *c.position); !s.ok()) return s;
        if (c.linear_velocity)
            if (Status s =
                    check_length("edit.linear_velocity", *c.linear_velocity, spawn_speed_max);
                !s.ok())
                return s;
        if (c.angular_velocity)
            if (Status s =
                    check_length("edit.angular_velocity", *c.angular_velocity, spawn_speed_max);
                !s.ok())
                return s;
        if (c.mass && c.density)
            return invalid_argument("edit.mass and edit.density are both set; set one of them");
        if (c.mass)
            if (Status s = check_number("edit.mass", *c.mass, mass_min, mass_max); !s.ok())
                return s;
        if (c.density)
            if (Status s = check_number("edit.density", *c.density, 1, 20000); !s.ok()) return s;
        if (c.friction)
            if (Status s = check_number("edit.friction", *c.friction, 0, 10); !s.ok()) return s;
        if (c.restitution)
            if (Status s = check_number("edit.restitution", *c.restitution, 0, 1); !s.ok())
                return s;
        return c.gravity_scale ? check_number("edit.gravity_scale", *c.gravity_scale, -10, 10)
                               : Status();
    }
    Status operator()(const CloneCommand& c) const { return check_point("clone.offset", c.offset); }
    Status operator()(const CreateJointCommand& c) const { return check_joint(c); }
    Status operator()(const DeleteJointCommand&) const { return {}; }
    Status operator()(const UndoCommand&) const { return {}; }

private:
    static Status check_motor(bool enabled, double speed, double force, const char* speed_name,
                              const char* force_name) {
        if (!enabled) return {};
        if (Status s = check_number(speed_name, speed, -motor_speed_max, motor_speed_max); !s.ok())
            return s;
        return check_number(force_name, force, 0, motor_force_max);
    }
    static Status check_spring(const char* name, const physics::JointSpring& spring) {
        return check_number(name, spring.hertz, 0, joint_spring_hertz_max);
    }
    static Status check_joint_kind(const physics::JointKind& kind) {
        if (const auto* ball = std::get_if<physics::BallJoint>(&kind))
            return check_spring("create_joint.joint.ball.drive.spring.hertz", ball->drive.spring);
        if (const auto* hinge = std::get_if<physics::HingeJoint>(&kind)) {
            if (Status s =
                    check_motor(hinge->motor.enabled, hinge->motor.speed, hinge->motor.max_torque,
                                "create_joint.joint.hinge.motor_speed",
                                "create_joint.joint.hinge.motor_max_torque");
                !s.ok())
                return s;
            return check_spring("create_joint.joint.hinge.spring.hertz", hinge->spring);
        }
        if (const auto* slider = std::get_if<physics::SliderJoint>(&kind)) {
            if (Status s =
                    check_motor(slider->motor.enabled, slider->motor.speed, slider->motor.max_force,
                                "create_joint.joint.slider.motor_speed",
                                "create_joint.joint.slider.motor_max_force");
                !s.ok())
                return s;
            return check_spring("create_joint.joint.slider.spring.hertz", slider->spring);
        }
        if (const auto* distance = std::get_if<physics::DistanceJoint>(&kind))
            return check_spring("create_joint.joint.distance.spring.hertz", distance->spring);
        if (const auto* fixed = std::get_if<physics::FixedJoint>(&kind)) {
            if (Status s = check_spring("create_joint.joint.fixed.linear.hertz", fixed->linear);
                !s.ok())
                return s;
            return check_spring("create_joint.joint.fixed.angular.hertz", fixed->angular);
        }
        return invalid_argument(
            fmt::format("create_joint.joint is a {} joint; allowed are ball, hinge, slider, fixed "
                        "and distance",
                        physics::kind_name(kind)));
    }
    static Status check_joint(const CreateJointCommand& c) {
        if (c.entity_b == 0)
            return invalid_argument(
                "create_joint.entity_b is 0; only entity_a may be the world (0)");
        if (c.frame)
            if (Status s = check_point("create_joint.joint.frame.position", c.frame->position);
                !s.ok())
                return s;
        if (Status s = check_point("create_joint.joint.frame_a.position", c.joint.frame_a.position);
            !s.ok())
            return s;
        if (Status s = check_point("create_joint.joint.frame_b.position", c.joint.frame_b.position);
            !s.ok())
            return s;
        return check_joint_kind(c.joint.kind);
    }
    static Status check_shape(const physics::Geometry& geometry) {
        if (const auto* sphere = std::get_if<physics::Sphere>(&geometry))
            return check_size("sphere.radius", sphere->radius);
        if (const auto* capsule = std::get_if<physics::Capsule>(&geometry)) {
            if (Status s = check_size("capsule.radius", capsule->radius); !s.ok()) return s;
            return check_size("capsule.half_length", capsule->half_length);
        }
        if (const auto* box = std::get_if<physics::Box>(&geometry)) {
            const Vec3 h = box->half_extents;
            if (Status s = check_size("box.half_extents.x", h.x); !s.ok()) return s;
            if (Status s = check_size("box.half_extents.y", h.y); !s.ok()) return s;
            return check_size("box.half_extents.z", h.z);
        }
        if (const auto* cylinder = std::get_if<physics::Cylinder>(&geometry)) {
            if (Status s = check_size("cylinder.radius", cylinder->radius); !s.ok()) return s;
            return check_size("cylinder.half_length", cylinder->half_length);
        }
        if (const auto* cone = std::get_if<physics::Cone>(&geometry)) {
            if (Status s = check_size("cone.radius", cone->radius); !s.ok()) return s;
            return check_size("cone.half_length", cone->half_length);
        }
        if (const auto* hull = std::get_if<physics::Hull>(&geometry))
            return check_hull(*hull->data);
        return invalid_argument(fmt::format("a {} cannot be spawned; {}",
                                            kind_name(physics::kind_of(geometry)),
                                            spawned_shapes_allowed));
    }
    // The minimum size applies to the inscribed ball, which excludes slivers. The maximum applies
    // to the distance from the body's origin, so that the shape is not far away from it.
    static Status check_hull(const physics::ConvexHull& hull) {
        if (hull.vertices.size() > static_cast<std::size_t>(spawned_hull_points_max))
            return invalid_argument(fmt::format("the hull has {} points; {}", hull.vertices.size(),
                                                spawned_shapes_allowed));
        for (const Vec3& p : hull.vertices)
            if (!within(p, size_max))
                return invalid_argument(
                    fmt::format("hull.points: ({:g}, {:g}, {:g}) is not within {:g} m of the "
                                "origin along each axis",
                                p.x, p.y, p.z, size_max));
        return check_size("hull: inscribed radius", hull.inner_radius);
    }
    // The remaining properties of the shape.
    static Status check_material(const physics::ShapeDef& shape) {
        const physics::Material& m = shape.material;
        if (Status s = check_number("density", shape.density, 1, 20000); !s.ok()) return s;
        if (shape.mass != 0)
            if (Status s = check_number("mass", shape.mass, mass_min, mass_max); !s.ok()) return s;
        if (Status s = check_number("friction", m.friction, 0, 10); !s.ok()) return s;
        if (Status s = check_number("restitution", m.restitution, 0, 1); !s.ok()) return s;
        if (Status s = check_number("rolling_friction", m.rolling_friction, 0, size_max); !s.ok())
            return s;
        if (Status s = check_number("torsional_friction", m.torsional_friction, 0, size_max);
            !s.ok())
            return s;
        if (Status s = check_length("surface_velocity", m.surface_velocity, spawn_speed_max);
            !s.ok())
            return s;
        return check_length("shape.position", shape.pose.position, size_max);
    }
};

}  // namespace

Status check_numbers(const Action& action) {
    return std::visit(Check{}, action);
}

Admission::Admission(const ClientLimits& limits, bool spectator, Clock::time_point now)
    : limits_(limits),
      spectator_(spectator),
      messages_(limits.messages_per_second, now),
      bytes_(limits.bytes_per_second, now),
      inputs_(limits.inputs_per_second, now),
      user_messages_(limits.user_messages_per_second,
                     std::max(1.0, 2 * limits.user_messages_per_second), now),
      attribute_changes_(limits.attribute_changes_per_second,
                         std::max(static_cast<double>(attributes_per_input_max),
                                  limits.attribute_changes_per_second),
                         now) {}

bool Admission::admit_message(std::size_t bytes, Clock::time_point now) {
    // Both buckets are always charged, so that an oversized message also counts as a message.
    const bool count = messages_.take(1, now);
    return bytes_.take(static_cast<double>(bytes), now) && count;
}

Status Admission::admit_input(const Action& action, Clock::time_point now) {
    // The world checks whose attributes a spectator sets.
    if (spectator_ && !is_data_command(action))
        return Error{ErrorCode::permission_denied,
                     "spectators cannot send inputs, except to rename themselves, to send messages "
                     "and to set their own attributes"};
    if (!inputs_.take(1, now))
        return Error{ErrorCode::resource_exhausted,
                     fmt::format("more than {:g} inputs per second", limits_.inputs_per_second),
                     static_cast<int>(std::ceil(to_ms(inputs_.wait_for(1, now))))};
    if (Status s = check_numbers(action); !s.ok()) return s;
    if (const auto* message = std::get_if<SendMessageCommand>(&action))
        return admit_user_message(*message, now);
    if (const auto* attributes = std::get_if<SetAttributesCommand>(&action))
        return admit_attributes(*attributes, now);
    return {};
}

Status Admission::admit_user_message(const SendMessageCommand& message, Clock::time_point now) {
    if (message.data.size() > static_cast<std::size_t>(limits_.user_message_bytes_max))
        return invalid_argument(
            fmt::format("send_message.data has {} bytes; client.user_message_bytes_max allows {}",
                        message.data.size(), limits_.user_message_bytes_max));
    if (user_messages_.take(1, now)) return {};
    return Error{ErrorCode::resource_exhausted,
                 fmt::format("more than {:g} messages per second "
                             "(client.user_messages_per_second)",
                             limits_.user_messages_per_second),
                 static_cast<int>(std::ceil(to_ms(user_messages_.wait_for(1, now))))};
}

Status Admission::admit_attributes(const SetAttributesCommand& command, Clock::time_point now) {
    const auto changes = static_cast<double>(command.changes.size());
    if (attribute_changes_.take(changes, now)) return {};
    return Error{ErrorCode::resource_exhausted,
                 fmt::format("more than {:g} attribute changes per second "
                             "(client.attribute_changes_per_second)",
                             limits_.attribute_changes_per_second),
                 static_cast<int>(std::ceil(to_ms(attribute_changes_.wait_for(changes, now))))};
}

}  // namespace jostle::server
