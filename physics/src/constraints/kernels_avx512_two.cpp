// SPDX-License-Identifier: MIT
//
// The most expensive contact passes with AVX-512 registers: sixteen lanes, two consecutive blocks
// of eight with the same kind of inertia. Their bodies are distinct like the bodies of one block.
// Remaining blocks use eight lanes. Lanes are independent, so the bits are the same. Built with
// AVX-512 (physics/CMakeLists.txt).
#if defined(__x86_64__)
#define JOSTLE_ISA avx512_two
#define JOSTLE_TWO_BLOCKS
#include "physics/src/constraints/contact_kernel.h"
#include "physics/src/constraints/kernels.h"
#include "physics/src/constraints/planar_kernel.h"

namespace jostle::physics::avx512_two {
namespace {

bool is_alike(const ContactConstraintWideMeta& a, const ContactConstraintWideMeta& b, bool planar) {
    const auto none = [&](LaneFlag flag) { return (a.bits(flag) | b.bits(flag)) == 0; };
    if (planar) return none(LaneFlag::rolls);
    return none(LaneFlag::locked) && none(LaneFlag::rolls) &&
           (a.bits(LaneFlag::anisotropic) != 0) == (b.bits(LaneFlag::anisotropic) != 0);
}

template <PairKind kPair, bool kRelax, bool kLast>
void solve_two(const ContactRange& range, int k, SolverBody* bodies, const ContactSettings& set) {
    ContactConstraintWide& block = range.blocks[k];
    ContactConstraintWideMeta& meta = range.metas[k];
    const int sweeps = kRelax ? set.relax_sweeps : set.soft_sweeps;
    PairReport report;
    if (set.planar)
        report = solve_planar<kPair, kRelax, kLast>(block, meta, nullptr, bodies, set);
    else if (range.single)
        report = meta.bits(LaneFlag::anisotropic) != 0
                     ? solve_block<1, kPair, Inertia::full, kRelax, kLast>(block, meta, nullptr,
                                                                           bodies, set, 1)
                     : solve_block<1, kPair, Inertia::isotropic, kRelax, kLast>(
                           block, meta, nullptr, bodies, set, 1);
    else
        report = meta.bits(LaneFlag::anisotropic) != 0
                     ? solve_block<4, kPair, Inertia::full, kRelax, kLast>(block, meta, nullptr,
                                                                           bodies, set, sweeps)
                     : solve_block<4, kPair, Inertia::isotropic, kRelax, kLast>(
                           block, meta, nullptr, bodies, set, sweeps);
    if constexpr (kLast)
        for (int half = 0; half < 2; half++) {
            range.metas[k + half].bits(LaneFlag::needs_rebuild) =
                static_cast<std::uint8_t>(report.needs_rebuild >> (8 * half));
            range.metas[k + half].bits(LaneFlag::touching_now) =
                static_cast<std::uint8_t>(report.touching >> (8 * half));
        }
}

// `one`: the same pass with eight lanes.
template <bool kRelax, bool kLast>
void solve_range(const ContactRange& range, SolverBody* bodies, const ContactSettings& set,
                 ContactPass one) {
    if (range.one_by_one || range.pair == PairKind::kinematic) return one(range, bodies, set);
    ContactRange left = range;
    for (int k = range.begin; k < range.end;) {
        if (k + 1 < range.end && is_alike(range.metas[k], range.metas[k + 1], set.planar)) {
            if (range.pair == PairKind::static_)
                solve_two<PairKind::static_, kRelax, kLast>(range, k, bodies, set);
            else
                solve_two<PairKind::dynamic, kRelax, kLast>(range, k, bodies, set);
            k += 2;
        } else {
            left.begin = k;
            left.end = ++k;
            one(left, bodies, set);
        }
    }
}

}  // namespace

void solve(const ContactRange& range, SolverBody* bodies, const ContactSettings& set) {
    solve_range<false, false>(range, bodies, set, avx512::table.solve);
}
void relax(const ContactRange& range, SolverBody* bodies, const ContactSettings& set) {
    solve_range<true, false>(range, bodies, set, avx512::table.relax);
}
void relax_last(const ContactRange& range, SolverBody* bodies, const ContactSettings& set) {
    solve_range<true, true>(range, bodies, set, avx512::table.relax_last);
}

}  // namespace jostle::physics::avx512_two
#endif
