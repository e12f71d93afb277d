// SPDX-License-Identifier: MIT
#include "physics/src/constraints/contact_passes.h"

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"

#include <algorithm>
#include <cstdint>

namespace jostle::physics {
namespace {

// Runs a pass over the blocks [begin, end) of a colour.
void run_blocks(ContactPass pass, GraphColour& colour, int c, int begin, int end,
                const ContactTask& task) {
    if (begin >= end) return;
    ASSERT(begin >= 0 && end <= static_cast<int>(colour.blocks.size()) &&
           colour.metas.size() == colour.blocks.size());
    pass({colour.blocks.data(), colour.metas.data(), colour.restitutions.data(),
          colour.rollings.data(), begin, end, pair_kind_of(c), is_single(c), is_overflow(c)},
         task.bodies, task.set);
}

// Each grain covers the same fraction of both lists, so that a thread processes the same bodies in
// each. Fractions begin with even blocks, because kernels process two at a time.
void run(ContactPass pass, const ContactTask& task) {
    for (const ColourRun& run : task.runs) {
        const int total = run.blocks + run.singles;
        ASSERT(total > 0 && run.colour != nullptr && (run.singles == 0 || run.single != nullptr));
        const auto share = [&](int blocks, int at) {
            return at == total ? blocks : static_cast<int>(std::int64_t{at} * blocks / total) & ~1;
        };
        const auto work = [&](int begin, int end) {
            run_blocks(pass, *run.colour, run.number, share(run.blocks, begin),
                       share(run.blocks, end), task);
            if (run.singles > 0)
                run_blocks(pass, *run.single, single_colours + run.number,
                           share(run.singles, begin), share(run.singles, end), task);
        };
        if (run.shared)
            task.thread_pool.run(total, tuning::contact_grain, work, ThreadPool::Split::fixed);
        else
            work(0, total);
    }
}

// Sets the bodies of unused lanes: those of the last block, or all but the first lane of each block
// of an overflow list.
void point_unused_lanes(GraphColour& colour, int c, std::int32_t body) {
    if (colour.blocks.empty()) return;
    ASSERT(body < 0);
    const auto point = [body](ContactConstraintWide& block, int used) {
        for (int lane = used; lane < 8; lane++) block.a[lane] = block.b[lane] = body;
    };
    if (is_overflow(c))
        for (ContactConstraintWide& block : colour.blocks) point(block, 1);
    else if (colour.contacts % 8 != 0)
        point(colour.blocks.back(), colour.contacts % 8);
}

bool any_bouncy(const ContactTask& task) {
    const auto bouncy = [](const GraphColour* colour) {
        return colour != nullptr && std::any_of(colour->metas.begin(), colour->metas.end(),
                                                [](const ContactConstraintWideMeta& meta) {
                                                    return meta.bits(LaneFlag::bounces) != 0;
                                                });
    };
    return std::any_of(task.runs.begin(), task.runs.end(), [&](const ColourRun& run) {
        return bouncy(run.colour) || bouncy(run.single);
    });
}

}  // namespace

void list_runs(ConstraintGraph& graph, std::size_t first, std::size_t last,
               std::vector<ColourRun>& runs) {
    ASSERT(first < last && last <= solved_set_count);
    runs.clear();
    for (std::size_t k = first; k < last; k++) {
        ColourSet& set = graph.sets[k];
        if (set.contacts == 0) continue;
        for (const int c : solve_order) {
            if (is_single(c)) continue;
            GraphColour& colour = set.colours[static_cast<std::size_t>(c)];
            ColourRun run{.colour = &colour,
                          .number = c,
                          .blocks = static_cast<int>(colour.blocks.size()),
                          .shared = is_shared(set)};
            if (is_overflow(c)) {
                run.shared = false;  // blocks of an overflow list share bodies and run serially
            } else {
                run.single = &set.colours[static_cast<std::size_t>(single_colours + c)];
                run.singles = static_cast<int>(run.single->blocks.size());
            }
            if (run.blocks + run.singles == 0) continue;
            ASSERT(!run.shared || !is_overflow(c));
            runs.push_back(run);
            point_unused_lanes(colour, c, SolverBodies::spare_index(first, false));
            if (run.singles > 0)
                point_unused_lanes(*run.single, single_colours + c,
                                   SolverBodies::spare_index(first, true));
        }
    }
}

void warm_start(const ContactTask& task) {
    run(kernels().warm_start, task);
}

void solve(const ContactTask& task) {
    run(kernels().solve, task);
}

void relax(const ContactTask& task, bool last) {
    run(last ? kernels().relax_last : kernels().relax, task);
}

bool begin_restitution(const ContactTask& task) {
    if (!any_bouncy(task)) return false;
    run(kernels().begin_restitution, task);
    return true;
}

void predict_approaches(const ContactTask& task) {
    run(kernels().predict_approach, task);
}

void record_peaks(const ContactTask& task) {
    run(kernels().record_peaks, task);
}

void apply_restitution(const ContactTask& task) {
    run(kernels().apply_restitution, task);
}

}  // namespace jostle::physics
