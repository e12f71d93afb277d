// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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

}  // namespace jostle::ctl
