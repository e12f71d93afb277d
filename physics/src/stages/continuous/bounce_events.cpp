// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/bounce_events.h"

#include <algorithm>
#include <utility>

namespace jostle::physics {
namespace {

std::pair<ShapeId, ShapeId> shapes_of(const ContactBegin& c) {
    return {c.shape_a, c.shape_b};
}

// The shape order of their contact: see create_contact() in state/contact_graph.h.
bool is_in_order(const WorldState& world, std::uint32_t shape, std::uint32_t other) {
    const auto dynamic = [&](std::uint32_t s) {
        return is_dynamic(world.bodies, world.shapes.shapes[s].body);
    };
    return dynamic(shape) != dynamic(other) ? dynamic(shape) : shape < other;
}

}  // namespace

void report_impulse(WorldState& world, std::uint32_t shape, std::uint32_t other,
                    const HardestPoint& hit) {
    const ShapeRecord &first = world.shapes.shapes[shape], &second = world.shapes.shapes[other];
    if (!(first.report_stays || second.report_stays) || !(hit.normal_impulse > 0)) return;
    const bool in_order = is_in_order(world, shape, other);
    const std::uint32_t a = in_order ? shape : other, b = in_order ? other : shape;
    world.events.contacts.push_back({.shape_a = shape_id(world.shapes, a),
                                     .shape_b = shape_id(world.shapes, b),
                                     .body_a = body_id(world.bodies, world.shapes.shapes[a].body),
                                     .body_b = body_id(world.bodies, world.shapes.shapes[b].body),
                                     .point = hit.point.position,
                                     .normal = in_order ? hit.point.normal : -hit.point.normal,
                                     .normal_impulse = hit.normal_impulse,
                                     .friction_impulse = hit.friction_impulse});
}

void note_bounce(const WorldState& world, std::uint32_t shape, std::uint32_t other,
                 const HardestPoint& hit, std::vector<ContactBegin>& bounces) {
    const bool in_order = is_in_order(world, shape, other);
    const std::uint32_t a = in_order ? shape : other, b = in_order ? other : shape;
    const std::uint32_t body_a = world.shapes.shapes[a].body, body_b = world.shapes.shapes[b].body;
    bool touching = false;
    for_each_contact(world.contacts, world.bodies.cold[body_a], [&](std::uint32_t contact) {
        const Contact& c = world.contacts.contacts[contact];
        touching |= c.touching && c.parent == none && c.shape_a == a && c.shape_b == b;
    });
    if (touching) return;
    bounces.push_back({shape_id(world.shapes, a), shape_id(world.shapes, b),
                       body_id(world.bodies, body_a), body_id(world.bodies, body_b),
                       hit.point.position, in_order ? hit.point.normal : -hit.point.normal,
                       hit.approach});
}

void report_bounces(EventStore& events, std::vector<ContactBegin>& bounces) {
    std::stable_sort(
        bounces.begin(), bounces.end(),
        [](const ContactBegin& x, const ContactBegin& y) { return shapes_of(x) < shapes_of(y); });
    for (std::size_t k = 0; k < bounces.size(); k++) {
        const ContactBegin& c = bounces[k];
        if (k > 0 && shapes_of(bounces[k - 1]) == shapes_of(c)) continue;
        events.contacts_began.push_back(c);
        events.pending.ended.push_back({c.shape_a, c.shape_b, c.body_a, c.body_b});
    }
    bounces.clear();
}

}  // namespace jostle::physics
