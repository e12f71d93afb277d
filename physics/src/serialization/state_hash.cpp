// SPDX-License-Identifier: MIT
#include "jostle/physics/serialization.h"
#include "jostle/physics/world.h"
#include "physics/src/serialization/field_list.h"
#include "physics/src/serialization/hash_visitor.h"
#include "physics/src/state/world_access.h"

namespace jostle::physics {
std::uint64_t state_hash(const World& world) {
    HashVisitor visitor;
    visit_world(visitor, const_cast<WorldState&>(state_of(world)));
    return visitor.hasher.value;
}

}  // namespace jostle::physics
