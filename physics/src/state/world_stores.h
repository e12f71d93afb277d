// SPDX-License-Identifier: MIT
//
// The stores of one world, grouped by what functions use together. Each group contains the previous
// one, so a world converts to all of them. A function takes single stores or the smallest group
// that contains the stores it uses.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "jostle/base/check.h"
#include "jostle/physics/defs.h"
#include "jostle/physics/force_fields.h"
#include "jostle/physics/ids.h"
#include "physics/src/constraint_graph/constraint_graph.h"
#include "physics/src/foundation/id_pool.h"
#include "physics/src/state/body_store.h"
#include "physics/src/state/contact_store.h"
#include "physics/src/state/island_store.h"
#include "physics/src/state/joint_store.h"
#include "physics/src/state/shape_store.h"

namespace jostle::physics {

// Shapes inside triggers, as of the last step.
struct Inside {
    std::uint32_t trigger = 0, shape = 0;

    auto operator<=>(const Inside&) const = default;
};

struct TriggerStore {
    std::vector<Inside> inside;  // ascending
    // New or moved triggers, which are tested even if nothing moves.
    std::vector<std::uint32_t> fresh;
};

// The force fields of a world.
struct FieldStore {
    IdPool ids;
    std::vector<FieldDef> fields;       // by index
    std::vector<std::uint32_t> active;  // indices of existing fields, ascending; derived

    bool empty() const { return active.empty(); }

    void derive_active() {
        active.clear();
        for (std::uint32_t i = 0; i < ids.size(); i++)
            if (ids.alive(i)) active.push_back(i);
    }
};

inline FieldId field_id(const FieldStore& fields, std::uint32_t field) {
    return {field, fields.ids.generation(field)};
}

// Overload level of a world with a step budget (WorldDef::step_budget): the measures that reduce
// the work of a step. Each level includes the previous ones. The level is part of the state. It
// changes after a step, depending on the counted work of that step, never on a clock
// (update_step_budget). Without a budget it is 0 and has no effect.
struct OverloadState {
    std::uint8_t level = 0;  // 0 to max_overload_level
    std::uint8_t easy = 0;   // consecutive steps cheap enough for the next lower level
};

// Level 1: manifolds are reused over more motion.
inline bool reuses_manifolds_longer(const OverloadState& overload_level) {
    ASSERT(overload_level.level <= max_overload_level);
    return overload_level.level >= 1;
}
// Level 2: impacts between moving bodies are left to the contact solver. Sweeps against static and
// kinematic bodies remain, so no body passes through them.
inline bool leaves_impacts_to_contacts(const OverloadState& overload_level) {
    return overload_level.level >= 2;
}
// Level 3: islands take half of their sub-steps if that leaves at least two; slender, tall and
// heavily loaded islands, which would collapse, are exempt.
inline bool halves_substeps(const OverloadState& overload_level) {
    return overload_level.level >= 3;
}

// The settings of a world, and how far it was simulated.
struct SteppingState {
    WorldDef def;
    std::uint64_t steps = 0;
    double last_dt = 0;  // s; 0 before the first step
    // The step length that determines the stiffness of contacts, s; 0: that of the step. Longer
    // than the step after it became shorter (stages/step_world.cpp).
    double stiffness_dt = 0;
    // Batches are size levels (substeps_per_size): set once an island of the world needs it.
    bool size_levels = false;
    double time = 0;               // sum of all dt, s
    OverloadState overload_level;  // of the next step
};

// The step length that determines the stiffness of contacts in a step of dt.
inline double stiffness_dt_of(const SteppingState& stepping, double dt) {
    return stepping.stiffness_dt > 0 ? stepping.stiffness_dt : dt;
}

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

// Scratch memory for traversals of connected bodies, reused between traversals. Not part of the
// state.
struct GraphScratch {
    std::vector<std::uint8_t> visited, seen_jointed;  // by body; zero between uses
    std::vector<std::uint8_t> visited_jointed;        // by body
    std::vector<std::uint32_t> jointed;               // bodies
    std::vector<std::uint32_t> stack;
};

// Whether the sub-steps of an island depend on its batch. Otherwise batches only share the work.
inline bool batches_differ(const SteppingState& stepping) {
    return controls_error(stepping.def) || stepping.size_levels;
}
// Sub-steps of the islands of a set in the current or next step.
inline int substeps_of(ColourSetKey set, const SteppingState& stepping) {
    return substeps_of(set, stepping.def, halves_substeps(stepping.overload_level),
                       stepping.size_levels);
}

inline BodyWarm& warm_of(BodySets& sets, std::uint32_t body) {
    ASSERT(body < sets.bodies.cold.size());
    ASSERT(sets.bodies.ids.alive(body));
    const BodyCold& cold = sets.bodies.cold[body];
    switch (cold.set) {
        case BodySet::static_set:
            ASSERT(cold.at < sets.bodies.statics.size());
            return sets.bodies.statics[cold.at];
        case BodySet::awake:
            ASSERT(cold.at < sets.bodies.awake.size());
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
