// SPDX-License-Identifier: MIT
//
// The motions of bodies in a step, in the detail needed to decide whether two may have collided.
// Known motions are computed once, because all neighbours use them. Part of solve_continuous. Reads
// the world and FinalizeScratch, writes only itself.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/time_of_impact.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/continuous/ccd_policy.h"
#include "physics/src/stages/relative_displacement.h"
#include "physics/src/stages/step_context.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {

class SweptMotions {
public:
    // `known`: awake indices. sweep_of_body(awake index): the sweep of the body from the start of
    // the step to its end.
    template <class MotionOf>
    void note(StepContext& step, const std::vector<std::uint32_t>& known,
              MotionOf&& sweep_of_body) {
        const BodyStore& bodies = step.world.bodies;
        motions_.resize(known.size());
        sweeps_.resize(known.size());
        index_.assign(step.scratch.finalize.fast.size(), not_known);
        for (std::size_t k = 0; k < known.size(); k++) {
            ASSERT(known[k] < index_.size() && index_[known[k]] == not_known);
            index_[known[k]] = static_cast<std::uint32_t>(k);
        }
        step.thread_pool.run(static_cast<int>(known.size()), 64, [&](int begin, int end) {
            for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); k++) {
                const Sweep& sweep = sweeps_[k] = sweep_of_body(known[k]);
                const double radius = bodies.cold[bodies.awake[known[k]].body].radius;
                motions_[k] = {sweep.center, sweep.translation, sweep.rotation_vector, radius};
            }
        });
        dt_ = step.dt;
    }

    // Returns whether the motion of an awake body is known.
    bool knows(std::uint32_t awake) const {
        return awake < index_.size() && index_[awake] != not_known;
    }
    // The sweep of a body with known motion.
    const Sweep& sweep_of(std::uint32_t awake) const {
        ASSERT(knows(awake));
        return sweeps_[index_[awake]];
    }
    // The motion of any body. If it is not known, it is extrapolated backwards from the velocity.
    BodyDisplacement of(const WorldState& world, std::uint32_t body) const {
        const BodyCold& cold = world.bodies.cold[body];
        const bool awake = cold.set == BodySet::awake;
        if (awake && knows(cold.at)) return motions_[index_[cold.at]];
        const BodyWarm& warm = warm_of(world, body);
        if (!awake) return {warm.center, {}, {}, displaced_radius(cold)};
        const Vec3 translation = warm.v * dt_;
        return {warm.center - translation, translation, warm.w * dt_, cold.radius};
    }

    // Returns whether the motions of a body and another body, one of whose shapes is given, may
    // make them collide and are large enough relative to each other for a sweep. Smaller motions
    // are left to the contact solver (stages/contacts/update_contacts.cpp), unless the pair bounces
    // (ccd_policy.h), which is evaluated last.
    template <class Bounces>
    bool may_collide(const WorldState& world, const BodyDisplacement& motion, const BodyCold& cold,
                     std::uint32_t other, std::uint32_t other_shape, Bounces&& bounces) const {
        const BodyCold& cold_other = world.bodies.cold[other];
        if (left_to_contacts(world, cold, cold_other, true)) return false;
        const BodyDisplacement other_motion = of(world, other);
        const Vec3 closing = motion.translation - other_motion.translation;
        if (cold_other.type != BodyType::dynamic) {
            if (!is_on_path(world, motion, cold.radius, world.shapes.shapes[other_shape]))
                return false;
        } else {
            // The minimum distance of their centres for linear motions.
            const Vec3 apart = other_motion.center - motion.center;
            const double nearest =
                clamp(dot(apart, closing) / maximum(dot(closing, closing), 1e-30), 0, 1);
            const double reach = cold.radius + cold_other.radius + tuning::swept_margin;
            if (!(length_squared(apart - closing * nearest) < reach * reach)) return false;
        }
        // Slightly less than predicted, so that no pair falls between the two criteria.
        return max_relative_displacement(motion, other_motion) >=
                   tuning::sweep_share * motion_without_sweep(cold, cold_other) ||
               bounces();
    }

private:
    static bool is_on_path(const WorldState& world, const BodyDisplacement& motion, double radius,
                           const ShapeRecord& shape) {
        const Vec3 end = motion.center + motion.translation;
        const Aabb swept_box =
            grow({min(motion.center, end), max(motion.center, end)}, radius + tuning::swept_margin);
        return is_plane(shape) ? reaches_plane(world, shape, swept_box)
                               : overlap(swept_box, shape.fat);
    }

    static constexpr std::uint32_t not_known = 0xffffffff;

    std::vector<BodyDisplacement> motions_;
    std::vector<Sweep> sweeps_;         // of the same bodies
    std::vector<std::uint32_t> index_;  // by awake index: index into motions_
    double dt_ = 0;
};

}  // namespace jostle::physics
