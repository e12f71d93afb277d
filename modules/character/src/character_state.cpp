// SPDX-License-Identifier: MIT
//
// Serialization of characters: saved state, scene settings, driver input and client channels.
#include <string>

#include "jostle/modules/character.h"
#include "jostle/modules/settings.h"
#include "modules/character/src/character_data.h"
#include "modules/character/src/check_character.h"
#include "modules/character/src/steering.h"

namespace jostle::modules {

using namespace physics;
using character_detail::CharacterData;

namespace {

constexpr double controlled_walk_speed = 5;  // m/s at full stick

void visit_size(StateVisitor& v, CharacterData& r) {
    using namespace character_detail;
    bounded(v, "radius", r.radius, radius_min, radius_max);
    const double least = 2 * r.radius + 1.9 * min_shape_size;
    bounded(v, "height", r.height, least, height_max);
    bounded(v, "crouched_height", r.crouched_height, least, r.height);
    bounded(v, "skin", r.skin, r.kind == CharacterKind::rigid ? 0 : skin_min, 0.5 * r.radius);
    bounded(v, "foot_height", r.foot_height, -1e4, 1e4);
    v.field("mask", r.mask);
    for (const Ability& a : ability_ranges) bounded(v, a.name, r.abilities.*a.value, a.low, a.high);
}

void visit_controls(StateVisitor& v, CharacterData& r) {
    bounded(v, "walk", r.controls.walk, character_detail::walk_speed_max);
    v.field("jump", r.controls.jump);
    v.field("crouch", r.controls.crouch);
    v.field("jump_armed", r.jump_armed);
    bounded(v, "stroll", r.stroll, 0, 20);
    bounded(v, "stroll_turn", r.stroll_turn, -10, 10);
    bounded(v, "stroll_angle", r.stroll_angle, -4, 4);
}

void visit_ground(StateVisitor& v, CharacterData& r) {
    v.field("ground", r.ground, GroundKind::in_air);
    v.field("ground_body", r.ground_body);
    v.field("ground_shape", r.ground_shape);
    bounded(v, "ground_normal", r.ground_normal, 1.001);
    bounded(v, "ground_point", r.ground_point, 1e8);
    bounded(v, "ground_velocity", r.ground_velocity, 1e9);
    bounded(v, "given", r.applied_impulse, 1e15);
    v.field("pushed", r.pushed);
}

void visit_character_data(StateVisitor& v, CharacterData& r) {
    v.field("generation", r.generation);
    v.field("alive", r.alive);
    if (!r.alive) {
        const std::uint32_t generation = r.generation;
        if (v.loading()) r = CharacterData{}, r.generation = generation;
        return;
    }
    v.field("kind", r.kind, CharacterKind::rigid);
    v.field("body", r.body);
    visit_size(v, r);
    visit_controls(v, r);
    bounded(v, "heading", r.heading, -4, 4);
    bounded(v, "feet", r.feet, character_detail::coordinate_max);
    bounded(v, "velocity", r.velocity, 1e9);
    v.field("crouched", r.crouched);
    visit_ground(v, r);
}

Error unknown_character(const std::string& name, const std::string& why) {
    return {ErrorCode::invalid_argument, name + " " + why};
}

// Settings that a scene gives for all of its characters.
struct SceneNumbers {
    CharacterAbilities abilities;             // m; 0 derives it from the height
    double skin = 0.02, crouched_height = 0;  // m; 0: by the height
    double stroll = 0, stroll_turn = 0;
};

Status read(const ModuleSettings& given, SceneNumbers& numbers) {
    using namespace character_detail;
    SettingsReader settings(given);
    for (const Ability& a : ability_ranges)
        settings.number(a.name, numbers.abilities.*a.value, a.low, a.high);
    settings.number("skin", numbers.skin, skin_min, 0.5 * radius_max);
    settings.number("crouched_height", numbers.crouched_height, 0, height_max);
    settings.number("stroll", numbers.stroll, 0, 20);
    settings.number("stroll_turn", numbers.stroll_turn, -10, 10);
    BodyId any;
    for (const auto& [name, body] : given.bodies) settings.body(name, any);
    return settings.finish();
}

Result<CharacterData> character_data_for(World& world, const std::string& name, BodyId id,
                                         const SceneNumbers& numbers) {
    const Result<BodyState> body = world.body(id);
    if (!body.ok()) return unknown_character(name, "is not a body");
    if (body->type == BodyType::static_body)
        return unknown_character(name, "is static; it must be kinematic or dynamic");
    const std::vector<ShapeId> shapes = world.shapes_of(id);
    if (shapes.empty())
        return unknown_character(name, "has no shape; its first shape must be an upright capsule");
    const Result<ShapeState> shape = world.shape(shapes.front());
    const auto* capsule = std::get_if<Capsule>(&shape->geometry);
    if (capsule == nullptr || absolute(rotate(shape->pose.rotation, {0, 1, 0}).y) < 0.999999)
        return unknown_character(name, "has the wrong first shape; it must be an upright capsule");
    CharacterData r;
    r.kind = body->type == BodyType::dynamic ? CharacterKind::rigid : CharacterKind::sweeping;
    r.skin = r.kind == CharacterKind::rigid ? 0 : numbers.skin;
    r.body = id;
    r.radius = capsule->radius + r.skin;
    r.height = 2 * (capsule->half_length + r.radius);
    const bool configured = numbers.crouched_height > 0;
    r.crouched_height =
        configured ? numbers.crouched_height
                   : maximum(0.6 * r.height, minimum(r.height, 2 * r.radius + 2 * min_shape_size));
    r.foot_height = 0.5 * r.height - shape->pose.position.y;
    r.mask = shape->filter.mask;
    r.abilities = numbers.abilities;
    if (r.kind == CharacterKind::rigid) r.abilities.mass = clamp(body->mass, 1, 1e4);
    r.stroll = numbers.stroll;
    r.stroll_turn = numbers.stroll_turn;
    r.feet = body->pose.position - character_detail::up * r.foot_height;
    r.velocity = body->linear_velocity;
    return r;
}

Status check_character_data(const std::string& name, const CharacterData& r) {
    CharacterDef def{.kind = r.kind,
                     .feet = r.feet,
                     .velocity = r.velocity,
                     .radius = r.radius,
                     .height = r.height,
                     .crouched_height = r.crouched_height,
                     .skin = r.skin,
                     .abilities = r.abilities};
    if (Status s = character_detail::check_def(def); !s.ok())
        return unknown_character(name, "cannot become a character: " + s.error().message);
    return {};
}

}  // namespace

void Characters::visit(StateVisitor& v) {
    std::vector<CharacterData>& records = store_->characters;
    v.all("characters", records, [&](CharacterData& record) { visit_character_data(v, record); });
    if (v.loading() && records.size() > characters_max)
        v.fail("characters", "has more than 4096 elements");
}

bool Characters::visit_controlled_entity(World& world, BodyId body, StateVisitor& v) {
    std::vector<CharacterData>& records = store_->characters;
    const CharacterId id = character_of(body);
    CharacterData* known = store_->find(id);
    if (!v.loading()) {
        if (known != nullptr) visit_character_data(v, *known);
        return known != nullptr;
    }
    CharacterData read;
    visit_character_data(v, read);
    const Result<BodyState> state = world.body(body);
    if (v.failed() || !state.ok() || !read.alive || read.body != body) return false;
    const bool rigid = read.kind == CharacterKind::rigid;
    if (state->type != (rigid ? BodyType::dynamic : BodyType::kinematic)) return false;
    if (known == nullptr) {
        if (records.size() >= characters_max) return false;
        read.generation = 1;
        known = &records.emplace_back();
    } else {
        read.generation = known->generation;
    }
    if (rigid) static_cast<void>(world.set_locks(body, character_detail::upright));
    const bool other_shape = known->crouched != read.crouched;
    *known = read;
    if (other_shape) character_detail::update_shape(world, *known);
    return true;
}

Status Characters::configure(World& world, const ModuleSettings& settings) {
    SceneNumbers numbers;
    if (Status s = read(settings, numbers); !s.ok()) return s;
    for (const auto& [name, body] : settings.bodies) {
        if (is_controllable(body)) return unknown_character(name, "is already a character");
        Result<CharacterData> record = character_data_for(world, name, body, numbers);
        if (!record.ok()) return record.error();
        if (Status s = check_character_data(name, *record); !s.ok()) return s;
        if (store_->characters.size() == characters_max)
            return unknown_character(name, "exceeds the limit of 4096 characters");
        if (record->kind == CharacterKind::rigid) {
            if (Status s = world.set_locks(body, character_detail::upright); !s.ok()) return s;
        }
        record->alive = true;
        record->generation = 1;
        store_->characters.push_back(*record);
    }
    if (settings.bodies.empty())
        return Error{ErrorCode::invalid_argument,
                     "has no body; name at least one body that becomes a character"};
    return {};
}

bool Characters::is_controllable(BodyId body) const {
    return !is_null(body) && character_of(body) != CharacterId{};
}

void Characters::control(World&, BodyId body, const Controls& controls) {
    const SinCos turn = sin_cos(controls.axes[3] * pi);
    const Vec3 forward{-turn.sin, 0, -turn.cos}, right{turn.cos, 0, -turn.sin};
    Vec3 walk = forward * controls.axes[1] + right * controls.axes[0];
    const double size = length(walk);
    walk = walk * (controlled_walk_speed / maximum(size, 1));
    static_cast<void>(set_controls(character_of(body), {.walk = walk,
                                                        .jump = (controls.buttons & 1) != 0,
                                                        .crouch = (controls.buttons & 2) != 0}));
}

void Characters::publish(const World& world, ChannelWriter& channels) const {
    for (const CharacterId id : ids()) {
        const Result<CharacterState> state = this->state(world, id);
        if (!state.ok()) continue;
        if (!channels.begin(0, state->body)) continue;
        const unsigned bits = (state->kind == CharacterKind::rigid ? 1u : 0u) |
                              (state->crouched ? 2u : 0u) |
                              (static_cast<unsigned>(state->ground) << 2);
        channels.value(static_cast<std::int32_t>(bits));
        const Vec3 over = state->velocity - state->ground_velocity;
        channels.quantized(state->heading, -pi, pi, 8);
        channels.quantized(length(character_detail::horizontal(over)), 0, 20, 8);
        channels.quantized(state->velocity.y, -20, 20, 8);
    }
}

}  // namespace jostle::modules
