// SPDX-License-Identifier: MIT
//
// Impacts on pieces that break: a piece cannot exert more force than its bonds bear, so the excess
// impulse is reversed on both bodies.
#include <algorithm>

#include "jostle/modules/destruction.h"
#include "modules/destruction/src/bond_network.h"
#include "modules/destruction/src/contact_motion.h"
#include "modules/destruction/src/destruction_impact.h"
#include "modules/destruction/src/impulse_reversal.h"

namespace jostle::modules {

using namespace physics;
using namespace destruction_detail;

namespace {

constexpr double passing_seconds = 0.2;  // s

bool precedes(const PreStepState& stored, BodyId id) {
    return stored.state.id < id;
}

}  // namespace

// Stores the states before the step of pieces and of the bodies that touch them, and updates chunks
// that pass through their destructible.
void Destruction::before_step(World& world, double dt) {
    rebuild_derived_state();
    passing_bodies_.clear();
    reversed_bodies_.clear();
    pre_step_states_.clear();
    for (const ReversedContact& again : reversed_contacts_)
        if (const Result<BodyState> body = world.body(again.other_body); body.ok())
            reversed_bodies_.push_back(*body);
    for (std::uint32_t w = 0; w < destructibles_.size(); w++)
        for (Piece& piece : destructibles_[w].pieces) {
            if (piece.passing_time > 0) {
                passing_bodies_.emplace_back(piece.body, w);
                piece.passing_time = maximum(0, piece.passing_time - dt);
            }
            if (!bonded_shapes_.empty()) store_pre_step_state(world, w, piece);
        }
}

void Destruction::store_pre_step_state(const World& world, std::uint32_t destructible,
                                       Piece& piece) {
    store_pre_step_state(world, destructible, piece.body);
    if (piece.chunks.size() < 2) return;
    if (const Result<std::vector<ContactInfo>> near = world.contacts_of(piece.body); near.ok())
        for (const ContactInfo& c : *near)
            store_pre_step_state(world, destructible, c.body_a == piece.body ? c.body_b : c.body_a);
    if (piece.anchored) return;
    const Result<BodyState> body = world.body(piece.body);
    if (!body.ok()) return;
    piece.linear = body->linear_velocity;
    piece.angular = body->angular_velocity;
}

void Destruction::pre_solve(PreSolve& pair) {
    if (const BondedShape* at = find_bonded_shape(pair.shape_a))
        store_pre_step_state(pair.world, at->destructible, pair.body_b);
    if (const BondedShape* at = find_bonded_shape(pair.shape_b))
        store_pre_step_state(pair.world, at->destructible, pair.body_a);
    for (const auto& [body, destructible] : passing_bodies_) {
        if (pair.body_a != body && pair.body_b != body) continue;
        const BodyId other = pair.body_a == body ? pair.body_b : pair.body_a;
        for (const Piece& piece : destructibles_[destructible].pieces)
            if (piece.body == other) pair.enabled = false;
    }
}

// Stores the state before the first contact of this step.
void Destruction::store_pre_step_state(const World& world, std::uint32_t destructible,
                                       BodyId body) {
    const auto at =
        std::lower_bound(pre_step_states_.begin(), pre_step_states_.end(), body, precedes);
    if (at != pre_step_states_.end() && at->state.id == body) return;
    const Result<BodyState> state = world.body(body);
    if (state.ok() && state->mass > 0) pre_step_states_.insert(at, {*state, destructible});
}

const BodyState* Destruction::pre_step_body(BodyId body) const {
    for (const BodyState& state : reversed_bodies_)
        if (state.id == body) return &state;
    const PreStepState* stored = find_pre_step_state(body);
    return stored ? &stored->state : nullptr;
}

const PreStepState* Destruction::find_pre_step_state(BodyId body) const {
    const auto at =
        std::lower_bound(pre_step_states_.begin(), pre_step_states_.end(), body, precedes);
    return at != pre_step_states_.end() && at->state.id == body ? &*at : nullptr;
}

// Starts the passing time of chunks that were struck and separated.
void Destruction::start_passing() {
    for (const ReversedContact& again : reversed_contacts_) {
        Destructible& destructible = destructibles_[again.destructible];
        const std::uint32_t at = destructible.chunks[again.chunk].piece;
        if (at >= destructible.pieces.size()) continue;
        Piece& piece = destructible.pieces[at];
        if (!piece.anchored && piece.chunks.size() == 1) piece.passing_time = passing_seconds;
    }
}

// The fraction 1 - 1 / load_ratio of the impulse exceeded the strength of the bonds. It is reversed
// on both bodies at the contact point, which conserves momentum.
void Destruction::reverse_excess_impulses(World& world, double dt) {
    reversed_contacts_.clear();
    merge_mutual_impacts();
    for (std::size_t first = 0; first < chunk_contacts_.size();) {
        std::size_t end = first + 1;
        while (end < chunk_contacts_.size() &&
               &piece_of(chunk_contacts_[end]) == &piece_of(chunk_contacts_[first]))
            end++;
        limit_grounded_pieces(world, std::span(chunk_contacts_).subspan(first, end - first), dt);
        first = end;
    }
    reverse_impacts(world, dt);
}

// For two breaking bodies, the weaker one determines the load that both bear; both dissipate
// energy.
void Destruction::merge_mutual_impacts() {
    for (std::size_t k = 0; k < chunk_contacts_.size(); k++) {
        ChunkContact& chunk_contact = chunk_contacts_[k];
        if (!chunk_contact.mutual || !chunk_contact.impact || !(chunk_contact.load_ratio > 1))
            continue;
        for (std::size_t i = 0; i < k; i++) {
            ChunkContact& other = chunk_contacts_[i];
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

const Destruction::Piece& Destruction::piece_of(const ChunkContact& chunk_contact) const {
    const Destructible& destructible = destructibles_[chunk_contact.destructible];
    return destructible.pieces[destructible.chunks[chunk_contact.chunk].piece];
}

// For a piece that also touches a static body, the sources of its velocity change are unknown. It
// retains the fraction of the change that its bonds bear; the ground takes the rest.
void Destruction::limit_grounded_pieces(World& world, std::span<ChunkContact> chunk_contacts,
                                        double dt) {
    double worst = 0;
    bool free = true;
    for (const ChunkContact& chunk_contact : chunk_contacts) {
        worst = maximum(worst, chunk_contact.load_ratio);
        const Result<BodyState> other = world.body(chunk_contact.other_body);
        free = free && other.ok() && other->type == BodyType::dynamic;
    }
    if (free || !(worst > 1)) return;
    for (ChunkContact& chunk_contact : chunk_contacts) chunk_contact.grounded = true;
    const Piece& piece = piece_of(chunk_contacts[0]);
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
double Destruction::remaining_speed(const ChunkContact& chunk_contact) {
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
double Destruction::restored_speed(const World& world, const ChunkContact& chunk_contact) const {
    const double speed = remaining_speed(chunk_contact);
    const BodyState* before = pre_step_body(chunk_contact.other_body);
    const Piece& piece = piece_of(chunk_contact);
    const Result<BodyState> own = world.body(piece.body);
    if (!before || !own.ok()) return speed;
    const Vec3 initial_velocity = velocity_at(*before, chunk_contact.point) - piece.linear -
                                  cross(piece.angular, chunk_contact.point - own->center);
    return minimum(speed, dot(initial_velocity, chunk_contact.normal));
}

// Adds a body in contact, with its velocity before the step. A body without a stored state uses its
// current velocity, so nothing is restored to it.
std::size_t Destruction::add_reversal_body(const World& world, std::vector<ReversalBody>& bodies,
                                           BodyId id, const Piece* piece, double dt) const {
    std::size_t at = 0;
    while (at < bodies.size() && bodies[at].state.id != id) at++;
    if (at == bodies.size()) {
        const BodyState now = *world.body(id);
        const BodyState* before = pre_step_body(id);
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
void Destruction::add_nearby_bodies(const World& world, std::uint32_t destructible, double dt,
                                    std::vector<ReversalBody>& bodies,
                                    std::vector<std::size_t>& added) const {
    const std::size_t known = bodies.size();
    for (const PreStepState& stored : pre_step_states_) {
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
BodyPairs Destruction::shared_energy_pairs(const World& world, double dt,
                                           std::vector<ReversalBody>& bodies) const {
    BodyPairs links;
    // Destructible, and one of its bodies
    std::vector<std::pair<std::uint32_t, std::size_t>> wholes;
    std::vector<std::size_t> added;
    const auto link = [&](std::size_t body, BodyId touched) {
        const PreStepState* stored = find_pre_step_state(touched);
        if (!stored) return;
        const auto known = std::find_if(wholes.begin(), wholes.end(), [&](const auto& entry) {
            return entry.first == stored->destructible;
        });
        if (known != wholes.end()) return void(links.emplace_back(known->second, body));
        wholes.emplace_back(stored->destructible, body);
        added.clear();
        add_nearby_bodies(world, stored->destructible, dt, bodies, added);
        for (const std::size_t k : added) links.emplace_back(body, k);
    };
    for (std::size_t k = 0; k < bodies.size(); k++) {
        const BodyId id = bodies[k].state.id;
        link(k, id);
        for (const ChunkContact& chunk_contact : chunk_contacts_) {
            if (chunk_contact.other_body == id) link(k, piece_of(chunk_contact).body);
            if (piece_of(chunk_contact).body == id) link(k, chunk_contact.other_body);
        }
        const Result<std::vector<ContactInfo>> contacts = world.contacts_of(id);
        if (!contacts.ok()) continue;
        for (const ContactInfo& c : *contacts) link(k, c.body_a == id ? c.body_b : c.body_a);
    }
    return links;
}

// Solves all reversals at once, then applies each impulse to both bodies at its point.
void Destruction::reverse_impacts(World& world, double dt) {
    std::vector<ReversalBody> bodies;
    std::vector<ImpulseReversal> all;
    for (const ChunkContact& chunk_contact : chunk_contacts_) {
        if (!chunk_contact.impact || !(chunk_contact.load_ratio > 1)) continue;
        const Piece& piece = piece_of(chunk_contact);
        if (!world.contains(piece.body) || !world.contains(chunk_contact.other_body)) continue;
        const double speed = restored_speed(world, chunk_contact);
        if (speed > 0)
            reversed_contacts_.push_back({chunk_contact.destructible, chunk_contact.chunk,
                                          chunk_contact.other, chunk_contact.other_body,
                                          chunk_contact.point, -chunk_contact.normal, speed});
        if (chunk_contact.is_duplicate) continue;
        const std::size_t own = add_reversal_body(world, bodies, piece.body, &piece, dt),
                          other = add_reversal_body(world, bodies, chunk_contact.other_body,
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
    const BodyPairs links = shared_energy_pairs(world, dt, bodies);
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

}  // namespace jostle::modules
