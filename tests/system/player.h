// SPDX-License-Identifier: MIT
//
// A client of the real server over one transport. It sends messages, receives on its own thread
// into a PlayState, and records how the stream ended.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "tests/system/play_state.h"

namespace jostle::test {

class Player {
public:
    virtual ~Player() = default;

    virtual void send(const v1::ClientMessage& message) = 0;
    // Stops reading, like a program that hangs.
    virtual void stall() = 0;
    // How the stream ended, in terms of the transport ("OK", "RESOURCE_EXHAUSTED: ...", "1000");
    // nothing while it is open.
    std::optional<std::string> end() const;

    // Reads the state under the lock.
    template <class Read>
    auto with_state(const Read& read) const {
        const std::lock_guard lock(mutex_);
        return read(state_);
    }
    // Returns false on timeout.
    bool wait_until(const std::function<bool(const PlayState&)>& condition,
                    std::chrono::milliseconds patience = std::chrono::seconds(10)) const;
    bool wait_for_end(std::chrono::milliseconds patience = std::chrono::seconds(10)) const;

    void hello(const std::string& world = {}, const std::string& name = "tester",
               bool events = false);
    // Numbers the inputs, acknowledges the newest snapshot and sends all as one batch.
    void send_inputs(std::vector<v1::Input> inputs);
    void leave();
    // By sequence. Only for the thread that sends.
    const std::map<std::uint32_t, v1::Input>& inputs_sent() const { return sent_; }

protected:
    void take(const v1::ServerMessage& message);
    void ended(std::string how);

private:
    mutable std::mutex mutex_;
    PlayState state_;
    std::optional<std::string> end_;
    std::uint32_t next_sequence_ = 1;
    std::map<std::uint32_t, v1::Input> sent_;
};

std::unique_ptr<Player> grpc_player(const std::string& address);
std::unique_ptr<Player> websocket_player(int port, const std::string& origin = {});

// --- inputs ---

v1::Input spawn_box(double x, double y, double z, double half = 0.2);
v1::Input spawn_ball(double x, double y, double z, double radius = 0.5);
v1::Input impulse(std::uint32_t entity, double x, double y, double z);
v1::Input remove_body(std::uint32_t entity);

}  // namespace jostle::test
