// SPDX-License-Identifier: MIT
//
// Replay protection: tracks which of the newest 1024 packet numbers were received, so that each
// packet is accepted once. Older numbers count as received. One thread at a time.
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
    /// Marks a number as received. Only for authenticated packets: otherwise anyone could move the
    /// window.
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
    /// Returns whether no higher number was received.
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
