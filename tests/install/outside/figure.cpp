// SPDX-License-Identifier: MIT
//
// A module that was installed: a person falls on the ground.
#include <cstdio>
#include <memory>

#include "jostle/modules/ragdoll.h"
#include "jostle/physics/world.h"

using namespace jostle;

int main() {
    physics::World world = std::move(*physics::World::create({}));
    auto module = std::make_unique<modules::Ragdolls>();
    modules::Ragdolls& ragdolls = *module;
    world.add_module(std::move(module)).expect();
    world.create_body({.type = physics::BodyType::static_body}, {.geometry = physics::Plane{}})
        .value();
    const modules::RagdollId person =
        ragdolls.add(world, modules::human_figure(), {.position = {0, 1, 0}}).value();
    for (int k = 0; k < 120; k++) world.step(1.0 / 60).expect();
    const double height = world.body(ragdolls.bodies(person)->front())->pose.position.y;
    std::printf("the hips lie %.2f m above the ground\n", height);
    return height > 0.02 && height < 0.5 ? 0 : 1;
}
