// SPDX-License-Identifier: MIT
//
// jostlectl: administration of a running server, from a terminal or a script.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "base/command_line/command_line.h"
#include "clients/cpp/cli/security_flags.h"
#include "tools/ctl/build_commands.h"
#include "tools/ctl/commands.h"
#include "tools/ctl/room_commands.h"

namespace {

using jostle::ctl::CommandArguments;
using jostle::ctl::Connection;
using jostle::ctl::ConnectionFlags;
using jostle::ctl::Outcome;

constexpr const char* footer = R"(
Examples:
  jostlectl worlds                                  list worlds and their load
  jostlectl world create arena --scene pyramid      create a world from a catalogue scene
  jostlectl world create arena --file arena.json    create a world from a scene file
  jostlectl clients arena                           list clients, connection times and data rates
  jostlectl kick 17 --reason "please be kind"
  jostlectl ban --subject eve --hours 24 --reason "spamming"
  jostlectl ban --network 2001:db8::/48             ban a network; see also bans, unban
  jostlectl pause arena && jostlectl step arena 60 && jostlectl resume arena
  jostlectl export arena arena.json                 write a scene file; "-" is standard output
  jostlectl export arena then.json --at 1234        export an earlier tick of a persisted world
  jostlectl profile arena arena.trace.json          record 5 s of ticks for ui.perfetto.dev
  jostlectl world create track --template race      create a room; "worlds --json" lists templates
  jostlectl room show track                         list its members, bans and protected areas
  jostlectl room role track 17 builder
  jostlectl room speed track 25                     slow motion; see also room step, room rewind
  jostlectl inspect yard 12                         mass, contacts and joints of entity 12
  jostlectl edit yard 12 --position 0 5 0 --mass 20
  jostlectl joint create yard hinge 0 12 --at 0 2 0 --axis 0 1 0
  jostlectl reports                                 list what players reported about others
  jostlectl undo yard 17 --seconds 30               undo what client 17 did in the last 30 s
  jostlectl players arena                           list players, their roles and pings
  jostlectl say arena "the match starts"            send a message to all players
  jostlectl set-attribute arena player:17 score 12  clients cannot change it; see also attributes
  jostlectl backup worlds.backup                    download a backup while the worlds run
  jostlectl verify worlds.backup && jostlectl restore worlds.backup worlds.db
  jostlectl drain                                   notify clients, then stop the server
  jostlectl clients --json | jq '.clients[] | select(.kbitPerSecond > 500)'
  jostlectl --server game.example.org:50051 --ca ca.pem --token-file admin.jwt worlds

WORLD is the id or the name of a world.
Exit status: 0 success, 1 the server rejected the call or is unreachable, 2 invalid flags, or a file
cannot be read or written.)";

using Command = Outcome (*)(Connection&, const CommandArguments&);

struct Flags {
    ConnectionFlags connection;
    CommandArguments arguments;
    Command command = nullptr;
    Outcome (*local_command)(const CommandArguments& arguments) = nullptr;
};

void add_connection_flags(CLI::App& app, Flags& flags) {
    ConnectionFlags& c = flags.connection;
    app.add_option("--server", c.server, "Connect to this gRPC server [default: 127.0.0.1:50051]")
        ->type_name("HOST:PORT")
        ->envname("JOSTLE_SERVER");
    jostle::client::add_security_flags(app, c.files);
    app.add_flag("--json", flags.arguments.json, "Print the response as JSON");
}

// Adds a subcommand that runs `command`; the caller adds its flags.
CLI::App* add(CLI::App& app, Flags& flags, const char* name, const char* help, Command command) {
    CLI::App* const sub = app.add_subcommand(name, help);
    sub->callback([&flags, command] { flags.command = command; });
    return sub;
}

void add_world_argument(CLI::App* sub, Flags& flags) {
    sub->add_option("WORLD", flags.arguments.world, "Id or name of the world")
        ->type_name("")
        ->required();
}

