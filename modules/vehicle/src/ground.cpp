// SPDX-License-Identifier: MIT
#include "ground.h"

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

// Steeper against the suspension than this it is a wall, which is the chassis' business.
constexpr double steepest = 0.2;  // cosine
// A cast begins so far above where the wheel is when pressed in, in radii: that it does not start
// inside of what it stands on.
constexpr double begins_above = 0.5;
// What a wheel stands on for long is asked for its friction every so many steps.
constexpr std::uint64_t friction_steps = 32;

struct Found {
    BodyId body;
    ShapeId shape;
    double fraction;
    Vec3 point, normal;
};

// A wheel's way, for a step.
struct Way {
    Transform pose;     // of the chassis
    Vec3 from, motion;  // of the wheel's centre
    Vec3 down;
};

// Friction of two materials by the rule of materials: whichever is further down the list.
double combine(double a, Combine rule_a, double b, Combine rule_b) {
    switch (rule_a < rule_b ? rule_b : rule_a) {
        case Combine::average: return 0.5 * (a + b);
        case Combine::geometric_mean: return square_root(a * b);
        case Combine::minimum: return minimum(a, b);
        case Combine::multiply: return a * b;
        case Combine::maximum: return maximum(a, b);
    }
    return a;
}

// Turns the y axis to the axle.
Quat from_y(Vec3 axle) {
    const Quat q{axle.z, 0, -axle.x, 1 + axle.y};
    return norm_squared(q) > 1e-12 ? normalized(q) : Quat{1, 0, 0, 0};
}

std::optional<Found> cast_ray_of(const Queries& queries, const QueryFilter& filter, const Way& way,
                                 double radius) {
    const Vec3 motion = way.motion + way.down * radius;
    const auto hit = queries.cast_ray({way.from, motion}, filter);
    if (!hit.ok() || !*hit) return {};
    // As if the wheel's centre had come to a radius above: the share of its own way may pass both
    // ends.
    const double came = (**hit).fraction * length(motion) - radius;
    return Found{(**hit).body, (**hit).shape, came / length(way.motion), (**hit).point,
                 (**hit).normal};
}

std::optional<Found> cast_shape_of(const Queries& queries, const QueryFilter& filter,
                                   const Way& way, const Geometry& shape, Quat rotation) {
    const auto hit =
        queries.cast_shape({shape, {way.from, rotation}, way.motion}, filter);
    if (!hit.ok() || !*hit || (**hit).fraction <= 0) return {};
    return Found{(**hit).body, (**hit).shape, (**hit).fraction, (**hit).point, (**hit).normal};
}

std::optional<Found> cast_wheel(const Queries& queries, const Car& car, std::size_t index,
                                const Way& way) {
    const Wheel& wheel = car.def.wheels[index];
    const QueryFilter filter{.categories = car.def.ground, .ignore = car.def.chassis};
    std::optional<Found> found;
    if (car.def.cast == WheelCast::sphere)
        found = cast_shape_of(queries, filter, way, Sphere{wheel.radius}, {});
    if (car.def.cast == WheelCast::cylinder)
        found = cast_shape_of(queries, filter, way, Cylinder{wheel.radius, 0.5 * wheel.width},
                              way.pose.rotation * from_y(car.rigs[index].axle));
    if (found && dot(found->normal, way.down) <= -steepest) return found;
    // Rays, and wheels that start inside of something or lean on a wall.
    found = cast_ray_of(queries, filter, way, wheel.radius);
    if (found && dot(found->normal, way.down) <= -steepest) return found;
    return {};
}

Way way_of(const BodyState& chassis, const Transform& pose, const Wheel& wheel, double dt) {
    Way way{pose, {}, {}, rotate(pose.rotation, wheel.down)};
    const double above = begins_above * wheel.radius;
    const double first = wheel.suspension.shortest - above;
    // Further down by what the chassis may fall in the step.
    const Vec3 v = chassis.linear_velocity +
                   cross(chassis.angular_velocity, apply(pose, wheel.attachment) - chassis.center);
    const double fall = maximum(0, dot(v, way.down)) * dt + 0.01 * wheel.radius;
    way.from = apply(pose, wheel.attachment + wheel.down * first);
    way.motion = way.down * (wheel.suspension.longest - first + fall);
    return way;
}

void take_friction(const World& world, const Tyre& tyre, const Found& found, WheelRun& run) {
    if (run.shape == found.shape && run.friction > 0 && world.step_count() % friction_steps != 0)
        return;
    const Result<ShapeState> shape = world.shape(found.shape);
    if (!shape.ok()) return;
    run.friction = combine(tyre.friction, tyre.friction_rule, shape->material.friction,
                           shape->material.friction_rule);
}

void take_motion(const World& world, const Found& found, Ground& ground) {
    const Result<BodyState> body = world.body(found.body);
    if (!body.ok() || body->type == BodyType::static_body) return;
    ground.velocity =
        body->linear_velocity + cross(body->angular_velocity, found.point - body->center);
    ground.dynamic = body->type == BodyType::dynamic;
}

void look(const World& world, const Queries& queries, const Way& way, std::size_t index,
          Car& car) {
    WheelRun& run = car.wheels[index];
    Ground& ground = car.grounds[index] = {};
    const std::optional<Found> found = cast_wheel(queries, car, index, way);
    if (!found) return;
    ground.found = true;
    ground.point = found->point;
    ground.normal = found->normal;
    const Vec3 center = way.from + way.motion * found->fraction;
    ground.reach = dot(center - found->point, found->normal);
    take_friction(world, car.def.wheels[index].tyre, *found, run);
    take_motion(world, *found, ground);
    run.ground = found->body;
    run.shape = found->shape;
}

}  // namespace

void look_for_ground(const World& world, const Queries& queries, const BodyState& chassis,
                     double dt, Car& car) {
    Transform pose = chassis.pose;
    const Vec3 ahead = chassis.linear_velocity * (0.5 * dt);
    pose.position += ahead;
    car.grounds.resize(car.wheels.size());
    for (std::size_t k = 0; k < car.wheels.size(); k++)
        look(world, queries, way_of(chassis, pose, car.def.wheels[k], dt), k, car);
}

}  // namespace jostle::modules::vehicle_detail
