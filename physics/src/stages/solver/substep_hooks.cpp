// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/substep_hooks.h"

#include <limits>

#include "jostle/base/check.h"
#include "jostle/physics/step_listener.h"
#include "physics/src/constraints/free_motion.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/solver/solver_velocities.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/force_fields.h"

namespace jostle::physics {
namespace {

// Common base of both kinds of groups.
class Substep : public SubstepContext {
public:
    Substep(StepContext& step, const SubstepInfo& substep_info,
            std::span<const std::uint32_t> awake, std::vector<BodyId>& ids)
        : step_(step), substep_info_(substep_info), ids_(ids) {
        ids_.clear();
        for (const std::uint32_t index : awake)
            ids_.push_back(body_id(step.world.bodies, step.world.bodies.awake[index].body));
    }

    double h() const override { return substep_info_.h; }
    int index() const override { return substep_info_.index; }
    int count() const override { return substep_info_.count; }
    double time() const override {
        return step_.world.time + substep_info_.index * substep_info_.h;
    }
    const World& world() const override { return *step_.world.listeners.stepping; }
    std::span<const BodyId> bodies() const override { return ids_; }

    MovingBody body(BodyId id) const override {
        ASSERT(contains(id));
        const BodyWarm now = motion(id);
        const BodyCold& cold = step_.world.bodies.cold[id.index];
        return {id, pose_of(now, cold), now.center, now.v, now.w, cold.mass};
    }
    BodyResponse response(BodyId id) const override {
        ASSERT(contains(id));
        const BodyWarm now = motion(id);
        const BodyCold& cold = step_.world.bodies.cold[id.index];
        return {free_directions(cold) * cold.inverse_mass, inverse_inertia(id, now),
                acceleration_of(now, cold, step_.world.def.gravity)};
    }
    Vec3 velocity_at(BodyId id, Vec3 point) const override {
        ASSERT(contains(id));
        const BodyWarm now = motion(id);
        return now.v + cross(now.w, point - now.center);
    }
    bool add_impulse(BodyId id, Vec3 impulse, Vec3 point) override {
        if (!contains(id)) return false;
        push(id, impulse, cross(point - motion(id).center, impulse));
        return true;
    }
    bool add_angular_impulse(BodyId id, Vec3 impulse) override {
        if (!contains(id)) return false;
        push(id, {}, impulse);
        return true;
    }
    void parallel_for(int count, int grain,
                      const std::function<void(int, int)>& function) const override {
        ASSERT(count >= 0 && grain >= 1);
        // A concurrent group has one thread.
        if (!listens_at_once(step_.world.listeners))
            step_.thread_pool.run(count, grain, function);
        else if (count > 0)
            function(0, count);
    }

protected:
    virtual BodyWarm motion(BodyId id) const = 0;
    // As push() uses it, 1/(kg m^2), world axes.
    virtual Mat3 inverse_inertia(BodyId id, const BodyWarm& now) const = 0;
    virtual void push(BodyId id, Vec3 impulse, Vec3 angular_impulse) = 0;

    // Its index in the awake set, or none.
    std::uint32_t awake_index(BodyId id) const {
        if (!step_.world.bodies.ids.matches(id.index, id.generation)) return none;
        const BodyCold& cold = step_.world.bodies.cold[id.index];
        return cold.set == BodySet::awake ? cold.at : none;
    }

    StepContext& step_;

private:
    const SubstepInfo& substep_info_;
    std::vector<BodyId>& ids_;
};

class SolverSubstep final : public Substep {
public:
    SolverSubstep(StepContext& step, const SubstepInfo& substep_info, ListenedGroup& group,
                  std::size_t first, std::size_t last)
        : Substep(step, substep_info, group.awake, group.bodies), first_(first), last_(last) {}

    bool contains(BodyId id) const override {
        const std::uint32_t at = awake_index(id);
        if (at == none) return false;
        ASSERT(at < step_.scratch.solver.set_of.size());
        const std::size_t set = step_.scratch.solver.set_of[at];
        return set >= first_ && set < last_;
    }

private:
    BodyWarm motion(BodyId id) const override {
        return motion_now(step_.world.bodies, step_.scratch.solver, awake_index(id));
    }
    Mat3 inverse_inertia(BodyId id, const BodyWarm&) const override {
        return solver_inverse_inertia(step_.scratch.solver, awake_index(id));
    }
    void push(BodyId id, Vec3 impulse, Vec3 angular_impulse) override {
        apply_solver_impulse(step_.world.bodies, step_.scratch.solver, awake_index(id), impulse,
                             angular_impulse);
    }