void add_world_commands(CLI::App& app, Flags& flags) {
    namespace ctl = jostle::ctl;
    CommandArguments& w = flags.arguments;
    CLI::App* const worlds = add(app, flags, "worlds", "List the worlds", ctl::list_worlds);
    worlds
        ->add_option("--tags", w.tags, "List rooms with all of these tags only, such as race,cars")
        ->type_name("TAGS");
    worlds
        ->add_option("--text", w.words, "List worlds with TEXT in name, title or description only")
        ->type_name("TEXT");
    worlds->add_flag("--not-full", w.not_full, "List rooms with a free place only");
    worlds->add_flag("--public", w.is_public, "List rooms without a join code only");
    CLI::App* const world = app.add_subcommand("world", "Create or delete a world");
    world->require_subcommand(1);
    CLI::App* const create = add(*world, flags, "create", "Create a world", ctl::create_world);
    create->add_option("NAME", w.name, "Name of the world [default: the name of the scene]")
        ->type_name("");
    auto* const scene =
        create->add_option("--scene", w.scene, "Use a scene of the server's catalogue")
            ->type_name("SCENE");
    auto* const file =
        create->add_option("--file", w.file, "Read a scene file; \"-\" reads standard input")
            ->type_name("FILE");
    auto* const room_template =
        create->add_option("--template", w.room_template, "Use a room template of the server")
            ->type_name("TEMPLATE");
    create
        ->add_option("--room", w.room,
                     "Make the world a room with the settings in this JSON file; \"-\" reads "
                     "standard input")
        ->type_name("FILE");
    auto* const from =
        create->add_option("--from", w.from, "Copy a persisted world as it was after the tick --at")
            ->type_name("WORLD");
    auto* const at =
        create->add_option("--at", w.tick, "Tick of --from")->type_name("TICK")->needs(from);
    from->needs(at);
    scene->excludes(file)->excludes(from)->excludes(room_template);
    file->excludes(from)->excludes(room_template);
    room_template->excludes(from);
    create->callback([&flags, scene, file, from, room_template] {
        if (scene->count() + file->count() + from->count() + room_template->count() == 0)
            throw CLI::RequiredError(
                "world create: --scene NAME, --template NAME, --file FILE, or --from WORLD --at "
                "TICK");
        if (from->count() != 0 && flags.arguments.name.empty())
            throw CLI::RequiredError("world create --from: NAME");
        flags.command = ctl::create_world;
    });
    add_world_argument(add(*world, flags, "delete", "Delete a world and disconnect its clients",
                           ctl::delete_world),
                       flags);
    for (const auto& [name, help, command] :
         {std::tuple("pause", "Pause a world", &ctl::pause),
          std::tuple("resume", "Resume a paused world", &ctl::resume)}) {
        CLI::App* const sub = add(app, flags, name, help, command);
        add_world_argument(sub, flags);
        if (command == &ctl::pause)
            sub->add_option("--reason", w.reason,
                            "Send TEXT to clients whose inputs are rejected [at most 100 bytes]")
                ->type_name("TEXT");
    }
    CLI::App* const rewind =
        add(app, flags, "rewind", "Restore a persisted world to an earlier tick", ctl::rewind);
    add_world_argument(rewind, flags);
    rewind
        ->add_option("--to", w.tick,
                     "Tick to restore; \"worlds --json\" shows oldest_restorable_tick")
        ->type_name("TICK")
        ->required();
    CLI::App* const step = add(app, flags, "step", "Step a paused world", ctl::step);
    add_world_argument(step, flags);
    step->add_option("STEPS", w.steps, "Number of steps [default: 1; 1 to 1000]")
        ->type_name("")
        ->check(CLI::Range(1, 1000).description(""));
    CLI::App* const exported =
        add(app, flags, "export", "Write a world as a scene file", ctl::export_world);
    add_world_argument(exported, flags);
    exported->add_option("FILE", w.file, "Scene file to write; \"-\" is standard output")
        ->type_name("")
        ->required();
    exported
        ->add_option("--at", w.tick, "Export a persisted world as it was after TICK [default: now]")
        ->type_name("TICK");
    CLI::App* const profile =
        add(app, flags, "profile", "Record where the ticks of a world spend time", ctl::profile);
    add_world_argument(profile, flags);
    profile->add_option("FILE", w.file, "Trace file to write; \"-\" is standard output")
        ->type_name("")
        ->required();
    profile->add_option("--seconds", w.seconds, "Record for this time [default: 5; 1 to 30]")
        ->type_name("SECONDS")
        ->check(CLI::Range(1.0, 30.0).description(""));
}

