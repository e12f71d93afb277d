// SPDX-License-Identifier: MIT
//
// jostlectl: what an operator does to a running server, from a terminal or a script.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "clients/cpp/cli/security_flags.h"
#include "tools/ctl/commands.h"

namespace {

using jostle::ctl::CommandArguments;
using jostle::ctl::Connection;
using jostle::ctl::ConnectionFlags;
using jostle::ctl::Outcome;

constexpr const char* footer = R"(
Examples:
  jostlectl worlds                                  what runs, and how busy it is
  jostlectl world create arena --scene pyramid      another world
  jostlectl world create arena --file arena.json    ... of a scene file
  jostlectl clients arena                           who is there, for how long, at what rate
  jostlectl kick 17 --reason "please be kind"
  jostlectl pause arena && jostlectl step arena 60 && jostlectl resume arena
  jostlectl export arena arena.json                 as a scene file; "-" writes to the terminal
  jostlectl export arena then.json --at 1234        ... as it was in that tick, where worlds are kept
  jostlectl profile arena arena.trace.json          5 s of ticks, for ui.perfetto.dev
  jostlectl drain                                   the server says goodbye and ends
  jostlectl clients --json | jq '.clients[] | select(.kbitPerSecond > 500)'
  jostlectl --server game.example.org:50051 --ca ca.pem --token-file admin.jwt worlds

Worlds are named by id or name. JOSTLE_SERVER may hold the server's address.
Exit status: 0 done, 1 the server refused or cannot be reached, 2 wrong flags or a file that cannot be read or written.)";

using Command = Outcome (*)(Connection&, const CommandArguments&);

struct Flags {
    ConnectionFlags connection;
    CommandArguments arguments;
    Command command = nullptr;
};

void add_connection_flags(CLI::App& app, Flags& flags) {
    ConnectionFlags& c = flags.connection;
    app.add_option("--server", c.server, "gRPC address of the server, HOST:PORT")
        ->envname("JOSTLE_SERVER")
        ->capture_default_str();
    jostle::client::add_security_flags(app, c.files);
    app.add_flag("--json", flags.arguments.json, "Prints the answer as JSON, for programs");
}

// A subcommand that runs `command`; the app goes on to add its flags.
CLI::App* add(CLI::App& app, Flags& flags, const char* name, const char* help, Command command) {
    CLI::App* const sub = app.add_subcommand(name, help);
    sub->callback([&flags, command] { flags.command = command; });
    return sub;
}

void add_world_argument(CLI::App* sub, Flags& flags) {
    sub->add_option("WORLD", flags.arguments.world, "Id or name of the world")->required();
}

void add_world_commands(CLI::App& app, Flags& flags) {
    namespace ctl = jostle::ctl;
    CommandArguments& w = flags.arguments;
    add(app, flags, "worlds", "Lists the worlds", ctl::list_worlds);
    CLI::App* const world = app.add_subcommand("world", "Creates and deletes worlds");
    world->require_subcommand(1);
    CLI::App* const create = add(*world, flags, "create", "Creates a world", ctl::create_world);
    create->add_option("NAME", w.name, "Its name; the scene's when not given");
    auto* const scene = create->add_option("--scene", w.scene, "A scene of the server's catalogue");
    auto* const file = create->add_option("--file", w.file, "A scene file; - reads standard input");
    auto* const from =
        create->add_option("--from", w.from, "A world that the server keeps, as it was at --at");
    auto* const at =
        create->add_option("--at", w.tick, "The tick after which that was")->needs(from);
    from->needs(at);
    scene->excludes(file)->excludes(from);
    file->excludes(from);
    create->callback([&flags, scene, file, from] {
        if (scene->count() + file->count() + from->count() == 0)
            throw CLI::RequiredError(
                "world create: --scene NAME, --file FILE, or --from WORLD --at TICK");
        if (from->count() != 0 && flags.arguments.name.empty())
            throw CLI::RequiredError("world create --from: NAME");
        flags.command = ctl::create_world;
    });
    add_world_argument(
        add(*world, flags, "delete", "Deletes a world; its clients are told", ctl::delete_world),
        flags);
    for (const auto& [name, help, command] :
         {std::tuple("pause", "Lets a world stand still", &ctl::pause),
          std::tuple("resume", "Lets a paused world go on", &ctl::resume)}) {
        CLI::App* const sub = add(app, flags, name, help, command);
        add_world_argument(sub, flags);
        if (command == &ctl::pause)
            sub->add_option("--reason", w.reason, "Told to who sends inputs, at most 100 bytes");
    }
    CLI::App* const rewind =
        add(app, flags, "rewind", "Takes a world back to an earlier tick; its clients come along",
            ctl::rewind);
    add_world_argument(rewind, flags);
    rewind
        ->add_option("--to", w.tick,
                     "The tick; worlds --json has oldest_restorable_tick, the first")
        ->required();
    CLI::App* const step = add(app, flags, "step", "Steps a paused world", ctl::step);
    add_world_argument(step, flags);
    step->add_option("STEPS", w.steps, "How many, 1 to 1000")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    CLI::App* const exported =
        add(app, flags, "export", "Writes a world as a scene file", ctl::export_world);
    add_world_argument(exported, flags);
    exported->add_option("FILE", w.file, "Where to; - is the terminal")->required();
    exported->add_option("--at", w.tick, "As it was after this tick, if the server keeps it");
    CLI::App* const profile =
        add(app, flags, "profile", "Records where the time of a world's ticks goes", ctl::profile);
    add_world_argument(profile, flags);
    profile->add_option("FILE", w.file, "Where to write the trace; - is the terminal")->required();
    profile->add_option("--seconds", w.seconds, "For how long, 1 to 30")
        ->check(CLI::Range(1.0, 30.0))
        ->capture_default_str();
}

void add_client_commands(CLI::App& app, Flags& flags) {
    CommandArguments& w = flags.arguments;
    add(app, flags, "clients", "Lists who is connected", jostle::ctl::list_clients)
        ->add_option("WORLD", w.world, "Of this world alone, by id or name");
    CLI::App* const kick =
        add(app, flags, "kick", "Sends a client away; it may come back", jostle::ctl::kick);
    kick->add_option("CLIENT", w.client, "Its id, as clients lists it")->required();
    kick->add_option("--reason", w.reason, "Told to the client, at most 100 bytes");
    add(app, flags, "drain", "Has the server say goodbye and end", jostle::ctl::drain);
}

int run(Flags& flags) {
    const auto fail = [](int status, const std::string& message) {
        std::fprintf(stderr, "jostlectl: %s\n", message.c_str());
        return status;
    };
    auto connection = Connection::open(flags.connection);
    if (!connection.ok()) return fail(2, connection.error().message);
    const Outcome outcome = flags.command(*connection, flags.arguments);
    std::fputs(outcome.text.c_str(), stdout);
    if (outcome.error.empty()) return 0;
    return fail(outcome.is_usage_error ? 2 : 1, outcome.error);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Looks after a running jostle-server."};
    Flags flags;
    app.fallthrough();  // flags of all commands may stand after the command, too
    add_connection_flags(app, flags);
    add_world_commands(app, flags);
    add_client_commands(app, flags);
    app.require_subcommand(1);
    app.set_version_flag("--version", "jostlectl " JOSTLE_VERSION);
    app.footer(footer);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    return run(flags);
}
