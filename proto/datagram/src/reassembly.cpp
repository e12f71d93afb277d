// SPDX-License-Identifier: MIT
#include "jostle/datagram/reassembly.h"

#include <algorithm>
#include <utility>

namespace jostle::datagram {

// What is older than a finished message is of no use: a snapshot would be skipped.
Reassembly::PartialMessage* Reassembly::find_or_begin(const Fragment& part) {
    if (done_ && part.message <= *done_) return nullptr;
    const auto at = std::ranges::lower_bound(unfinished_, part.message, {}, &PartialMessage::number);
    if (at != unfinished_.end() && at->number == part.message)
        return at->count == part.count ? &*at : nullptr;
    if (unfinished_.size() == unfinished_max && at == unfinished_.begin()) return nullptr;
    const auto made = unfinished_.insert(at, {.number = part.message,
                                              .count = part.count,
                                              .parts = std::vector<std::string>(part.count),
                                              .missing = part.count});
    if (unfinished_.size() <= unfinished_max) return &*made;
    const auto place = made - unfinished_.begin();
    unfinished_.erase(unfinished_.begin());
    return &unfinished_[static_cast<std::size_t>(place - 1)];
}

std::optional<std::string> Reassembly::add(const Fragment& part) {
    PartialMessage* const message = find_or_begin(part);
    if (!message) return std::nullopt;
    std::string& place = message->parts[part.index];
    if (!place.empty()) return std::nullopt;
    place = part.bytes;
    if (--message->missing != 0) return std::nullopt;
    std::string whole;
    for (const std::string& bytes : message->parts) whole += bytes;
    done_ = part.message;
    std::erase_if(unfinished_, [&](const PartialMessage& u) { return u.number <= *done_; });
    return whole;
}

std::size_t Reassembly::bytes_held() const {
    std::size_t bytes = 0;
    for (const PartialMessage& message : unfinished_)
        for (const std::string& part : message.parts) bytes += part.size();
    return bytes;
}

}  // namespace jostle::datagram
