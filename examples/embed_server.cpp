// SPDX-License-Identifier: MIT
//
// Embedded server: runs a Jostle server inside another program, creates a world in it over its own
// API, and stops it.
//
// Shows: Config, check, ServerApp, WorldClient.
// Run:   build/dev/bin/jostle-embed-server
#include <cstdio>
#include <string>
#include <thread>

#include "jostle/client/world_client.h"
#include "server/app/server_app.h"
#include "server/config/config.h"
#include "server/util/log.h"

using namespace jostle;

namespace {

int create_and_list_worlds(int grpc_port) {
    client::WorldClient worlds("127.0.0.1:" + std::to_string(grpc_port));
    v1::CreateWorldRequest request;
    request.set_name("arena");
    request.set_scene_name("stack");
    if (const auto created = worlds.create(request); !created.ok()) {
        std::fprintf(stderr, "cannot create a world: %s\n", created.error().message.c_str());
        return 1;
    }
    const auto list = worlds.list();
    if (!list.ok()) return 1;
    for (const v1::WorldInfo& world : list->worlds())
        std::printf("world %s runs scene %s with %u bodies\n", world.name().c_str(),
                    world.scene().c_str(), world.bodies());
    return list->worlds_size() == 2 ? 0 : 1;
}

}  // namespace

int main() {
    server::Config config;
    config.listen = "127.0.0.1:0";  // port 0: any free port
    config.http = "127.0.0.1:0";
    config.admin = "";  // no metrics
    config.scenes = {"sandbox"};
    config.log_level = "warn";
    server::check(config).expect();  // names the setting that is out of range
    server::start_log({.level = config.log_level});

    auto app = server::ServerApp::start(config, {.version = "1.0", .handle_signals = false});
    if (!app.ok()) {
        std::fprintf(stderr, "cannot start: %s\n", app.error().message.c_str());
        return 1;
    }
    int status = 1;
    std::thread user([&] {
        status = create_and_list_worlds((*app)->ports().grpc);
        (*app)->drain();  // disconnects the clients and makes run() return
    });
    (*app)->run();  // start(), run() and stop() belong to one thread
    user.join();
    (*app)->stop();
    server::stop_log();
    std::printf("the server has stopped\n");
    return status;
}
