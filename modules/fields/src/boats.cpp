// SPDX-License-Identifier: MIT
#include "jostle/modules/boats.h"

#include <algorithm>
#include <string>
#include <utility>

#include "jostle/modules/fields.h"
#include "jostle/modules/settings.h"
#include "jostle/modules/volume.h"

namespace jostle::modules {

using namespace physics;

namespace {

constexpr double rudder_rate = 2.5;           // 1/s, in units of full deflection
constexpr double reverse_thrust_share = 0.5;  // of the forward thrust
constexpr double propeller_offset_max = 8;    // m
// The keel force acts at both ends: at this fraction of the propeller's distance, fore and aft.
constexpr double keel_half_length_ratio = 0.7;

struct Range {
    const char* name;
    double BoatDef::*value;
    double low, high;
};
constexpr Range ranges[] = {{"thrust", &BoatDef::thrust, 0, 1e7},
                            {"top_speed", &BoatDef::top_speed, 0.1, 100},
                            {"rudder_most", &BoatDef::max_rudder_angle, 0, 1.2},
                            {"keel", &BoatDef::keel, 0, 1e6}};

Error invalid(std::string message) {
    return {ErrorCode::invalid_argument, std::move(message)};
}

Status check(const World& world, const BoatDef& def) {
    const Result<BodyState> hull = world.body(def.hull);
    if (!hull.ok()) return invalid("hull is not a body");
    if (hull->type != BodyType::dynamic) return invalid("hull is not a dynamic body");
    if (!is_finite(def.propeller) || length(def.propeller) > propeller_offset_max)
        return invalid("propeller is out of range; it must be within 8 m of the hull's origin");
    for (const Range& range : ranges)
        if (!(def.*range.value >= range.low && def.*range.value <= range.high))
            return invalid(std::string(range.name) + " is out of range");
    return {};
}

// Thrust impulse on the hull at the propeller, N s.
Vec3 thrust_of(const BoatDef& def, const MovingBody& hull, double throttle, double rudder,
               double h) {
    const Vec3 forward = rotate(hull.pose.rotation, {0, 0, -1});
    const double along = dot(hull.linear_velocity, forward);
    // The angle of attack of the blades decreases with the speed of the inflow.
    const double slip = clamp(1 - (throttle < 0 ? -along : along) / def.top_speed, 0, 1);
    const double force = def.thrust * throttle * slip * (throttle < 0 ? reverse_thrust_share : 1);
    // Pushing the stern to the left turns the bow to the right.
    const SinCos turn = sin_cos(rudder * def.max_rudder_angle);
    return rotate(hull.pose.rotation, {-turn.sin, 0, -turn.cos}) * (force * h);
}

// Impulse at one point of the keel, N s. Like a wing, the keel redirects the flow along the hull.
// The impulse is limited so that it does not reverse the sideways motion.
Vec3 keel_of(const BoatDef& def, const MovingBody& hull, Vec3 velocity, double h) {
    const Vec3 right = rotate(hull.pose.rotation, {1, 0, 0});
    const double sideways = dot(velocity, right);
    const double uncapped = 0.5 * def.keel * length(velocity) * absolute(sideways) * h;
    const double most = 0.1 * hull.mass * absolute(sideways);
    return right * (minimum(uncapped, most) * (sideways < 0 ? 1 : -1));
}

}  // namespace

const Boats::Boat* Boats::find(BodyId hull) const {
    const auto found =
        std::ranges::find_if(boats_, [&](const Boat& b) { return b.def.hull == hull; });
    return found == boats_.end() ? nullptr : &*found;
}

Boats::Boat* Boats::find(BodyId hull) {
    return const_cast<Boat*>(std::as_const(*this).find(hull));
}

Status Boats::add(const World& world, const BoatDef& def) {
    if (Status good = check(world, def); !good.ok()) return good;
    if (find(def.hull) != nullptr) return invalid("hull is already a boat");
    if (boats_.size() == boats_max)
        return Error{ErrorCode::resource_exhausted,
                     "the world already has the maximum of 256 boats; remove one first"};
    boats_.push_back({.def = def});
    return {};
}

Status Boats::steer(World& world, BodyId hull, double throttle, double rudder) {
    Boat* boat = find(hull);
    if (boat == nullptr) return Error{ErrorCode::not_found, "the body is not a boat"};
    if (!(absolute(throttle) <= 1 && absolute(rudder) <= 1))
        return invalid("throttle and rudder must be from -1 to 1");
    boat->throttle = throttle;
    boat->rudder_target = rudder;
    return world.wake(hull);
}

std::vector<Boats::State> Boats::states() const {
    std::vector<State> states;
    for (const Boat& boat : boats_)
        states.push_back({boat.def.hull, boat.throttle, boat.rudder, boat.in_water});
    return states;
}

void Boats::visit(StateVisitor& v) {
    v.all("boats", boats_, [&](Boat& boat) {
        v.field("hull", boat.def.hull);
        bounded(v, "screw", boat.def.propeller, propeller_offset_max);
        for (const Range& range : ranges)
            bounded(v, range.name, boat.def.*range.value, range.low, range.high);
        bounded(v, "throttle", boat.throttle, -1, 1);
        bounded(v, "rudder_target", boat.rudder_target, -1, 1);
        bounded(v, "rudder", boat.rudder, -1, 1);
        v.field("wet", boat.in_water);
    });
    if (v.loading() && boats_.size() > boats_max) v.fail("boats", "has more than 256 elements");
}

Status Boats::configure(World& world, const ModuleSettings& given) {
    BoatDef def;
    SettingsReader settings(given);
    settings.number("screw_y", def.propeller.y, -5, 5);
    settings.number("screw_z", def.propeller.z, -5, 5);
    for (const Range& range : ranges)
        settings.number(range.name, def.*range.value, range.low, range.high);
    for (const auto& [name, body] : given.bodies) settings.body(name, def.hull);
    if (Status read = settings.finish(); !read.ok()) return read;
    for (const auto& [name, body] : given.bodies) {
        def.hull = body;
        if (Status added = add(world, def); !added.ok())
            return Error{added.error().code, name + ": " + added.error().message};
    }
    return {};
}

void Boats::control(World& world, BodyId body, const Controls& controls) {
    // Axes are in range. A missing body is ignored: its boat is removed in the next step.
    static_cast<void>(steer(world, body, controls.axes[1], controls.axes[0]));
}

void Boats::before_step(World& world, double dt) {
    std::erase_if(boats_, [&](const Boat& boat) { return !world.contains(boat.def.hull); });
    waters_.clear();
    if (const auto* fields = dynamic_cast<const Fields*>(world.module("fields")))
        for (const FieldKey key : fields->fields())
            if (const auto field = fields->field(key);
                field.ok() && std::holds_alternative<Waves>(field->law))
                waters_.push_back(*field);
    for (Boat& boat : boats_) {
        boat.rudder += clamp(boat.rudder_target - boat.rudder, -rudder_rate * dt, rudder_rate * dt);
        if (boat.throttle != 0) static_cast<void>(world.wake(boat.def.hull));
    }
}

bool Boats::in_water(const SubstepContext& substep, Vec3 point) const {
    const double gravity = -substep.world().gravity().y;
    return std::ranges::any_of(waters_, [&](const VolumeField& water) {
        return contains(water.volume, point) &&
               water_at(std::get<Waves>(water.law), gravity, point, substep.time()).height >
                   point.y;
    });
}

void Boats::before_substep(SubstepContext& substep) {
    for (Boat& boat : boats_) {
        if (!substep.contains(boat.def.hull)) continue;
        if (substep.index() == 0) boat.in_water = false;
        const MovingBody hull = substep.body(boat.def.hull);
        const Vec3 propeller = apply(hull.pose, boat.def.propeller);
        if (!in_water(substep, propeller)) continue;
        boat.in_water = true;
        for (const double end : {-keel_half_length_ratio, keel_half_length_ratio}) {
            const Vec3 at =
                hull.center + rotate(hull.pose.rotation, {0, 0, end * boat.def.propeller.z});
            substep.add_impulse(
                hull.id, keel_of(boat.def, hull, substep.velocity_at(hull.id, at), substep.h()),
                at);
        }
        if (boat.throttle != 0)
            substep.add_impulse(hull.id,
                                thrust_of(boat.def, hull, boat.throttle, boat.rudder, substep.h()),
                                propeller);
    }
}

void Boats::publish(const World&, ChannelWriter& channels) const {
    for (const Boat& boat : boats_) {
        if (!channels.begin(0, boat.def.hull)) continue;
        const Vec3 propeller = boat.def.propeller;
        for (const double x : {propeller.x, propeller.y, propeller.z})
            channels.quantized(x, -propeller_offset_max, propeller_offset_max, 16);
        channels.quantized(boat.throttle, -1, 1, 8);
        channels.quantized(boat.rudder, -1, 1, 8);
        channels.value(boat.in_water ? 1 : 0);
    }
}

}  // namespace jostle::modules
