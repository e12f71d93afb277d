// SPDX-License-Identifier: MIT
//
// Allocates indices. It always assigns the lowest free index, with a generation per index that
// distinguishes successive uses. The same sequence of calls yields the same ids, which replays and
// saved worlds rely on.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "jostle/base/check.h"

namespace jostle::physics {

class IdPool {
public:
    std::uint32_t take() {
        if (free_.empty()) {
            generation_.push_back(1);
            alive_.push_back(1);
            return static_cast<std::uint32_t>(alive_.size() - 1);
        }
        std::pop_heap(free_.begin(), free_.end(), std::greater<>{});
        const std::uint32_t index = free_.back();
        free_.pop_back();
        alive_[index] = 1;
        return index;
    }

    void release(std::uint32_t index) {
        ASSERT(alive(index));
        alive_[index] = 0;
        generation_[index]++;
        free_.push_back(index);
        std::push_heap(free_.begin(), free_.end(), std::greater<>{});
    }

    bool alive(std::uint32_t index) const { return index < alive_.size() && alive_[index] != 0; }
    bool matches(std::uint32_t index, std::uint32_t generation) const {
        return alive(index) && generation_[index] == generation;
    }
    std::uint32_t generation(std::uint32_t index) const { return generation_[index]; }
    std::uint32_t size() const { return static_cast<std::uint32_t>(alive_.size()); }
    std::uint32_t alive_count() const { return size() - static_cast<std::uint32_t>(free_.size()); }

    // Same as alive_count(), computed from the flags. Correct even before rebuild_free_list().
    std::size_t alive_count_slow() const {
        return static_cast<std::size_t>(std::count(alive_.begin(), alive_.end(), 1));
    }

    // For the field list. The two arrays are the complete state; the heap of free indices is
    // derived.
    std::vector<std::uint32_t>& generations() { return generation_; }
    std::vector<std::uint8_t>& alive_flags() { return alive_; }
    void rebuild_free_list() {
        free_.clear();
        for (std::uint32_t i = 0; i < alive_.size(); i++)
            if (alive_[i] == 0) free_.push_back(i);  // ascending order is a valid min-heap
    }

private:
    std::vector<std::uint32_t> generation_;
    std::vector<std::uint8_t> alive_;
    std::vector<std::uint32_t> free_;  // min-heap
};

}  // namespace jostle::physics
