// SPDX-License-Identifier: MIT
//
// Impacts on pieces that break: a piece cannot exert more force than its bonds bear, so the excess
// impulse is reversed on both bodies.
#include <algorithm>

#include "modules/destruction/src/bond_network.h"
#include "modules/destruction/src/destruction_data.h"
#include "modules/destruction/src/destruction_steps.h"
#include "modules/destruction/src/impulse_reversal.h"

namespace jostle::modules::destruction_detail {

using namespace physics;

namespace {

constexpr double passing_seconds = 0.2;  // s

bool precedes(const PreStepState& stored, BodyId id) {
    return stored.state.id < id;
}

// Stores the state before the first contact of this step.
void store_pre_step_state(DestructionState& state, const World& world, std::uint32_t destructible,
                          BodyId body) {
    const auto at = std::lower_bound(state.pre_step_states.begin(), state.pre_step_states.end(),
                                     body, precedes);
    if (at != state.pre_step_states.end() && at->state.id == body) return;
    const Result<BodyState> stored = world.body(body);
    if (stored.ok() && stored->mass > 0) state.pre_step_states.insert(at, {*stored, destructible});
}

void store_pre_step_state(DestructionState& state, const World& world, std::uint32_t destructible,
                          Piece& piece) {
    store_pre_step_state(state, world, destructible, piece.body);
    if (piece.chunks.size() < 2) return;
    if (const Result<std::vector<ContactInfo>> near = world.contacts_of(piece.body); near.ok())
        for (const ContactInfo& c : *near)
            store_pre_step_state(state, world, destructible,
                                 c.body_a == piece.body ? c.body_b : c.body_a);
    if (piece.anchored) return;
    const Result<BodyState> body = world.body(piece.body);
    if (!body.ok()) return;
    piece.linear = body->linear_velocity;
    piece.angular = body->angular_velocity;
}

const PreStepState* find_pre_step_state(const DestructionState& state, BodyId body) {
    const auto at = std::lower_bound(state.pre_step_states.begin(), state.pre_step_states.end(),
                                     body, precedes);
    return at != state.pre_step_states.end() && at->state.id == body ? &*at : nullptr;
}

const BodyState* pre_step_body(const DestructionState& state, BodyId body) {
    for (const BodyState& reversed : state.reversed_bodies)
        if (reversed.id == body) return &reversed;
    const PreStepState* stored = find_pre_step_state(state, body);
    return stored ? &stored->state : nullptr;
}

const Piece& piece_of(const DestructionState& state, const ChunkContact& chunk_contact) {
    const Destructible& destructible = state.destructibles[chunk_contact.destructible];
    return destructible.pieces[destructible.chunks[chunk_contact.chunk].piece];
}

// For two breaking bodies, the weaker one determines the load that both bear; both dissipate
// energy.
void merge_mutual_impacts(DestructionState& state) {
    for (std::size_t k = 0; k < state.chunk_contacts.size(); k++) {
        ChunkContact& chunk_contact = state.chunk_contacts[k];
        if (!chunk_contact.mutual || !chunk_contact.impact || !(chunk_contact.load_ratio > 1))
            continue;
        for (std::size_t i = 0; i < k; i++) {
            ChunkContact& other = state.chunk_contacts[i];
            if (other.own != chunk_contact.other || other.other != chunk_contact.own ||
                !(other.load_ratio > 1))
                continue;
            chunk_contact.load_ratio = other.load_ratio =
                maximum(chunk_contact.load_ratio, other.load_ratio);
            chunk_contact.dissipated_energy = other.dissipated_energy =
                chunk_contact.dissipated_energy + other.dissipated_energy;
            chunk_contact.is_duplicate = true;
        }
    }
}

// For a piece that also touches a static body, the sources of its velocity change are unknown. It
// retains the fraction of the change that its bonds bear; the ground takes the rest.
void limit_grounded_pieces(DestructionState& state, World& world,
                           std::span<ChunkContact> chunk_contacts, double dt) {
    double worst = 0;
    bool free = true;
    for (const ChunkContact& chunk_contact : chunk_contacts) {
        worst = maximum(worst, chunk_contact.load_ratio);
        const Result<BodyState> other = world.body(chunk_contact.other_body);
        free = free && other.ok() && other->type == BodyType::dynamic;
    }
    if (free || !(worst > 1)) return;
    for (ChunkContact& chunk_contact : chunk_contacts) chunk_contact.grounded = true;
    const Piece& piece = piece_of(state, chunk_contacts[0]);
    const Result<BodyState> body = world.body(piece.body);
    if (!body.ok() || body->type != BodyType::dynamic) return;
    const double share = 1 - 1 / worst;
    const Vec3 linear = (body->linear_velocity - piece.linear - world.gravity() * dt) * share;
    const Vec3 angular = (body->angular_velocity - piece.angular) * share;
    static_cast<void>(world
                          .set_velocity(piece.body, body->linear_velocity - linear,
                                        body->angular_velocity - angular)
                          .ok());
}

// Remaining approach speed after the dissipation of the bonds, E = (v0^2 - v^2) / (2 inv).
// Negative: the bodies separate.
double remaining_speed(const ChunkContact& chunk_contact) {
    const double undamped =
        chunk_contact.approach -
        (chunk_contact.approach + chunk_contact.separation_speed) / chunk_contact.load_ratio;
    if (!(undamped > 0)) return undamped;
    const double left2 =
        undamped * undamped - 2 * chunk_contact.dissipated_energy * chunk_contact.inverse_mass;
    return left2 > 0 ? square_root(left2) : 0;
}

// Approach speed to restore. A body that was deflected within the step hit with a speed that it did
// not have before. Limiting the speed along any normal to the initial one prevents an increase of
// energy.
double restored_speed(const DestructionState& state, const World& world,
                      const ChunkContact& chunk_contact) {
    const double speed = remaining_speed(chunk_contact);
    const BodyState* before = pre_step_body(state, chunk_contact.other_body);
    const Piece& piece = piece_of(state, chunk_contact);
    const Result<BodyState> own = world.body(piece.body);
    if (!before || !own.ok()) return speed;
    const Vec3 initial_velocity = velocity_at(*before, chunk_contact.point) - piece.linear -
                                  cross(piece.angular, chunk_contact.point - own->center);
    return minimum(speed, dot(initial_velocity, chunk_contact.normal));
}

// Adds a body in contact, with its velocity before the step. A body without a stored state uses its
// current velocity, so nothing is restored to it.
std::size_t add_reversal_body(const DestructionState& state, const World& world,
                              std::vector<ReversalBody>& bodies, BodyId id, const Piece* piece,
                              double dt) {
    std::size_t at = 0;
    while (at < bodies.size() && bodies[at].state.id != id) at++;
    if (at == bodies.size()) {
        const BodyState now = *world.body(id);
        const BodyState* before = pre_step_body(state, id);
        bodies.push_back({now, (before ? *before : now).linear_velocity,
                          (before ? *before : now).angular_velocity,
                          before ? world.gravity() * dt : Vec3{}});
    }
    if (piece) {
        bodies[at].linear = piece->linear;
        bodies[at].angular = piece->angular;
        bodies[at].gravity_velocity = world.gravity() * dt;
    }
    return at;
}

// Adds other bodies of a destructible, or near it, that gained energy in this step. That energy
// came from the striking body and must not be restored to it as well.
void add_nearby_bodies(const DestructionState& state, const World& world,
                       std::uint32_t destructible, double dt, std::vector<ReversalBody>& bodies,
                       std::vector<std::size_t>& added) {
    const std::size_t known = bodies.size();
    for (const PreStepState& stored : state.pre_step_states) {
        if (stored.destructible != destructible) continue;
        const auto same = [&](const ReversalBody& candidate) {
            return candidate.state.id == stored.state.id;
        };
        if (std::any_of(bodies.begin(), bodies.begin() + static_cast<std::ptrdiff_t>(known), same))
            continue;
        const Result<BodyState> now = world.body(stored.state.id);
        if (!now.ok() || !now->awake) continue;
        const ReversalBody candidate{*now, stored.state.linear_velocity,
                                     stored.state.angular_velocity, world.gravity() * dt};
        if (!(candidate.energy() > candidate.energy_before())) continue;
        added.push_back(bodies.size());
        bodies.push_back(candidate);
    }
}

// Pairs of bodies that share an energy budget: the bodies of a destructible, and of destructibles
// that touch each other.
BodyPairs shared_energy_pairs(const DestructionState& state, const World& world, double dt,
                              std::vector<ReversalBody>& bodies) {
    BodyPairs links;
    // Destructible, and one of its bodies
    std::vector<std::pair<std::uint32_t, std::size_t>> wholes;
    std::vector<std::size_t> added;
    const auto link = [&](std::size_t body, BodyId touched) {
        const PreStepState* stored = find_pre_step_state(state, touched);
        if (!stored) return;
        const auto known = std::find_if(wholes.begin(), wholes.end(), [&](const auto& entry) {
            return entry.first == stored->destructible;
        });
        if (known != wholes.end()) return void(links.emplace_back(known->second, body));
        wholes.emplace_back(stored->destructible, body);
        added.clear();
        add_nearby_bodies(state, world, stored->destructible, dt, bodies, added);
        for (const std::size_t k : added) links.emplace_back(body, k);
    };
    for (std::size_t k = 0; k < bodies.size(); k++) {
        const BodyId id = bodies[k].state.id;
        link(k, id);
        for (const ChunkContact& chunk_contact : state.chunk_contacts) {
            if (chunk_contact.other_body == id) link(k, piece_of(state, chunk_contact).body);
            if (piece_of(state, chunk_contact).body == id) link(k, chunk_contact.other_body);
        }
        const Result<std::vector<ContactInfo>> contacts = world.contacts_of(id);
        if (!contacts.ok()) continue;
        for (const ContactInfo& c : *contacts) link(k, c.body_a == id ? c.body_b : c.body_a);
    }
    return links;
}

// Solves all reversals at once, then applies each impulse to both bodies at its point.
void reverse_impacts(DestructionState& state, World& world, double dt) {
    std::vector<ReversalBody> bodies;
    std::vector<ImpulseReversal> all;
    for (const ChunkContact& chunk_contact : state.chunk_contacts) {
        if (!chunk_contact.impact || !(chunk_contact.load_ratio > 1)) continue;
        const Piece& piece = piece_of(state, chunk_contact);
        if (!world.contains(piece.body) || !world.contains(chunk_contact.other_body)) continue;
        const double speed = restored_speed(state, world, chunk_contact);
        if (speed > 0)
            state.reversed_contacts.push_back({chunk_contact.destructible, chunk_contact.chunk,
                                               chunk_contact.other, chunk_contact.other_body,
                                               chunk_contact.point, -chunk_contact.normal, speed});
        if (chunk_contact.is_duplicate) continue;
        const std::size_t own = add_reversal_body(state, world, bodies, piece.body, &piece, dt),
                          other = add_reversal_body(state, world, bodies, chunk_contact.other_body,
                                                    nullptr, dt);
        all.push_back({.point = chunk_contact.point,
                       .normal = chunk_contact.normal,
                       .piece = own,
                       .struck = other,
                       .speed = speed,
                       .inverse_mass_piece =
                           chunk_contact.grounded
                               ? 0
                               : inverse_effective_mass(bodies[own].state, chunk_contact.point,
                                                        chunk_contact.normal),
                       .inverse_mass_struck = inverse_effective_mass(
                           bodies[other].state, chunk_contact.point, chunk_contact.normal),
                       .dissipated_energy = chunk_contact.dissipated_energy});
    }
    if (all.empty()) return;
    const BodyPairs links = shared_energy_pairs(state, world, dt, bodies);
    reverse_impulses(bodies, all, links);
    for (const ImpulseReversal& one : all) {
        if (!(one.impulse > 0)) continue;
        const Vec3 push = one.normal * one.impulse;
        const BodyId struck = bodies[one.struck].state.id, piece = bodies[one.piece].state.id;
        static_cast<void>(world.apply_impulse(struck, push, one.point).ok());
        if (one.inverse_mass_piece > 0)
            static_cast<void>(world.apply_impulse(piece, -push, one.point).ok());
    }
}

}  // namespace

// Stores the states before the step of pieces and of the bodies that touch them, and updates chunks
// that pass through their destructible.
void store_pre_step_states(DestructionState& state, const World& world, double dt) {
    rebuild_derived_state(state);
    state.passing_bodies.clear();
    state.reversed_bodies.clear();
    state.pre_step_states.clear();
    for (const ReversedContact& again : state.reversed_contacts)
        if (const Result<BodyState> body = world.body(again.other_body); body.ok())
            state.reversed_bodies.push_back(*body);
    for (std::uint32_t w = 0; w < state.destructibles.size(); w++)
        for (Piece& piece : state.destructibles[w].pieces) {
            if (piece.passing_time > 0) {
                state.passing_bodies.emplace_back(piece.body, w);
                piece.passing_time = maximum(0, piece.passing_time - dt);
            }
            if (!state.bonded_shapes.empty()) store_pre_step_state(state, world, w, piece);
        }
}

void on_pre_solve(DestructionState& state, PreSolve& pair) {
    if (const BondedShape* at = find_bonded_shape(state, pair.shape_a))
        store_pre_step_state(state, pair.world, at->destructible, pair.body_b);
    if (const BondedShape* at = find_bonded_shape(state, pair.shape_b))
        store_pre_step_state(state, pair.world, at->destructible, pair.body_a);
    for (const auto& [body, destructible] : state.passing_bodies) {
        if (pair.body_a != body && pair.body_b != body) continue;
        const BodyId other = pair.body_a == body ? pair.body_b : pair.body_a;
        for (const Piece& piece : state.destructibles[destructible].pieces)
            if (piece.body == other) pair.enabled = false;
    }
}

// The fraction 1 - 1 / load_ratio of the impulse exceeded the strength of the bonds. It is reversed
// on both bodies at the contact point, which conserves momentum.
void reverse_excess_impulses(DestructionState& state, World& world, double dt) {
    state.reversed_contacts.clear();
    merge_mutual_impacts(state);
    for (std::size_t first = 0; first < state.chunk_contacts.size();) {
        std::size_t end = first + 1;
        while (end < state.chunk_contacts.size() &&
               &piece_of(state, state.chunk_contacts[end]) ==
                   &piece_of(state, state.chunk_contacts[first]))
            end++;
        limit_grounded_pieces(state, world,
                              std::span(state.chunk_contacts).subspan(first, end - first), dt);
        first = end;
    }
    reverse_impacts(state, world, dt);
}

// Starts the passing time of chunks that were struck and separated.
void start_passing(DestructionState& state) {
    for (const ReversedContact& again : state.reversed_contacts) {
        Destructible& destructible = state.destructibles[again.destructible];
        const std::uint32_t at = destructible.chunks[again.chunk].piece;
        if (at >= destructible.pieces.size()) continue;
        Piece& piece = destructible.pieces[at];
        if (!piece.anchored && piece.chunks.size() == 1) piece.passing_time = passing_seconds;
    }
}

}  // namespace jostle::modules::destruction_detail
