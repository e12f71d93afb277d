// SPDX-License-Identifier: MIT
#include "jostle/modules/character.h"

#include <algorithm>

#include "modules/character/src/character_data.h"
#include "modules/character/src/character_steps.h"
#include "modules/character/src/check_character.h"
#include "modules/character/src/steering.h"

namespace jostle::modules {

using namespace physics;
using character_detail::CharacterData;
using character_detail::CharacterStore;

namespace {

Error unknown(CharacterId id) {
    return {ErrorCode::not_found, "character {" + std::to_string(id.index) + ", " +
                                      std::to_string(id.generation) +
                                      "} does not exist or was removed"};
}

CharacterData character_data_of(const CharacterDef& def) {
    CharacterData record;
    record.kind = def.kind;
    record.radius = def.radius;
    record.height = def.height;
    record.crouched_height = def.crouched_height;
    record.skin = def.kind == CharacterKind::sweeping ? def.skin : 0;
    record.mask = def.filter.mask;
    record.abilities = def.abilities;
    record.heading = def.heading - 2 * pi * std::floor((def.heading + pi) / (2 * pi));
    record.feet = def.feet;
    record.velocity = def.velocity;
    return record;
}

// The body's origin is at the feet: crouching changes the shape but not the pose.
Result<BodyId> make_body(World& world, const CharacterData& record, const CharacterDef& def) {
    const bool sweeps = def.kind == CharacterKind::sweeping;
    const BodyDef body{.type = sweeps ? BodyType::kinematic : BodyType::dynamic,
                       .pose = {record.feet, orientation(record)},
                       .linear_velocity = sweeps ? Vec3{} : def.velocity,
                       .locks = sweeps ? AxisLocks{0} : character_detail::upright,
                       .user_data = def.user_data};
    const ShapeDef shape{
        .geometry = character_detail::capsule_of(record, record.height),
        .pose = {.position = {0, 0.5 * record.height, 0}, .rotation = {}},
        .material = {.friction = sweeps ? 0.5 : 0, .friction_rule = Combine::multiply},
        .mass = def.abilities.mass,
        .filter = def.filter};
    return world.create_body(body, shape);
}

}  // namespace

Characters::Characters() : store_(std::make_unique<CharacterStore>()) {}
Characters::~Characters() = default;

Result<CharacterId> Characters::add(World& world, const CharacterDef& def) {
    if (Status s = character_detail::check_def(def); !s.ok()) return s.error();
    std::vector<CharacterData>& records = store_->characters;
    std::size_t index = 0;
    while (index < records.size() && records[index].alive) index++;
    if (index == characters_max)
        return Error{ErrorCode::resource_exhausted, "the world already has the maximum of " +
                                                        std::to_string(characters_max) +
                                                        " characters; remove one first"};
    CharacterData record = character_data_of(def);
    const Result<BodyId> body = make_body(world, record, def);
    if (!body.ok()) return body.error();
    if (index == records.size()) records.emplace_back();
    record.generation = records[index].generation + 1;
    record.alive = true;
    record.body = *body;
    records[index] = record;
    return CharacterId{static_cast<std::uint32_t>(index), record.generation};
}

Status Characters::remove(World& world, CharacterId id) {
    CharacterData* record = store_->find(id);
    if (record == nullptr) return unknown(id);
    record->alive = false;
    if (world.contains(record->body)) return world.destroy_body(record->body);
    return {};
}

bool Characters::contains(CharacterId id) const {
    return store_->find(id) != nullptr;
}

std::vector<CharacterId> Characters::ids() const {
    std::vector<CharacterId> ids;
    for (std::uint32_t k = 0; k < store_->characters.size(); k++)
        if (const CharacterData& record = store_->characters[k]; record.alive)
            ids.push_back({k, record.generation});
    return ids;
}

CharacterId Characters::character_of(BodyId body) const {
    for (std::uint32_t k = 0; k < store_->characters.size(); k++)
        if (const CharacterData& record = store_->characters[k];
            record.alive && record.body == body)
            return {k, record.generation};
    return {};
}

Status Characters::set_controls(CharacterId id, const CharacterControls& controls) {
    CharacterData* record = store_->find(id);
    if (record == nullptr) return unknown(id);
    if (Status s = character_detail::check_walk(controls.walk); !s.ok()) return s;
    record->controls = controls;
    record->controls.walk.y = 0;
    record->stroll = 0;
    return {};
}

Result<CharacterControls> Characters::controls(CharacterId id) const {
    const CharacterData* record = store_->find(id);
    if (record == nullptr) return unknown(id);
    return record->controls;
}

Status Characters::set_abilities(CharacterId id, const CharacterAbilities& abilities) {
    CharacterData* record = store_->find(id);
    if (record == nullptr) return unknown(id);
    if (Status s = character_detail::check_abilities(abilities); !s.ok()) return s;
    record->abilities = abilities;
    return {};
}

Result<CharacterAbilities> Characters::abilities(CharacterId id) const {
    const CharacterData* record = store_->find(id);
    if (record == nullptr) return unknown(id);
    return record->abilities;
}

Status Characters::set_feet(World& world, CharacterId id, Vec3 feet) {
    CharacterData* record = store_->find(id);
    if (record == nullptr) return unknown(id);
    if (Status s = character_detail::check_feet(feet); !s.ok()) return s;
    const Transform pose{feet + character_detail::up * record->foot_height, orientation(*record)};
    if (Status s = world.set_pose(record->body, pose); !s.ok()) return s;
    if (record->ground == GroundKind::on_ground) record->velocity += record->ground_velocity;
    record->feet = feet;
    record->ground = GroundKind::in_air;
    return {};
}

Status Characters::set_velocity(World& world, CharacterId id, Vec3 velocity) {
    CharacterData* record = store_->find(id);
    if (record == nullptr) return unknown(id);
    if (Status s = character_detail::check_velocity(velocity); !s.ok()) return s;
    if (record->kind == CharacterKind::rigid)
        return world.set_linear_velocity(record->body, velocity);
    record->velocity = velocity;
    record->ground = GroundKind::in_air;  // the next step detects ground contact
    return {};
}

Result<CharacterState> Characters::state(const World& world, CharacterId id) const {
    const CharacterData* record = store_->find(id);
    if (record == nullptr) return unknown(id);
    CharacterState state{.id = id,
                         .kind = record->kind,
                         .body = record->body,
                         .feet = record->feet,
                         .heading = record->heading,
                         .velocity = record->velocity + record->ground_velocity,
                         .crouched = record->crouched,
                         .ground = record->ground,
                         .ground_body = record->ground_body,
                         .ground_normal = record->ground_normal,
                         .ground_velocity = record->ground_velocity,
                         .applied_impulse = record->applied_impulse};
    if (record->kind == CharacterKind::sweeping) return state;
    const Result<BodyState> body = world.body(record->body);
    if (!body.ok()) return body.error();
    state.feet = body->pose.position - character_detail::up * record->foot_height;
    state.velocity = body->linear_velocity;
    return state;
}

void Characters::before_step(World& world, double dt) {
    for (CharacterData& record : store_->characters) {
        if (!record.alive) continue;
        if (!world.contains(record.body))
            record.alive = false;  // the body was destroyed by another caller
        else if (record.kind == CharacterKind::sweeping)
            sweep_step(world, record, dt);
        else
            rigid_step(world, record, dt);
    }
}

}  // namespace jostle::modules
