// SPDX-License-Identifier: MIT
#include "ground.h"

#include "jostle/physics/hull.h"

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
    Vec3 from, motion;  // of its centre
    Vec3 down, axle;
};

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
    const auto hit = queries.cast_shape({shape, {way.from, rotation}, way.motion}, filter);
    if (!hit.ok() || !*hit || (**hit).fraction <= 0) return {};
    return Found{(**hit).body, (**hit).shape, (**hit).fraction, (**hit).point, (**hit).normal};
}

// The shortest turn from one unit vector to another.
Quat turn_to(Vec3 from, Vec3 to) {
    const Vec3 axis = cross(from, to);
    const Quat q{axis.x, axis.y, axis.z, 1 + dot(from, to)};
    return norm_squared(q) > 1e-12 ? normalized(q) : Quat{0, 1, 0, 0};
}

// How far a wheel's centre is from a plane that it touches.
double reach_of(WheelCast cast, const Wheel& wheel, double lean) {
    if (cast == WheelCast::sphere) return wheel.radius;
    return wheel.radius * square_root(maximum(1 - lean * lean, 0)) + 0.5 * wheel.width * lean;
}

// Whether a wheel meets nothing but the plane that a ray found below its middle; then that is what
// it stands on, and `found` says how far down. Asked of a probe that holds the wheel's lower half,
// a hundredth of a radius above the plane: what sticks out by less is not seen. That costs a fifth
// of a cast.
bool stands_on(const Queries& queries, const QueryFilter& filter, const Way& way,
               const Wheel& wheel, WheelCast cast, const Geometry& probe, Found& found) {
    const Vec3 normal = found.normal;
    const double along = dot(way.axle, normal);
    const double reach = reach_of(cast, wheel, absolute(along));
    const double facing = -dot(way.down, normal);
    const double down = (dot(way.from - found.point, normal) - reach) / facing;
    if (down <= 0) return false;
    const Vec3 center = way.from + way.down * down;
    const Quat level = turn_to({1, 0, 0}, way.axle);
    const Vec3 up = normalized(normal - way.axle * along, -way.down);
    const Transform pose{center + normal * (0.01 * wheel.radius),
                         turn_to(rotate(level, {0, 1, 0}), up) * level};
    const auto met = queries.overlap_shape(probe, pose, filter);
    if (!met.ok() || !met->empty()) return false;
    found.fraction = down / length(way.motion);
    return true;
}

std::optional<Found> cast_whole(const Queries& queries, const QueryFilter& filter, const Way& way,
                                const Wheel& wheel, WheelCast cast) {
    if (cast == WheelCast::sphere)
        return cast_shape_of(queries, filter, way, Sphere{wheel.radius}, {});
    return cast_shape_of(queries, filter, way, Cylinder{wheel.radius, 0.5 * wheel.width},
                         turn_to({0, 1, 0}, way.axle));
}

bool bears(const Way& way, const std::optional<Found>& found) {
    return found && dot(found->normal, way.down) <= -steepest;
}

std::optional<Found> cast_wheel(const Queries& queries, const Car& car, const Wheel& wheel,
                                const Geometry& probe, const Way& way) {
    const QueryFilter filter{.categories = car.def.ground, .ignore = car.def.chassis};
    std::optional<Found> below = cast_ray_of(queries, filter, way, wheel.radius);
    if (!bears(way, below)) below.reset();
    if (car.def.cast == WheelCast::ray) return below;
    if (below && stands_on(queries, filter, way, wheel, car.def.cast, probe, *below)) return below;
    const std::optional<Found> found = cast_whole(queries, filter, way, wheel, car.def.cast);
    if (bears(way, found)) return found;
    // It starts inside of something, or leans on a wall.
    return below;
}

// Where the chassis is in the middle of the step, and how it moves.
struct Chassis {
    Transform pose;
    Vec3 center, v, w;
    double dt;
};

Way way_of(const Chassis& chassis, const Wheel& wheel, Vec3 axle) {
    const Quat turn = chassis.pose.rotation;
    const Vec3 hub = apply(chassis.pose, wheel.attachment), down = rotate(turn, wheel.down);
    const double first = wheel.suspension.shortest - begins_above * wheel.radius;
    // Further down by what the chassis may fall in the step.
    const Vec3 v = chassis.v + cross(chassis.w, hub - chassis.center);
    const double fall = maximum(0, dot(v, down)) * chassis.dt + 0.01 * wheel.radius;
    return {hub + down * first, down * (wheel.suspension.longest - first + fall), down,
            rotate(turn, axle)};
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

void look(const World& world, const Queries& queries, const Way& way, std::size_t index, Car& car) {
    WheelRun& run = car.wheels[index];
    Ground& ground = car.grounds[index] = {};
    const std::optional<Found> found =
        cast_wheel(queries, car, car.def.wheels[index], car.probes[index], way);
    if (!found) return;
    ground.found = true;
    ground.point = found->point;
    ground.normal = found->normal;
    const Vec3 center = way.from + way.motion * found->fraction;
    ground.reach = dot(center - found->point, found->normal);
    const double crown = car.def.wheels[index].crown;
    if (crown > 0) {
        const double lean = dot(way.axle, found->normal);
        ground.reach = crown + (car.def.wheels[index].radius - crown) *
                                   square_root(maximum(1 - lean * lean, 0));
    }
    take_friction(world, car.def.wheels[index].tyre, *found, run);
    take_motion(world, *found, ground);
    run.ground = found->body;
    run.shape = found->shape;
}

// The lower half of a wheel: a prism along x that touches its circle every 30 degrees from outside.
Geometry lower_half(const Wheel& wheel) {
    constexpr double cos_15 = 0.96592582628906829, sin_15 = 0.25881904510252076;
    constexpr double cos_45 = 0.70710678118654752;
    const double r = wheel.radius, corner = r / cos_15, half = 0.5 * wheel.width;
    std::vector<Vec3> points;
    for (const double x : {-half, half})
        for (const double side : {-1.0, 1.0}) {
            points.push_back({x, 0, side * r});
            points.push_back({x, -corner * sin_15, side * r});
            points.push_back({x, -corner * cos_45, side * corner * cos_45});
            points.push_back({x, -r, side * corner * sin_15});
        }
    auto hull = build_hull(points);
    if (hull.ok()) return Hull{*hull};
    return Box{{half, r, r}};
}

void make_probes(Car& car) {
    for (const Wheel& wheel : car.def.wheels)
        car.probes.push_back(car.def.cast == WheelCast::cylinder ? lower_half(wheel)
                                                                 : Sphere{wheel.radius});
}

}  // namespace

void look_for_ground(const World& world, const Queries& queries, const BodyState& body, double dt,
                     Car& car) {
    const Vec3 ahead = body.linear_velocity * (0.5 * dt);
    Chassis chassis{body.pose, body.center + ahead, body.linear_velocity, body.angular_velocity,
                    dt};
    chassis.pose.position += ahead;
    if (car.probes.empty()) make_probes(car);
    car.grounds.resize(car.wheels.size());
    for (std::size_t k = 0; k < car.wheels.size(); k++)
        look(world, queries, way_of(chassis, car.def.wheels[k], car.rigs[k].axle), k, car);
}

}  // namespace jostle::modules::vehicle_detail
