// SPDX-License-Identifier: MIT
#include "server/world/query_frame.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::server {

using namespace physics;

namespace {

// Appends the item, or marks the layer as truncated if the list is full.
template <class Item>
void add(std::vector<Item>& list, Item item, QueryFrame& frame, CopyLayers layer) {
    if (list.size() < debug_items_max)
        list.push_back(std::move(item));
    else
        frame.truncated |= layer;
}

void add_contacts(QueryFrame& frame, const World& world) {
    for (const ContactInfo& contact : world.contacts())
        for (int k = 0; k < contact.count; k++)
            add(frame.contacts,
                DebugContact{contact.point[k], contact.normal, contact.gap[k], contact.impulse[k],
                             contact.touching},
                frame, copy_contacts);
}

void add_islands(QueryFrame& frame, const World& world,
                 const std::vector<EntityId>& entity_of_body) {
    for (const std::vector<BodyId>& bodies : world.islands()) {
        DebugIsland island;
        for (const BodyId body : bodies) island.entities.push_back(entity_of_body[body.index]);
        std::ranges::sort(island.entities);
        // The bodies of an island sleep and wake together.
        ASSERT(!bodies.empty());
        const auto first = world.body(bodies.front());
        island.asleep = first.ok() && !first->awake;
        add(frame.islands, std::move(island), frame, copy_islands);
    }
}

void add_bounds(QueryFrame& frame, const World& world) {
    for (const auto& entity : *frame.entity_list)
        for (const ShapeState& shape : entity->shapes)
            if (const auto box = world.bounds(shape.id); box.ok())  // planes are unbounded
                add(frame.bounds, *box, frame, copy_bounds);
}

Vec3 anchor_of(const World& world, BodyId body, const Transform& frame) {
    const auto state = world.body(body);
    if (is_null(body)) return frame.position;  // attached to the world
    return state.ok() ? apply(state->pose, frame.position) : Vec3{};
}

void add_joints(QueryFrame& frame, const World& world,
                const std::vector<EntityId>& entity_of_body) {
    for (const JointId id : world.joints()) {
        const auto joint = world.joint(id);
        if (!joint.ok()) continue;
        const JointDef& def = joint->def;
        add(frame.joints,
            DebugJoint{is_null(def.body_a) ? EntityId{} : entity_of_body[def.body_a.index],
                       entity_of_body[def.body_b.index], anchor_of(world, def.body_a, def.frame_a),
                       anchor_of(world, def.body_b, def.frame_b), kind_name(def.kind)},
            frame, copy_joints);
    }
}

}  // namespace

BodyId QueryFrame::body_of(EntityId entity) const {
    const auto at = std::ranges::lower_bound(*entity_list, entity, {},
                                             [](const auto& described) { return described->id; });
    if (at == entity_list->end() || (*at)->id != entity || (*at)->shapes.empty()) return {};
    return (*at)->shapes.front().body;
}

const std::shared_ptr<const PointShapes>& QueryFrame::point_shapes() const {
    ASSERT(points);
    return point_shapes_.get([&] {
        const auto pose_of = [&](EntityId entity) -> std::optional<Transform> {
            const auto at = std::ranges::lower_bound(carriers, entity, {}, &EntityPose::id);
            if (at == carriers.end() || at->id != entity) return std::nullopt;
            return at->pose;
        };
        const auto any = [](Vec3, double) { return true; };
        return std::make_shared<const PointShapes>(place_points(*points, pose_of, any));
    });
}

ShapeOwners shape_owners_in(const EntityList& entity_list) {
    ShapeOwners shape_owners;
    for (const auto& entity : entity_list)
        for (std::uint32_t number = 0; number < entity->shapes.size(); number++) {
            const std::size_t index = entity->shapes[number].id.index;
            if (shape_owners.size() <= index) shape_owners.resize(index + 1);
            shape_owners[index] = {entity->id, number};
        }
    return shape_owners;
}

void copy_layers(QueryFrame& frame, const World& world,
                 const std::vector<EntityId>& entity_of_body) {
    ASSERT(frame.entity_list && frame.shape_owners);
    if (frame.layers & copy_shapes) frame.queries = world.query_frame();
    if (frame.layers & copy_contacts) add_contacts(frame, world);
    if (frame.layers & copy_islands) add_islands(frame, world, entity_of_body);
    if (frame.layers & copy_bounds) add_bounds(frame, world);
    if (frame.layers & copy_joints) add_joints(frame, world, entity_of_body);
    if (frame.layers & copy_broad_phase)
        for (const Aabb& cell : world.broad_phase_cells())
            add(frame.cells, cell, frame, copy_broad_phase);
}

}  // namespace jostle::server
