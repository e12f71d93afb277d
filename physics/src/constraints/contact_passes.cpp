// SPDX-License-Identifier: MIT
#include "constraints/contact_passes.h"

#include <algorithm>
#include <cstdint>

namespace jostle::physics {
namespace {

constexpr int grain = 8;  // blocks that are taken at once

// The blocks [begin, end) of a colour.
void run_part(ContactPass pass, GraphColour& colour, int c, int begin, int end,
              const ContactPart& part) {
    if (begin >= end) return;
    pass({colour.blocks.data(), colour.metas.data(), colour.restitutions.data(),
          colour.rollings.data(), begin, end, pair_kind_of(c), is_single(c), is_overflow(c)},
         part.bodies, part.set);
}

// Each grain has its share of both lists: a thread meets the same bodies in each. Shares begin with
// even blocks, because kernels take two at a time.
void run(ContactPass pass, const ContactPart& part) {
    for (const ColourRun& run : part.runs) {
        const int total = run.blocks + run.singles;
        const auto share = [&](int blocks, int at) {
            return at == total ? blocks : static_cast<int>(std::int64_t{at} * blocks / total) & ~1;
        };
        const auto work = [&](int begin, int end) {
            run_part(pass, *run.colour, run.number, share(run.blocks, begin),
                     share(run.blocks, end), part);
            if (run.singles > 0)
                run_part(pass, *run.single, single_colours + run.number, share(run.singles, begin),
                         share(run.singles, end), part);
        };
        if (run.shared)
            part.team.run(total, grain, work, TaskTeam::Part::own);
        else
            work(0, total);
    }
}

// Those of the last block, or all but the first of each where a block holds one manifold.
void point_unused_lanes(GraphColour& colour, int c, std::int32_t body) {
    if (colour.blocks.empty()) return;
    const auto point = [body](ContactConstraintWide& block, int used) {
        for (int lane = used; lane < 8; lane++) block.a[lane] = block.b[lane] = body;
    };
    if (is_overflow(c))
        for (ContactConstraintWide& block : colour.blocks) point(block, 1);
    else if (colour.contacts % 8 != 0)
        point(colour.blocks.back(), colour.contacts % 8);
}

bool any_bouncy(const ContactPart& part) {
    const auto bouncy = [](const GraphColour* colour) {
        return colour != nullptr && std::any_of(colour->metas.begin(), colour->metas.end(),
                                                [](const ContactConstraintWideMeta& meta) {
                                                    return meta.bits(LaneFlag::bounces) != 0;
                                                });
    };
    return std::any_of(part.runs.begin(), part.runs.end(), [&](const ColourRun& run) {
        return bouncy(run.colour) || bouncy(run.single);
    });
}

}  // namespace

void list_runs(ConstraintGraph& graph, std::size_t first, std::size_t last,
               std::vector<ColourRun>& runs) {
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
                run.shared = false;  // these share bodies: one by one
            } else {
                run.single = &set.colours[static_cast<std::size_t>(single_colours + c)];
                run.singles = static_cast<int>(run.single->blocks.size());
            }
            if (run.blocks + run.singles == 0) continue;
            runs.push_back(run);
            point_unused_lanes(colour, c, HotBodies::spare_index(first, false));
            if (run.singles > 0)
                point_unused_lanes(*run.single, single_colours + c,
                                   HotBodies::spare_index(first, true));
        }
    }
}

void warm_start(const ContactPart& part) {
    run(kernels().warm_start, part);
}

void solve(const ContactPart& part) {
    run(kernels().solve, part);
}

void relax(const ContactPart& part, bool last) {
    run(last ? kernels().relax_last : kernels().relax, part);
}

bool begin_restitution(const ContactPart& part) {
    if (!any_bouncy(part)) return false;
    run(kernels().begin_restitution, part);
    return true;
}

void predict_approaches(const ContactPart& part) {
    run(kernels().predict_approach, part);
}

void record_peaks(const ContactPart& part) {
    run(kernels().record_peaks, part);
}

void apply_restitution(const ContactPart& part) {
    run(kernels().apply_restitution, part);
}

}  // namespace jostle::physics
