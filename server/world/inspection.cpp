// SPDX-License-Identifier: MIT
#include "server/world/inspection.h"

#include <algorithm>
#include <set>
#include <string>
#include <variant>

#include "jostle/base/check.h"

namespace jostle::server {

using namespace physics;

namespace {

std::uint32_t index_of(const World& world, BodyId body, ShapeId shape) {
    const std::vector<ShapeId> shapes = world.shapes_of(body);
    return static_cast<std::uint32_t>(std::ranges::find(shapes, shape) - shapes.begin());
}

// `substeps`: of the last step. The impulses of contacts are those of its last sub-step.
void add_contacts(BodyInspection& to, const HostedState& state, BodyId body, int substeps) {
    const auto contacts = state.world.contacts_of(body);
    if (!contacts.ok()) return;
    for (const ContactInfo& info : *contacts) {
        if (!info.touching) continue;
        to.contact_count++;
        if (to.contacts.size() == BodyInspection::contacts_max) continue;
        const bool is_a = info.body_a == body;
        const BodyId other = is_a ? info.body_b : info.body_a;
        ContactInspection& contact = to.contacts.emplace_back();
        contact.entity = state.entities.find_living(other);
        contact.shape = index_of(state.world, body, is_a ? info.shape_a : info.shape_b);
        contact.other_shape = index_of(state.world, other, is_a ? info.shape_b : info.shape_a);
        contact.normal = is_a ? info.normal : -info.normal;
        for (int k = 0; k < info.count; k++)
            contact.points.push_back({info.point[k], info.gap[k], info.impulse[k] * substeps});
    }
}

bool is_dynamic(const World& world, BodyId body) {
    const Result<BodyState> state = world.body(body);
    return state.ok() && state->type == BodyType::dynamic;
}

// The dynamic bodies that contacts and joints connect to the body. Returns the lowest one.
BodyId measure_island(BodyInspection& to, const HostedState& state, BodyId body) {
    const World& world = state.world;
    if (!is_dynamic(world, body)) return {};
    std::vector<BodyId> island{body};
    std::set<BodyId> known{body};
    const auto visit = [&](BodyId other) {
        if (island.size() < BodyInspection::island_bodies_max && !is_null(other) &&
            is_dynamic(world, other) && known.insert(other).second)
            island.push_back(other);
    };
    for (std::size_t i = 0; i < island.size(); i++) {
        const BodyId at = island[i];
        if (const auto touching = world.touching_bodies(at); touching.ok())
            for (const BodyId other : *touching) visit(other);
        for (const JointId id : world.joints_of(at)) {
            const JointDef def = world.joint(id)->def;
            visit(def.body_a);
            visit(def.body_b);
        }
    }
    to.island_bodies = island.size();
    for (const BodyId one : island) {
        const EntityId id = state.entities.find_living(one);
        if (id != 0 && (to.island == 0 || id < to.island)) to.island = id;
    }
    return *known.begin();
}

// Of an island in a step; islands at rest took those of the world.
int substeps_of(const World& world, BodyId lowest) {
    const std::vector<IslandSubsteps> islands = world.island_substeps();
    const auto found = std::ranges::find(islands, lowest, &IslandSubsteps::body);
    return found == islands.end() ? world.substeps() : found->substeps;
}

}  // namespace

Result<JointInspection> inspect_joint(const HostedState& state, JointId joint,
                                      const JointNames& name_of) {
    const Result<JointState> found = state.world.joint(joint);
    if (!found.ok()) return Error{ErrorCode::not_found, "the joint does not exist"};
    const auto anchor = [&](BodyId body, const Transform& frame) {
        const Result<BodyState> at = state.world.body(body);
        return at.ok() ? compose(at->pose, frame).position : frame.position;
    };
    const JointDef& def = found->def;
    return JointInspection{
        .id = name_of(joint),
        .entity_a = is_null(def.body_a) ? 0 : state.entities.find_living(def.body_a),
        .entity_b = state.entities.find_living(def.body_b),
        .owner = state.joint_owners.owner_of(joint),
        .state = *found,
        .anchor_a = anchor(def.body_a, def.frame_a),
        .anchor_b = anchor(def.body_b, def.frame_b)};
}

Result<BodyInspection> inspect_body(const HostedState& state, EntityId entity,
                                    const JointNames& name_of) {
    const Entity* const found = state.entities.find(entity);
    if (!found)
        return Error{ErrorCode::not_found, "entity " + std::to_string(entity) + " does not exist"};
    const BodyId body = found->body;
    BodyInspection out{.description = found->description,
                       .state = *state.world.body(body),
                       .definition = *state.world.definition(body)};
    for (const JointId id : state.world.joints_of(body)) {
        if (std::holds_alternative<GrabJoint>(state.world.joint(id)->def.kind)) continue;
        out.joint_count++;
        if (out.joints.size() < BodyInspection::joints_max)
            out.joints.push_back(*inspect_joint(state, id, name_of));
    }
    add_contacts(out, state, body, substeps_of(state.world, measure_island(out, state, body)));
    return out;
}

}  // namespace jostle::server
