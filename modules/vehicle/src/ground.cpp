// SPDX-License-Identifier: MIT
#include "modules/vehicle/src/car_parts.h"

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

// Cosine of the steepest supporting surface relative to the suspension. Steeper surfaces are walls,
// which only the chassis collides with.
constexpr double support_cosine_min = 0.2;
// Start of a cast above the fully compressed wheel, in radii. The margin prevents a cast from
// starting inside the ground.
constexpr double cast_start_offset = 0.5;
// Interval, in steps, at which the friction of unchanged ground is read again.
constexpr std::uint64_t friction_steps = 32;

struct GroundHit {
    BodyId body;
    ShapeId shape;
    double fraction;
    Vec3 point, normal;
};

// Path of a wheel in a cast, valid for one step.
struct WheelSweep {
    Vec3 from, motion;  // of its centre
    Vec3 down, axle;
};

std::optional<GroundHit> cast_ray_of(const Queries& queries, const QueryFilter& filter,
                                     const WheelSweep& sweep, double radius) {
    const Vec3 motion = sweep.motion + sweep.down * radius;
    const auto hit = queries.cast_ray({sweep.from, motion}, filter);
    if (!hit.ok() || !*hit) return {};
    // Converts to the position of the wheel's centre at one radius above the hit. The fraction of
    // its path may be outside 0 to 1.
    const double came = (**hit).fraction * length(motion) - radius;
    return GroundHit{(**hit).body, (**hit).shape, came / length(sweep.motion), (**hit).point,
                     (**hit).normal};
}

ShapeCast wheel_shape_cast(const WheelSweep& sweep, const Wheel& wheel, WheelCast cast) {
    if (cast == WheelCast::sphere) return {Sphere{wheel.radius}, {sweep.from, {}}, sweep.motion};
    return {Cylinder{wheel.radius, 0.5 * wheel.width},
            {sweep.from, rotation_between({0, 1, 0}, sweep.axle, {1, 0, 0})},
            sweep.motion};
}

bool is_supporting(const WheelSweep& sweep, const std::optional<GroundHit>& found) {
    return found && dot(found->normal, sweep.down) <= -support_cosine_min;
}

QueryFilter filter_of(const Car& car) {
    return {.categories = car.def.ground, .ignore = car.def.chassis};
}

// Casts all wheels at once.
void cast_wheel_shapes(const Queries& queries, const Car& car, std::span<const WheelSweep> sweeps,
                       std::span<std::optional<GroundHit>> found) {
    std::vector<ShapeCast> casts;
    casts.reserve(sweeps.size());
    for (std::size_t k = 0; k < sweeps.size(); k++)
        casts.push_back(wheel_shape_cast(sweeps[k], car.def.wheels[k], car.def.cast));
    const auto hits = queries.cast_shapes(casts, filter_of(car));
    if (!hits.ok()) return;
    for (std::size_t k = 0; k < sweeps.size(); k++) {
        const std::optional<ShapeCastHit>& hit = (*hits)[k];
        if (hit && hit->fraction > 0)
            found[k] = GroundHit{hit->body, hit->shape, hit->fraction, hit->point, hit->normal};
    }
}

// Pose of the chassis in the middle of the step, and its motion.
struct Chassis {
    Transform pose;
    Vec3 center, v, w;
    double dt;
};

WheelSweep sweep_of(const Chassis& chassis, const Wheel& wheel, Vec3 axle) {
    const Quat turn = chassis.pose.rotation;
    const Vec3 hub = apply(chassis.pose, wheel.attachment), down = rotate(turn, wheel.down);
    const double first = wheel.suspension.min_length - cast_start_offset * wheel.radius;
    // Extends the cast by the distance that the chassis may fall in the step.
    const Vec3 v = chassis.v + cross(chassis.w, hub - chassis.center);
    const double fall = maximum(0, dot(v, down)) * chassis.dt + 0.01 * wheel.radius;
    return {hub + down * first, down * (wheel.suspension.max_length - first + fall), down,
            rotate(turn, axle)};
}

void update_friction(const World& world, const Tyre& tyre, const GroundHit& found,
                     WheelRuntime& run) {
    if (run.shape == found.shape && run.friction > 0 && world.step_count() % friction_steps != 0)
        return;
    const Result<ShapeState> shape = world.shape(found.shape);
    if (!shape.ok()) return;
    run.friction = combine(tyre.friction, tyre.friction_rule, shape->material.friction,
                           shape->material.friction_rule);
}

void update_ground_motion(const World& world, const GroundHit& found, Ground& ground) {
    const Result<BodyState> body = world.body(found.body);
    if (!body.ok() || body->type == BodyType::static_body) return;
    ground.velocity =
        body->linear_velocity + cross(body->angular_velocity, found.point - body->center);
    ground.dynamic = body->type == BodyType::dynamic;
}

void stand(const World& world, const WheelSweep& sweep, const std::optional<GroundHit>& found,
           std::size_t index, Car& car) {
    WheelRuntime& run = car.wheels[index];
    Ground& ground = car.grounds[index] = {};
    if (!is_supporting(sweep, found)) return;
    ground.found = true;
    ground.point = found->point;
    ground.normal = found->normal;
    const Vec3 center = sweep.from + sweep.motion * found->fraction;
    ground.reach = dot(center - found->point, found->normal);
    const double crown = car.def.wheels[index].crown;
    if (crown > 0) {
        const double lean = dot(sweep.axle, found->normal);
        ground.reach = crown + (car.def.wheels[index].radius - crown) *
                                   square_root(maximum(1 - lean * lean, 0));
    }
    update_friction(world, car.def.wheels[index].tyre, *found, run);
    update_ground_motion(world, *found, ground);
    run.ground = found->body;
    run.shape = found->shape;
}

}  // namespace

void find_wheel_ground(const World& world, const Queries& queries, const BodyState& body, double dt,
                       Car& car) {
    const Vec3 forward = body.linear_velocity * (0.5 * dt);
    Chassis chassis{body.pose, body.center + forward, body.linear_velocity, body.angular_velocity,
                    dt};
    chassis.pose.position += forward;
    car.grounds.resize(car.wheels.size());
    std::array<WheelSweep, wheels_max> sweeps;
    std::array<std::optional<GroundHit>, wheels_max> found;
    const std::size_t count = car.wheels.size();
    for (std::size_t k = 0; k < count; k++)
        sweeps[k] = sweep_of(chassis, car.def.wheels[k], car.wheel_axes[k].axle);
    if (car.def.cast != WheelCast::ray)
        cast_wheel_shapes(queries, car, std::span(sweeps).first(count), found);
    for (std::size_t k = 0; k < count; k++) {
        // The cast starts inside a shape, hits a wall, or finds nothing.
        if (!is_supporting(sweeps[k], found[k]))
            found[k] = cast_ray_of(queries, filter_of(car), sweeps[k], car.def.wheels[k].radius);
        stand(world, sweeps[k], found[k], k, car);
    }
}

}  // namespace jostle::modules::vehicle_detail
