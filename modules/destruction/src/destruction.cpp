// SPDX-License-Identifier: MIT
#include "jostle/modules/destruction.h"

#include <algorithm>
#include <string>

#include "modules/destruction/src/destruction_checks.h"
#include "modules/destruction/src/destruction_data.h"
#include "modules/destruction/src/destruction_steps.h"

namespace jostle::modules {

using namespace physics;
using namespace destruction_detail;

namespace {

const Destructible* find(const DestructionState& state, DestructibleId id) {
    if (id.index >= state.destructibles.size()) return nullptr;
    const Destructible& destructible = state.destructibles[id.index];
    return destructible.alive && destructible.generation == id.generation ? &destructible : nullptr;
}

Destructible* find(DestructionState& state, DestructibleId id) {
    return const_cast<Destructible*>(find(std::as_const(state), id));
}

Error unknown(DestructibleId id) {
    return {ErrorCode::not_found, "destructible " + std::to_string(id.index) + " of generation " +
                                      std::to_string(id.generation) + " does not exist"};
}

std::size_t break_bonds_near(DestructionState& state, const World& world,
                             Destructible& destructible, Vec3 center, double radius) {
    rebuild_derived_state(state);
    std::size_t count = 0;
    for (Piece& piece : destructible.pieces) {
        const Result<BodyState> body = world.body(piece.body);
        if (!body.ok()) continue;
        const Vec3 local_center = apply_inverse(body->pose, center) + piece.origin;
        for (const std::uint32_t k : piece.bonds) {
            Bond& bond = destructible.bonds[k];
            if (length_squared(bond.face.center - local_center) > radius * radius) continue;
            bond.broken = true;
            piece.split_pending = true;
            count++;
        }
    }
    state.derived = state.derived && count == 0;
    return count;
}

}  // namespace

Destruction::Destruction() : state_(std::make_unique<DestructionState>()) {}
Destruction::~Destruction() = default;

const DestructionLimits& Destruction::limits() const {
    return state_->limits;
}

bool Destruction::contains(DestructibleId id) const {
    return find(*state_, id) != nullptr;
}

std::size_t Destruction::size() const {
    return static_cast<std::size_t>(std::count_if(state_->destructibles.begin(),
                                                  state_->destructibles.end(),
                                                  [](const Destructible& w) { return w.alive; }));
}

Status Destruction::set_limits(const DestructionLimits& limits) {
    if (Status s = check_limits(limits); !s.ok()) return s;
    state_->limits = limits;
    return {};
}

Result<DestructibleId> Destruction::add(World& world, const FracturedShape& shape,
                                        const DestructibleDef& def) {
    if (Status s = check_shape(shape); !s.ok()) return s.error();
    if (Status s = check_def(def); !s.ok()) return s.error();
    std::size_t at = 0;
    while (at < state_->destructibles.size() && state_->destructibles[at].alive) at++;
    if (at >= destructibles_max)
        return Error{ErrorCode::resource_exhausted, "the world already has the maximum of " +
                                                        std::to_string(destructibles_max) +
                                                        " destructibles; remove one first"};
    const bool anchored = std::any_of(shape.chunks.begin(), shape.chunks.end(),
                                      [](const FractureChunk& c) { return c.anchored; });
    const BodyDef body_def{.type = anchored ? BodyType::static_body : BodyType::dynamic,
                           .pose = def.pose,
                           .linear_velocity = anchored ? Vec3{} : def.linear_velocity,
                           .angular_velocity = anchored ? Vec3{} : def.angular_velocity};
    std::vector<ShapeDef> shapes;
    for (const FractureChunk& chunk : shape.chunks)
        shapes.push_back({.geometry = chunk.geometry,
                          .pose = chunk.pose,
                          .material = def.surface,
                          .density = def.density,
                          .filter = def.filter,
                          .report_stays = shape.chunks.size() > 1});
    const Result<BodyId> made_body = world.create_body(body_def, shapes);
    if (!made_body.ok()) return made_body.error();
    const BodyId body = *made_body;
    if (!anchored)  // creating shapes moved the centre of mass
        static_cast<void>(world.set_velocity(body, def.linear_velocity, def.angular_velocity).ok());
    if (at == state_->destructibles.size()) state_->destructibles.emplace_back();
    const std::uint32_t generation = state_->destructibles[at].generation + 1;
    Destructible& destructible = state_->destructibles[at] = {};
    destructible.alive = true;
    destructible.generation = generation;
    destructible.material = def.bonds;
    destructible.density = def.density;
    const std::vector<ShapeId> made = world.shapes_of(body);
    Piece piece{.body = body, .anchored = anchored};
    for (std::uint32_t k = 0; k < shape.chunks.size(); k++) {
        const FractureChunk& chunk = shape.chunks[k];
        destructible.chunks.push_back({.center = chunk.center,
                                       .mass = chunk.volume * def.density,
                                       .inertia = chunk.unit_inertia * def.density,
                                       .shape = made[k],
                                       .anchored = chunk.anchored});
        piece.chunks.push_back(k);
    }
    for (const FractureBond& bond : shape.bonds) destructible.bonds.push_back({bond, false});
    // Chunks without bonds separate in the first step.
    piece.split_pending = true;
    destructible.pieces.push_back(std::move(piece));
    state_->derived = false;
    return DestructibleId{static_cast<std::uint32_t>(at), generation};
}

Status Destruction::remove(World& world, DestructibleId id) {
    Destructible* destructible = find(*state_, id);
    if (!destructible) return unknown(id);
    for (const Piece& piece : destructible->pieces)
        if (world.contains(piece.body)) static_cast<void>(world.destroy_body(piece.body).ok());
    *destructible = {.generation = destructible->generation};
    std::erase_if(state_->reversed_contacts,
                  [&](const ReversedContact& again) { return again.destructible == id.index; });
    state_->derived = false;
    return {};
}

Result<std::size_t> Destruction::break_near(const World& world, DestructibleId id, Vec3 center,
                                            double radius) {
    Destructible* destructible = find(*state_, id);
    if (!destructible) return unknown(id);
    if (!is_finite(center) || !(radius >= 0 && radius <= 1e7))
        return Error{
            ErrorCode::invalid_argument,
            "center or radius is out of range; center must be finite, radius from 0 to 1e7 m"};
    return break_bonds_near(*state_, world, *destructible, center, radius);
}

std::size_t Destruction::break_near(const World& world, Vec3 center, double radius) {
    std::size_t count = 0;
    for (Destructible& destructible : state_->destructibles)
        if (destructible.alive)
            count += break_bonds_near(*state_, world, destructible, center, radius);
    return count;
}

Result<std::vector<BodyId>> Destruction::bodies(DestructibleId id) const {
    const Destructible* destructible = find(*state_, id);
    if (!destructible) return unknown(id);
    std::vector<BodyId> bodies;
    for (const Piece& piece : destructible->pieces) bodies.push_back(piece.body);
    return bodies;
}

Result<std::size_t> Destruction::intact_bonds(DestructibleId id) const {
    const Destructible* destructible = find(*state_, id);
    if (!destructible) return unknown(id);
    return static_cast<std::size_t>(std::count_if(destructible->bonds.begin(),
                                                  destructible->bonds.end(),
                                                  [](const Bond& b) { return !b.broken; }));
}

Result<double> Destruction::max_load_ratio(const World& world, DestructibleId id) const {
    const Destructible* destructible = find(*state_, id);
    if (!destructible) return unknown(id);
    return destruction_detail::max_load_ratio(world, *destructible);
}

void Destruction::before_step(World& world, double dt) {
    store_pre_step_states(*state_, world, dt);
}

void Destruction::pre_solve(PreSolve& pair) {
    on_pre_solve(*state_, pair);
}

void Destruction::after_step(World& world, double dt) {
    DestructionState& state = *state_;
    drop_lost_bodies(state, world);
    rebuild_derived_state(state);
    update_gravity(state, world);
    gather_contacts(state, world, dt);
    break_all_bonds(state, world);
    reverse_excess_impulses(state, world, dt);
    split_all_pieces(state, world);
    rebuild_derived_state(state);
    start_passing(state);
    drop_debris(state, world, dt);
}

}  // namespace jostle::modules
