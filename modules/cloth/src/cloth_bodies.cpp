// SPDX-License-Identifier: MIT
#include "modules/cloth/src/cloth_bodies.h"

#include <algorithm>

namespace jostle::modules::cloth_detail {

using namespace physics;

namespace {

// Of a body outside of the group; inside, SubstepContext::response() is exact.
BodyResponse response_of(const BodyState& body, Vec3 gravity) {
    if (body.type != BodyType::dynamic || !body.awake) return {};
    const Vec3 free{(body.locks & lock_x) != 0 ? 0.0 : 1.0, (body.locks & lock_y) != 0 ? 0.0 : 1.0,
                    (body.locks & lock_z) != 0 ? 0.0 : 1.0};
    const AxisLocks rotations = lock_rotation_x | lock_rotation_y | lock_rotation_z;
    const bool turns = (body.locks & rotations) == 0;
    return {.inverse_mass = free * (1 / body.mass),
            .inverse_inertia = turns ? inverse(body.inertia) : diagonal({0, 0, 0}),
            .acceleration = gravity};
}

CarriedBody carried(const BodyState& body, Vec3 gravity) {
    const bool moves = body.awake || body.type == BodyType::kinematic;
    CarriedBody c;
    c.id = body.id;
    c.type = body.type;
    c.center = c.start_center = body.center;
    c.velocity = moves ? body.linear_velocity : Vec3{};
    c.spin = moves ? body.angular_velocity : Vec3{};
    c.rotation = body.pose.rotation;
    c.origin = {inverse_rotate(body.pose.rotation, body.pose.position - body.center), {}};
    c.response = response_of(body, gravity);
    return c;
}

// Index of a body among those of the cloth; adds it.
std::uint32_t carry(const World& world, Cloth& cloth, BodyId id) {
    for (std::size_t k = 0; k < cloth.bodies.size(); k++)
        if (cloth.bodies[k].id == id) return static_cast<std::uint32_t>(k);
    const Result<BodyState> body = world.body(id);
    if (!body.ok()) return no_body;
    cloth.bodies.push_back(carried(*body, world.gravity()));
    return static_cast<std::uint32_t>(cloth.bodies.size() - 1);
}

}  // namespace

bool is_attached_to(const Cloth& cloth, BodyId body) {
    return std::ranges::any_of(cloth.attachments, [&](const ClothAttachment& attachment) {
        return !is_null(attachment.body) && attachment.body == body;
    });
}

void find_bodies(const World& world, Cloth& cloth) {
    cloth.bodies.clear();
    cloth.attached_body.clear();
    cloth.nearby_body.clear();
    for (const ClothAttachment& attachment : cloth.attachments)
        cloth.attached_body.push_back(
            is_null(attachment.body) ? no_body : carry(world, cloth, attachment.body));
    for (const NearbyShapes::Body& body : cloth.nearby.bodies())
        cloth.nearby_body.push_back(carry(world, cloth, body.id));
    for (const std::uint32_t body : cloth.attached_body)
        if (body != no_body) cloth.bodies[body].attached++;
}

bool is_moving(const World& world, BodyId id) {
    const Result<BodyState> body = world.body(id);
    if (!body.ok() || (!body->awake && body->type != BodyType::kinematic)) return false;
    const double speed = body->type == BodyType::kinematic ? 0 : rest_speed;
    return length_squared(body->linear_velocity) > speed * speed ||
           length_squared(body->angular_velocity) > speed * speed;
}

void tie_bodies(World& world, Cloth& cloth) {
    std::vector<BodyId> bodies;
    const auto add = [&](BodyId id) {
        const Result<BodyState> body = world.body(id);
        if (body.ok() && body->type == BodyType::dynamic) bodies.push_back(id);
    };
    for (const ClothAttachment& attachment : cloth.attachments)
        if (!is_null(attachment.body)) add(attachment.body);
    for (const TouchedBody& touched : cloth.touched) add(touched.body);
    std::ranges::sort(bodies);
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    // The world may refuse a tie if it has too many joints; the impulses then act after the step.
    static_cast<void>(cloth.ties.update(world, bodies));
    for (const BodyId body : cloth.ties.bodies()) static_cast<void>(world.wake(body));
}

bool touch(Cloth& cloth, const CarriedBody& body) {
    if (body.type != BodyType::dynamic) return false;
    const auto at = std::ranges::lower_bound(cloth.touched, body.id, {}, &TouchedBody::body);
    if (at != cloth.touched.end() && at->body == body.id) {
        at->steps_since = 0;
        return false;
    }
    cloth.touched.insert(at, {body.id, 0});
    return true;
}

void read_group(Cloth& cloth, const SubstepContext* group) {
    for (CarriedBody& body : cloth.bodies) {
        if (body.type != BodyType::dynamic) continue;
        body.in_group = group != nullptr && group->contains(body.id);
        if (!body.in_group) continue;
        const MovingBody now = group->body(body.id);
        body.center = body.start_center = now.center;
        body.velocity = now.linear_velocity;
        body.spin = now.angular_velocity;
        body.rotation = now.pose.rotation;
        body.response = group->response(body.id);
        body.impulse = body.angular_impulse = {};
    }
}

void write_group(Cloth& cloth, SubstepContext* group) {
    for (CarriedBody& body : cloth.bodies) {
        if (!body.in_group) continue;
        if (body.impulse != Vec3{}) group->add_impulse(body.id, body.impulse, body.start_center);
        if (body.angular_impulse != Vec3{})
            group->add_angular_impulse(body.id, body.angular_impulse);
        body.impulse = body.angular_impulse = {};
    }
}

void move_bodies(Cloth& cloth, double h) {
    for (CarriedBody& body : cloth.bodies) {
        if (body.type == BodyType::static_body) continue;
        body.velocity += body.response.acceleration * h;
        body.center += body.velocity * h;
        if (body.spin != Vec3{})
            body.rotation = normalized(from_rotation_vector(body.spin * h) * body.rotation);
    }
}

bool is_pushed(const CarriedBody& body) {
    return body.type == BodyType::dynamic &&
           (body.response.inverse_mass != Vec3{} || body.response.inverse_inertia.x != Vec3{});
}

Vec3 travel_of(const CarriedBody& body, Vec3 arm, double h) {
    if (body.type == BodyType::static_body) return {};
    const Vec3 moved = (body.velocity + body.response.acceleration * h) * h;
    if (body.spin == Vec3{}) return moved;
    return moved + (rotate(from_rotation_vector(body.spin * h), arm) - arm);
}

void push(CarriedBody& body, Vec3 impulse, Vec3 arm) {
    if (body.type != BodyType::dynamic) return;
    const Vec3 angular = cross(arm, impulse);
    body.impulse += impulse;
    body.angular_impulse += angular + cross(body.center - body.start_center, impulse);
    body.velocity += scaled(impulse, body.response.inverse_mass);
    body.spin += body.response.inverse_inertia * angular;
}

}  // namespace jostle::modules::cloth_detail