// Players, attributes and messages of a world.
void add_data_commands(CLI::App& app, Flags& flags) {
    namespace ctl = jostle::ctl;
    CommandArguments& w = flags.arguments;
    add_world_argument(add(app, flags, "players", "List the players of a world", ctl::list_players),
                       flags);
    CLI::App* const role =
        add(app, flags, "role", "Change the role of a player in its world", ctl::set_role);
    add_world_argument(role, flags);
    role->add_option("CLIENT", w.client, "Id of the player, as listed by \"players\"")
        ->type_name("")
        ->required();
    role->add_option("ROLE", w.role, "spectator, player, builder or owner")
        ->type_name("")
        ->required();
    CLI::App* const get =
        add(app, flags, "attributes", "List attributes of a world, its players and its entities",
            ctl::get_attributes);
    add_world_argument(get, flags);
    get->add_option("TARGET", w.target,
                    "world, player:CLIENT or entity:ENTITY [default: all targets]")
        ->type_name("");
    get->callback([&flags, get] {
        if (get->get_option("TARGET")->count() == 0) flags.arguments.target.clear();
        flags.command = ctl::get_attributes;
    });
    CLI::App* const set = add(app, flags, "set-attribute",
                              "Set an attribute; clients cannot change it", ctl::set_attribute);
    add_world_argument(set, flags);
    set->add_option("TARGET", w.target, "world, player:CLIENT or entity:ENTITY")
        ->type_name("")
        ->required();
    set->add_option("KEY", w.key, "1 to 32 of the characters a-z, 0-9, _ and .")
        ->type_name("")
        ->required();
    auto* const value =
        set->add_option("VALUE", w.value,
                        "true, false, an integer, a number, a vector such as 1,2,3, or a text")
            ->type_name("");
    set->add_flag("--text", w.is_text, "Set VALUE as a text, whatever it looks like");
    auto* const removes = set->add_flag("--remove", w.removes, "Remove the attribute");
    set->add_option("--visibility", w.visibility,
                    "Clients that receive it: everyone, owner, or roles:ROLE,ROLE [default: "
                    "everyone]")
        ->type_name("WHO");
    set->callback([&flags, value, removes] {
        if (value->count() + removes->count() != 1)
            throw CLI::RequiredError("set-attribute: either VALUE or --remove");
        flags.command = ctl::set_attribute;
    });
    CLI::App* const say =
        add(app, flags, "say", "Send a user message as the server", ctl::send_message);
    add_world_argument(say, flags);
    say->add_option("TEXT", w.text, "Data of the message")->type_name("")->required();
    say->add_option("--topic", w.topic, "Topic of the message [default: chat]")->type_name("TOPIC");
    say->add_option("--to", w.recipients, "Send it to this client only; repeatable")
        ->type_name("CLIENT");
}

