// SPDX-License-Identifier: MIT
//
// The stores of one world, grouped by what functions use together. Each group contains the previous
// one, so a world converts to all of them. A function takes single stores or the smallest group
// that contains the stores it uses.
#pragma once

#include <cstdint>

#include "jostle/base/check.h"
#include "jostle/physics/defs.h"
#include "physics/src/constraint_graph/constraint_graph.h"
#include "physics/src/state/body_store.h"
#include "physics/src/state/contact_store.h"
#include "physics/src/state/field_store.h"
#include "physics/src/state/island_store.h"
#include "physics/src/state/joint_store.h"
#include "physics/src/state/overload_state.h"
#include "physics/src/state/shape_store.h"
#include "physics/src/state/trigger_store.h"

namespace jostle::physics {

// The settings of a world, and how far it was simulated.
struct SteppingState {
    WorldDef def;
    std::uint64_t steps = 0;
    double last_dt = 0;            // s; 0 before the first step
    double time = 0;               // sum of all dt, s
    OverloadState overload_level;  // of the next step
};

// All bodies: static and awake ones in the body store, sleeping ones in their islands.
struct BodySets {
    BodyStore bodies;
    IslandStore islands;
};

// Bodies with their shapes, some of which are triggers.
struct ShapedBodies : BodySets {
    ShapeStore shapes;
    TriggerStore triggers;
};

// Bodies and shapes connected by contacts, and the constraint graph that solves the contacts.
struct ContactGraph : ShapedBodies, SteppingState {
    ContactStore contacts;
    ConstraintGraph graph;
};

// Everything that the next step depends on, and data derived from it. A copy of this struct is a
// copy of the world (serialization/restore_point.cpp).
struct WorldStores : ContactGraph {
    JointStore joints;
    FieldStore fields;
};

// Sub-steps of the islands of a set in the current or next step.
inline int substeps_of(ColourSetKey set, const SteppingState& stepping) {
    return substeps_of(set, stepping.def, halves_substeps(stepping.overload_level));
}

inline BodyWarm& warm_of(BodySets& sets, std::uint32_t body) {
    ASSERT(body < sets.bodies.cold.size());
    const BodyCold& cold = sets.bodies.cold[body];
    switch (cold.set) {
        case BodySet::static_set:
            return sets.bodies.statics[cold.at];
        case BodySet::awake:
            return sets.bodies.awake[cold.at];
        case BodySet::sleeping:
            break;
    }
    return sets.islands.islands[cold.island].sleepers[cold.at];
}
inline const BodyWarm& warm_of(const BodySets& sets, std::uint32_t body) {
    return warm_of(const_cast<BodySets&>(sets), body);
}

}  // namespace jostle::physics
