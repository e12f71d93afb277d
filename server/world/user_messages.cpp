// SPDX-License-Identifier: MIT
#include "server/world/user_messages.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

bool UserMessage::is_for(ClientId client) const {
    if (to_server) return false;
    return to.empty() || std::ranges::binary_search(to, client);
}

UserMessages::UserMessages() {
    static const RecentMessagesPtr none = std::make_shared<const RecentMessages>();
    recent_ = none;
}

std::uint32_t UserMessages::add(UserMessage message) {
    message.number = ++count_;
    std::ranges::sort(message.to);
    // A replay adds messages without publishing them.
    if (added_.size() == RecentMessages::messages_max) added_.erase(added_.begin());
    added_.push_back(std::make_shared<UserMessage>(std::move(message)));
    return count_;
}

void UserMessages::set_count(std::uint32_t count) {
    count_ = count;
    added_.clear();
    recent_ = std::make_shared<const RecentMessages>(RecentMessages{count, {}});
}

const RecentMessagesPtr& UserMessages::publish(std::uint32_t tick) {
    if (added_.empty()) return recent_;
    auto recent = std::make_shared<RecentMessages>();
    recent->count = count_;
    std::vector<UserMessagePtr>& all = recent->messages;
    // Numbers must be consecutive: those of a replay are not published.
    if (recent_->count + 1 == added_.front()->number) all = recent_->messages;
    for (std::shared_ptr<UserMessage>& message : added_) {
        message->tick = tick;
        all.push_back(std::move(message));
    }
    added_.clear();
    std::size_t bytes = 0, retained = 0;
    while (retained < std::min(all.size(), RecentMessages::messages_max)) {
        const std::size_t next = bytes + all[all.size() - 1 - retained]->data.size();
        if (next > RecentMessages::bytes_max && retained > 0) break;
        bytes = next;
        retained++;
    }
    all.erase(all.begin(), all.end() - static_cast<std::ptrdiff_t>(retained));
    ASSERT(!all.empty() && all.back()->number == recent->count);
    recent_ = std::move(recent);
    return recent_;
}

}  // namespace jostle::server
