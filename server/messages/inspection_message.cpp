// SPDX-License-Identifier: MIT
#include "server/messages/inspection_message.h"

#include <variant>

#include "jostle/scenes/joint_definition.h"
#include "jostle/v1/query.pb.h"
#include "server/messages/message_parts.h"

namespace jostle::server {

namespace {

using physics::Vec3;

void write_rotation(v1::Quat& to, const physics::Quat& from) {
    to.set_x(from.x);
    to.set_y(from.y);
    to.set_z(from.z);
    to.set_w(from.w);
}

double coordinate_of(const physics::JointState& joint) {
    if (std::holds_alternative<physics::HingeJoint>(joint.def.kind)) return joint.angle;
    if (std::holds_alternative<physics::SliderJoint>(joint.def.kind)) return joint.travel;
    if (std::holds_alternative<physics::DistanceJoint>(joint.def.kind)) return joint.separation;
    return 0;
}

void write_inertia(v1::InspectedBody& to, const physics::BodyState& body) {
    const physics::Quat& turn = body.pose.rotation;
    const auto column = [&](Vec3 axis) {
        return inverse_rotate(turn, body.inertia * rotate(turn, axis));
    };
    write_vector(*to.mutable_inertia_x(), column({1, 0, 0}));
    write_vector(*to.mutable_inertia_y(), column({0, 1, 0}));
    write_vector(*to.mutable_inertia_z(), column({0, 0, 1}));
}

}  // namespace

void write_inspection(v1::InspectedJoint& to, const JointInspection& from) {
    to.set_id(from.id);
    to.set_entity_a(from.entity_a);
    to.set_entity_b(from.entity_b);
    to.set_owner(from.owner);
    scenes::write_joint_definition(*to.mutable_joint(), from.state.def);
    write_vector(*to.mutable_anchor_a(), from.anchor_a);
    write_vector(*to.mutable_anchor_b(), from.anchor_b);
    to.set_force(length(from.state.force));
    to.set_torque(length(from.state.torque));
    to.set_coordinate(coordinate_of(from.state));
}

void write_inspection(v1::InspectedBody& to, const BodyInspection& from) {
    const EntityDescription& entity = *from.description;
    const physics::BodyState& body = from.state;
    to.set_entity(entity.id);
    to.set_name(entity.name);
    to.set_type(to_message(entity.type));
    to.set_owner(entity.owner);
    write_vector(*to.mutable_position(), body.pose.position);
    write_rotation(*to.mutable_rotation(), body.pose.rotation);
    write_vector(*to.mutable_linear_velocity(), body.linear_velocity);
    write_vector(*to.mutable_angular_velocity(), body.angular_velocity);
    to.set_mass(body.mass);
    write_vector(*to.mutable_center_of_mass(), body.center);
    write_inertia(to, body);
    to.set_gravity_scale(from.definition.gravity_scale);
    to.set_kinetic_energy(0.5 * body.mass * dot(body.linear_velocity, body.linear_velocity) +
                          0.5 * dot(body.angular_velocity, body.inertia * body.angular_velocity));
    to.set_asleep(body.type == physics::BodyType::dynamic && !body.awake);
    to.set_frozen(entity.frozen);
    to.set_island(from.island);
    to.set_island_bodies(static_cast<std::uint32_t>(from.island_bodies));
    for (const physics::ShapeState& shape : entity.shapes) {
        v1::InspectedMaterial& material = *to.add_materials();
        material.set_density(shape.density);
        material.set_friction(shape.material.friction);
        material.set_restitution(shape.material.restitution);
    }
    for (const ContactInspection& one : from.contacts) {
        v1::InspectedContact& contact = *to.add_contacts();
        contact.set_entity(one.entity);
        contact.set_shape(one.shape);
        contact.set_other_shape(one.other_shape);
        write_vector(*contact.mutable_normal(), one.normal);
        for (const ContactInspection::Point& point : one.points) {
            v1::InspectedContactPoint& out = *contact.add_points();
            write_vector(*out.mutable_point(), point.point);
            out.set_separation(point.separation);
            out.set_impulse(point.impulse);
        }
    }
    to.set_contact_count(static_cast<std::uint32_t>(from.contact_count));
    for (const JointInspection& joint : from.joints) write_inspection(*to.add_joints(), joint);
    to.set_joint_count(static_cast<std::uint32_t>(from.joint_count));
}

}  // namespace jostle::server
