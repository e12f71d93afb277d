// SPDX-License-Identifier: MIT
#include "physics/src/serialization/derive.h"

#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {
namespace {

void derive_axes(std::vector<BodyWarm>& set) {
    for (BodyWarm& warm : set) warm.axes = to_matrix(warm.rotation);
}

void derive_shapes(ShapedBodies& stores) {
    for (std::uint32_t i = 0; i < stores.shapes.ids.size(); i++) {
        if (!stores.shapes.ids.alive(i)) continue;
        ShapeRecord& shape = stores.shapes.shapes[i];
        derive_shape_pose(stores.bodies.cold[shape.body], shape);
        // The list of moved shapes was saved in its order; inserting a proxy must not extend it.
        const bool moved = shape.moved;
        const std::size_t fresh = stores.triggers.fresh.size();
        shape.moved = true;
        create_proxy(stores, i);
        shape.moved = moved;
        stores.triggers.fresh.resize(fresh);
    }
}

void derive_contacts(ContactGraph& stores) {
    for (std::uint32_t i = 0; i < stores.contacts.ids.size(); i++) {
        if (!stores.contacts.ids.alive(i)) continue;
        const Contact& c = stores.contacts.contacts[i];
        if (c.parent == none) {
            stores.contacts.pairs.insert(pair_key(c.shape_a, c.shape_b));
            count_pair(stores.bodies, c, 1);
        }
        if (c.colour < 0) continue;
        write_body_indices(stores.bodies, stores.graph, c);
        derive_flags(stores, c);
        const ContactLaneRef lane_ref = lane_ref_of(stores.graph, c);
        lane_ref.meta->set(LaneFlag::bounces, lane_ref.lane,
                           lane_ref.meta->restitution[lane_ref.lane] > 0);
        lane_ref.meta->set(LaneFlag::touching_now, lane_ref.lane, c.touching);
    }
}

}  // namespace

void derive_all(WorldState& world) {
    world.bodies.ids.rebuild_free_list();
    world.shapes.ids.rebuild_free_list();
    world.contacts.ids.rebuild_free_list();
    world.joints.ids.rebuild_free_list();
    world.islands.ids.rebuild_free_list();
    world.fields.ids.rebuild_free_list();
    world.fields.derive_active();
    for (const ContactModifier& modifier : world.contacts.modifiers)
        world.contacts.contacts[modifier.contact].has_modifier = true;
    derive_axes(world.bodies.statics);
    derive_axes(world.bodies.awake);
    for (Island& island : world.islands.islands) derive_axes(island.sleepers);
    for (std::uint32_t i = 0; i < world.bodies.ids.size(); i++) {
        BodyCold& cold = world.bodies.cold[i];
        if (!world.bodies.ids.alive(i)) continue;
        world.bodies.asleep_in_place += cold.asleep_in_place ? 1 : 0;
        // The inverses in the bytes are not trusted. Saved worlds from before 2026-11-24 contain
        // zeros for bodies that sleep in place.
        invert_mass(cold);
    }
    derive_shapes(world);
    derive_contacts(world);
}

}  // namespace jostle::physics
