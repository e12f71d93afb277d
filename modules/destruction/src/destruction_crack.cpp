// SPDX-License-Identifier: MIT
//
// Breaking of bonds: evaluates the loads of bonds, breaks overloaded ones, worst first, and
// evaluates the remaining groups again.
#include <algorithm>
#include <limits>

#include "modules/destruction/src/bond_network.h"
#include "modules/destruction/src/destruction_data.h"
#include "modules/destruction/src/destruction_steps.h"

namespace jostle::modules::destruction_detail {

using namespace physics;

namespace {

// Relative to the worst load: bonds above this fraction break in the same round.
constexpr double same_round_load_ratio = 0.5;
// Relative to the loads, and to the weight: bonds are evaluated again after larger changes.
constexpr double load_change_share = 0.05, load_change_weight_share = 0.05;
constexpr double standard_gravity = 9.81;
constexpr double load_max = 1e29;         // N, J, m: upper limit of valid loads
constexpr double beam_length_min = 1e-6;  // m
constexpr std::uint32_t no_piece = 0xffffffff;

struct Unknowns {
    std::vector<std::uint32_t> of_chunk;  // by chunk of the destructible
    std::uint32_t count = 0;
};

enum class SolveResult : std::uint8_t { held, broke, no_time };

}  // namespace

// Groups connected by intact bonds, in order of their lowest chunk.
std::vector<Group> connected_groups(const Destructible& destructible, const Group& group) {
    std::vector<std::uint32_t> part(destructible.chunks.size(), no_piece);
    std::vector<std::vector<std::uint32_t>> near(destructible.chunks.size());
    for (const std::uint32_t k : group.bonds) {
        if (destructible.bonds[k].broken) continue;
        const FractureBond& face = destructible.bonds[k].face;
        near[face.a].push_back(face.b);
        near[face.b].push_back(face.a);
    }
    std::vector<Group> parts;
    std::vector<std::uint32_t> open;
    for (const std::uint32_t first : group.chunks) {
        if (part[first] != no_piece) continue;
        const auto number = static_cast<std::uint32_t>(parts.size());
        parts.emplace_back();
        part[first] = number;
        open.assign(1, first);
        while (!open.empty()) {
            const std::uint32_t chunk = open.back();
            open.pop_back();
            for (const std::uint32_t next : near[chunk]) {
                if (part[next] != no_piece) continue;
                part[next] = number;
                open.push_back(next);
            }
        }
    }
    for (const std::uint32_t chunk : group.chunks) parts[part[chunk]].chunks.push_back(chunk);
    for (const std::uint32_t k : group.bonds)
        if (!destructible.bonds[k].broken)
            parts[part[destructible.bonds[k].face.a]].bonds.push_back(k);
    return parts;
}

namespace {

// Anchored chunks have no unknowns. In a group without anchors, the first chunk is held: the loads
// are balanced, so its support transmits no force.
Unknowns unknowns_of(const std::vector<Chunk>& chunks, const Group& group) {
    Unknowns unknowns{std::vector<std::uint32_t>(chunks.size(), fixed_unknown), 0};
    const bool held = std::any_of(group.chunks.begin(), group.chunks.end(),
                                  [&](std::uint32_t c) { return chunks[c].anchored; });
    for (const std::uint32_t c : group.chunks)
        if (!chunks[c].anchored && (held || c != group.chunks.front()))
            unknowns.of_chunk[c] = unknowns.count++;
    return unknowns;
}

std::vector<Beam> beams_of(const Destructible& destructible, const Group& group,
                           const Unknowns& unknowns) {
    std::vector<Beam> beams;
    for (const std::uint32_t k : group.bonds) {
        const FractureBond& face = destructible.bonds[k].face;
        const Vec3 a = destructible.chunks[face.a].center, b = destructible.chunks[face.b].center;
        beams.push_back({.face = &face,
                         .a = unknowns.of_chunk[face.a],
                         .b = unknowns.of_chunk[face.b],
                         .arm_a = face.center - a,
                         .arm_b = face.center - b,
                         .length = maximum(dot(b - a, face.normal), beam_length_min)});
    }
    return beams;
}

// In a free group, inertia balances the loads (d'Alembert): each chunk adds minus its mass times
// the acceleration of the group at that point. Gravity acts uniformly and cancels.
void add_inertia(const Destructible& destructible, const Group& group, Vec3 spin,
                 std::vector<ChunkLoad>& chunk_loads) {
    double mass = 0;
    Vec3 center, force, torque;
    for (const std::uint32_t c : group.chunks) {
        mass += destructible.chunks[c].mass;
        center += destructible.chunks[c].center * destructible.chunks[c].mass;
    }
    center = center / mass;
    Mat3 inertia = diagonal({0, 0, 0});
    for (const std::uint32_t c : group.chunks) {
        const auto& chunk = destructible.chunks[c];
        const Vec3 r = chunk.center - center;
        const double r2 = length_squared(r) * chunk.mass;
        inertia = inertia + chunk.inertia + diagonal({r2, r2, r2}) -
                  Mat3{r * (r.x * chunk.mass), r * (r.y * chunk.mass), r * (r.z * chunk.mass)};
        force += chunk_loads[c].force;
        torque += chunk_loads[c].torque + cross(r, chunk_loads[c].force);
    }
    const Vec3 linear = force / mass;
    const Vec3 angular = inverse(inertia) * (torque - cross(spin, inertia * spin));
    for (const std::uint32_t c : group.chunks) {
        const auto& chunk = destructible.chunks[c];
        const Vec3 r = chunk.center - center;
        chunk_loads[c].force +=
            (linear + cross(angular, r) + cross(spin, cross(spin, r))) * -chunk.mass;
        chunk_loads[c].torque += -(chunk.inertia * angular + cross(spin, chunk.inertia * spin));
    }
}

// Load of each bond of the group as a fraction of its strength.
std::vector<double> loads_of(const Destructible& destructible, const Group& group,
                             const StiffnessFactor& factor,
                             std::span<const ChunkLoad> contact_loads, Vec3 spin, Vec3 gravity) {
    const Unknowns unknowns = unknowns_of(destructible.chunks, group);
    std::vector<ChunkLoad> chunk_loads(contact_loads.begin(), contact_loads.end());
    const bool held = std::any_of(group.chunks.begin(), group.chunks.end(),
                                  [&](std::uint32_t c) { return destructible.chunks[c].anchored; });
    if (held)
        for (const std::uint32_t c : group.chunks)
            chunk_loads[c].force += gravity * destructible.chunks[c].mass;
    else
        add_inertia(destructible, group, spin, chunk_loads);
    std::vector<Vec6> moved(unknowns.count);
    for (const std::uint32_t c : group.chunks)
        if (const std::uint32_t at = unknowns.of_chunk[c]; at != fixed_unknown)
            moved[at] = {chunk_loads[c].force.x,  chunk_loads[c].force.y,  chunk_loads[c].force.z,
                         chunk_loads[c].torque.x, chunk_loads[c].torque.y, chunk_loads[c].torque.z};
    factor.solve(moved);
    constexpr Vec6 still = {};
    std::vector<double> loads;
    for (const Beam& beam : beams_of(destructible, group, unknowns))
        loads.push_back(load_of(beam, beam.a == fixed_unknown ? still : moved[beam.a],
                                beam.b == fixed_unknown ? still : moved[beam.b],
                                destructible.material));
    return loads;
}

// Evaluates a group and breaks the worst bonds. `cached` is the piece whose factor belongs to the
// group.
SolveResult solve_group(DestructionState& state, Destructible& destructible, const Group& group,
                        Piece* cached, std::span<const ChunkLoad> chunk_loads, Vec3 spin,
                        Vec3 gravity, double& energy) {
    std::shared_ptr<const StiffnessFactor> factor = cached ? cached->factor : nullptr;
    const bool dissipated_energy = cached && cached->solved;
    if (!dissipated_energy && state.work_left <= 0) return SolveResult::no_time;
    if (!factor) {
        const Unknowns unknowns = unknowns_of(destructible.chunks, group);
        factor = std::make_shared<StiffnessFactor>(beams_of(destructible, group, unknowns),
                                                   unknowns.count, destructible.material);
        if (cached) cached->factor = factor;
    }
    if (cached) cached->solved = true;
    if (!dissipated_energy) state.work_left -= static_cast<std::int64_t>(factor->work());
    const std::vector<double> loads =
        loads_of(destructible, group, *factor, chunk_loads, spin, gravity);
    const double worst = loads.empty() ? 0 : *std::max_element(loads.begin(), loads.end());
    if (cached) state.max_load_ratio = worst;
    const double limit = maximum(1, same_round_load_ratio * worst);
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < loads.size(); k++)
        if (loads[k] > 1 && loads[k] >= limit) order.push_back(k);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return loads[a] > loads[b]; });
    bool broke = false;
    for (const std::size_t k : order) {
        Bond& bond = destructible.bonds[group.bonds[k]];
        const double cost = destructible.material.fracture_energy * bond.face.area;
        if (cost > energy) break;
        energy -= cost;
        bond.broken = true;
        broke = true;
    }
    return broke ? SolveResult::broke : SolveResult::held;
}

