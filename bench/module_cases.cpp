// SPDX-License-Identifier: MIT
#include "module_cases.h"

#include <stdexcept>

#include "jostle/modules/ragdoll.h"

namespace jostle::bench {
namespace {

using namespace physics;
using namespace modules;

// Scenes are ours: a refused call is a fault of this file.
template <class T>
T must(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(*result);
}
void must(const Status& status) {
    if (!status) throw std::runtime_error(status.error().message);
}

void add_floor(World& world) {
    must(world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}}));
}

// Adds a module to a world and keeps it in sight.
template <class M>
M& add(World& world) {
    auto module = std::make_unique<M>();
    M& there = *module;
    must(world.add_module(std::move(module)));
    return there;
}

// Places in a square, `spacing` m apart.
Vec3 in_square(int k, double spacing) {
    constexpr int side = 16;
    return {spacing * (k % side), 0, spacing * (k / side)};
}

// Figures that wave on the floor, or lie there and twitch: none sleeps.
class Figures final : public ModuleScene {
public:
    Figures(int count, RagdollMode mode) : ragdolls_(add<Ragdolls>(world_)) {
        add_floor(world_);
        RagdollDef figure = human_figure();
        figure.sleep_allowed = false;
        for (int k = 0; k < count; k++) {
            ids_.push_back(must(ragdolls_.add(world_, figure, {in_square(k, 2.5), {}})));
            must(ragdolls_.set_mode(world_, ids_.back(), mode));
        }
    }
    void step(int k) override {
        RagdollPose pose{.turns = std::vector<Quat>(11)};
        pose.turns[3] = from_axis_angle({0, 0, 1}, 0.6 * sin_cos(0.1 * k).sin);
        for (std::size_t i = 0; i < ids_.size(); i++) {
            pose.root.position = in_square(static_cast<int>(i), 2.5);
            must(ragdolls_.set_pose(ids_[i], pose));
        }
        must(world_.step(1.0 / 60));
    }

private:
    World world_;
    Ragdolls& ragdolls_;
    std::vector<RagdollId> ids_;
};

template <RagdollMode mode>
std::unique_ptr<ModuleScene> figures(int count) {
    return std::make_unique<Figures>(count, mode);
}

constexpr ModuleCase cases[] = {
    {"ragdoll_limp", 40, figures<RagdollMode::limp>},
    {"ragdoll_powered", 40, figures<RagdollMode::powered>},
    {"ragdoll_kinematic", 40, figures<RagdollMode::kinematic>},
};

}  // namespace

std::span<const ModuleCase> module_cases() {
    return cases;
}

}  // namespace jostle::bench