// Bodies and joints of a world.
void add_build_commands(CLI::App& app, Flags& flags) {
    namespace ctl = jostle::ctl;
    CommandArguments& w = flags.arguments;
    CLI::App* const inspect =
        add(app, flags, "inspect", "Show the complete state of an entity or a joint", ctl::inspect);
    add_world_argument(inspect, flags);
    auto* const entity = inspect->add_option("ENTITY", w.entity, "Id of the entity")
                             ->type_name("")
                             ->check(CLI::PositiveNumber.description(""));
    auto* const joint = inspect->add_option("--joint", w.joint, "Show this joint instead")
                            ->type_name("JOINT")
                            ->check(CLI::PositiveNumber.description(""));
    inspect->callback([&flags, entity, joint] {
        if (entity->count() + joint->count() != 1)
            throw CLI::RequiredError("inspect: either ENTITY or --joint JOINT");
        flags.command = ctl::inspect;
    });
    inspect->footer("Example: jostlectl inspect yard 12 --json");

    CLI::App* const edit =
        add(app, flags, "edit", "Change properties of a dynamic or frozen body", ctl::edit);
    add_world_argument(edit, flags);
    edit->add_option("ENTITY", w.entity, "Id of the entity")->type_name("")->required();
    const auto vector = [&](const char* name, std::vector<double>& to, const char* help) {
        edit->add_option(name, to, help)->option_text("X Y Z")->expected(3);
    };
    const auto number = [&](const char* name, std::optional<double>& to, const char* help) {
        edit->add_option(name, to, help)->type_name("NUMBER");
    };
    vector("--position", w.position, "Position, m [each within 10000]");
    edit->add_option("--rotation", w.rotation, "Rotation, a quaternion")
        ->option_text("X Y Z W")
        ->expected(4);
    vector("--velocity", w.velocity, "Velocity, m/s [at most 50]");
    vector("--angular-velocity", w.angular_velocity, "Angular velocity, rad/s [at most 50]");
    number("--mass", w.mass, "Mass, kg [0.001 to 1000000]");
    number("--density", w.density, "Density of all shapes, kg/m^3 [1 to 20000]");
    number("--friction", w.friction, "Friction of all shapes [0 to 10]");
    number("--restitution", w.restitution, "Restitution of all shapes [0 to 1]");
    number("--gravity-scale", w.gravity_scale, "Factor of gravity [-10 to 10]");
    edit->add_option("--color", w.color, "Colour, such as ff8000")->type_name("RRGGBB");
    auto* const freeze = edit->add_flag("--freeze", w.freeze, "Make the body static");
    edit->add_flag("--unfreeze", w.unfreeze, "Make a frozen body dynamic again")->excludes(freeze);
    edit->footer("Example: jostlectl edit yard 12 --position 0 5 0 --mass 20 --color ff8000");

    CLI::App* const clone = add(app, flags, "clone", "Copy a dynamic body", ctl::clone);
    add_world_argument(clone, flags);
    clone->add_option("ENTITY", w.entity, "Id of the entity")->type_name("")->required();
    clone->add_option("--offset", w.offset, "Position of the copy relative to the original, m")
        ->option_text("X Y Z REQUIRED")
        ->expected(3)
        ->required();
    clone->add_flag("--jointed", w.jointed,
                    "Copy all bodies that joints connect to it as well, with the joints");
    clone->footer("Example: jostlectl clone yard 12 --offset 2 0 0 --jointed");

    CLI::App* const joints = app.add_subcommand("joint", "Create or delete a joint");
    joints->require_subcommand(1);
    CLI::App* const create = add(*joints, flags, "create",
                                 "Join two bodies, or a body and the world", ctl::create_joint);
    add_world_argument(create, flags);
    create
        ->add_option("KIND", w.kind,
                     "ball, hinge, slider, fixed or distance; file for the joint in --file")
        ->type_name("")
        ->required();
    create->add_option("ENTITY_A", w.entity_a, "Id of an entity; 0 is the world")
        ->type_name("")
        ->required();
    create->add_option("ENTITY_B", w.entity_b, "Id of the other entity")->type_name("")->required();
    create->add_option("--at", w.position, "Point of the joint in the world, m")
        ->option_text("X Y Z")
        ->expected(3);
    create->add_option("--axis", w.axis, "Axis of a hinge or a slider [default: 0 0 1]")
        ->option_text("X Y Z")
        ->expected(3);
    create
        ->add_option("--limit", w.limit,
                     "Range of a hinge, rad, of a slider, m, or length of a distance joint, m")
        ->option_text("MIN MAX")
        ->expected(2);
    create
        ->add_option("--motor", w.motor,
                     "Speed, rad/s or m/s, and largest torque, N m, or force, N")
        ->option_text("SPEED MAX")
        ->expected(2);
    create->add_option("--break-force", w.break_force, "Break at this force, N [default: never]")
        ->type_name("NEWTONS");
    create
        ->add_option("--break-torque", w.break_torque, "Break at this torque, N m [default: never]")
        ->type_name("NEWTON_METRES");
    create->add_flag("--collide", w.collides, "Let the two bodies collide with each other");
    auto* const file =
        create
            ->add_option("--file", w.file,
                         "Read the joint from a JSON file as in scene files, without its bodies; "
                         "\"-\" reads standard input")
            ->type_name("FILE");
    create->callback([&flags, file] {
        if ((flags.arguments.kind == "file") != (file->count() == 1))
            throw CLI::RequiredError("joint create: KIND file and --file FILE together");
        flags.command = ctl::create_joint;
    });
    create->footer("Example: jostlectl joint create yard hinge 0 12 --at 0 2 0 --axis 0 1 0");
    CLI::App* const removal = add(*joints, flags, "delete", "Delete a joint", ctl::delete_joint);
    add_world_argument(removal, flags);
    removal->add_option("JOINT", w.joint, "Id of the joint, as listed by \"inspect\"")
        ->type_name("")
        ->required();
    removal->footer("Example: jostlectl joint delete yard 3");
}

