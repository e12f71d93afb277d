// SPDX-License-Identifier: MIT
#include "constraints/contact_passes.h"

#include "constraints/contact_kernel.h"
#include "constraints/planar_kernel.h"
#include "jostle/physics/tuning.h"

namespace jostle::physics {
namespace {

// Blocks below four times this many stay on the calling thread.
constexpr int grain = 16;

// Calls pass(colour, block, second, turning) for every block, the latter two as compile-time
// constants.
template <class Pass>
void for_each_block(ManifoldStore& store, TaskTeam& team, Pass&& pass) {
    const auto with_inertia = [&](Colour& colour, int begin, int end, auto second) {
        for (int k = begin; k < end; k++) {
            const auto block = static_cast<std::size_t>(k);
            const BlockSide& side = colour.sides[block];
            if (side.locked != 0)
                pass(colour, block, second, std::integral_constant<Inertia, Inertia::locked>{});
            else if (side.turning != 0)
                pass(colour, block, second, std::integral_constant<Inertia, Inertia::full>{});
            else
                pass(colour, block, second, std::integral_constant<Inertia, Inertia::isotropic>{});
        }
    };
    for (const int c : solve_order) {
        Colour& colour = store.colours[static_cast<std::size_t>(c)];
        if (colour.blocks.empty()) continue;
        const auto blocks = static_cast<int>(colour.blocks.size());
        const auto run = [&](auto second) {
            if (is_overflow(c))
                with_inertia(colour, 0, blocks, second);  // these share bodies: one after the other
            else
                team.run(blocks, grain,
                         [&](int begin, int end) { with_inertia(colour, begin, end, second); });
        };
        switch (second_of(c)) {
            case Second::moving:
                run(std::integral_constant<Second, Second::moving>{});
                break;
            case Second::driven:
                run(std::integral_constant<Second, Second::driven>{});
                break;
            case Second::fixed:
                run(std::integral_constant<Second, Second::fixed>{});
                break;
        }
    }
}

BlockRough* rough_of(Colour& colour, std::size_t block) {
    return colour.sides[block].rough != 0 ? &colour.roughs[block] : nullptr;
}

template <bool kRelax, bool kLast>
void solve_all(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set,
               TaskTeam& team) {
    for_each_block(store, team, [&](Colour& colour, std::size_t k, auto second, auto inertia) {
        BlockSide& side = colour.sides[k];
        if (set.planar) {
            const BlockReport report = solve_planar<second(), kRelax, kLast>(
                colour.blocks[k], side, rough_of(colour, k), bodies.data(), set);
            if constexpr (kLast) {
                side.aged = static_cast<std::uint8_t>(report.aged);
                side.pressing = static_cast<std::uint8_t>(report.touching);
            }
            return;
        }
        const BlockReport report = solve_block<second(), inertia(), kRelax, kLast>(
            colour.blocks[k], side, rough_of(colour, k), bodies.data(), set,
            tuning::manifold_sweeps);
        if constexpr (kLast) {
            side.aged = static_cast<std::uint8_t>(report.aged);
            side.pressing = static_cast<std::uint8_t>(report.touching);
        }
    });
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
    for_each_block(store, team, [&](Colour& colour, std::size_t k, auto second, auto inertia) {
        if (set.planar)
            return warm_start_planar<second()>(colour.blocks[k], rough_of(colour, k),
                                               bodies.data());
        warm_start_block<second(), inertia()>(colour.blocks[k], rough_of(colour, k), bodies.data());
    });
}

void solve(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set,
           TaskTeam& team) {
    solve_all<false, false>(store, bodies, set, team);
}

void relax(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set, bool last,
           TaskTeam& team) {
    if (last)
        solve_all<true, true>(store, bodies, set, team);
    else
        solve_all<true, false>(store, bodies, set, team);
}

bool begin_bounces(ManifoldStore& store, std::span<const HotBody> bodies, TaskTeam& team) {
    if (!any_bouncy(store)) return false;
    for_each_block(store, team, [&](Colour& colour, std::size_t k, auto second, auto inertia) {
        if (colour.sides[k].bouncy != 0)
            begin_bounce<second(), inertia()>(colour.blocks[k], colour.bounces[k], bodies.data());
    });
    return true;
}

void foresee_bounces(ManifoldStore& store, std::span<const HotBody> bodies,
                     const ContactSettings& set, TaskTeam& team) {
    for_each_block(store, team, [&](Colour& colour, std::size_t k, auto second, auto inertia) {
        if (colour.sides[k].bouncy != 0)
            foresee_bounce<second(), inertia()>(colour.blocks[k], colour.bounces[k], bodies.data(),
                                                set);
    });
}

void note_bounce_peaks(ManifoldStore& store, TaskTeam& team) {
    for_each_block(store, team, [&](Colour& colour, std::size_t k, auto, auto) {
        if (colour.sides[k].bouncy != 0) note_peaks(colour.blocks[k], colour.bounces[k]);
    });
}

void end_bounces(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set,
                 TaskTeam& team) {
    for_each_block(store, team, [&](Colour& colour, std::size_t k, auto second, auto inertia) {
        if (colour.sides[k].bouncy != 0)
            end_bounce<second(), inertia()>(colour.blocks[k], colour.bounces[k],
                                            colour.sides[k].restitution, bodies.data(), set);
    });
}

}  // namespace jostle::physics
