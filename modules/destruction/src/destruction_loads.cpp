// SPDX-License-Identifier: MIT
//
// Loads on chunks: contacts and impacts of the last step.
#include <algorithm>
#include <tuple>

#include "modules/destruction/src/bond_network.h"
#include "modules/destruction/src/destruction_data.h"
#include "modules/destruction/src/destruction_steps.h"

namespace jostle::modules::destruction_detail {

using namespace physics;

// Rebuilds derived state after a change: the piece of each chunk, the intact bonds of each piece,
// and the shapes with bonds.
void rebuild_derived_state(DestructionState& state) {
    if (state.derived) return;
    constexpr std::uint32_t no_piece = 0xffffffff;
    state.bonded_shapes.clear();
    for (std::uint32_t w = 0; w < state.destructibles.size(); w++) {
        Destructible& destructible = state.destructibles[w];
        for (Chunk& chunk : destructible.chunks) chunk.piece = no_piece;
        for (std::uint32_t p = 0; p < destructible.pieces.size(); p++) {
            Piece& piece = destructible.pieces[p];
            piece.bonds.clear();
            for (const std::uint32_t c : piece.chunks) {
                destructible.chunks[c].piece = p;
                if (piece.chunks.size() > 1)
                    state.bonded_shapes.push_back({destructible.chunks[c].shape, w, c});
            }
        }
        for (std::uint32_t k = 0; k < destructible.bonds.size(); k++) {
            const Bond& bond = destructible.bonds[k];
            const std::uint32_t piece = destructible.chunks[bond.face.a].piece;
            if (bond.broken || piece == no_piece || piece != destructible.chunks[bond.face.b].piece)
                continue;
            destructible.pieces[piece].bonds.push_back(k);
        }
    }
    std::sort(state.bonded_shapes.begin(), state.bonded_shapes.end(),
              [](const BondedShape& a, const BondedShape& b) {
                  return std::tuple(a.shape, a.destructible, a.chunk) <
                         std::tuple(b.shape, b.destructible, b.chunk);
              });
    state.derived = true;
}

void update_gravity(DestructionState& state, const World& world) {
    if (world.gravity() == state.gravity) return;
    state.gravity = world.gravity();
    for (Destructible& destructible : state.destructibles)
        for (Piece& piece : destructible.pieces)
            piece.solve_pending = piece.solve_pending || piece.anchored;
}

const BondedShape* find_bonded_shape(const DestructionState& state, ShapeId shape) {
    const auto found =
        std::lower_bound(state.bonded_shapes.begin(), state.bonded_shapes.end(), shape,
                         [](const BondedShape& entry, ShapeId id) { return entry.shape < id; });
    return found != state.bonded_shapes.end() && found->shape == shape ? &*found : nullptr;
}

namespace {

constexpr double impact_speed_min = 0.5;  // m/s

bool is_impact(const DestructionState& state, ShapeId a, ShapeId b) {
    return std::any_of(
        state.chunk_contacts.begin(), state.chunk_contacts.end(), [&](const ChunkContact& p) {
            return p.impact && ((p.own == a && p.other == b) || (p.own == b && p.other == a));
        });
}

// Computes the impulse from the approach and separation speeds, because the solver does not report
// impulses of impacts between its sub-steps.
void add_impact(DestructionState& state, const World& world, double dt, ShapeId a, ShapeId b,
                BodyId body_a, BodyId body_b, Vec3 point, Vec3 normal, double approach) {
    const BondedShape *at_a = find_bonded_shape(state, a), *at_b = find_bonded_shape(state, b);
    if ((!at_a && !at_b) || !(approach > 0)) return;
    const Result<BodyState> first = world.body(body_a), second = world.body(body_b);
    if (!first.ok() || !second.ok()) return;
    const double inv = inverse_effective_mass(*first, point, normal) +
                       inverse_effective_mass(*second, point, normal);
    const double separation_speed =
        dot(velocity_at(*second, point) - velocity_at(*first, point), normal);
    if (!(inv > 0) || !(approach + separation_speed > 0)) return;
    const double impulse = (approach + separation_speed) / inv;
    for (const BondedShape* at : {at_a, at_b}) {
        if (!at) continue;
        const Destructible& destructible = state.destructibles[at->destructible];
        const double time = minimum(dt, destructible.material.contact_time);
        const Vec3 against = at == at_a ? -normal : normal;
        ChunkContact chunk_contact{.destructible = at->destructible,
                                   .chunk = at->chunk,
                                   .own = at == at_a ? a : b,
                                   .other = at == at_a ? b : a,
                                   .other_body = at == at_a ? body_b : body_a,
                                   .point = point,
                                   .force = against * (impulse / time),
                                   .impact = true,
                                   .normal = against,
                                   .approach = approach,
                                   .separation_speed = separation_speed,
                                   .inverse_mass = inv,
                                   .energy = 0.5 * approach * approach / inv};
        chunk_contact.mutual = at_a && at_b;
        state.chunk_contacts.push_back(chunk_contact);
    }
}

// Approach speed before the step, m/s, if one body had its impulse reversed; otherwise 0.
double pre_step_approach_speed(const DestructionState& state, const ContactStay& stay) {
    for (const BodyState& mover : state.reversed_bodies)
        if (mover.id == stay.body_a || mover.id == stay.body_b)
            return dot(velocity_at(mover, stay.point), stay.normal) *
                   (mover.id == stay.body_a ? 1 : -1);
    return 0;
}

void add_stay(DestructionState& state, const World& world, const ContactStay& stay, double dt) {
    const BondedShape *at_a = find_bonded_shape(state, stay.shape_a),
                      *at_b = find_bonded_shape(state, stay.shape_b);
    if (!at_a && !at_b) return;
    if (is_impact(state, stay.shape_a, stay.shape_b)) return;
    if (const double approach = pre_step_approach_speed(state, stay); approach > impact_speed_min) {
        add_impact(state, world, dt, stay.shape_a, stay.shape_b, stay.body_a, stay.body_b,
                   stay.point, stay.normal, approach);
        return;
    }
    const Vec3 push = stay.normal * (stay.normal_impulse / dt);
    if (at_a)
        state.chunk_contacts.push_back({.destructible = at_a->destructible,
                                        .chunk = at_a->chunk,
                                        .own = stay.shape_a,
                                        .other = stay.shape_b,
                                        .other_body = stay.body_b,
                                        .point = stay.point,
                                        .force = -push});
    if (at_b)
        state.chunk_contacts.push_back({.destructible = at_b->destructible,
                                        .chunk = at_b->chunk,
                                        .own = stay.shape_b,
                                        .other = stay.shape_a,
                                        .other_body = stay.body_a,
                                        .point = stay.point,
                                        .force = push});
}

// Handles bodies with reversed impulses that were stopped again without an event, by continuous
// collision detection at static bodies. Their impact acts on the shapes that they touch.
void add_unreported_impacts(DestructionState& state, const World& world, double dt) {
    for (const BodyState& mover : state.reversed_bodies) {
        if (std::any_of(state.chunk_contacts.begin(), state.chunk_contacts.end(),
                        [&](const ChunkContact& chunk_contact) {
                            return chunk_contact.impact && chunk_contact.other_body == mover.id;
                        }))
            continue;
        const Result<std::vector<ContactInfo>> near = world.contacts_of(mover.id);
        if (!near.ok()) continue;
        for (const ContactInfo& c : *near) {
            const double sign = c.body_a == mover.id ? 1 : -1;
            const double approach = sign * dot(mover.linear_velocity, c.normal);
            if (c.count > 0 && approach > impact_speed_min)
                add_impact(state, world, dt, c.shape_a, c.shape_b, c.body_a, c.body_b, c.point[0],
                           c.normal, approach);
        }
    }
}

// An impact on several places of a piece at once is distributed equally.
void distribute_impacts(DestructionState& state) {
    std::vector<BodyId> others;
    for (const ChunkContact& chunk_contact : state.chunk_contacts)
        if (chunk_contact.impact) others.push_back(chunk_contact.other_body);
    std::sort(others.begin(), others.end());
    for (ChunkContact& chunk_contact : state.chunk_contacts) {
        if (!chunk_contact.impact) continue;
        const auto range = std::equal_range(others.begin(), others.end(), chunk_contact.other_body);
        const double share = 1 / static_cast<double>(range.second - range.first);
        chunk_contact.force = chunk_contact.force * share;
        chunk_contact.energy *= share;
    }
}

}  // namespace

// Sorted by destructible and piece, otherwise in the order of events.
void gather_contacts(DestructionState& state, const World& world, double dt) {
    state.chunk_contacts.clear();
    if (state.bonded_shapes.empty()) return;
    const Events events = world.events();
    for (const ContactBegin& e : events.contacts_began)
        add_impact(state, world, dt, e.shape_a, e.shape_b, e.body_a, e.body_b, e.point, e.normal,
                   e.approach_speed);
    for (const ContactHit& e : events.hits)
        if (!is_impact(state, e.shape_a, e.shape_b))
            add_impact(state, world, dt, e.shape_a, e.shape_b, e.body_a, e.body_b, e.point,
                       e.normal, e.approach_speed);
    for (const ReversedContact& e : state.reversed_contacts) {
        const Destructible& destructible = state.destructibles[e.destructible];
        const ShapeId own = destructible.chunks[e.chunk].shape;
        if (!find_bonded_shape(state, own) || is_impact(state, own, e.other)) continue;
        add_impact(state, world, dt, own, e.other,
                   destructible.pieces[destructible.chunks[e.chunk].piece].body, e.other_body,
                   e.point, e.normal, e.approach_speed);
    }
    for (const ContactStay& e : events.contacts) add_stay(state, world, e, dt);
    add_unreported_impacts(state, world, dt);
    distribute_impacts(state);
    const auto key = [&](const ChunkContact& p) {
        return std::pair(p.destructible, state.destructibles[p.destructible].chunks[p.chunk].piece);
    };
    std::stable_sort(state.chunk_contacts.begin(), state.chunk_contacts.end(),
                     [&](const ChunkContact& a, const ChunkContact& b) { return key(a) < key(b); });
}

}  // namespace jostle::modules::destruction_detail
