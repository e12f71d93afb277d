// SPDX-License-Identifier: MIT
//
// A bounded map with string keys that evicts the least recently used entry when full. The caller
// locks.
#pragma once

#include <list>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

template <class Value>
class LruMap {
public:
    explicit LruMap(std::size_t size_max) : size_max_(size_max) { ASSERT(size_max > 0); }
    LruMap(const LruMap&) = delete;  // index_ points into entries_
    LruMap& operator=(const LruMap&) = delete;

    // The value of `key`, created by `make()` if missing. Valid until the next call.
    template <class Make>
    Value& find_or_make(std::string_view key, Make make) {
        if (const auto at = index_.find(key); at != index_.end()) {
            entries_.splice(entries_.begin(), entries_, at->second);
            return at->second->second;
        }
        if (entries_.size() >= size_max_) {
            index_.erase(entries_.back().first);
            entries_.pop_back();
        }
        entries_.emplace_front(std::string(key), make());
        index_.emplace(entries_.front().first, entries_.begin());
        ASSERT(index_.size() == entries_.size() && entries_.size() <= size_max_);
        return entries_.front().second;
    }

    std::size_t size() const { return entries_.size(); }

private:
    using Entries = std::list<std::pair<std::string, Value>>;

    const std::size_t size_max_;
    Entries entries_;  // most recently used first
    std::unordered_map<std::string_view, typename Entries::iterator> index_;  // keys of entries_
};

}  // namespace jostle::server
