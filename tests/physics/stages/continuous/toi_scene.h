// SPDX-License-Identifier: MIT
//
// A world of balls in the middle of a step, for tests of the parts of solve_continuous. The balls
// do not move; tests set the paths of their TOI bodies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "physics/src/stages/continuous/toi_state.h"
#include "physics/src/state/world_access.h"
#include "tests/support/world_builder.h"

namespace jostle::test {

class ToiScene {
public:
    explicit ToiScene(physics::WorldDef def = {}) : world(make_world(def)) {}

    // Adds a ball of 0.1 m at x. Index of the body and of its shape.
    std::uint32_t ball(double x, double restitution = 0) {
        return add(world, {.geometry = physics::Sphere{0.1},
                           .position = {x, 0, 0},
                           .restitution = restitution})
            .index;
    }

    // Call after all balls are added.
    physics::ToiState& begin() {
        physics::WorldState& state = state_of(world);
        physics::FinalizeScratch& finalize = scratch_.finalize;
        const std::size_t awake = state.bodies.awake.size();
        for (auto* flags : {&finalize.fast, &finalize.not_finite, &finalize.deflected,
                            &finalize.left_predicted_aabb})
            flags->assign(awake, 0);
        finalize.previous = state.bodies.awake;
        scratch_.contacts.had_contacts.assign(awake, 0);
        return toi_.emplace(step_);
    }

    // Adds the TOI body of a ball that moves by `motion` m along x in the step.
    std::size_t moving(std::uint32_t body, double motion) {
        const std::size_t index = add_toi_body(*toi_, body, true);
        physics::ToiBody& t = toi_->bodies[index];
        t.sweep = {0, warm_of(state_of(world), body).center, {}, {motion, 0, 0}, {}};
        t.queued = false;
        return index;
    }

    physics::World world;

private:
    physics::StepScratch scratch_;
    physics::StepContext step_{
        state_of(world), scratch_, *state_of(world).thread_pool, 1.0 / 60, {}};
    std::optional<physics::ToiState> toi_;
};

}  // namespace jostle::test
