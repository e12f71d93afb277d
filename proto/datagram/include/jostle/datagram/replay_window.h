// SPDX-License-Identifier: MIT
//
// Which of the newest 1024 packet numbers have come, so that each is taken once: what an attacker
// recorded and sends again changes nothing. Older ones count as seen. One thread at a time.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>

namespace jostle::datagram {

class ReplayWindow {
public:
    static constexpr std::uint64_t size = 1024;

    bool seen(std::uint64_t number) const {
        if (!any_ || number > newest_) return false;
        return newest_ - number >= size || received_[slot(number)];
    }
    // Only of a packet that is authentic: else anybody could move the window.
    void add(std::uint64_t number) {
        if (!any_ || number > newest_) {
            const std::uint64_t steps = any_ ? number - newest_ : size;
            if (steps >= size)
                received_.reset();
            else
                for (std::uint64_t k = 1; k <= steps; k++) received_.reset(slot(newest_ + k));
            newest_ = number;
            any_ = true;
        }
        if (newest_ - number < size) received_.set(slot(number));
    }
    // Whether nothing newer has come.
    bool is_newest(std::uint64_t number) const { return !any_ || number >= newest_; }

private:
    static std::size_t slot(std::uint64_t number) {
        return static_cast<std::size_t>(number % size);
    }

    std::bitset<size> received_;
    std::uint64_t newest_ = 0;
    bool any_ = false;
};

}  // namespace jostle::datagram
