// SPDX-License-Identifier: MIT
//
// Helpers for tests of framings: generated frames and a reader of messages.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "tools/load/framing.h"

namespace jostle::load {

struct MessageList final : Framing::Reader {
    void on_message(Bytes message) override {
        texts.emplace_back(reinterpret_cast<const char*>(message.data()), message.size());
    }
    std::vector<std::string> texts;
};

inline Bytes as_bytes(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

inline std::string big_endian(std::uint64_t value, unsigned bytes) {
    std::string out;
    for (unsigned k = bytes; k-- > 0;) out.push_back(static_cast<char>(value >> (8 * k)));
    return out;
}

// Feeds `bytes` in two pieces, split at each position; returns the received messages or the error.
template <class Make>
std::vector<std::string> take_cut_at(std::size_t place, const std::string& bytes,
                                     const Make& make) {
    auto framing = make();
    MessageList list;
    Status status = framing.take(as_bytes(bytes.substr(0, place)), list);
    if (status.ok()) status = framing.take(as_bytes(bytes.substr(place)), list);
    if (!status.ok()) list.texts.push_back("error: " + status.error().message);
    return list.texts;
}

// Feeds a valid stream with modified bytes a thousand times; the framing must return each time.
template <class Make>
int count_refused_of_spoilt(const std::string& good, const Make& make) {
    std::mt19937 random(7);
    int refused = 0;
    for (int k = 0; k < 1000; k++) {
        std::string bytes = good;
        for (int n = 0; n < 3; n++) bytes[random() % bytes.size()] = static_cast<char>(random());
        auto framing = make();
        MessageList list;
        Status status;
        for (std::size_t at = 0; at < bytes.size() && status.ok(); at += 11)
            status = framing.take(as_bytes(bytes.substr(at, 11)), list);
        refused += status.ok() ? 0 : 1;
    }
    return refused;
}

}  // namespace jostle::load
