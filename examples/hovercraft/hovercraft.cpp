// SPDX-License-Identifier: MIT
#include "hovercraft.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace jostle::examples {

using namespace physics;

namespace {

constexpr Vec3 corners[4] = {{-1, -0.3, -1.6}, {1, -0.3, -1.6}, {-1, -0.3, 1.6}, {1, -0.3, 1.6}};
constexpr double max_ray = 4;     // m
constexpr double lag = 0.03;      // s, time constant of a thruster
constexpr double max_lift = 3;    // maximum force of a thruster, relative to its force at rest
constexpr double stiffness = 20;  // 1/s^2; an error of 1 m adds twice the weight
constexpr double damping = 6;     // 1/s
constexpr double gravity = 9.81;  // m/s^2

Status read(const char* name, double value, double low, double high, double& to) {
    if (!(value >= low && value <= high))
        return Error{ErrorCode::invalid_argument, std::string(name) + ": " + std::to_string(value) +
                                                      " is out of range; must be from " +
                                                      std::to_string(low) + " to " +
                                                      std::to_string(high)};
    to = value;
    return {};
}

}  // namespace

void Hovercraft::visit(StateVisitor& v) {
    v.field("craft", craft_);
    v.field("height", settings_.height);
    v.field("speed", settings_.speed);
    v.field("radius", settings_.radius);
    v.field("aside", steering_);
    v.field("ahead", throttle_);
    for (std::size_t k = 0; k < thrusters_.size(); k++) {
        v.enter("thrusters");
        v.enter(k);
        v.field("force", thrusters_[k].force);
        v.field("ray", thrusters_[k].ray);
        v.leave();
        v.leave();
    }
    if (!v.loading()) return;
    // Saved bytes are untrusted: a value out of range fails the load.
    if (!(settings_.height >= 0.3 && settings_.height <= 3)) v.fail("height", "is not 0.3 to 3 m");
    if (!(settings_.speed >= 0 && settings_.speed <= 20)) v.fail("speed", "is not 0 to 20 m/s");
    if (!(settings_.radius >= 4 && settings_.radius <= 1000))
        v.fail("radius", "is not 4 to 1000 m");
    if (!(std::abs(steering_) <= 1)) v.fail("aside", "is not -1 to 1");
    if (!(std::abs(throttle_) <= 1)) v.fail("ahead", "is not -1 to 1");
    for (const Thruster& thruster : thrusters_) {
        if (!(thruster.force >= 0 && thruster.force <= 1e9))
            v.fail("thrusters", "have a force out of range");
        if (!(thruster.ray >= 0 && thruster.ray <= max_ray))
            v.fail("thrusters", "have a ray out of range");
    }
}

Status Hovercraft::configure(World& world, const ModuleSettings& settings) {
    for (const auto& [name, number] : settings.numbers) {
        Status status;
        if (name == "height")
            status = read("height", number, 0.3, 3, settings_.height);
        else if (name == "speed")
            status = read("speed", number, 0, 20, settings_.speed);
        else if (name == "radius")
            status = read("radius", number, 4, 1000, settings_.radius);
        else
            return Error{ErrorCode::invalid_argument,
                         "has no setting " + name + "; it has height, speed and radius"};
        if (!status.ok()) return status;
    }
    for (const auto& [name, body] : settings.bodies) {
        if (name != "craft")
            return Error{ErrorCode::invalid_argument, "has no body " + name + "; it has craft"};
        craft_ = body;
    }
    const Result<BodyState> craft = world.body(craft_);
    if (!craft.ok()) return Error{ErrorCode::invalid_argument, "body craft is missing"};
    if (craft->type != BodyType::dynamic)
        return Error{ErrorCode::invalid_argument, "craft is not dynamic; use BODY_TYPE_DYNAMIC"};
    return world.set_sleep_allowed(craft_, false);
}

