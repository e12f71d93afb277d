// SPDX-License-Identifier: MIT
//
// The commands of jostlectl, one function each: call the server and return the text to print.
// Outcome distinguishes errors of flags or files from errors of the server.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/ctl/connection.h"

namespace jostle::ctl {

// Arguments of all commands.
struct CommandArguments {
    std::string world, name, scene, file, reason;
    std::string database;
    std::string from;  // world of which the new one is a copy
    std::uint32_t client = 0, steps = 1;
    std::uint32_t tick = 0;        // 0: the current tick
    std::string subject, network;  // of a ban; one of them is empty
    double seconds = 5;
    double undo_seconds = 60;
    double hours = 0;                 // of a ban; 0: until it is removed
    std::string room, room_template;  // a file with room settings; a room template
    std::string tags, words;          // filters of "worlds"; tags are separated by commas
    bool not_full = false, is_public = false;
    std::string member, area;
    std::vector<double> min, max;  // of an area
    std::string target = "world";  // of attributes
    std::string key, value, visibility = "everyone";
    bool is_text = false, removes = false;
    std::string role, topic = "chat", text;
    std::vector<std::uint32_t> recipients;  // of a message; empty: all players
    // Of bodies and joints.
    std::uint32_t entity = 0, joint = 0, entity_a = 0, entity_b = 0, percent = 100;
    std::vector<double> position, rotation, velocity, angular_velocity, offset{0, 0, 0};
    std::optional<double> mass, density, friction, restitution, gravity_scale;
    std::string color, kind;
    bool freeze = false, unfreeze = false, jointed = false, collides = false, newest = false;
    std::vector<double> axis, limit, motor;
    double break_force = 0, break_torque = 0;
    bool json = false;
};

struct Outcome {
    std::string text;             // for standard output
    std::string error;            // for standard error; empty: success
    bool is_usage_error = false;  // the error is in flags or files, not in the server
};

Outcome list_worlds(Connection& server, const CommandArguments& arguments);
Outcome create_world(Connection& server, const CommandArguments& arguments);
Outcome delete_world(Connection& server, const CommandArguments& arguments);
Outcome list_clients(Connection& server, const CommandArguments& arguments);
Outcome kick(Connection& server, const CommandArguments& arguments);
Outcome ban(Connection& server, const CommandArguments& arguments);
Outcome unban(Connection& server, const CommandArguments& arguments);
Outcome list_bans(Connection& server, const CommandArguments& arguments);
Outcome pause(Connection& server, const CommandArguments& arguments);
Outcome resume(Connection& server, const CommandArguments& arguments);
Outcome step(Connection& server, const CommandArguments& arguments);
Outcome export_world(Connection& server, const CommandArguments& arguments);
Outcome rewind(Connection& server, const CommandArguments& arguments);
// Undoes the inputs of `client` in the last `undo_seconds` of `world`.
Outcome undo(Connection& server, const CommandArguments& arguments);
// Downloads a backup of the database to `file`.
Outcome backup(Connection& server, const CommandArguments& arguments);
// Removes the bodies that `client` spawned in `world`.
Outcome remove_bodies(Connection& server, const CommandArguments& arguments);
// Players, attributes and messages of `world`.
Outcome list_players(Connection& server, const CommandArguments& arguments);
Outcome set_role(Connection& server, const CommandArguments& arguments);
// Of `target`; "": all attributes.
Outcome get_attributes(Connection& server, const CommandArguments& arguments);
Outcome set_attribute(Connection& server, const CommandArguments& arguments);
Outcome send_message(Connection& server, const CommandArguments& arguments);
Outcome drain(Connection& server, const CommandArguments& arguments);
Outcome profile(Connection& server, const CommandArguments& arguments);

// ---- commands without a server ----

// Compares every row of the database or backup `file` with its digest.
Outcome verify(const CommandArguments& arguments);
// Puts the backup `file` in the place of `database`, which no server may use.
Outcome restore(const CommandArguments& arguments);

}  // namespace jostle::ctl
