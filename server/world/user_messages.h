// SPDX-License-Identifier: MIT
//
// The newest messages between the clients and the server of a world. The thread that owns the world
// adds messages and publishes immutable lists, which any thread may read. Only the number of
// messages is saved: a message is delivered at most once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "server/world/command.h"

namespace jostle::server {

struct UserMessage {
    std::uint32_t number = 0;  // counts the messages of the world from 1
    std::uint32_t tick = 0;    // in which it was sent
    ClientId from = 0;         // scene_client: the server
    std::string topic, data;
    std::vector<ClientId> to;  // sorted; empty: all clients, unless to_server
    bool to_server = false;    // for the server alone

    bool is_for(ClientId client) const;
};
using UserMessagePtr = std::shared_ptr<const UserMessage>;

struct RecentMessages {
    static constexpr std::size_t messages_max = 256;
    static constexpr std::size_t bytes_max = 256 << 10;

    std::uint32_t count = 0;               // number of the last message
    std::vector<UserMessagePtr> messages;  // consecutive numbers up to `count`
};
using RecentMessagesPtr = std::shared_ptr<const RecentMessages>;

class UserMessages {
public:
    UserMessages();

    // Assigns the number and returns it.
    std::uint32_t add(UserMessage message);
    std::uint32_t count() const { return count_; }
    // Numbers continue after this one.
    void set_count(std::uint32_t count);

    // The messages since the start of the process; the same pointer if there was none since the
    // last call. `tick`: in which they were sent.
    const RecentMessagesPtr& publish(std::uint32_t tick);

private:
    std::uint32_t count_ = 0;
    std::vector<std::shared_ptr<UserMessage>> added_;  // since the last publish()
    RecentMessagesPtr recent_;
};

}  // namespace jostle::server
