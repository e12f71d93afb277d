// SPDX-License-Identifier: MIT
//
// All stores of one world. Plain data: functions that maintain consistency between the stores are
// in this folder, the stages in stages/.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/base/check.h"
#include "jostle/physics/defs.h"
#include "jostle/physics/force_fields.h"
#include "jostle/physics/profile.h"
#include "physics/src/constraint_graph/constraint_graph.h"
#include "physics/src/foundation/id_pool.h"
#include "physics/src/foundation/thread_choice.h"
#include "physics/src/foundation/thread_pool.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/state/body_store.h"
#include "physics/src/state/contact_store.h"
#include "physics/src/state/event_store.h"
#include "physics/src/state/island_store.h"
#include "physics/src/state/joint_store.h"
#include "physics/src/state/listener_store.h"
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

// Wake requests. Stages file them; they are applied at two points of the step in order of bodies,
// so that the result does not depend on the order of discovery (stages/sleep/wake_bodies.cpp). Not
// part of the state: empty after a step.
struct WakeRequest {
    std::uint32_t body = 0xffffffff;  // a body that sleeps, with its island or in place
    double mass = 0;                  // kg of its surroundings that wake with it
    // Only its load changed: it soon sleeps again if it still rests.
    bool briefly = false;
    auto operator<=>(const WakeRequest&) const = default;
};
using WakeRequests = std::vector<WakeRequest>;

// Returns the mass that a momentum in kg m/s would move at the speed gentle_speed, kg.
inline double mass_to_wake(double momentum) {
    return momentum / tuning::gentle_speed;
}

// Scratch memory for traversals of connected bodies, reused between traversals. Not part of the
// state.
struct GraphScratch {
    std::vector<std::uint8_t> visited, seen_jointed;  // by body; zero between uses
    std::vector<std::uint8_t> visited_jointed;        // by body
    std::vector<std::uint32_t> jointed;               // bodies
    std::vector<std::uint32_t> stack;
};

// Everything that the next step depends on, and data derived from it. A copy of this struct is a
// copy of the world (serialization/restore_point.cpp).
struct WorldStores {
    WorldDef def;
    std::uint64_t steps = 0;
    double last_dt = 0;            // s; 0 before the first step
    double time = 0;               // sum of all dt, s
    OverloadState overload_level;  // of the next step

    BodyStore bodies;
    ShapeStore shapes;
    ContactStore contacts;
    ConstraintGraph graph;
    JointStore joints;
    TriggerStore triggers;
    IslandStore islands;
    FieldStore fields;
};

// Thread usage of the last step. It affects the distribution of work in the next step, never its
// result.
struct ThreadUsage {
    std::int64_t work = 0;  // StepProfile::work
    int solver_tasks = 0;
};

struct WorldState : WorldStores {
    // Modules are part of the state; a restore point stores theirs through their visitors.
    ListenerStore listeners;
    // Not part of the state.
    EventStore events;
    WakeRequests wake_requests;
    std::uint64_t static_revision = 0;  // World::static_revision()
    StepProfile profile;
    // Composite pairs of which a child began or ended to touch; merge_islands reports them.
    std::vector<std::uint32_t> changed_pairs;
    GraphScratch scratch;
    std::unique_ptr<ThreadPool> thread_pool;
    ThreadChoice thread_choice;
    ThreadUsage thread_usage;
};

// Sub-steps of the islands of a set in the current or next step.
inline int substeps_of(ColourSetKey set, const WorldStores& world) {
    return substeps_of(set, world.def, halves_substeps(world.overload_level));
}

inline BodyWarm& warm_of(WorldState& world, std::uint32_t body) {
    ASSERT(body < world.bodies.cold.size());
    ASSERT(world.bodies.ids.alive(body));
    const BodyCold& cold = world.bodies.cold[body];
    switch (cold.set) {
        case BodySet::static_set:
            ASSERT(cold.at < world.bodies.statics.size());
            return world.bodies.statics[cold.at];
        case BodySet::awake:
            ASSERT(cold.at < world.bodies.awake.size());
            return world.bodies.awake[cold.at];
        case BodySet::sleeping:
            break;
    }
    return world.islands.islands[cold.island].sleepers[cold.at];
}
inline const BodyWarm& warm_of(const WorldState& world, std::uint32_t body) {
    return warm_of(const_cast<WorldState&>(world), body);
}

inline bool is_dynamic(const WorldState& world, std::uint32_t body) {
    return body != none && world.bodies.cold[body].type == BodyType::dynamic;
}

inline BodyId body_id(const WorldState& world, std::uint32_t body) {
    if (body == none) return {};
    return {body, world.bodies.ids.generation(body)};
}
inline JointId joint_id(const WorldState& world, std::uint32_t joint) {
    return {joint, world.joints.ids.generation(joint)};
}
inline FieldId field_id(const WorldState& world, std::uint32_t field) {
    return {field, world.fields.ids.generation(field)};
}
inline ShapeId shape_id(const WorldState& world, std::uint32_t shape) {
    return {shape, world.shapes.ids.generation(shape)};
}

}  // namespace jostle::physics
