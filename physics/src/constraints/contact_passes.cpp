// SPDX-License-Identifier: MIT
#include "constraints/contact_passes.h"

namespace jostle::physics {
namespace {

// Blocks below four times this many stay on the calling thread.
constexpr int grain = 16;

void run(BlockPass pass, ManifoldStore& store, std::span<HotBody> bodies,
         const ContactSettings& set, TaskTeam& team) {
    for (const int c : solve_order) {
        Colour& colour = store.colours[static_cast<std::size_t>(c)];
        if (colour.blocks.empty()) continue;
        const auto blocks = static_cast<int>(colour.blocks.size());
        BlockRange all{colour.blocks.data(),
                       colour.sides.data(),
                       colour.bounces.data(),
                       colour.roughs.data(),
                       0,
                       blocks,
                       second_of(c),
                       is_single(c)};
        if (is_overflow(c)) {
            pass(all, bodies.data(), set);  // these share bodies: one after the other
            continue;
        }
        team.run(blocks, grain, [&](int begin, int end) {
            BlockRange part = all;
            part.begin = begin;
            part.end = end;
            pass(part, bodies.data(), set);
        });
    }
}

bool any_bouncy(const ManifoldStore& store) {
    for (const Colour& colour : store.colours)
        for (const BlockSide& side : colour.sides)
            if (side.bouncy != 0) return true;
    return false;
}

}  // namespace

void warm_start(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set,
                TaskTeam& team) {
    run(kernels().warm_start, store, bodies, set, team);
}

void solve(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set,
           TaskTeam& team) {
    run(kernels().solve, store, bodies, set, team);
}

void relax(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set, bool last,
           TaskTeam& team) {
    run(last ? kernels().relax_last : kernels().relax, store, bodies, set, team);
}

bool begin_bounces(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set,
                   TaskTeam& team) {
    if (!any_bouncy(store)) return false;
    run(kernels().begin_bounce, store, bodies, set, team);
    return true;
}

void foresee_bounces(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set,
                     TaskTeam& team) {
    run(kernels().foresee_bounce, store, bodies, set, team);
}

void note_bounce_peaks(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set,
                       TaskTeam& team) {
    run(kernels().note_peaks, store, bodies, set, team);
}

void end_bounces(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set,
                 TaskTeam& team) {
    run(kernels().end_bounce, store, bodies, set, team);
}

}  // namespace jostle::physics
