// SPDX-License-Identifier: MIT
//
// What debug views show: contacts, islands, bounds, the cells of the broad phase.
#include <algorithm>

#include "geometry/bounds.h"
#include "jostle/physics/world.h"
#include "state/contact_constraints.h"
#include "world/checks.h"

namespace jostle::physics {
namespace {

// The rows of a manifold, whether it is in the constraint graph or kept by a sleeping island.
template <class Row>
void fill_points(ContactInfo& info, Vec3 center, Row&& row) {
    constexpr int normal = 2, tangent = 5, arm = 8, x = 14, y = 18, gap = 22, lambda = 26;
    const auto vec = [&](int first) {
        return Vec3{double{row(first)}, double{row(first + 1)}, double{row(first + 2)}};
    };
    info.normal = vec(normal);
    const Vec3 t1 = vec(tangent), t2 = cross(info.normal, t1), middle = center + vec(arm);
    for (int k = 0; k < 4; k++) {
        if (row(gap + k) > 0.5f * no_point) continue;
        info.point[info.count] = middle + t1 * double{row(x + k)} + t2 * double{row(y + k)};
        info.gap[info.count] = double{row(gap + k)};
        info.impulse[info.count] = double{row(lambda + k)};
        info.count++;
    }
}

ContactInfo info_of(const WorldState& world, std::uint32_t index) {
    const Contact& c = world.contacts.contacts[index];
    return {.shape_a = shape_id(world, c.shape_a),
            .shape_b = shape_id(world, c.shape_b),
            .body_a = body_id(world, c.body_a),
            .body_b = body_id(world, c.body_b),
            .normal = {},
            .point = {},
            .touching = c.touching};
}

ContactInfo solved_contact(const WorldState& world, std::uint32_t contact) {
    const Contact& c = world.contacts.contacts[contact];
    const ContactPlace place = place_of(world, c);
    ContactInfo info = info_of(world, contact);
    fill_points(info, warm_of(world, c.body_a).center,
                [&](int row) { return float_at(*place.block, row, place.lane); });
    return info;
}

ContactInfo sleeping_contact(const WorldState& world, const SavedContact& saved) {
    ContactInfo info = info_of(world, saved.contact);
    info.asleep = true;
    fill_points(
        info, warm_of(world, world.contacts.contacts[saved.contact].body_a).center,
        [&](int row) { return saved.rows[static_cast<std::size_t>(row - first_saved_row)]; });
    return info;
}

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
    if (Status s = check_id(world, body); !s.ok()) return s.error();
    std::vector<ContactInfo> all;
    std::vector<std::uint32_t> asleep;
    for_each_contact(world.contacts, world.bodies.cold[body.index], [&](std::uint32_t contact) {
        if (world.contacts.contacts[contact].colour >= 0)
            all.push_back(solved_contact(world, contact));
        else if (world.contacts.contacts[contact].dormant)
            asleep.push_back(contact);
    });
    // A sleeping contact is kept by the island of its body a, or of b if only that one sleeps.
    std::sort(asleep.begin(), asleep.end());
    std::vector<std::uint32_t> islands;
    for (const std::uint32_t contact : asleep)
        for (const std::uint32_t end :
             {world.contacts.contacts[contact].body_a, world.contacts.contacts[contact].body_b})
            if (world.bodies.cold[end].island != none)
                islands.push_back(world.bodies.cold[end].island);
    std::sort(islands.begin(), islands.end());
    islands.erase(std::unique(islands.begin(), islands.end()), islands.end());
    for (const std::uint32_t island : islands)
        for (const SavedContact& saved : world.islands.islands[island].manifolds)
            if (std::binary_search(asleep.begin(), asleep.end(), saved.contact))
                all.push_back(sleeping_contact(world, saved));
    sort_by_shapes(all);
    return all;
}

Result<std::vector<BodyId>> World::touching_bodies(BodyId body) const {
    const WorldState& world = *state_;
    if (Status s = check_id(world, body); !s.ok()) return s.error();
    std::vector<BodyId> touching;
    for_each_contact(world.contacts, world.bodies.cold[body.index], [&](std::uint32_t contact) {
        const Contact& c = world.contacts.contacts[contact];
        if (c.touching)
            touching.push_back(body_id(world, c.body_a == body.index ? c.body_b : c.body_a));
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
            all.back().push_back(body_id(world, b));
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
    if (Status s = check_id(world, shape); !s.ok()) return s.error();
    const ShapeRecord& record = world.shapes.shapes[shape.index];
    if (is_plane(record))
        return Error{ErrorCode::failed_precondition, "a plane is infinite; it has no bounds"};
    return bounds_of(placed(record, warm_of(world, record.body)));
}

Result<Aabb> World::fat_bounds(ShapeId shape) const {
    const WorldState& world = *state_;
    if (Status s = check_id(world, shape); !s.ok()) return s.error();
    const ShapeRecord& record = world.shapes.shapes[shape.index];
    if (is_plane(record))
        return Error{ErrorCode::failed_precondition, "a plane is infinite; it has no bounds"};
    return record.fat;
}

}  // namespace jostle::physics