void add_client_commands(CLI::App& app, Flags& flags) {
    CommandArguments& w = flags.arguments;
    add(app, flags, "clients", "List the connected clients", jostle::ctl::list_clients)
        ->add_option("WORLD", w.world, "Id or name of a world [default: all worlds]")
        ->type_name("");
    CLI::App* const kick = add(app, flags, "kick", "Disconnect a client", jostle::ctl::kick);
    kick->add_option("CLIENT", w.client, "Id of the client, as listed by \"clients\"")
        ->type_name("")
        ->required();
    kick->add_option("--reason", w.reason, "Send TEXT to the client [at most 100 bytes]")
        ->type_name("TEXT");
    for (const auto& [name, help, command] :
         {std::tuple("ban", "Ban a subject or a network and end its sessions", &jostle::ctl::ban),
          std::tuple("unban", "Remove a ban", &jostle::ctl::unban)}) {
        CLI::App* const sub = add(app, flags, name, help, command);
        auto* const target = sub->add_option_group("Target");
        target
            ->add_option("--subject", w.subject,
                         "Subject of a token, as listed by \"clients\" or \"bans\"")
            ->type_name("SUBJECT");
        target
            ->add_option("--network", w.network,
                         "Address or prefix, such as 192.0.2.7, 192.0.2.0/24 or 2001:db8::/48; an "
                         "IPv6 address is its /64")
            ->type_name("NETWORK");
        target->require_option(1);
        if (command != &jostle::ctl::ban) continue;
        sub->add_option("--reason", w.reason, "Send TEXT to the banned caller [at most 100 bytes]")
            ->type_name("TEXT");
        sub->add_option("--hours", w.hours, "Duration [default: until unban; at most 87600]")
            ->type_name("HOURS")
            ->check(CLI::Range(0.0, 87600.0).description(""));
    }
    add(app, flags, "bans", "List the bans", jostle::ctl::list_bans);
    CLI::App* const remove_bodies =
        add(app, flags, "remove-bodies", "Remove the bodies that a client spawned in a world",
            jostle::ctl::remove_bodies);
    add_world_argument(remove_bodies, flags);
    remove_bodies->add_option("CLIENT", w.client, "Id of the client, also one that has left")
        ->type_name("")
        ->required();
    CLI::App* const undo =
        add(app, flags, "undo", "Undo the recent inputs of one client in a persisted world",
            jostle::ctl::undo);
    add_world_argument(undo, flags);
    undo->add_option("CLIENT", w.client, "Id of the client, also one that has left")
        ->type_name("")
        ->required();
    auto* const seconds = undo->add_option("--seconds", w.undo_seconds,
                                           "Undo the inputs of this time [default: 60; 1 to 3600]")
                              ->type_name("SECONDS")
                              ->check(CLI::Range(1.0, 3600.0).description(""));
    undo->add_flag("--newest", w.newest,
                   "Undo only the newest spawn, clone, deletion, edit or joint, also in a world "
                   "that is not persisted")
        ->excludes(seconds);
    undo->callback([&flags] {
        flags.command = flags.arguments.newest ? jostle::ctl::undo_newest : jostle::ctl::undo;
    });
    undo->footer("Example: jostlectl undo yard 17 --newest");
    add_data_commands(app, flags);
    add_build_commands(app, flags);
    CLI::App* const reports =
        add(app, flags, "reports", "List what players reported about other players",
            jostle::ctl::list_reports);
    reports->add_option("WORLD", w.world, "Id or name of a world [default: all worlds]")
        ->type_name("");
    reports->footer("Example: jostlectl reports arena");
    CLI::App* const backup =
        add(app, flags, "backup", "Download a backup of all persisted worlds", jostle::ctl::backup);
    backup->add_option("FILE", w.file, "File to write")->type_name("")->required();
    add(app, flags, "drain", "Notify all clients, then stop the server", jostle::ctl::drain);
}

