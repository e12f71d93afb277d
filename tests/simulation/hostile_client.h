// SPDX-License-Identifier: MIT
//
// A malicious or defective client. It knows the protocol and violates it.
#pragma once

#include <memory>
#include <string>

#include "jostle/v1/play.pb.h"
#include "tests/simulation/honest_client.h"

namespace jostle::simulation {

class HostileClient {
public:
    // The behaviour, chosen at random.
    enum class Kind {
        garbage,  // random bytes
        mutant,   // valid messages with a few changed bits
        flooder,  // hundreds of valid inputs with arbitrary sequences
        hoarder,  // spawns as much as possible at one position and explodes it
        deaf,     // never reads
        liar,     // acknowledges frames that it never received and requests keyframes
        silent,   // sends at most a Hello
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
