// SPDX-License-Identifier: MIT
#include "bench/speed/engine_kinds.h"

#include <optional>

namespace jostle::bench {
namespace {

using physics::Transform;
using physics::Vec3;

class JostleEngine final : public Engine {
public:
    physics::Status init(const scenes::SceneDescription& scene) override {
        auto built = scenes::build_scene(scene);
        if (!built) return built.error();
        built_ = std::move(*built);
        step_seconds_ = 1 / scene.hz;
        return {};
    }

    void step() override {
        // step() fails only for a step length out of range.
        static_cast<void>(built_->world.step(step_seconds_));
    }

    Transform pose(std::uint32_t body) const override { return state(body).pose; }

    Vec3 velocity(std::uint32_t body) const override { return state(body).linear_velocity; }

    void set_velocity(std::uint32_t body, Vec3 linear) override {
        static_cast<void>(
            built_->world.set_velocity(built_->bodies[body], linear, state(body).angular_velocity));
    }

    int awake() const override {
        // before the first step the count is unknown
        const auto all = static_cast<int>(built_->bodies.size());
        return built_->world.step_count() == 0 ? all : built_->world.profile().bodies_awake;
    }

    const char* worst_stage() const override {
        return stage_name(built_->world.profile().worst_stage);
    }

private:
    physics::BodyState state(std::uint32_t body) const {
        return *built_->world.body(built_->bodies[body]);
    }

    std::optional<scenes::BuiltScene> built_;
    double step_seconds_ = 0;
};

}  // namespace

std::unique_ptr<Engine> make_jostle_engine() {
    return std::make_unique<JostleEngine>();
}

}  // namespace jostle::bench