// Repeats in rounds: groups that separated in one round are evaluated one by one in the next.
// Returns false if there was no work budget to begin.
bool break_bonds(DestructionState& state, Destructible& destructible, Piece& piece,
                 std::span<const ChunkLoad> chunk_loads, Vec3 spin, Vec3 gravity, double& energy) {
    std::vector<Group> groups = {{piece.chunks, piece.bonds}};
    for (int round = 0; round < state.limits.rounds && !groups.empty(); round++) {
        std::vector<Group> next;
        for (const Group& group : groups) {
            if (group.bonds.empty()) continue;
            const SolveResult result =
                solve_group(state, destructible, group, round == 0 ? &piece : nullptr, chunk_loads,
                            spin, gravity, energy);
            if (result == SolveResult::no_time) return round > 0;
            if (result == SolveResult::held) continue;
            piece.split_pending = true;
            for (Group& part : connected_groups(destructible, group))
                next.push_back(std::move(part));
        }
        groups = std::move(next);
    }
    return true;
}

// Evaluates the bonds if the loads changed enough.
void break_bonds_if_loaded(DestructionState& state, const World& world, std::uint32_t w,
                           std::uint32_t p, std::span<ChunkContact> chunk_contacts) {
    Destructible& destructible = state.destructibles[w];
    Piece& piece = destructible.pieces[p];
    if (piece.split_pending) return;
    const Result<BodyState> body = world.body(piece.body);
    if (!body.ok() || (!body->awake && !piece.anchored && !piece.solve_pending)) return;
    const Quat back = conjugate(body->pose.rotation);
    const Vec3 spin = piece.anchored ? Vec3{} : rotate(back, body->angular_velocity);
    const double spin2 = length_squared(spin);
    if (state.chunk_loads.size() < destructible.chunks.size())
        state.chunk_loads.resize(destructible.chunks.size());
    const std::span<ChunkLoad> chunk_loads(state.chunk_loads.data(), destructible.chunks.size());
    for (const std::uint32_t c : piece.chunks) chunk_loads[c] = {};
    double energy = 0, mass = 0, change = 0, previous = 0, sum = spin2;
    for (const ChunkContact& chunk_contact : chunk_contacts) {
        const Vec3 force = rotate(back, chunk_contact.force);
        const Vec3 at = apply_inverse(body->pose, chunk_contact.point) + piece.origin;
        chunk_loads[chunk_contact.chunk].force += force;
        chunk_loads[chunk_contact.chunk].torque +=
            cross(at - destructible.chunks[chunk_contact.chunk].center, force);
        energy += chunk_contact.energy;
        sum += length(chunk_contact.force) + length(chunk_contact.point) + chunk_contact.energy;
    }
    // A diverging body is quarantined after this step; its loads are meaningless.
    if (!(sum < load_max)) return;
    for (const std::uint32_t c : piece.chunks) {
        const Chunk& chunk = destructible.chunks[c];
        mass += chunk.mass;
        change += length(chunk_loads[c].force - chunk.force);
        previous += length(chunk.force);
        if (piece.loads_pending) chunk_loads[c] = {chunk.force, chunk.torque};
    }
    const double size = length(destructible.chunks[piece.chunks.back()].center -
                               destructible.chunks[piece.chunks.front()].center);
    change += absolute(spin2 - piece.spin2) * mass * size;
    previous += piece.spin2 * mass * size;
    const bool noticeable =
        change > load_change_share * previous + load_change_weight_share * standard_gravity * mass;
    if (!piece.solve_pending && !piece.loads_pending && !noticeable) return;
    if (piece.loads_pending) energy = piece.energy;
    const bool hit = energy > 0;
    double left = hit ? energy : std::numeric_limits<double>::max();
    const bool evaluated = break_bonds(state, destructible, piece, chunk_loads, spin,
                                       rotate(back, world.gravity()), left);
    for (ChunkContact& chunk_contact : chunk_contacts)
        if (hit && evaluated && chunk_contact.impact && !piece.loads_pending) {
            chunk_contact.dissipated_energy = (energy - left) * (chunk_contact.energy / energy);
            chunk_contact.load_ratio = piece.split_pending ? state.max_load_ratio : 0;
        }
    for (const std::uint32_t c : piece.chunks) {
        destructible.chunks[c].force = chunk_loads[c].force;
        destructible.chunks[c].torque = chunk_loads[c].torque;
    }
    piece.loaded = !chunk_contacts.empty();
    piece.loads_pending = !evaluated;
    piece.energy = evaluated ? 0 : energy;
    piece.solve_pending = piece.solve_pending && !evaluated;
    piece.spin2 = spin2;
}

}  // namespace

