// SPDX-License-Identifier: MIT
//
// Bot: three players that tidy up. Each looks for the loose body that is farthest from the middle
// of the world and pushes it towards the middle.
//
// Shows: many clients on one Loop, WorldView, entities, client statistics.
// Run:   build/dev/bin/jostle-server &
//        build/dev/bin/jostle-example-bot localhost:50051 10     10 seconds
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "jostle/client/client.h"

using namespace jostle;

namespace {

class Bot {
public:
    Bot(client::Loop& loop, const std::string& target, const std::string& name)
        : client_(client::Client::connect(loop, {.target = target, .name = name})) {}

    // Decides on the newest snapshot and sends at most one input.
    void think() {
        std::uint32_t farthest = 0;
        double distance = 2, mass = 0;  // m; bodies within 2 m stay there
        snapshot::Pose at;
        client_->read([&](const client::WorldView& world) {
            for (const auto& [id, entity] : world.entities()) {
                const auto pose = world.pose_of(id);
                if (entity.type() != v1::BODY_TYPE_DYNAMIC || !pose) continue;
                const double r = std::hypot(pose->position[0], pose->position[2]);
                if (r <= distance) continue;
                farthest = id, distance = r, mass = entity.mass(), at = *pose;
            }
        });
        if (farthest == 0) return;
        v1::Input input;
        input.mutable_impulse()->set_entity(farthest);
        v1::Vec3& impulse = *input.mutable_impulse()->mutable_impulse();  // N s, for 2 m/s
        impulse.set_x(-2 * mass * at.position[0] / distance);
        impulse.set_z(-2 * mass * at.position[2] / distance);
        client_->send(std::move(input));
    }

    client::Client& client() { return *client_; }

private:
    std::shared_ptr<client::Client> client_;
};

}  // namespace

int main(int argc, char** argv) {
    const std::string target = argc > 1 ? argv[1] : "localhost:50051";
    const double seconds = argc > 2 ? std::atof(argv[2]) : 5;
    client::Loop loop;
    std::vector<std::unique_ptr<Bot>> bots;
    for (int k = 1; k <= 3; k++)
        bots.push_back(std::make_unique<Bot>(loop, target, "tidy " + std::to_string(k)));

    const auto end = client::Clock::now() + std::chrono::duration<double>(seconds);
    while (client::Clock::now() < end) {
        for (const auto& bot : bots) bot->think();
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }

    bool played = true;
    for (const auto& bot : bots) {
        const client::ClientStats stats = bot->client().stats();
        std::printf("client %u: %llu snapshots, %llu pushes applied, %llu rejected\n",
                    stats.client_id, static_cast<unsigned long long>(stats.snapshots),
                    static_cast<unsigned long long>(stats.inputs_applied),
                    static_cast<unsigned long long>(stats.inputs_refused));
        played = played && stats.inputs_applied > 0 && stats.decode_errors == 0;
        bot->client().leave();
    }
    std::printf("%s\n", played ? "every bot pushed something" : "a bot did nothing");
    return played ? 0 : 1;
}
