// SPDX-License-Identifier: MIT
//
// A server without threads and sockets: a world that stands still until it is told to tick, and all
// that a conversation or a question needs. Made anew for each input.
#pragma once

#include <spdlog/spdlog.h>

#include "jostle/scenes/scene.h"
#include "server/services/query_control.h"
#include "server/services/world_control.h"
#include "server/session/play_context.h"
#include "tests/support/small_scene.h"

namespace jostle::fuzz {

struct SmallServer {
    SmallServer() {
        spdlog::set_level(spdlog::level::off);
        worlds.create("", scene()).value();
    }

    server::Config config = [] {
        server::Config c;
        c.world.worlds_max = 2;
        c.world.bodies_max = 16;
        c.client.bodies_owned_max = 6;
        c.quota.query_share = 0;  // depends on measured times
        return c;
    }();
    server::Authorizer& authorizer = open_gate();
    server::SessionDirectory sessions{2};
    server::WorldDirectory worlds{
        {.limits = {.scene = {.bodies_max = config.world.bodies_max, .first_step_seconds_max = 100},
                    .bodies_owned_max = config.client.bodies_owned_max},
         .command_queue_max = 256,
         .own_ticks = false},
        config.world.worlds_max};
    server::PlayContext context{
        .config = config, .worlds = worlds, .sessions = sessions, .authorizer = authorizer};

    server::Identity anybody() { return authorizer.identify({.address = "127.0.0.1"}).value(); }

private:
    // One for all inputs, because its log has a thread: everybody may do everything, as often as
    // he likes.
    static server::Authorizer& open_gate() {
        static const std::unique_ptr<server::Authorizer> authorizer = [] {
            server::Config c;
            c.auth.anonymous_role = "admin";
            c.auth.audit_log = "/dev/null";
            for (double* rate : {&c.quota.creates_per_minute, &c.quota.joins_per_minute,
                                 &c.quota.queries_per_second})
                *rate = 1e9;
            return server::Authorizer::open(c).value();
        }();
        return *authorizer;
    }
    static const scenes::SceneDescription& scene() {
        static const scenes::SceneDescription scene = test::small_scene();
        return scene;
    }
};

}  // namespace jostle::fuzz
