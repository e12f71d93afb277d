// SPDX-License-Identifier: MIT
#include "jostle/physics/snapshot.h"
#include "jostle/physics/world.h"
#include "persist/field_list.h"
#include "persist/hash_visitor.h"
#include "state/world_access.h"

namespace jostle::physics {
std::uint64_t state_hash(const World& world) {
    HashVisitor visitor;
    visit_world(visitor, const_cast<WorldState&>(state_of(world)));
    return visitor.hasher.value;
}

}  // namespace jostle::physics
