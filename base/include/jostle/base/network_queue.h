// SPDX-License-Identifier: MIT
//
// Messages in transit in one direction of a simulated network. The caller passes the time, so that
// tests can supply their own clock.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <optional>
#include <utility>

#include "jostle/base/network_simulator.h"

namespace jostle {

/// Queue of messages, ordered by the arrival times of a NetworkSimulator. Not thread-safe: one
/// thread at a time.
template <class Message>
class NetworkQueue {
public:
    using TimePoint = std::chrono::steady_clock::time_point;

    /// Parameters as of NetworkSimulator.
    explicit NetworkQueue(const NetworkConditions& conditions, std::uint32_t path = 0,
                          Delivery delivery = Delivery::stream)
        : simulator_(conditions, path, delivery),
          bytes_max_(conditions.queue_bytes),
          delivery_(delivery) {}

    /// Sends a message of `bytes` now. Returns false if the message, a datagram, is lost. A stream
    /// accepts messages even if it is full.
    bool push(Message message, std::size_t bytes, TimePoint now) {
        if (delivery_ == Delivery::datagrams && full()) return false;
        const Transit transit = simulator_.send(to_us(now), bytes);
        for (int copy = 1; copy < transit.copies; copy++)
            insert({message, bytes, transit.arrival_us});
        if (transit.copies > 0) insert({std::move(message), bytes, transit.arrival_us});
        return transit.copies > 0;
    }

    /// Sends a message of `message.size()` bytes.
    bool push(Message message, TimePoint now) {
        const std::size_t bytes = message.size();
        return push(std::move(message), bytes, now);
    }

    /// Returns the next message that has arrived; null: none.
    Message* front(TimePoint now) {
        return empty() || entries_.front().arrival_us > to_us(now) ? nullptr
                                                                   : &entries_.front().message;
    }
    /// Removes the next message. Precondition: !empty().
    void pop() {
        bytes_ -= entries_.front().bytes;
        entries_.pop_front();
    }
    /// Removes and returns the next message that has arrived.
    std::optional<Message> take(TimePoint now) { return front(now) ? take_next() : std::nullopt; }
    /// Removes and returns the next message, whether it has arrived or not.
    std::optional<Message> take_next() {
        if (empty()) return std::nullopt;
        Message message = std::move(entries_.front().message);
        pop();
        return message;
    }

    /// Arrival time of the next message. Precondition: !empty().
    TimePoint next_arrival() const {
        return TimePoint(std::chrono::microseconds(entries_.front().arrival_us));
    }
    bool empty() const { return entries_.empty(); }
    std::size_t bytes() const { return bytes_; }  ///< in transit
    /// NetworkConditions::queue_bytes are in transit. The sender of a stream should wait.
    bool full() const { return bytes_max_ > 0 && static_cast<double>(bytes_) >= bytes_max_; }

private:
    struct Entry {
        Message message;
        std::size_t bytes;
        std::int64_t arrival_us;
    };

    static std::int64_t to_us(TimePoint t) {
        return std::chrono::duration_cast<std::chrono::microseconds>(t.time_since_epoch()).count();
    }
    // Behind all entries that arrive no later, which is the end except for reordered datagrams.
    void insert(Entry entry) {
        bytes_ += entry.bytes;
        auto at = entries_.end();
        while (at != entries_.begin() && std::prev(at)->arrival_us > entry.arrival_us) --at;
        entries_.insert(at, std::move(entry));
    }

    NetworkSimulator simulator_;
    double bytes_max_;
    Delivery delivery_;
    std::deque<Entry> entries_;
    std::size_t bytes_ = 0;
};

}  // namespace jostle
