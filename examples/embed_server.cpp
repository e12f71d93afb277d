// SPDX-License-Identifier: MIT
//
// Embedded server: runs a Jostle server inside another program, creates a world in it over its own
// API, and shuts it down.
//
// Shows: Config, check, run_server, the port file, WorldClient.
// Run:   build/dev/bin/jostle-embed-server
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "jostle/client/world_client.h"
#include "server/app/server_app.h"
#include "server/config/config.h"
#include "server/util/log.h"

using namespace jostle;

namespace {

// The port of gRPC from a file such as {"grpc": 50051, "http": 8080}; 0 if the server has not
// started within 10 s.
int read_grpc_port(const std::filesystem::path& port_file) {
    for (int k = 0; k < 1000; k++) {
        int port = 0;
        std::ifstream file(port_file);
        std::string line;
        if (std::getline(file, line) && std::sscanf(line.c_str(), "{\"grpc\": %d", &port) == 1)
            return port;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return 0;
}

int use_server(int port) {
    client::WorldClient worlds("127.0.0.1:" + std::to_string(port));
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
    const std::filesystem::path port_file = std::filesystem::temp_directory_path() /
                                            ("jostle-ports-" + std::to_string(getpid()) + ".json");
    server::Config config;
    config.listen = "127.0.0.1:0";  // port 0: any free port
    config.http = "127.0.0.1:0";
    config.admin = "";  // no metrics
    config.scenes = {"sandbox"};
    config.log_level = "warn";
    server::check(config).expect();  // names the setting that is out of range
    server::start_log({.level = config.log_level});

    int status = 1;
    std::thread server([&] { status = server::run_server(config, port_file.string(), "1.0"); });
    const int port = read_grpc_port(port_file);
    const int used = port != 0 ? use_server(port) : 1;
    std::raise(SIGTERM);  // the server disconnects its clients and returns
    server.join();
    server::stop_log();
    std::filesystem::remove(port_file);
    std::printf("the server ended with status %d\n", status);
    return used != 0 ? used : status;
}
