// SPDX-License-Identifier: MIT
//
// Creation, destruction, replacement, change and reading of shapes.
#include <string>

#include "jostle/base/check.h"
#include "jostle/physics/world.h"
#include "physics/src/state/contact_graph.h"
#include "physics/src/state/shape_proxy.h"
#include "physics/src/state/wake.h"
#include "physics/src/world/body_change.h"
#include "physics/src/world/checks.h"
#include "physics/src/world/mass.h"

namespace jostle::physics {
namespace {

// Adds the shape record to the body's list. The proxy is created later, because the pose relative
// to the centre of mass depends on the mass of the body.
std::uint32_t add_record(BodyStore& bodies, ShapeStore& shapes, std::uint32_t body,
                         const ShapeDef& def) {
    BodyCold& cold = bodies.cold[body];
    const std::uint32_t index = shapes.ids.take();
    if (index == shapes.shapes.size()) shapes.shapes.emplace_back();
    ASSERT((cold.first_shape == none) == (cold.last_shape == none));
    ShapeRecord& shape = shapes.shapes[index];
    shape = ShapeRecord{.geometry = stored(def.geometry),
                        .pose = {def.pose.position, unit(def.pose.rotation)},
                        .material = def.material,
                        .density = def.density,
                        .mass = def.mass,
                        .filter = def.filter,
                        .trigger = def.trigger,
                        .report_stays = def.report_stays,
                        .user_data = def.user_data,
                        .body = body};
    if (cold.last_shape == none)
        cold.first_shape = index;
    else
        shapes.shapes[cold.last_shape].next = index;
    cold.last_shape = index;
    return index;
}

void free_record(WorldState& world, std::uint32_t shape) {
    ASSERT(world.shapes.ids.alive(shape));
    destroy_proxy(world, shape, world.events.pending.left);
    world.shapes.shapes[shape] = ShapeRecord{};
    world.shapes.ids.release(shape);
}

}  // namespace

Result<ShapeId> World::create_shape(BodyId body, const ShapeDef& def) {
    WorldState& world = *state_;
    if (Status s = check_id(world.bodies, body); !s.ok()) return s.error();
    const BodyCold& cold = world.bodies.cold[body.index];
    if (Status s = check_shape_in(world.def, def, cold.type); !s.ok()) return s.error();
    wake_body(world, body.index);
    const std::uint32_t index = add_record(world.bodies, world.shapes, body.index, def);
    // The centre of mass moves, so manifolds of the body's other shapes must be rebuilt.
    if (cold.type == BodyType::dynamic)
        destroy_contacts_of(world, body.index, world.events.pending.ended);
    update_mass(world, world.def, body.index);
    after_move(world, body.index);
    create_proxy(world, index);
    return shape_id(world.shapes, index);
}

Status World::destroy_shape(ShapeId id) {
    WorldState& world = *state_;
    if (Status s = check_id(world.shapes, id); !s.ok()) return s;
    const std::uint32_t body = world.shapes.shapes[id.index].body;
    BodyCold& cold = world.bodies.cold[body];
    if (cold.type == BodyType::dynamic && cold.first_shape == cold.last_shape)
        return Error{ErrorCode::failed_precondition,
                     "a dynamic body needs a shape for its mass; destroy the body instead of its "
                     "last shape"};
    wake_neighbours(world, body);
    wake_body(world, body);
    destroy_contacts_of(world, body, world.events.pending.ended);
    std::uint32_t previous = none;
    for (std::uint32_t s = cold.first_shape; s != id.index; s = world.shapes.shapes[s].next)
        previous = s;
    ASSERT(previous == none || world.shapes.shapes[previous].next == id.index);
    const std::uint32_t next = world.shapes.shapes[id.index].next;
    (previous == none ? cold.first_shape : world.shapes.shapes[previous].next) = next;
    if (cold.last_shape == id.index) cold.last_shape = previous;
    free_record(world, id.index);
    update_mass(world, world.def, body);
    after_move(world, body);
    return {};
}

Result<std::vector<ShapeId>> World::set_shapes(BodyId body, std::span<const ShapeDef> defs) {
    WorldState& world = *state_;
    if (Status s = check_id(world.bodies, body); !s.ok()) return s.error();
    BodyCold& cold = world.bodies.cold[body.index];
    if (Status s = check_shapes_in(world.def, defs, cold.type); !s.ok()) return s.error();
    if (cold.type == BodyType::dynamic && defs.empty())
        return Error{ErrorCode::failed_precondition,
                     "shapes is empty; a dynamic body needs at least one shape for its mass"};
    wake_neighbours(world, body.index);
    wake_body(world, body.index);
    destroy_contacts_of(world, body.index, world.events.pending.ended);
    for (std::uint32_t s = cold.first_shape; s != none;) {
        const std::uint32_t next = world.shapes.shapes[s].next;
        free_record(world, s);
        s = next;
    }
    cold.first_shape = cold.last_shape = none;
    std::vector<ShapeId> created;
    for (const ShapeDef& def : defs)
        created.push_back(
            shape_id(world.shapes, add_record(world.bodies, world.shapes, body.index, def)));
    update_mass(world, world.def, body.index);
    after_move(world, body.index);
    for (const ShapeId& shape : created) create_proxy(world, shape.index);
    ASSERT(created.size() == defs.size());
    return created;
}

Result<ShapeState> World::shape(ShapeId id) const {
    if (Status s = check_id(state_->shapes, id); !s.ok()) return s.error();
    const ShapeRecord& shape = state_->shapes.shapes[id.index];
    return ShapeState{.id = id,
                      .body = body_id(state_->bodies, shape.body),
                      .geometry = shape.geometry,
                      .pose = shape.pose,
                      .material = shape.material,
                      .density = shape.density,
                      .mass = shape.mass,
                      .filter = shape.filter,
                      .trigger = shape.trigger,
                      .report_stays = shape.report_stays,
                      .user_data = shape.user_data};
}

std::vector<ShapeId> World::shapes_of(BodyId body) const {
    std::vector<ShapeId> shapes;
    if (!contains(body)) return shapes;
    for (std::uint32_t s = state_->bodies.cold[body.index].first_shape; s != none;
         s = state_->shapes.shapes[s].next)
        shapes.push_back(shape_id(state_->shapes, s));
    return shapes;
}

Status World::set_material(ShapeId shape, const Material& material) {
    WorldState& world = *state_;
    if (Status s = check_id(world.shapes, shape); !s.ok()) return s;
    if (Status s = check_material(material); !s.ok()) return s;
    ShapeRecord& record = world.shapes.shapes[shape.index];
    wake_neighbours(world, record.body);
    wake_body(world, record.body);
    // Manifolds store the combined material and must be rebuilt.
    destroy_contacts_of_shape(world, shape.index, world.events.pending.ended);
    record.material = material;
    buffer_move(world.shapes, world.triggers, shape.index);
    return {};
}

Status World::set_filter(ShapeId shape, const Filter& filter) {
    WorldState& world = *state_;
    if (Status s = check_id(world.shapes, shape); !s.ok()) return s;
    ShapeRecord& record = world.shapes.shapes[shape.index];
    wake_neighbours(world, record.body);
    wake_body(world, record.body);
    destroy_contacts_of_shape(world, shape.index, world.events.pending.ended);
    destroy_proxy(world, shape.index, world.events.pending.left);
    record.filter = filter;
    create_proxy(world, shape.index);
    return {};
}

Status World::set_user_data(ShapeId shape, std::uint64_t data) {
    if (Status s = check_id(state_->shapes, shape); !s.ok()) return s;
    state_->shapes.shapes[shape.index].user_data = data;
    return {};
}

}  // namespace jostle::physics
