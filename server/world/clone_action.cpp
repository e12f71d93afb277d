// SPDX-License-Identifier: MIT
#include "server/world/clone_action.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "server/world/edit_action.h"
#include "server/world/joint_actions.h"

namespace jostle::server {

using namespace physics;

JointedGroup jointed_group(const HostedState& state, EntityId entity, bool all) {
    JointedGroup group{.entities = {entity}};
    const World& world = state.world;
    const Entity* const first = state.entities.find(entity);
    if (!first) return group;
    std::set<BodyId> bodies{first->body};
    std::set<JointId> joints;
    for (std::size_t i = 0; all && i < group.entities.size(); i++)
        for (const JointId id : world.joints_of(state.entities.find(group.entities[i])->body)) {
            const JointDef def = world.joint(id)->def;
            for (const BodyId body : {def.body_a, def.body_b}) {
                const EntityId other = is_null(body) ? 0 : state.entities.find_living(body);
                const Entity* const found = state.entities.find(other);
                if (!found || bodies.contains(body) ||
                    (found->description->type != BodyType::dynamic && !found->description->frozen))
                    continue;
                if (group.entities.size() > clone_bodies_max) return group;
                bodies.insert(body);
                group.entities.push_back(other);
            }
            if (!std::holds_alternative<GrabJoint>(def.kind)) joints.insert(id);
        }
    for (const JointId id : joints) {
        const JointDef def = world.joint(id)->def;
        if (bodies.contains(def.body_a) && bodies.contains(def.body_b)) group.joints.push_back(id);
    }
    std::sort(group.entities.begin() + 1, group.entities.end());
    return group;
}

Status clone_bodies(const ActionContext& context, const CloneCommand& c) {
    HostedState& state = context.state;
    const ClientId client = context.client;
    context.affected.entity = c.entity;
    const Result<const Entity*> entity = editable_entity(context, c.entity, Reachable::any);
    if (!entity.ok()) return entity.error();
    const JointedGroup group = jointed_group(state, c.entity, c.jointed);
    if (group.entities.size() > clone_bodies_max)
        return refused(ErrorCode::resource_exhausted,
                       "joints connect more than " + std::to_string(clone_bodies_max) +
                           " bodies to entity " + std::to_string(c.entity) +
                           "; clone fewer bodies");
    const int joints_owned = state.joint_owners.count(state.world, client);
    if (joints_owned + static_cast<int>(group.joints.size()) > state.limits.joints_owned_max)
        return too_many_joints(state, client);
    std::vector<BodyAndShapes> bodies;
    for (const EntityId id : group.entities) {
        BodyAndShapes def = definition_of(state.world, state.entities.find(id)->body);
        def.body.pose.position += c.offset;
        def.body.user_data = 0;
        if (Status s = context.check_body_limits(static_cast<int>(group.entities.size()),
                                                 def.body.pose, def.shapes);
            !s.ok())
            return s;
        bodies.push_back(std::move(def));
    }
    const Result<std::vector<BodyId>> copies = state.world.create_bodies(bodies);
    if (!copies.ok()) return from_solver(copies.error());
    std::map<BodyId, BodyId> copy_of;
    UndoStep step{.kind = UndoStep::Kind::spawned};
    for (std::size_t i = 0; i < copies->size(); i++) {
        const Entity& original = *state.entities.find(group.entities[i]);
        copy_of[original.body] = (*copies)[i];
        const EntityDescription description = *original.description;
        const EntityId id =
            state.entities.add(state.world, (*copies)[i], client, description.color, {});
        if (description.frozen) state.entities.update(state.world, id, description.color, true);
        context.own(id);
        step.entities.push_back(id);
    }
    context.affected.entity = step.entities.front();
    for (const JointId joint : group.joints) {
        JointDef def = state.world.joint(joint)->def;
        def.body_a = copy_of.at(def.body_a);
        def.body_b = copy_of.at(def.body_b);
        def.user_data = 0;
        // Both bodies are valid, and the original has the same kind.
        if (const auto copy = state.world.create_joint(def); copy.ok() && client != scene_client)
            state.joint_owners.add(*copy, client);
    }
    context.record(std::move(step));
    return {};
}

}  // namespace jostle::server
