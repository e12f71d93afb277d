// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/error_trial.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/solver/substep_hooks.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/impulse_scale.h"
#include "physics/src/state/pair_properties.h"

namespace jostle::physics {
namespace {

// Both factors are exact in float.
constexpr float longer = 2, shorter = 0.5f;
constexpr double max_error = 1e6;    // m: also stands for NaN
constexpr double min_error = 1e-12;  // m: 0 means unknown

// Visits the colours with contacts, always in the same order.
template <class Visit>
void each_colour(ConstraintGraph& graph, std::size_t first, std::size_t last, Visit&& visit) {
    for_each_colour(std::span(graph.sets).subspan(first, last - first), visit);
}

void scale_all(StepContext& step, std::span<const std::uint32_t> jointed, double scale) {
    for (const std::uint32_t hot : jointed)
        scale_joints(step.world.bodies, step.world.joints, step.world.bodies.awake[hot - 1].body,
                     scale);
}

void lengthen(GraphColour& colour, int number) {
    for (std::int32_t slot = 0; slot < colour.contacts; slot++)
        scale_warm_start(lane_ref_at(colour, number, slot), longer);
}

// At the start of the step.
void note_overlaps(ContactGraph& stores, std::size_t first, std::size_t last) {
    each_colour(stores.graph, first, last, [&](const GraphColour& colour) {
        for (std::size_t k = 0; k < colour.blocks.size(); k++)
            for (int lane = 0; lane < block_lanes; lane++) {
                if (!colour.metas[k].has(LaneFlag::touching, lane)) continue;
                float least = 0;
                for (const auto& gap : colour.blocks[k].gap) least = std::min(least, gap[lane]);
                if (double{least} >= -tuning::contact_slop) continue;
                const Contact& c = stores.contacts.contacts[colour.metas[k].contact[lane]];
                const double overlap =
                    -double{least} - tuning::contact_slop * scale_of_pair(stores.bodies, c);
                note_error(stores.islands.islands[stores.bodies.cold[c.body_a].island], overlap);
            }
    });
}

double length_between(const float* a, const float* b) {
    const Vec3 x{double{a[0]}, double{a[1]}, double{a[2]}},
        y{double{b[0]}, double{b[1]}, double{b[2]}};
    return length(x - y);
}

}  // namespace

bool wants_trial(const StepContext& step, std::size_t set) {
    const WorldState& world = step.world;
    if (!controls_error(world.def) || has_substep_listeners(world.listeners)) return false;
    const std::uint64_t turn = world.steps + set;
    return turn % tuning::trial_interval == 1 ||
           (turn % tuning::first_trial_interval == 1 && step.scratch.islands.unknown[set] != 0);
}

void begin_trial(StepContext& step, std::size_t first, std::size_t last,
                 std::span<const std::uint32_t> jointed) {
    ErrorTrial& trial = step.scratch.solver.trials[first];
    std::size_t next = 0;
    each_colour(step.world.graph, first, last, [&](GraphColour& colour, int number) {
        if (colour.contacts == 0) return;
        if (next == trial.colours.size()) trial.colours.emplace_back();
        trial.colours[next++] = colour;
        lengthen(colour, number);
    });
    scale_all(step, jointed, double{longer});
}

void end_trial(StepContext& step, std::size_t first, std::size_t last,
               std::span<const std::uint32_t> bodies, std::span<const std::uint32_t> jointed) {
    ErrorTrial& trial = step.scratch.solver.trials[first];
    trial.bodies.clear();
    for (const std::uint32_t hot : bodies) trial.bodies.push_back(step.scratch.solver.hot[hot]);
    std::size_t next = 0;
    each_colour(step.world.graph, first, last, [&](GraphColour& colour) {
        if (colour.contacts == 0) return;
        ASSERT(next < trial.colours.size());
        std::swap(colour, trial.colours[next++]);
    });
    scale_all(step, jointed, double{shorter});
}

double second_error(double shift, double change, double dt, ErrorLife life) {
    // s: half a second on average for a lasting error.
    const double lasts = life == ErrorLife::lasting ? 0.5 : tuning::velocity_error_life;
    const double seconds = 1;
    return (shift + change * lasts) * seconds / dt;
}

void note_error(Island& island, double error) {
    // A maximum that maps NaN to the largest error.
    const double known = error < max_error ? maximum(error, min_error) : max_error;
    island.error.estimate = island.error.fresh ? maximum(island.error.estimate, known) : known;
    island.error.fresh = true;
}

void compare_trial(StepContext& step, std::size_t first, std::size_t last,
                   std::span<const std::uint32_t> bodies) {
    WorldState& world = step.world;
    const ErrorTrial& trial = step.scratch.solver.trials[first];
    ASSERT(trial.bodies.size() == bodies.size());
    for (const std::uint32_t hot : bodies)
        world.islands.islands[world.bodies.cold[world.bodies.awake[hot - 1].body].island]
            .error.fresh = false;
    for (std::size_t k = 0; k < bodies.size(); k++) {
        const SolverBody &now = step.scratch.solver.hot[bodies[k]], &then = trial.bodies[k];
        const BodyCold& cold = world.bodies.cold[world.bodies.awake[bodies[k] - 1].body];
        const double shift =
            length_between(now.dp, then.dp) + cold.radius * length_between(now.dr, then.dr);
        // An error that contacts immediately remove barely affects positions: it is limited to the
        // velocity error that would cause the position error if it had grown linearly.
        const double change =
            minimum(length_between(now.v, then.v) + cold.radius * length_between(now.w, then.w),
                    2 * shift / step.dt);
        note_error(world.islands.islands[cold.island],
                   second_error(shift, change, step.dt, ErrorLife::damped));
    }
    note_overlaps(world, first, last);
}

}  // namespace jostle::physics
