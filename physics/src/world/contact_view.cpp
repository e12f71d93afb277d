// SPDX-License-Identifier: MIT
#include "physics/src/world/contact_view.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/math/is_unit.h"
#include "physics/src/state/contact_constraints.h"

namespace jostle::physics {
namespace {

// Reads the rows of a manifold, from the constraint graph or from a sleeping island.
template <class Row>
void fill_points(ContactInfo& info, Vec3 center, Row&& row) {
    constexpr int normal = 2, tangent = 5, arm = 8, x = 14, y = 18, gap = 22, lambda = 26;
    const auto vec = [&](int first) {
        return Vec3{double{row(first)}, double{row(first + 1)}, double{row(first + 2)}};
    };
    info.normal = vec(normal);
    ASSERT(is_unit(info.normal, 1e-4));
    const Vec3 t1 = vec(tangent), t2 = cross(info.normal, t1), middle = center + vec(arm);
    for (int k = 0; k < 4; k++) {
        if (row(gap + k) > 0.5f * no_point) continue;
        ASSERT(info.count < 4);
        info.point[info.count] = middle + t1 * double{row(x + k)} + t2 * double{row(y + k)};
        info.gap[info.count] = double{row(gap + k)};
        info.impulse[info.count] = double{row(lambda + k)};
        info.count++;
    }
}

ContactInfo info_of(const ContactGraph& stores, std::uint32_t index) {
    const Contact& c = stores.contacts.contacts[index];
    return {.shape_a = shape_id(stores.shapes, c.shape_a),
            .shape_b = shape_id(stores.shapes, c.shape_b),
            .body_a = body_id(stores.bodies, c.body_a),
            .body_b = body_id(stores.bodies, c.body_b),
            .normal = {},
            .point = {},
            .touching = c.touching};
}

}  // namespace

ContactInfo solved_contact(const ContactGraph& stores, std::uint32_t contact) {
    const Contact& c = stores.contacts.contacts[contact];
    const ContactLaneRef lane_ref = lane_ref_of(stores.graph, c);
    ASSERT(lane_ref.meta->contact[lane_ref.lane] == contact);
    ContactInfo info = info_of(stores, contact);
    fill_points(info, warm_of(stores, c.body_a).center,
                [&](int row) { return float_at(*lane_ref.block, row, lane_ref.lane); });
    return info;
}

ContactInfo sleeping_contact(const ContactGraph& stores, const SavedContact& saved) {
    ContactInfo info = info_of(stores, saved.contact);
    info.asleep = true;
    fill_points(
        info, warm_of(stores, stores.contacts.contacts[saved.contact].body_a).center,
        [&](int row) { return saved.rows[static_cast<std::size_t>(row - first_saved_row)]; });
    return info;
}

std::vector<ContactView> contacts_on(const ContactGraph& stores, std::uint32_t body) {
    std::vector<ContactView> all;
    std::vector<std::uint32_t> asleep;
    for_each_contact(stores.contacts, stores.bodies.cold[body], [&](std::uint32_t contact) {
        if (stores.contacts.contacts[contact].colour >= 0)
            all.push_back({contact, solved_contact(stores, contact)});
        else if (stores.contacts.contacts[contact].dormant)
            asleep.push_back(contact);
    });
    // A sleeping contact is stored by the island of its body a, or of b if only b sleeps.
    std::sort(asleep.begin(), asleep.end());
    std::vector<std::uint32_t> islands;
    for (const std::uint32_t contact : asleep)
        for (const std::uint32_t end :
             {stores.contacts.contacts[contact].body_a, stores.contacts.contacts[contact].body_b})
            if (stores.bodies.cold[end].island != none)
                islands.push_back(stores.bodies.cold[end].island);
    std::sort(islands.begin(), islands.end());
    islands.erase(std::unique(islands.begin(), islands.end()), islands.end());
    for (const std::uint32_t island : islands)
        for (const SavedContact& saved : stores.islands.islands[island].manifolds)
            if (std::binary_search(asleep.begin(), asleep.end(), saved.contact))
                all.push_back({saved.contact, sleeping_contact(stores, saved)});
    return all;
}

}  // namespace jostle::physics
