// SPDX-License-Identifier: MIT
//
// Step listener: changes contacts while they are created, and reads the events of a step. Two
// crates slide at the same speed, one of them onto a patch of ice.
//
// Shows: StepListener, StepHooks, PreSolve, Events, user_data.
// Run:   build/dev/bin/jostle-listener
#include <cstdio>

#include "jostle/physics/physics.h"

using namespace jostle::physics;

namespace {

constexpr std::uint64_t ice = 1;  // user data of slippery shapes

class IceRink : public StepListener {
public:
    // A listener receives only the calls that it requests here.
    StepHooks hooks() const override { return {.pre_solve = true}; }

    // Called once per new contact, before the solver uses it.
    void pre_solve(PreSolve& pair) override {
        const bool slippery = pair.world.shape(pair.shape_a)->user_data == ice ||
                              pair.world.shape(pair.shape_b)->user_data == ice;
        if (slippery) pair.friction = 0.02;
    }

    void after_step(World& world, double) override {
        contacts += static_cast<int>(world.events().contacts_began.size());
        for (const BodyId body : world.events().fell_asleep)
            std::printf("%.2f s: body %u comes to rest\n", world.time(), body.index);
    }

    int contacts = 0;
};

BodyId create_crate(World& world, double z) {
    return world
        .create_body({.pose = {.position = {0, 0.25, z}}, .linear_velocity = {4, 0, 0}},
                     {.geometry = Box{{0.25, 0.25, 0.25}}})
        .value();
}

void create_floor(World& world, double z, std::uint64_t surface) {
    world
        .create_body({.type = BodyType::static_body, .pose = {.position = {20, -0.5, z}}},
                     {.geometry = Box{{30, 0.5, 1}}, .user_data = surface})
        .value();
}

}  // namespace

int main() {
    World world;
    create_floor(world, 0, 0);
    create_floor(world, 3, ice);
    const BodyId on_wood = create_crate(world, 0);
    const BodyId on_ice = create_crate(world, 3);

    IceRink rink;
    world.add_listener(rink).expect();
    for (int step = 0; step < 180; step++) world.step(1.0 / 60).expect();

    const double wood = world.body(on_wood)->center.x, slid = world.body(on_ice)->center.x;
    std::printf("%d contacts\n", rink.contacts);
    std::printf("on wood the crate slid %.1f m, on ice %.1f m\n", wood, slid);
    return slid > 4 * wood ? 0 : 1;
}