void Hovercraft::before_substep(SubstepContext& substep) {
    if (!substep.contains(craft_)) return;
    const MovingBody craft = substep.body(craft_);
    lift(substep, craft);
    drive(substep, craft);
}

void Hovercraft::lift(SubstepContext& substep, const MovingBody& craft) {
    const Vec3 up = rotate(craft.pose.rotation, {0, 1, 0});
    const double share = craft.mass / 4, weight = share * gravity;
    const Queries ground = substep.world().queries();
    for (std::size_t k = 0; k < thrusters_.size(); k++) {
        Thruster& thruster = thrusters_[k];
        const Vec3 at = apply(craft.pose, corners[k]);
        const auto hit =
            ground.cast_ray({.origin = at, .motion = up * -max_ray}, {.ignore = craft_});
        const bool found = hit.ok() && hit->has_value();
        thruster.ray = found ? (*hit)->fraction * max_ray : max_ray;
        double target = 0;
        if (found)
            target = weight + share * (stiffness * (settings_.height - thruster.ray) -
                                       damping * dot(substep.velocity_at(craft_, at), up));
        target = std::clamp(target, 0.0, max_lift * weight);
        thruster.force += (target - thruster.force) * std::min(1.0, substep.h() / lag);
        substep.add_impulse(craft_, up * (thruster.force * substep.h()), at);
    }
}

// Steers towards a course along the circle that corrects the distance to it.
double Hovercraft::turn_to_circle(const MovingBody& craft) const {
    const Vec3 forward = rotate(craft.pose.rotation, {0, 0, -1});
    const Vec3 up = rotate(craft.pose.rotation, {0, 1, 0});
    const Vec3 out{craft.center.x, 0, craft.center.z};
    const double distance = length(out);
    const Vec3 radial = distance > 0.1 ? out * (1 / distance) : Vec3{1, 0, 0};
    const Vec3 along{radial.z, 0, -radial.x};
    const Vec3 course = along - radial * std::clamp((distance - settings_.radius) / 6, -1.5, 1.5);
    return 4 * dot(cross(forward, course), up);
}

// Accelerates along the craft's -z axis and damps sideways motion.
void Hovercraft::drive(SubstepContext& substep, const MovingBody& craft) {
    const Vec3 forward = rotate(craft.pose.rotation, {0, 0, -1});
    const Vec3 right = rotate(craft.pose.rotation, {1, 0, 0});
    const Vec3 up = rotate(craft.pose.rotation, {0, 1, 0});
    const Vec3 v = craft.linear_velocity;
    const bool steered = steering_ != 0 || throttle_ != 0;
    const double speed = settings_.speed * (steered ? throttle_ : 1);
    const Vec3 gain = forward * (speed - dot(v, forward)) - right * (2 * dot(v, right));
    substep.add_impulse(craft_, gain * (craft.mass * substep.h()), craft.center);
    const double turn =
        (steered ? -4 * steering_ : turn_to_circle(craft)) - 3 * dot(craft.angular_velocity, up);
    substep.add_angular_impulse(craft_, up * (craft.mass * 1.2 * turn * substep.h()));
}

void Hovercraft::control(World& world, BodyId, const Controls& controls) {
    steering_ = controls.axes[0];
    throttle_ = controls.axes[1];
    static_cast<void>(world.wake(craft_).ok());
}

void Hovercraft::publish(const World& world, ChannelWriter& channels) const {
    const Result<BodyState> craft = world.body(craft_);
    if (!craft.ok()) return;
    const double max_force = max_lift * craft->mass / 4 * gravity;
    if (!channels.begin(0, craft_)) return;
    for (std::size_t k = 0; k < thrusters_.size(); k++) {
        for (const double x : {corners[k].x, corners[k].y, corners[k].z})
            channels.quantized(x, -2, 2, 16);
        channels.quantized(thrusters_[k].ray, 0, max_ray, 16);
        channels.quantized(thrusters_[k].force / max_force, 0, 1, 8);
    }
}

}  // namespace jostle::examples
