// SPDX-License-Identifier: MIT
//
// All stores of one world. Plain data: functions that maintain consistency between the stores are
// in this folder, the stages in stages/.
#pragma once

#include <memory>

#include "jostle/base/check.h"
#include "jostle/physics/defs.h"
#include "jostle/physics/profile.h"
#include "physics/src/constraint_graph/constraint_graph.h"
#include "physics/src/foundation/thread_choice.h"
#include "physics/src/foundation/thread_pool.h"
#include "physics/src/state/body_store.h"
#include "physics/src/state/contact_store.h"
#include "physics/src/state/event_store.h"
#include "physics/src/state/field_store.h"
#include "physics/src/state/graph_scratch.h"
#include "physics/src/state/island_store.h"
#include "physics/src/state/joint_store.h"
#include "physics/src/state/listener_store.h"
#include "physics/src/state/overload_state.h"
#include "physics/src/state/shape_store.h"
#include "physics/src/state/trigger_store.h"
#include "physics/src/state/wake_requests.h"

namespace jostle::physics {

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
