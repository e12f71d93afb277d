// SPDX-License-Identifier: MIT
#include "bench/integrators/integrator_kinds.h"

#include "jostle/physics/step_listener.h"
#include "jostle/physics/world.h"

namespace jostle::bench::integrators {
namespace {

using physics::BodyId;

class FieldListener final : public physics::StepListener {
public:
    FieldListener(const ParticleField& field, BodyId body) : field_(field), body_(body) {}

    physics::StepHooks hooks() const override { return {.substeps = true}; }

    // The context contains the position at the midpoint of the sub-step and the velocity at its
    // start; half the impulse extrapolates the velocity to the midpoint.
    void before_substep(physics::SubstepContext& substep) override {
        if (!substep.contains(body_)) return;
        const physics::MovingBody now = substep.body(body_);
        const double h = substep.h(), middle = substep.time() + 0.5 * h;
        const Vec3 guess = now.linear_velocity +
                           field_.acceleration(now.center, now.linear_velocity, middle) * (0.5 * h);
        substep.add_impulse(body_, field_.acceleration(now.center, guess, middle) * (now.mass * h),
                            now.center);
    }

private:
    const ParticleField& field_;
    BodyId body_;
};

class WorldIntegrator final : public Integrator {
public:
    explicit WorldIntegrator(const ParticleField& field)
        : world_({.gravity = {}, .sleeping = false}),
          body_(world_
                    .create_body({.pose = {field.start.position, {}},
                                  .linear_velocity = field.start.velocity},
                                 {.geometry = physics::Sphere{0.05}, .mass = 1})
                    .value()),
          listener_(field, body_) {
        static_cast<void>(world_.add_listener(listener_));
    }
    ~WorldIntegrator() override { static_cast<void>(world_.remove_listener(listener_)); }
    WorldIntegrator(const WorldIntegrator&) = delete;
    WorldIntegrator& operator=(const WorldIntegrator&) = delete;

    // The world keeps its own state between steps; the caller receives a copy.
    void step(ParticleState& state, double, double dt) override {
        static_cast<void>(world_.step(dt));
        const auto now = *world_.body(body_);
        state = {now.center, now.linear_velocity};
    }

private:
    physics::World world_;
    BodyId body_;
    FieldListener listener_;
};

}  // namespace

std::unique_ptr<Integrator> make_world_integrator(const ParticleField& field) {
    return std::make_unique<WorldIntegrator>(field);
}

}  // namespace jostle::bench::integrators