    std::size_t first_, last_;
};

class FreeSubstep final : public Substep {
public:
    FreeSubstep(StepContext& step, const SubstepInfo& substep_info,
                std::span<const std::uint32_t> awake, std::span<BodyWarm> moving,
                std::uint32_t first_free_index, std::vector<BodyId>& ids)
        : Substep(step, substep_info, awake, ids),
          moving_(moving),
          first_free_index_(first_free_index) {}

    bool contains(BodyId id) const override { return moving_index(id) != none; }

private:
    std::uint32_t moving_index(BodyId id) const {
        const std::uint32_t at = awake_index(id);
        ASSERT(at == none || at < step_.scratch.solver.free_index.size());
        const std::uint32_t moving_index = at == none ? none : step_.scratch.solver.free_index[at];
        const bool inside = moving_index != none && moving_index >= first_free_index_ &&
                            moving_index - first_free_index_ < moving_.size();
        return inside ? moving_index - first_free_index_ : none;
    }
    BodyWarm motion(BodyId id) const override { return moving_[moving_index(id)]; }
    Mat3 inverse_inertia(BodyId id, const BodyWarm& now) const override {
        return world_inverse_inertia(now, step_.world.bodies.cold[id.index]);
    }
    void push(BodyId id, Vec3 impulse, Vec3 angular_impulse) override {
        BodyWarm& now = moving_[moving_index(id)];
        const BodyCold& cold = step_.world.bodies.cold[id.index];
        now.v += scaled(impulse, free_directions(cold)) * cold.inverse_mass;
        now.w += world_inverse_inertia(now, cold) * angular_impulse;
    }

    std::span<BodyWarm> moving_;
    std::uint32_t first_free_index_;
};

void call(const ListenerStore& listeners, const SubstepInfo& substep_info,
          SubstepContext& context) {
    ASSERT(listeners.stepping != nullptr && has_substep_listeners(listeners));
    for (const auto& [listener, hooks] : listeners.order) {
        if (!hooks.substeps) continue;
        if (substep_info.after)
            listener->after_substep(context);
        else
            listener->before_substep(context);
    }
}

}  // namespace

void call_listeners(StepContext& step, const SubstepInfo& substep_info,
                    std::span<const std::uint32_t> hot, std::size_t first, std::size_t last) {
    ListenedGroup& group = step.scratch.solver.listened[first];
    group.awake.clear();
    for (const std::uint32_t index : hot) group.awake.push_back(index - 1);
    SolverSubstep context(step, substep_info, group, first, last);
    call(step.world.listeners, substep_info, context);
}

void call_listeners(StepContext& step, const SubstepInfo& substep_info,
                    std::span<const std::uint32_t> awake, std::span<BodyWarm> moving,
                    std::uint32_t first_free_index, ListenedGroup& group) {
    ASSERT(awake.size() == moving.size());
    FreeSubstep context(step, substep_info, awake, moving, first_free_index, group.bodies);
    call(step.world.listeners, substep_info, context);
}

void find_in_fields(const StepContext& step, std::span<const std::uint32_t> hot,
                    std::vector<std::uint32_t>& found) {
    const WorldState& world = step.world;
    const double fall = length(world.def.gravity) * step.dt * step.dt;
    for (const std::uint32_t index : hot) {
        const BodyWarm& body = world.bodies.awake[index - 1];
        if (reaches(world.fields, body.center, 2 * step.dt * length(body.v) + fall))
            found.push_back(index);
    }
}

void push_by_fields(StepContext& step, const SubstepInfo& substep_info,
                    std::span<const std::uint32_t> hot) {
    const WorldState& world = step.world;
    const BodyStore& bodies = world.bodies;
    SolverScratch& scratch = step.scratch.solver;
    const double time = world.time + substep_info.index * substep_info.h;
    step.thread_pool.run(static_cast<int>(hot.size()), tuning::body_grain, [&](int begin, int end) {
        for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); k++) {
            const std::uint32_t awake = hot[k] - 1;
            if (!reaches(world.fields, center_now(bodies, scratch, awake), 0)) continue;
            const BodyWarm now = motion_now(bodies, scratch, awake);
            const FieldPush push =
                field_push(world, now, bodies.cold[now.body], time, substep_info.h);
            if (push.force == Vec3{} && push.torque == Vec3{}) continue;
            apply_solver_impulse(bodies, scratch, awake, push.force * substep_info.h,
                                 push.torque * substep_info.h);
        }
    });
}

Mat3 point_response(const BodyResponse& body, Vec3 arm) {
    const Mat3 across = skew(arm);
    return diagonal(body.inverse_mass) - across * body.inverse_inertia * across;
}

double effective_mass(const BodyResponse& body, Vec3 arm, Vec3 direction) {
    const double inverse = dot(direction, point_response(body, arm) * direction);
    return inverse > 0 ? 1 / inverse : std::numeric_limits<double>::infinity();
}

}  // namespace jostle::physics
