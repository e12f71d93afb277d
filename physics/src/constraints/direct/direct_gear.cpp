// SPDX-License-Identifier: MIT
#include "physics/src/constraints/direct/direct_gear.h"

#include "jostle/base/check.h"
#include "physics/src/constraints/joints/gear_ends.h"

namespace jostle::physics {
namespace {

using End = DirectGear::End;
using Motion = DirectGear::Motion;

struct GearBodyPose {
    Vec3 x;
    Quat q;
};
GearBodyPose now_of(const DirectBody& body) {
    return {body.x, body.q};
}
GearBodyPose trial_of(const DirectBody& body) {
    return {body.x1, body.q1};
}

// An end in the world.
struct PlacedEnd {
    Vec3 arm, anchor, axis;  // axis: of the motion, unit
    Vec3 carrier_arm;        // from the carrier's centre to the anchor
    double travel = 0;
};

template <class PoseOf>
PlacedEnd place(const End& end, std::span<const DirectBody> bodies, PoseOf pose_of) {
    const GearBodyPose body = pose_of(bodies[static_cast<std::size_t>(end.body)]);
    PlacedEnd placed;
    placed.arm = rotate(body.q, end.arm);
    placed.anchor = body.x + placed.arm;
    if (end.motion == Motion::hang) {
        const Vec3 apart = placed.anchor - end.point;
        placed.travel = length(apart);
        placed.axis = placed.travel > 1e-9 ? apart * (1 / placed.travel) : Vec3{0, -1, 0};
        return placed;
    }
    const Quat frame = body.q * end.frame;
    placed.axis = rotate(frame, {0, 0, 1});
    Carrier carrier;
    if (end.carrier >= 0) {
        const GearBodyPose pose = pose_of(bodies[static_cast<std::size_t>(end.carrier)]);
        carrier.rotation = pose.q * conjugate(end.carrier_axes);
        carrier.origin = pose.x - rotate(carrier.rotation, end.carrier_center);
        placed.carrier_arm = placed.anchor - pose.x;
    }
    placed.travel = end.motion == Motion::turn
                        ? unwrapped(turn_against(frame, carrier.rotation), end.travel)
                        : travel_against(placed.anchor, placed.axis, carrier);
    return placed;
}

void add_to(DirectGear& gear, int body, Vec3 linear, Vec3 angular) {
    if (body < 0) return;
    for (int k = 0; k < gear.part_count; k++)
        if (gear.parts[k].body == body) {
            gear.parts[k].linear += linear;
            gear.parts[k].angular += angular;
            return;
        }
    ASSERT(false);
}

// `axis`: of unit length, or scaled to the mean of a step.
void add_end(DirectGear& gear, const End& end, const PlacedEnd& placed) {
    const Vec3 axis = placed.axis * end.scale;
    if (end.motion == Motion::turn) {
        add_to(gear, end.body, {}, axis);
        add_to(gear, end.carrier, {}, -axis);
        return;
    }
    add_to(gear, end.body, axis, cross(placed.arm, axis));
    if (end.motion == Motion::slide)
        add_to(gear, end.carrier, -axis, -cross(placed.carrier_arm, axis));
}

// x / tan(x) by its series.
double over_tangent(double x) {
    const double s = x * x;
    return 1 - s * (1.0 / 3 + s * (1.0 / 45 + s * (2.0 / 945 + s / 4725)));
}

}  // namespace

void clear_parts(DirectGear& gear) {
    for (int k = 0; k < gear.part_count; k++) gear.parts[k].linear = gear.parts[k].angular = Vec3{};
}

void list_parts(DirectGear& gear) {
    gear.part_count = 0;
    for (const End& end : gear.ends)
        for (const int body : {end.body, end.carrier}) {
            bool known = body < 0;
            for (int k = 0; k < gear.part_count; k++) known |= gear.parts[k].body == body;
            if (!known) gear.parts[gear.part_count++] = {body, {}, {}};
        }
    ASSERT(gear.part_count >= 1 && gear.part_count <= 4);
}

void write_gear(DirectGear& gear, std::span<const DirectBody> bodies) {
    clear_parts(gear);
    gear.value = 0;
    for (End& end : gear.ends) {
        const PlacedEnd placed = place(end, bodies, now_of);
        end.travel = placed.travel;
        gear.value += end.scale * placed.travel;
        add_end(gear, end, placed);
    }
}

void write_mean_gear(DirectGear& gear, std::span<const DirectBody> bodies) {
    clear_parts(gear);
    for (const End& end : gear.ends) {
        const PlacedEnd before = place(end, bodies, now_of), after = place(end, bodies, trial_of);
        PlacedEnd mean;
        mean.arm = (before.arm + after.arm) * 0.5;
        mean.carrier_arm = (before.carrier_arm + after.carrier_arm) * 0.5;
        mean.axis = (before.axis + after.axis) * 0.5;
        if (end.motion == Motion::turn) {
            // A Cayley map turns by the arc tangent of what the mean spin says.
            mean.axis = normalized(mean.axis) * over_tangent((after.travel - before.travel) * 0.5);
        } else if (end.motion == Motion::hang) {
            const double sum = before.travel + after.travel;
            if (sum > 1e-9)
                mean.axis = (before.axis * before.travel + after.axis * after.travel) * (1 / sum);
        }
        add_end(gear, end, mean);
    }
}

double trial_sum(const DirectGear& gear, std::span<const DirectBody> bodies) {
    double sum = 0;
    for (const End& end : gear.ends) sum += end.scale * place(end, bodies, trial_of).travel;
    return sum;
}

double rate_of(const DirectGear& gear, std::span<const DirectBody> bodies) {
    double rate = 0;
    for (int k = 0; k < gear.part_count; k++) {
        const DirectBody& body = bodies[static_cast<std::size_t>(gear.parts[k].body)];
        rate += dot(gear.parts[k].linear, velocity(body)) + dot(gear.parts[k].angular, spin(body));
    }
    return rate;
}

const DirectGear::Part& part_of(const DirectGear& gear, int body) {
    int k = 0;
    while (k + 1 < gear.part_count && gear.parts[k].body != body) k++;
    ASSERT(gear.parts[k].body == body);
    return gear.parts[k];
}

}  // namespace jostle::physics
