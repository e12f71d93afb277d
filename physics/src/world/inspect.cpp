// SPDX-License-Identifier: MIT
//
// Data for debug views: contacts, islands, bounds, broad-phase cells.
#include <algorithm>

#include "jostle/physics/world.h"
#include "physics/src/geometry/shape_measures.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/world_state.h"
#include "physics/src/world/checks.h"
#include "physics/src/world/contact_view.h"

namespace jostle::physics {
namespace {

void sort_by_shapes(std::vector<ContactInfo>& contacts) {
    std::stable_sort(contacts.begin(), contacts.end(),
                     [](const ContactInfo& x, const ContactInfo& y) {
                         return std::pair(x.shape_a, x.shape_b) < std::pair(y.shape_a, y.shape_b);
                     });
}

}  // namespace

std::vector<ContactInfo> World::contacts() const {
    const WorldState& world = *state_;
    std::vector<ContactInfo> all;
    for (std::uint32_t i = 0; i < world.contacts.ids.size(); i++)
        if (world.contacts.ids.alive(i) && world.contacts.contacts[i].colour >= 0)
            all.push_back(solved_contact(world, i));
    for (const Island& island : world.islands.islands)
        for (const SavedContact& saved : island.manifolds)
            all.push_back(sleeping_contact(world, saved));
    sort_by_shapes(all);
    return all;
}

Result<std::vector<ContactInfo>> World::contacts_of(BodyId body) const {
    const WorldState& world = *state_;
    if (Status s = check_id(world.bodies, body); !s.ok()) return s.error();
    std::vector<ContactInfo> all;
    for (const ContactView& view : contacts_on(world, body.index)) all.push_back(view.info);
    sort_by_shapes(all);
    return all;
}

Result<std::vector<BodyId>> World::touching_bodies(BodyId body) const {
    const WorldState& world = *state_;
    if (Status s = check_id(world.bodies, body); !s.ok()) return s.error();
    std::vector<BodyId> touching;
    for_each_contact(world.contacts, world.bodies.cold[body.index], [&](std::uint32_t contact) {
        const Contact& c = world.contacts.contacts[contact];
        if (c.touching)
            touching.push_back(body_id(world.bodies, c.body_a == body.index ? c.body_b : c.body_a));
    });
    std::sort(touching.begin(), touching.end());
    touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
    return touching;
}

std::vector<std::vector<BodyId>> World::islands() const {
    const WorldState& world = *state_;
    std::vector<std::vector<BodyId>> all;
    for (std::uint32_t i = 0; i < world.islands.ids.size(); i++) {
        if (!world.islands.ids.alive(i)) continue;
        all.emplace_back();
        for (std::uint32_t b = world.islands.islands[i].first; b != none;
             b = world.bodies.cold[b].island_next)
            all.back().push_back(body_id(world.bodies, b));
        std::sort(all.back().begin(), all.back().end());
    }
    return all;
}

std::vector<Aabb> World::broad_phase_cells() const {
    std::vector<Aabb> cells;
    state_->shapes.statics->cells(cells);
    state_->shapes.moving->cells(cells);
    return cells;
}

Result<Aabb> World::bounds(ShapeId shape) const {
    const WorldState& world = *state_;
    if (Status s = check_id(world.shapes, shape); !s.ok()) return s.error();
    const ShapeRecord& record = world.shapes.shapes[shape.index];
    if (is_plane(record))
        return Error{ErrorCode::failed_precondition, "a plane is infinite; it has no bounds"};
    return bounds_of(transformed_shape(record, warm_of(world, record.body)));
}

Result<Aabb> World::fat_bounds(ShapeId shape) const {
    const WorldState& world = *state_;
    if (Status s = check_id(world.shapes, shape); !s.ok()) return s.error();
    const ShapeRecord& record = world.shapes.shapes[shape.index];
    if (is_plane(record))
        return Error{ErrorCode::failed_precondition, "a plane is infinite; it has no bounds"};
    return record.fat;
}

}  // namespace jostle::physics
