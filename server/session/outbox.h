// SPDX-License-Identifier: MIT
//
// The messages of one session that are ready to be written, in order. Snapshots are not queued
// here: they are made when the transport can write. Used on the session's thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "jostle/base/check.h"
#include "server/messages/out_message.h"
#include "server/util/fifo.h"

namespace jostle::server {

class Outbox {
public:
    // A reply or a notice for this client alone. Replies are counted, so that a client that
    // requests replies without reading them can be disconnected.
    void push_reply(std::string message) {
        messages_.push_back({std::move(message), nullptr});
        replies_++;
    }
    // An entity update, whose bytes other sessions may share.
    void push_shared(SharedBytes message) {
        ASSERT(message != nullptr);
        messages_.push_back({{}, std::move(message)});
    }
    std::optional<OutMessage> pop() {
        if (messages_.empty()) return std::nullopt;
        OutMessage message = std::move(messages_.front());
        messages_.pop_front();
        if (!message.shared) {
            ASSERT(replies_ > 0);
            replies_--;
        }
        return message;
    }
    void clear() {
        messages_.clear();
        replies_ = 0;
    }

    bool empty() const { return messages_.empty(); }
    std::size_t replies() const { return replies_; }

private:
    Fifo<OutMessage> messages_;
    std::size_t replies_ = 0;
};

}  // namespace jostle::server
