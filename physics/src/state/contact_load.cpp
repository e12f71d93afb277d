// SPDX-License-Identifier: MIT
#include "physics/src/state/contact_load.h"

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/wide_rows.h"
#include "physics/src/math/is_unit.h"
#include "physics/src/state/contact_constraints.h"

namespace jostle::physics {

Vec3 load_of(const ContactGraph& stores, const Contact& contact) {
    ASSERT(stores.last_dt > 0);
    const ContactLaneRef lane_ref = lane_ref_of(stores.graph, contact);
    const ContactConstraintWide& block = *lane_ref.block;
    const int lane = lane_ref.lane;
    double normal_sum = 0;
    ASSERT(block.lambda[0][lane] >= 0);
    for (const auto& lambda : block.lambda) normal_sum += double{lambda[lane]};
    const Vec3 normal = normal_of(lane_ref);
    ASSERT(is_unit(normal, 1e-4));
    const Vec3 t1 = get_lane(block.tangent, lane);
    const Vec3 impulse = normal * normal_sum + t1 * double{block.friction[0][lane]} +
                         cross(normal, t1) * double{block.friction[1][lane]};
    const std::uint32_t island = stores.bodies.cold[contact.body_a].island;
    const ColourSetKey set = stores.islands.islands[island].colour_set;
    return impulse * (substeps_of(set, stores) / stores.last_dt);
}

Vec3 saved_load(const Contact& c) {
    return {double{c.load[0]}, double{c.load[1]}, double{c.load[2]}};
}

double supported_mass(const WorldDef& def, const Contact& contact) {
    const double gravity = length(def.gravity);
    return gravity > 0 ? length(saved_load(contact)) / gravity : 0;
}

void save_load(ContactGraph& stores, std::uint32_t contact) {
    Contact& c = stores.contacts.contacts[contact];
    const Vec3 load = load_of(stores, c);
    for (int k = 0; k < 3; k++) c.load[k] = static_cast<float>(load[k]);
}

}  // namespace jostle::physics