void add_room_commands(CLI::App& app, Flags& flags) {
    namespace ctl = jostle::ctl;
    CommandArguments& w = flags.arguments;
    CLI::App* const room = app.add_subcommand("room", "Show or moderate the room of a world");
    room->require_subcommand(1);
    const auto command = [&](const char* name, const char* help, Command run) {
        CLI::App* const sub = add(*room, flags, name, help, run);
        add_world_argument(sub, flags);
        return sub;
    };
    const auto on_client = [&](const char* name, const char* help, Command run) {
        CLI::App* const sub = command(name, help, run);
        sub->add_option("CLIENT", w.client, "Id of the client, as listed by \"room show\"")
            ->type_name("")
            ->required();
        return sub;
    };
    command("show", "List members, bans and protected areas", ctl::show_room);
    on_client("role", "Change the role of a client", ctl::set_room_role)
        ->add_option("ROLE", w.role, "spectator, player, builder or owner")
        ->type_name("")
        ->required();
    CLI::App* const kick = on_client("kick", "Remove a client", ctl::kick_from_room);
    CLI::App* const ban = on_client("ban", "Remove and ban a client", ctl::ban_from_room);
    for (CLI::App* const sub : {kick, ban})
        sub->add_option("--reason", w.reason, "Send TEXT to the client [at most 100 bytes]")
            ->type_name("TEXT");
    ban->add_option("--hours", w.hours, "Duration in simulated time [default: until unban]")
        ->type_name("HOURS")
        ->check(CLI::Range(0.0, 87600.0).description(""));
    command("unban", "Remove a ban", ctl::unban_from_room)
        ->add_option("MEMBER", w.member, "Member, as listed by \"room show\"")
        ->type_name("")
        ->required();
    on_client("mute", "Refuse the messages of a client", ctl::mute)
        ->add_option("--seconds", w.seconds,
                     "Duration in simulated time; 0 ends the mute [default: 5]")
        ->type_name("SECONDS")
        ->check(CLI::Range(0.0, 315360000.0).description(""));
    on_client("clean-up", "Delete all bodies of a client", ctl::clean_up);
    CLI::App* const protect = command("protect", "Add a protected area", ctl::protect);
    CLI::App* const unprotect = command("unprotect", "Remove a protected area", ctl::unprotect);
    for (CLI::App* const sub : {protect, unprotect})
        sub->add_option("AREA", w.area, "Name of the area")->type_name("")->required();
    protect->add_option("--min", w.min, "Corner of the box, m")
        ->option_text("X Y Z REQUIRED")
        ->expected(3)
        ->required();
    protect->add_option("--max", w.max, "Opposite corner of the box, m")
        ->option_text("X Y Z REQUIRED")
        ->expected(3)
        ->required();
    protect->add_option("--role", w.role, "Lowest role that may act in the area [default: builder]")
        ->type_name("ROLE");
    command("update", "Replace all settings", ctl::update_room)
        ->add_option("FILE", w.file, "JSON file with room settings; \"-\" is standard input")
        ->type_name("")
        ->required();
    command("reset", "Start the world from its scene again", ctl::reset);
    CLI::App* const settings =
        command("settings", "Write the settings as JSON", ctl::write_room_settings);
    settings->add_option("FILE", w.file, "File to write; \"-\" is standard output [default: -]")
        ->type_name("")
        ->default_str("");
    settings->callback([&flags] {
        if (flags.arguments.file.empty()) flags.arguments.file = "-";
        flags.command = ctl::write_room_settings;
    });
    settings->footer("Example: jostlectl room settings track room.json");
    CLI::App* const step = command("step", "Step a paused room", ctl::step);
    step->add_option("STEPS", w.steps, "Number of steps [default: 1; 1 to 1000]")
        ->type_name("")
        ->check(CLI::Range(1, 1000).description(""));
    step->footer("Example: jostlectl pause track && jostlectl room step track 10");
    CLI::App* const speed =
        command("speed", "Run the room slower than real time", ctl::set_room_speed);
    speed->add_option("PERCENT", w.percent, "Percent of real time, a multiple of 5 [5 to 100]")
        ->type_name("")
        ->required();
    speed->footer("Example: jostlectl room speed track 25");
    CLI::App* const rewind =
        command("rewind", "Continue from an earlier state of the timeline", ctl::rewind_room);
    rewind->add_option("TICK", w.tick, "Tick, as listed by \"room ticks\"")
        ->type_name("")
        ->required();
    rewind->footer("Example: jostlectl room rewind track 1234");
    command("ticks", "List the ticks to which the room can be rewound", ctl::list_restorable_ticks)
        ->footer("Example: jostlectl room ticks track | tail -1");
}

