// SPDX-License-Identifier: MIT
#include "jostle/datagram/reassembly.h"

#include <algorithm>
#include <utility>

namespace jostle::datagram {

// Fragments older than a completed message are useless: the client would skip the snapshot.
Reassembly::PartialMessage* Reassembly::find_or_add(const Fragment& part) {
    if (done_ && part.message <= *done_) return nullptr;
    const auto at = std::ranges::lower_bound(partial_, part.message, {}, &PartialMessage::number);
    if (at != partial_.end() && at->number == part.message)
        return at->count == part.count ? &*at : nullptr;
    if (partial_.size() == partial_messages_max && at == partial_.begin()) return nullptr;
    const auto inserted = partial_.insert(at, {.number = part.message,
                                               .count = part.count,
                                               .parts = std::vector<std::string>(part.count),
                                               .missing = part.count});
    if (partial_.size() <= partial_messages_max) return &*inserted;
    const auto slot = inserted - partial_.begin();
    partial_.erase(partial_.begin());
    return &partial_[static_cast<std::size_t>(slot - 1)];
}

std::optional<std::string> Reassembly::add(const Fragment& part) {
    PartialMessage* const message = find_or_add(part);
    if (!message) return std::nullopt;
    std::string& slot = message->parts[part.index];
    if (!slot.empty()) return std::nullopt;
    slot = part.bytes;
    if (--message->missing != 0) return std::nullopt;
    std::string assembled;
    for (const std::string& bytes : message->parts) assembled += bytes;
    done_ = part.message;
    std::erase_if(partial_, [&](const PartialMessage& u) { return u.number <= *done_; });
    return assembled;
}

std::size_t Reassembly::bytes_held() const {
    std::size_t bytes = 0;
    for (const PartialMessage& message : partial_)
        for (const std::string& part : message.parts) bytes += part.size();
    return bytes;
}

}  // namespace jostle::datagram
