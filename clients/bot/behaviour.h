// SPDX-License-Identifier: MIT
//
// What one bot does next, from what it sees. No network: it is shown the world and answers with
// inputs.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "clients/bot/lap_counter.h"
#include "clients/bot/script.h"
#include "jostle/client/world_view.h"

namespace jostle::bots {

class Behaviour {
public:
    Behaviour(const ScriptLine& line, std::uint32_t seed);

    // At that many seconds since the bot began. `client_id` tells which bodies are its own.
    std::vector<v1::Input> act(double seconds, const client::WorldView& world,
                               std::uint32_t client_id);
    // Of one that races.
    const std::vector<Lap>& laps() const { return laps_.laps(); }

private:
    double random(double low, double high);
    double value(const char* key) const { return line_.values.at(key); }
    std::vector<std::uint32_t> owned(const client::WorldView& world, std::uint32_t client_id) const;
    // A dynamic entity of somebody else's, chosen at random; 0: there is none.
    std::uint32_t random_entity(const client::WorldView& world, std::uint32_t client_id);

    void wander(std::vector<v1::Input>& out, const client::WorldView& world, std::uint32_t id);
    void push(std::vector<v1::Input>& out, const client::WorldView& world, std::uint32_t id);
    void throw_ball(std::vector<v1::Input>& out, const client::WorldView& world, std::uint32_t id);
    void build(std::vector<v1::Input>& out, const client::WorldView& world, std::uint32_t id);
    void drag(std::vector<v1::Input>& out, const client::WorldView& world, std::uint32_t id,
              double seconds);
    // Takes something that can be driven, once in a while; false: there is none.
    bool take_control(std::vector<v1::Input>& out, const client::WorldView& world, double seconds);
    void drive(std::vector<v1::Input>& out, const client::WorldView& world);
    void walk(std::vector<v1::Input>& out, const client::WorldView& world);
    void race(std::vector<v1::Input>& out, const client::WorldView& world, double seconds);
    // Deletes its oldest body when it has `max_bodies` of them; true when there is room for one
    // more.
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
    std::array<double, 3> last_position_{};  // where it was, m ...
    double last_position_at_ = -1;           // ... and when, s; < 0: nowhere yet
    int built_ = 0;
    std::array<double, 2> site_{};
    std::uint32_t color_;
};

}  // namespace jostle::bots
