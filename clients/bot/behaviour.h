// SPDX-License-Identifier: MIT
//
// Decides the next inputs of one bot from its view of the world. Independent of the network.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "clients/bot/script.h"
#include "jostle/client/world_view.h"

namespace jostle::bot {

// Counts laps around the world's y axis from sampled positions.
struct Lap {
    double seconds = 0;
    double nearest = 1e9, furthest = 0;  // m from the axis
};

class LapCounter {
public:
    // Adds a position at a time. Successive positions must be less than half a lap apart. Laps
    // count in both directions.
    void add_position(double seconds, double x, double z);
    void begin() { *this = {}; }
    const std::vector<Lap>& laps() const { return laps_; }

private:
    std::vector<Lap> laps_;
    Lap lap_;
    bool seen_ = false;
    double began_ = 0, turned_ = 0;  // s; rad
    double x_ = 0, z_ = 0;
};

class Behaviour {
public:
    Behaviour(const ScriptLine& line, std::uint32_t seed);

    // Returns the inputs at `seconds` after the bot started. `client_id` identifies the bot's own
    // bodies.
    std::vector<v1::Input> act(double seconds, const client::WorldView& world,
                               std::uint32_t client_id);
    // Laps of a racing bot.
    const std::vector<Lap>& laps() const { return laps_.laps(); }

private:
    double random(double low, double high);
    double value(const char* key) const { return line_.values.at(key); }
    std::vector<std::uint32_t> owned(const client::WorldView& world, std::uint32_t client_id) const;
    // A random dynamic entity of the scene; 0: none.
    std::uint32_t random_entity(const client::WorldView& world, std::uint32_t client_id);

    void wander(std::vector<v1::Input>& out, const client::WorldView& world, std::uint32_t id);
    void push(std::vector<v1::Input>& out, const client::WorldView& world, std::uint32_t id);
    void throw_ball(std::vector<v1::Input>& out, const client::WorldView& world, std::uint32_t id);
    void build(std::vector<v1::Input>& out, const client::WorldView& world, std::uint32_t id);
    void drag(std::vector<v1::Input>& out, const client::WorldView& world, std::uint32_t id,
              double seconds);
    // Takes control of a controllable entity from time to time. Returns false if there is none.
    bool take_control(std::vector<v1::Input>& out, const client::WorldView& world, double seconds);
    void drive(std::vector<v1::Input>& out, const client::WorldView& world);
    void walk(std::vector<v1::Input>& out, const client::WorldView& world);
    void race(std::vector<v1::Input>& out, const client::WorldView& world, double seconds);
    // Deletes the oldest own body if there are `max_bodies`. Returns true if another one may be
    // spawned.
    bool make_room(std::vector<v1::Input>& out, const std::vector<std::uint32_t>& mine);

    const ScriptLine line_;
    std::uint32_t state_;
    double next_ = 0;  // s
    std::uint32_t grabbed_ = 0;
    double release_at_ = 0;
    std::array<double, 3> grab_point_{};
    std::uint32_t controlled_ = 0;
    double change_at_ = 0;  // s
    LapCounter laps_;
    std::array<double, 3> last_position_{};  // m
    double last_position_at_ = -1;           // s; negative: no position yet
    int built_ = 0;
    std::array<double, 2> site_{};
    std::uint32_t color_;
};

}  // namespace jostle::bot
