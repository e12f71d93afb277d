// SPDX-License-Identifier: MIT
//
// One bot: a client and its behaviour. The owner calls think() about 30 times per second.
#pragma once

#include <memory>

#include "clients/bot/behaviour.h"
#include "jostle/client/client.h"

namespace jostle::bot {

class Bot {
public:
    Bot(client::Loop& loop, client::ClientOptions options, const ScriptLine& line,
        std::uint32_t seed);

    void think(client::Clock::time_point now);
    client::Client& client() { return *client_; }
    const std::vector<Lap>& laps() const { return behaviour_.laps(); }

private:
    std::shared_ptr<client::Client> client_;
    Behaviour behaviour_;
    client::Clock::time_point began_;
};

}  // namespace jostle::bot
