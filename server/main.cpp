// SPDX-License-Identifier: MIT
//
// jostle-server: applies defaults, config file and flags in this order, then runs the server.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <optional>

#include "base/command_line/command_line.h"
#include "jostle/scenes/catalog.h"
#include "server/app/health_probe.h"
#include "server/app/server_app.h"
#include "server/app/start_guard.h"
#include "server/config/config_loader.h"
#include "server/config/exposure.h"
#include "server/util/log.h"

namespace {

constexpr const char* examples = R"(
Examples:
  jostle-server                                   host the sandbox; viewer at http://localhost:8080
  jostle-server --scene pyramid --scene my.json   host two worlds, one from a scene file
  jostle-server --scene a=pyramid --scene b=pyramid
  jostle-server --config server.toml --log-level debug --set world.worlds_max=4
  jostle-server --config server.toml --health     check a running server with these settings

SIGTERM or Ctrl-C notifies clients, then exits with status 0; a second signal exits at once.
A flag overrides its environment variable; the variable overrides the config file.
Exit status: 0 success, 1 start failed, 2 invalid flags or config, 3 shutdown timed out.)";

struct Flags {
    std::vector<std::string> scenes, settings;
    std::string listen, http, config, web_root, log_level, port_file;
    std::optional<std::string> admin, datagrams;
    bool list_scenes = false, insecure = false, health = false, accept_damage = false;
};

void add_flags(CLI::App& app, Flags& flags) {
    app.add_option(
           "--scene", flags.scenes,
           "Host a world from a catalogue scene or a scene file; repeatable\n[default: sandbox]")
        ->type_name("[NAME=]SCENE")
        ->group("Worlds");
    app.add_flag("--list-scenes", flags.list_scenes, "Print the scene catalogue and exit")
        ->group("Worlds");
    app.add_option("--listen", flags.listen,
                   "Listen for gRPC; port 0 selects a free port\n[default: 127.0.0.1:50051]")
        ->type_name("HOST:PORT")
        ->envname("JOSTLE_LISTEN")
        ->group("Network");
    app.add_option("--http", flags.http,
                   "Listen for the viewer and WebSocket clients\n[default: 127.0.0.1:8080]")
        ->type_name("HOST:PORT")
        ->envname("JOSTLE_HTTP")
        ->group("Network");
    app.add_option("--admin", flags.admin,
                   "Listen for metrics and profiles; \"\" disables\n[default: 127.0.0.1:9464]")
        ->type_name("HOST:PORT")
        ->envname("JOSTLE_ADMIN")
        ->group("Network");
    app.add_option("--datagrams", flags.datagrams,
                   "Listen for UDP datagrams of clients that request them\n[default: disabled]")
        ->type_name("HOST:PORT")
        ->envname("JOSTLE_DATAGRAMS")
        ->group("Network");
    app.add_option("--port-file", flags.port_file, "Write the bound ports to FILE as JSON")
        ->type_name("FILE")
        ->group("Network");
    app.add_flag("--insecure", flags.insecure,
                 "Allow non-loopback listeners without TLS and authentication")
        ->group("Network");
    app.add_option("--config", flags.config,
                   "Read settings from a TOML file (docs/reference/configuration.md)")
        ->type_name("FILE")
        ->envname("JOSTLE_CONFIG")
        ->group("Settings");
    app.add_option("--set", flags.settings,
                   "Override a setting, such as client.bodies_owned_max=10; repeatable")
        ->type_name("KEY=VALUE")
        ->group("Settings");
    app.add_option("--web-root", flags.web_root,
                   "Serve the viewer from DIR [default: clients/web/dist]")
        ->type_name("DIR")
        ->group("Settings");
    app.add_option("--log-level", flags.log_level,
                   "Log at LEVEL: trace, debug, info, warn or error [default: info]")
        ->type_name("LEVEL")
        ->envname("JOSTLE_LOG_LEVEL")
        ->group("Settings");
    app.add_flag("--accept-damage", flags.accept_damage,
                 "Continue with what can be read of a damaged database, after copying its files")
        ->group("Settings");
    app.add_flag("--health", flags.health,
                 "Check the server at --listen and --http; exit with 0 if it serves, else 1");
    app.footer(examples);
}

// A given flag overrides the value from the config file.
void apply_flags(jostle::server::Config& config, const Flags& flags) {
    const auto take = [](std::string& setting, const std::string& flag) {
        if (!flag.empty()) setting = flag;
    };
    if (!flags.scenes.empty()) config.scenes = flags.scenes;
    if (flags.insecure) config.insecure = true;
    if (flags.accept_damage) config.persistence.accept_damage = true;
    take(config.listen, flags.listen);
    take(config.http, flags.http);
    if (flags.admin) config.admin = *flags.admin;
    if (flags.datagrams) config.datagrams.listen = *flags.datagrams;
    take(config.web_root, flags.web_root);
    take(config.log_level, flags.log_level);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Host physics worlds and stream them to players, bots and browsers."};
    Flags flags;
    add_flags(app, flags);
    if (const auto status =
            jostle::parse_command_line(app, {"jostle-server", JOSTLE_VERSION}, argc, argv))
        return *status;
    if (flags.list_scenes) {
        for (const auto& scene : jostle::scenes::catalog())
            std::printf("%-12.*s %.*s\n", static_cast<int>(scene.name.size()), scene.name.data(),
                        static_cast<int>(scene.description.size()), scene.description.data());
        return 0;
    }
    jostle::server::Config config;
    if (!flags.config.empty()) {
        if (const auto loaded = jostle::server::load_config(config, flags.config); !loaded.ok()) {
            std::fprintf(stderr, "jostle-server: %s\n", loaded.error().message.c_str());
            return 2;
        }
    }
    if (const auto set = jostle::server::load_settings(config, flags.settings); !set.ok()) {
        std::fprintf(stderr, "jostle-server: %s\n", set.error().message.c_str());
        return 2;
    }
    apply_flags(config, flags);
    jostle::Status checked = jostle::server::check(config);
    // A health probe does not listen, and it need not be given all flags of the server.
    if (checked.ok() && !flags.health) checked = jostle::server::check_exposure(config);
    if (!checked.ok()) {
        std::fprintf(stderr, "jostle-server: %s\n", checked.error().message.c_str());
        return 2;
    }
    if (flags.health) return jostle::server::run_health_probe(config);
    jostle::server::begin_start_guard();
    jostle::server::start_log({.level = config.log_level, .json = config.log_format == "json"});
    const int status = jostle::server::run_server(config, flags.port_file, JOSTLE_VERSION);
    jostle::server::stop_log();
    return status;
}
