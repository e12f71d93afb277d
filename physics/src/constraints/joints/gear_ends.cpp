// SPDX-License-Identifier: MIT
#include "physics/src/constraints/joints/gear_ends.h"

#include <cmath>

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/joint_memory.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

// A vector perpendicular to n, continuous in n except at -z (Frisvad, "Building an orthonormal
// basis from a 3d unit vector without normalization", 2012).
Vec3 across(Vec3 n) {
    ASSERT(is_unit(n, 1e-5));
    if (n.z < -0.9999) return {0, -1, 0};
    return {1 - n.x * n.x / (1 + n.z), -n.x * n.y / (1 + n.z), -n.x};
}

using End = GearTerms::End;

Vec3 anchor_of(const JointEnd& end) {
    return end.center + end.arm;
}

End turning(const JointEnd& end, const Carrier& carrier, double scale) {
    return {true, scale, rotate(end.frame, {0, 0, 1}), turn_against(end.frame, carrier.rotation)};
}

End sliding(const JointEnd& end, const Carrier& carrier, double scale) {
    const Vec3 axis = rotate(end.frame, {0, 0, 1});
    return {false, scale, axis, travel_against(anchor_of(end), axis, carrier)};
}

End hanging(const JointEnd& end, Vec3 from, double scale) {
    const Vec3 apart = anchor_of(end) - from;
    const double long_is = length(apart);
    return {false, scale, long_is > 1e-9 ? apart * (1 / long_is) : Vec3{0, -1, 0}, long_is,
            long_is};
}

}  // namespace

double unwrapped(double angle, double expected) {
    return angle + 2 * pi * std::floor((expected - angle) / (2 * pi) + 0.5);
}

double turn_against(Quat frame, Quat carrier) {
    const Vec3 axis = inverse_rotate(carrier, rotate(frame, {0, 0, 1}));
    const Vec3 x = inverse_rotate(carrier, rotate(frame, {1, 0, 0}));
    const Vec3 first = across(axis);
    return arc_tangent(dot(x, cross(axis, first)), dot(x, first));
}

double travel_against(Vec3 point, Vec3 axis, const Carrier& carrier) {
    return dot(axis, point - carrier.origin);
}

GearTerms gear_terms(const Joint& joint, const JointEnd& a, const JointEnd& b,
                     const Carrier* carriers) {
    GearTerms terms;
    End* rows = terms.ends;
    const JointEnd* ends[] = {&a, &b};
    const auto* pulley = std::get_if<PulleyJoint>(&joint.kind);
    ASSERT(joint_is_geared(joint.kind));
    if (const auto* gear = std::get_if<GearJoint>(&joint.kind)) {
        rows[0] = turning(a, carriers[0], 1);
        rows[1] = turning(b, carriers[1], gear->ratio);
    } else if (const auto* rack = std::get_if<RackJoint>(&joint.kind)) {
        rows[0] = turning(a, carriers[0], -rack->radius);
        rows[1] = sliding(b, carriers[1], 1);
    } else {
        rows[0] = hanging(a, pulley->point_a, 1);
        rows[1] = hanging(b, pulley->point_b, pulley->ratio);
        terms.target = pulley->length;
    }
    // A carrier that is also an end, or the other end's carrier, participates once.
    const std::uint32_t bodies[] = {joint.body_a, joint.body_b, carriers[0].body, carriers[1].body};
    int slots[4];
    for (int k = 0; k < 4; k++) {
        slots[k] = k;
        for (int other = k - 1; other >= 0; other--)
            if (bodies[other] == bodies[k]) slots[k] = other;
        if (bodies[k] == none) slots[k] = k;
        terms.participates[k] = slots[k] == k;
        terms.body[k] = bodies[k];
        ASSERT(slots[k] >= 0 && slots[k] <= k);
    }
    const Vec3 centers[] = {a.center, b.center, carriers[0].center, carriers[1].center};
    for (int end = 0; end < 2; end++) {
        End& row = rows[end];
        for (int k = 0; k < 4; k++) {
            if (slots[k] != k) continue;
            double sign = k == end ? 1 : 0;
            if (pulley == nullptr && slots[end + 2] == k) sign -= 1;
            row.sign[k] = sign;
            row.arm[k] = anchor_of(*ends[end]) - centers[k];
        }
        if (pulley == nullptr) {
            const std::vector<double>& memory = joint.memory;
            const double last_travel = memory[static_cast<std::size_t>(GearMemory::travel_a + end)];
            if (memory[GearMemory::measured] != 0 && row.turns)
                row.travel = unwrapped(row.travel, last_travel);
        }
        terms.sum += row.scale * row.travel;
    }
    if (pulley == nullptr) {
        const std::vector<double>& memory = joint.memory;
        terms.target = memory[GearMemory::sum];
        // The joint is new, or another body has become a carrier.
        if (memory[GearMemory::measured] == 0 ||
            memory[GearMemory::carrier_a] != static_cast<double>(carriers[0].body) ||
            memory[GearMemory::carrier_b] != static_cast<double>(carriers[1].body))
            terms.target = terms.sum;
    }
    return terms;
}

void write_gear(const Joint& joint, const JointEnd& a, const JointEnd& b, const Carrier* carriers,
                JointGearWide& to, const JointLane& lane) {
    const GearTerms terms = gear_terms(joint, a, b, carriers);
    const bool rope = std::holds_alternative<PulleyJoint>(joint.kind);
    const std::int32_t hot[] = {a.hot, b.hot, carriers[0].hot, carriers[1].hot};
    for (int end = 0; end < 2; end++) {
        const End& row = terms.ends[end];
        for (int k = 0; k < 4; k++) {
            if (!terms.participates[k]) continue;
            if (end == 0) to.body[k][lane.at] = hot[k] < 0 ? -hot[k] : hot[k];
            lane.put(to.sign[end][k], row.sign[k]);
            lane.put(to.arm[end][k], row.arm[k]);
        }
        lane.put(to.axis[end], row.axis);
        lane.put(to.travel[end], row.length);
        lane.put(to.scale[end], row.scale);
        lane.put(to.turns[end], row.turns ? 1 : 0);
        if (!rope) to.carriers[end][lane.at] = static_cast<double>(carriers[end].body);
        to.travels[end][lane.at] = row.travel;
    }
    lane.put(to.rope, rope ? 1 : 0);
    lane.put(to.impulse, joint.motor);
    to.sum[lane.at] = terms.target;
    lane.put(to.error, terms.sum - terms.target);
}

void read_gear(Joint& joint, const JointGearWide& from, double dt, const JointLane& lane) {
    joint.motor = lane.get(from.impulse);
    ASSERT(dt > 0);
    joint.torque = lane.get3(from.torque) * (1 / dt);
    if (joint.memory.empty()) return;
    joint.memory[GearMemory::measured] = 1;
    ASSERT(joint.memory.size() == GearMemory::count);
    joint.memory[GearMemory::carrier_a] = from.carriers[0][lane.at];
    joint.memory[GearMemory::carrier_b] = from.carriers[1][lane.at];
    joint.memory[GearMemory::travel_a] = from.travels[0][lane.at] + lane.get(from.moved[0]);
    joint.memory[GearMemory::travel_b] = from.travels[1][lane.at] + lane.get(from.moved[1]);
    joint.memory[GearMemory::sum] = from.sum[lane.at];
}

}  // namespace jostle::physics
