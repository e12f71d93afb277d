// SPDX-License-Identifier: MIT
//
// Somebody who means harm, or whose program is broken: it knows the protocol, and how to break it.
#pragma once

#include <memory>
#include <string>

#include "jostle/v1/play.pb.h"
#include "tests/simulation/honest_client.h"

namespace jostle::simulation {

class HostileClient {
public:
    // What it does; chosen by chance.
    enum class Kind {
        garbage,  // bytes of no meaning
        mutant,   // good messages with a few bits changed
        flooder,  // good inputs, by the hundred, numbered as it likes
        hoarder,  // spawns as much as it can in one place, and blows it up
        deaf,     // never reads
        liar,     // acknowledges what it never got, and asks for keyframes
        silent,   // says Hello, or not even that
        count
    };

    HostileClient(std::uint64_t seed, Tally& tally);

    void connect(std::shared_ptr<NetworkLine> line);
    void act(Clock::time_point now);
    bool is_connected() const { return line_ != nullptr; }

private:
    void send_message(const google::protobuf::Message& message, Clock::time_point now);
    void send_message(std::string bytes, Clock::time_point now);
    v1::ClientMessage hello() const;
    v1::ClientMessage inputs(int count);
    v1::Input some_input();
    void misbehave(Clock::time_point now);

    Chance chance_;
    Tally& tally_;
    const Kind kind_;
    std::shared_ptr<NetworkLine> line_;
    std::uint32_t sequence_ = 1, frame_ = 0;
    int ticks_ = 0, patience_ = 0;
};

}  // namespace jostle::simulation
