// SPDX-License-Identifier: MIT
#include "constraints/contact_passes.h"

#include <algorithm>

namespace jostle::physics {
namespace {

// So many blocks are taken at once. With fewer manifolds in all, colours are so short that waking
// another thread again and again costs more than it does.
constexpr int grain = 8, shared_manifolds = 2000;

// The blocks [begin, end) of a colour.
void run_part(BlockPass pass, ManifoldStore& store, int c, int begin, int end,
              std::span<HotBody> bodies, const ContactSettings& set) {
    if (begin >= end) return;
    Colour& colour = store.colours[static_cast<std::size_t>(c)];
    pass({colour.blocks.data(), colour.sides.data(), colour.bounces.data(), colour.roughs.data(),
          begin, end, second_of(c), is_single(c)},
         bodies.data(), set);
}

void run(BlockPass pass, ManifoldStore& store, std::span<HotBody> bodies,
         const ContactSettings& set, TaskTeam& team) {
    const auto count = [&](int c) {
        return static_cast<int>(store.colours[static_cast<std::size_t>(c)].blocks.size());
    };
    const bool shared = store.lanes >= shared_manifolds;
    for (const int c : solve_order) {
        if (is_single(c)) continue;  // with the other list of its colour: their bodies are distinct
        const int blocks = count(c);
        if (is_overflow(c)) {
            run_part(pass, store, c, 0, blocks, bodies, set);  // these share bodies: one by one
            continue;
        }
        const int single = single_colours + c;
        const int total = blocks + count(single);
        team.run(total, shared ? grain : total, [&](int begin, int end) {
            run_part(pass, store, c, begin, std::min(end, blocks), bodies, set);
            run_part(pass, store, single, std::max(begin - blocks, 0), end - blocks, bodies, set);
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
