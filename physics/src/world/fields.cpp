// SPDX-License-Identifier: MIT
//
// Creation, change and destruction of force fields.
#include "jostle/physics/world.h"
#include "physics/src/state/force_fields.h"
#include "physics/src/state/shape_proxy.h"
#include "physics/src/state/wake.h"
#include "physics/src/world/body_change.h"
#include "physics/src/world/checks.h"

namespace jostle::physics {
namespace {

FieldDef stored(FieldDef def) {
    if (auto* vortex = std::get_if<VortexField>(&def.force))
        vortex->axis = normalized(vortex->axis);
    if (auto* fluid = std::get_if<BuoyancyField>(&def.force))
        fluid->normal = normalized(fluid->normal);
    return def;
}

// Wakes the bodies on which the field starts or stops to act.
void wake_region(WorldState& world, const FieldDef& field) {
    for (std::uint32_t body = 0; body < world.bodies.ids.size(); body++)
        if (world.bodies.ids.alive(body) &&
            acts_on(world.shapes, field, warm_of(world, body), world.bodies.cold[body]))
            wake_body(world, body);
}

// Call after a change of fields: updates the bounds on the motion of bodies in the next step.
void update_bounds(WorldState& world) {
    world.fields.derive_active();
    for (const BodyWarm& warm : world.bodies.awake)
        update_motion_bound(world, warm.body, expected_dt(world));
}

}  // namespace

Result<FieldId> World::create_field(const FieldDef& def) {
    WorldState& world = *state_;
    if (Status s = check_field(def, world.def.planar); !s.ok()) return s.error();
    const std::uint32_t index = world.fields.ids.take();
    if (index == world.fields.fields.size()) world.fields.fields.emplace_back();
    world.fields.fields[index] = stored(def);
    wake_region(world, def);
    update_bounds(world);
    return field_id(world.fields, index);
}

Status World::set_field(FieldId field, const FieldDef& def) {
    WorldState& world = *state_;
    if (Status s = check_id(world.fields, field); !s.ok()) return s;
    if (Status s = check_field(def, world.def.planar); !s.ok()) return s;
    wake_region(world, world.fields.fields[field.index]);
    world.fields.fields[field.index] = stored(def);
    wake_region(world, def);
    update_bounds(world);
    return {};
}

Status World::destroy_field(FieldId field) {
    WorldState& world = *state_;
    if (Status s = check_id(world.fields, field); !s.ok()) return s;
    wake_region(world, world.fields.fields[field.index]);
    world.fields.fields[field.index] = {};
    world.fields.ids.release(field.index);
    update_bounds(world);
    return {};
}

bool World::contains(FieldId field) const {
    return check_id(state_->fields, field).ok();
}

Result<FieldDef> World::field(FieldId field) const {
    if (Status s = check_id(state_->fields, field); !s.ok()) return s.error();
    return state_->fields.fields[field.index];
}

std::vector<FieldId> World::fields() const {
    std::vector<FieldId> ids;
    for (const std::uint32_t index : state_->fields.active)
        ids.push_back(field_id(state_->fields, index));
    return ids;
}

}  // namespace jostle::physics
