// SPDX-License-Identifier: MIT
#include "physics/src/state/joint_graph.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/state/islands.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {
namespace {

void attach_joint_edge(JointStore& store, std::uint32_t joint, unsigned side, BodyCold& body) {
    Joint& j = store.joints[joint];
    ASSERT(side < 2 && j.next[side] == none && j.prev[side] == none);
    j.prev[side] = none;
    j.next[side] = body.first_joint;
    if (body.first_joint != none)
        store.joints[body.first_joint / 2].prev[body.first_joint % 2] = joint * 2 + side;
    body.first_joint = joint * 2 + side;
}

void detach_joint_edge(JointStore& store, std::uint32_t joint, unsigned side, BodyCold& body) {
    const std::uint32_t next = store.joints[joint].next[side],
                        prev = store.joints[joint].prev[side];
    ASSERT(next == none || store.joints[next / 2].prev[next % 2] == joint * 2 + side);
    ASSERT(prev == none ? body.first_joint == joint * 2 + side
                        : store.joints[prev / 2].next[prev % 2] == joint * 2 + side);
    if (next != none) store.joints[next / 2].prev[next % 2] = prev;
    if (prev != none)
        store.joints[prev / 2].next[prev % 2] = next;
    else
        body.first_joint = next;
}

}  // namespace

void reset_density(BodySets& sets, const JointStore& joints, std::uint32_t joint) {
    const Joint& j = joints.joints[joint];
    for (const std::uint32_t body : {j.body_a, j.body_b})
        if (is_dynamic(sets.bodies, body) && sets.bodies.cold[body].island != none)
            sets.islands.islands[sets.bodies.cold[body].island].too_dense_for = -1;
}

void attach_joint(ContactGraph& stores, JointStore& joints, std::uint32_t joint) {
    const Joint& j = joints.joints[joint];
    ASSERT(joints.ids.alive(joint) && j.body_b != none);
    ASSERT(j.body_a != j.body_b);
    ASSERT(is_dynamic(stores.bodies, j.body_a) || is_dynamic(stores.bodies, j.body_b));
    if (j.body_a != none) attach_joint_edge(joints, joint, 0, stores.bodies.cold[j.body_a]);
    attach_joint_edge(joints, joint, 1, stores.bodies.cold[j.body_b]);
    if (is_dynamic(stores.bodies, j.body_a) && is_dynamic(stores.bodies, j.body_b))
        join_islands(stores, joints, stores.bodies.cold[j.body_a].island,
                     stores.bodies.cold[j.body_b].island);
    reset_density(stores, joints, joint);
    joints.revision++;
}

void destroy_joint(ShapedBodies& stores, JointStore& joints, std::uint32_t joint) {
    Joint& j = joints.joints[joint];
    ASSERT(joints.ids.alive(joint));
    reset_density(stores, joints, joint);
    const std::uint32_t a = j.body_a, b = j.body_b;
    if (a != none) detach_joint_edge(joints, joint, 0, stores.bodies.cold[a]);
    detach_joint_edge(joints, joint, 1, stores.bodies.cold[b]);
    if (is_dynamic(stores.bodies, a) && is_dynamic(stores.bodies, b))
        stores.islands.islands[stores.bodies.cold[a].island].may_be_split = true;
    const bool collided = j.collide_connected;
    j = Joint{};
    joints.ids.release(joint);
    joints.revision++;
    if (collided || a == none) return;
    // Their shapes may collide from now on.
    for (const std::uint32_t body : {a, b})
        for (std::uint32_t s = stores.bodies.cold[body].first_shape; s != none;
             s = stores.shapes.shapes[s].next)
            buffer_move(stores.shapes, stores.triggers, s);
}

bool joined_without_contact(const BodyStore& bodies, const JointStore& joints, std::uint32_t a,
                            std::uint32_t b) {
    ASSERT(a != b);
    if (bodies.cold[a].first_joint == none || bodies.cold[b].first_joint == none) return false;
    bool joined = false;
    for_each_joint(joints, bodies.cold[a], [&](std::uint32_t joint) {
        const Joint& j = joints.joints[joint];
        joined = joined || (!j.collide_connected && (j.body_a == b || j.body_b == b));
    });
    return joined;
}

std::uint32_t find_carrier(const BodyStore& bodies, const JointStore& joints, const Joint& gear,
                           int end) {
    ASSERT(end == 0 || end == 1);
    if (std::holds_alternative<PulleyJoint>(gear.kind)) return none;
    const bool slides = end == 1 && std::holds_alternative<RackJoint>(gear.kind);
    const std::uint32_t body = end == 0 ? gear.body_a : gear.body_b;
    if (body == none) return none;
    const Vec3 z{0, 0, 1};
    const Vec3 axis =
        // In the body's local frame.
        rotate(end == 0 ? gear.frame_a.rotation : gear.frame_b.rotation, z);
    std::uint32_t first = none, carrier = none;
    for_each_joint(joints, bodies.cold[body], [&](std::uint32_t index) {
        const Joint& j = joints.joints[index];
        const bool is_b = j.body_b == body;
        const bool holds = slides ? std::holds_alternative<SliderJoint>(j.kind)
                                  : std::holds_alternative<HingeJoint>(j.kind) ||
                                        (is_b && std::holds_alternative<WheelJoint>(j.kind));
        if (!holds || index > first) return;
        const Vec3 other = rotate(is_b ? j.frame_b.rotation : j.frame_a.rotation, z);
        if (absolute(dot(axis, other)) < 0.999) return;  // 2.6 degrees
        first = index;
        carrier = is_b ? j.body_a : j.body_b;
    });
    return carrier;
}

JointedBodies jointed_with(const BodyStore& bodies, const JointStore& joints, GraphScratch& scratch,
                           std::uint32_t body) {
    std::vector<std::uint32_t>& found = scratch.jointed;
    found.assign(1, body);
    if (bodies.cold[body].first_joint == none) return {found, false};
    std::vector<std::uint8_t>& seen = scratch.seen_jointed;
    seen.resize(bodies.cold.size(), 0);
    seen[body] = 1;
    bool to_kinematic = false;
    for (std::size_t k = 0; k < found.size(); k++)
        for_each_joint(joints, bodies.cold[found[k]], [&](std::uint32_t joint) {
            const Joint& j = joints.joints[joint];
            const std::uint32_t other = j.body_a == found[k] ? j.body_b : j.body_a;
            if (other == none) return;
            const BodyType type = bodies.cold[other].type;
            to_kinematic = to_kinematic || type == BodyType::kinematic;
            if (type != BodyType::dynamic || seen[other] != 0) return;
            seen[other] = 1;
            found.push_back(other);
        });
    ASSERT(seen.size() == bodies.cold.size());
    for (const std::uint32_t part : found) seen[part] = 0;
    std::sort(found.begin(), found.end());
    return {found, to_kinematic};
}

}  // namespace jostle::physics