void break_all_bonds(DestructionState& state, const World& world) {
    state.work_left = state.limits.work_per_step;
    std::size_t next = 0;
    for (std::uint32_t w = 0; w < state.destructibles.size(); w++)
        for (std::uint32_t p = 0; p < state.destructibles[w].pieces.size(); p++) {
            const std::size_t first = next;
            while (next < state.chunk_contacts.size() &&
                   state.chunk_contacts[next].destructible == w &&
                   state.destructibles[w].chunks[state.chunk_contacts[next].chunk].piece == p)
                next++;
            const Piece& piece = state.destructibles[w].pieces[p];
            if (piece.chunks.size() < 2) continue;
            if (next == first && !piece.loaded && !piece.solve_pending && !piece.loads_pending &&
                piece.anchored)
                continue;
            break_bonds_if_loaded(state, world, w, p,
                                  std::span(state.chunk_contacts).subspan(first, next - first));
        }
}

double max_load_ratio(const World& world, const Destructible& destructible) {
    double worst = 0;
    for (const Piece& piece : destructible.pieces) {
        const Result<BodyState> body = world.body(piece.body);
        if (!body.ok() || !piece.anchored) continue;
        Group all{piece.chunks, {}};
        std::vector<bool> in_piece(destructible.chunks.size());
        for (const std::uint32_t c : piece.chunks) in_piece[c] = true;
        for (std::uint32_t k = 0; k < destructible.bonds.size(); k++)
            if (in_piece[destructible.bonds[k].face.a] && in_piece[destructible.bonds[k].face.b])
                all.bonds.push_back(k);
        const Vec3 gravity = inverse_rotate(body->pose.rotation, world.gravity());
        for (const Group& group : connected_groups(destructible, all)) {
            const Unknowns unknowns = unknowns_of(destructible.chunks, group);
            const StiffnessFactor factor(beams_of(destructible, group, unknowns), unknowns.count,
                                         destructible.material);
            for (const double load :
                 loads_of(destructible, group, factor,
                          std::vector<ChunkLoad>(destructible.chunks.size()), {}, gravity))
                worst = maximum(worst, load);
        }
    }
    return worst;
}

}  // namespace jostle::modules::destruction_detail
