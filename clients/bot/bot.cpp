// SPDX-License-Identifier: MIT
#include "clients/bot/bot.h"

namespace jostle::bot {

Bot::Bot(client::Loop& loop, client::ClientOptions options, const ScriptLine& line,
         std::uint32_t seed)
    : client_(client::Client::connect(loop, std::move(options))),
      behaviour_(line, seed),
      began_(client::Clock::now()) {}

void Bot::think(client::Clock::time_point now) {
    const client::ClientStats stats = client_->stats();
    if (!stats.connected) return;
    const double seconds = std::chrono::duration<double>(now - began_).count();
    std::vector<v1::Input> inputs;
    client_->read([&](const client::WorldView& world) {
        inputs = behaviour_.act(seconds, world, stats.client_id);
    });
    for (v1::Input& input : inputs) client_->send(std::move(input));
}

}  // namespace jostle::bot
