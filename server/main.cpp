// SPDX-License-Identifier: MIT
//
// jostle-server: flags over the config file over the defaults, then run.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <optional>

#include "jostle/scenes/catalog.h"
#include "server/app/health_probe.h"
#include "server/app/server_app.h"
#include "server/config/config_loader.h"
#include "server/config/exposure.h"
#include "server/util/log.h"

namespace {

constexpr const char* examples = R"(
Examples:
  jostle-server                                   the sandbox; viewer at http://localhost:8080
  jostle-server --scene pyramid --scene my.json   two worlds, one from a scene file
  jostle-server --scene a=pyramid --scene b=pyramid
  jostle-server --config server.toml --log-level debug --set world.worlds_max=4
  jostle-server --config server.toml --health     exits with 0 when that server serves

SIGTERM or Ctrl-C tells clients goodbye and exits with 0; a second one exits at once.
A flag wins over its environment variable, and that over the config file.
Exit status: 0 in order, 1 could not start, 2 wrong flags or config.)";

struct Flags {
    std::vector<std::string> scenes, settings;
    std::string listen, http, config, web_root, log_level, port_file;
    std::optional<std::string> admin, datagrams;
    bool list_scenes = false, insecure = false, health = false;
};

void add_flags(CLI::App& app, Flags& flags) {
    app.add_option("--scene", flags.scenes,
                   "World to host: a scene's name or a scene file, with NAME= before it for a name "
                   "of its own; may be given several times");
    app.add_option("--listen", flags.listen, "Address of gRPC, HOST:PORT; port 0 takes a free one")
        ->envname("JOSTLE_LISTEN");
    app.add_option("--http", flags.http, "Address of viewer and WebSocket, HOST:PORT")
        ->envname("JOSTLE_HTTP");
    app.add_option("--admin", flags.admin,
                   "Address of metrics and profiles, HOST:PORT; \"\" for none")
        ->envname("JOSTLE_ADMIN");
    app.add_option("--datagrams", flags.datagrams,
                   "Address of datagrams (UDP), HOST:PORT, for clients that ask for them; none "
                   "unless given")
        ->envname("JOSTLE_DATAGRAMS");
    app.add_option("--config", flags.config, "TOML file; docs/operations.md lists its settings")
        ->envname("JOSTLE_CONFIG");
    app.add_option("--set", flags.settings,
                   "A setting of the config file, KEY=VALUE, as in client.bodies_owned_max=10");
    app.add_option("--web-root", flags.web_root, "Folder of the built viewer");
    app.add_option("--log-level", flags.log_level, "trace, debug, info, warn or error")
        ->envname("JOSTLE_LOG_LEVEL");
    app.add_option("--port-file", flags.port_file, "Writes the real ports here as JSON");
    app.add_flag("--insecure", flags.insecure,
                 "Lets strangers in: listens beyond this machine without TLS and tokens");
    app.add_flag("--list-scenes", flags.list_scenes,
                 "Names every scene of the catalogue and exits");
    app.add_flag("--health", flags.health,
                 "Asks the server at --listen and --http whether it serves, says so and exits "
                 "with 0, or with 1 if not");
    app.set_version_flag("--version", "jostle-server " JOSTLE_VERSION);
    app.footer(examples);
}

// A flag that was given replaces what the file said.
void apply_flags(jostle::server::Config& config, const Flags& flags) {
    const auto take = [](std::string& setting, const std::string& flag) {
        if (!flag.empty()) setting = flag;
    };
    if (!flags.scenes.empty()) config.scenes = flags.scenes;
    if (flags.insecure) config.insecure = true;
    take(config.listen, flags.listen);
    take(config.http, flags.http);
    if (flags.admin) config.admin = *flags.admin;
    if (flags.datagrams) config.datagrams.listen = *flags.datagrams;
    take(config.web_root, flags.web_root);
    take(config.log_level, flags.log_level);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Hosts physics worlds and streams them to players, bots and browsers."};
    Flags flags;
    add_flags(app, flags);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
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
    // A probe lets nobody in; its flags need not be all of the server's.
    if (checked.ok() && !flags.health) checked = jostle::server::check_exposure(config);
    if (!checked.ok()) {
        std::fprintf(stderr, "jostle-server: %s\n", checked.error().message.c_str());
        return 2;
    }
    if (flags.health) return jostle::server::run_health_probe(config);
    jostle::server::start_log({.level = config.log_level, .json = config.log_format == "json"});
    const int status = jostle::server::run_server(config, flags.port_file, JOSTLE_VERSION);
    jostle::server::stop_log();
    return status;
}