// Commands that read and write files on this machine.
void add_file_commands(CLI::App& app, Flags& flags) {
    CommandArguments& w = flags.arguments;
    CLI::App* const verify =
        app.add_subcommand("verify", "Verify a backup, or the database of a stopped server");
    verify->add_option("FILE", w.file, "Backup or database")->type_name("")->required();
    verify->callback([&flags] { flags.local_command = jostle::ctl::verify; });
    CLI::App* const restore =
        app.add_subcommand("restore", "Replace the database of a stopped server by a backup");
    restore->add_option("FILE", w.file, "Backup")->type_name("")->required();
    restore
        ->add_option("DATABASE", w.database,
                     "Database (persistence.database); its files so far are renamed")
        ->type_name("")
        ->required();
    restore->callback([&flags] { flags.local_command = jostle::ctl::restore; });
}

int run(Flags& flags) {
    const auto fail = [](int status, const std::string& message) {
        std::fprintf(stderr, "jostlectl: %s\n", message.c_str());
        return status;
    };
    Outcome outcome;
    if (flags.local_command) {
        outcome = flags.local_command(flags.arguments);
    } else {
        auto connection = Connection::open(flags.connection);
        if (!connection.ok()) return fail(2, connection.error().message);
        outcome = flags.command(*connection, flags.arguments);
    }
    std::fputs(outcome.text.c_str(), stdout);
    if (outcome.error.empty()) return 0;
    return fail(outcome.is_usage_error ? 2 : 1, outcome.error);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Administer a running jostle-server."};
    Flags flags;
    app.fallthrough();  // global flags are also accepted after the command
    add_connection_flags(app, flags);
    add_world_commands(app, flags);
    add_client_commands(app, flags);
    add_room_commands(app, flags);
    add_file_commands(app, flags);
    app.require_subcommand(1);
    app.footer(footer);
    if (const auto status =
            jostle::parse_command_line(app, {"jostlectl", JOSTLE_VERSION}, argc, argv))
        return *status;
    return run(flags);
}
