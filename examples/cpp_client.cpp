// SPDX-License-Identifier: MIT
//
// C++ client: joins a world, spawns a ball, pushes it, and prints the smooth poses that a renderer
// would draw.
//
// Shows: Loop, Client, ClientOptions, inputs and their results, WorldView, interpolated().
// Run:   build/dev/bin/jostle-server &
//        build/dev/bin/jostle-cpp-client localhost:50051
#include <chrono>
#include <cstdio>
#include <functional>
#include <thread>

#include "jostle/client/client.h"

using namespace jostle;

namespace {

void sleep_ms(int ms) {
    std::this_thread::sleep_for(std::chrono::milliseconds(ms));
}

bool wait_until(const std::function<bool()>& condition) {
    for (int k = 0; k < 500 && !condition(); k++) sleep_ms(10);
    return condition();
}

v1::Input spawn_ball(double x, double y, double z) {
    v1::Input input;
    v1::SpawnInput& spawn = *input.mutable_spawn();
    spawn.mutable_shape()->mutable_sphere()->set_radius(0.3);
    spawn.mutable_position()->set_x(x);
    spawn.mutable_position()->set_y(y);
    spawn.mutable_position()->set_z(z);
    return input;
}

v1::Input push(std::uint32_t entity, double impulse_x) {
    v1::Input input;
    input.mutable_impulse()->set_entity(entity);
    input.mutable_impulse()->mutable_impulse()->set_x(impulse_x);  // N s
    return input;
}

// The result of the next input that the server has handled.
v1::InputResult next_result(client::Client& me) {
    v1::InputResult result;
    wait_until([&] {
        const auto results = me.take_results();
        if (!results.empty()) result = results.front();
        return result.sequence() != 0;
    });
    return result;
}

}  // namespace

int main(int argc, char** argv) {
    client::Loop loop;  // one network thread, for any number of clients
    const auto me = client::Client::connect(
        loop, {.target = argc > 1 ? argv[1] : "localhost:50051", .name = "example"});
    if (!wait_until([&] { return me->stats().connected; })) {
        std::fprintf(stderr, "cannot join: %s\n", me->stats().last_error.c_str());
        return 1;
    }
    std::printf("joined as client %u\n", me->stats().client_id);

    me->send(spawn_ball(0, 1, 6.8));
    const v1::InputResult spawned = next_result(*me);
    if (spawned.code() != v1::INPUT_CODE_APPLIED) {
        std::fprintf(stderr, "cannot spawn: %s\n", spawned.message().c_str());
        return 1;
    }
    const std::uint32_t ball = spawned.entity();
    double mass = 0;  // kg; entities arrive with the snapshots
    wait_until([&] {
        me->read([&](const client::WorldView& world) {
            if (const auto found = world.entities().find(ball); found != world.entities().end())
                mass = found->second.mass();
        });
        return mass > 0;
    });
    std::printf("spawned a ball of %.0f kg as entity %u\n", mass, ball);

    me->send(push(ball, 3 * mass));  // 3 m/s
    double start = 0, x = 0;
    for (int frame = 0; frame < 90; frame++) {  // a render loop of 1.5 s
        for (const client::SmoothPose& pose : me->interpolated(client::Clock::now())) {
            if (pose.entity != ball) continue;
            x = pose.pose.position[0];
            if (frame == 0) start = x;
            if (frame % 30 == 29) std::printf("  x = %.2f m\n", x);
        }
        sleep_ms(16);
    }
    me->leave();
    std::printf("the ball moved %s\n", x - start > 1 ? "more than 1 m" : "less than 1 m");
    return x - start > 1 ? 0 : 1;
}
