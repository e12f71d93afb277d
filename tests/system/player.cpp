// SPDX-License-Identifier: MIT
#include "tests/system/player.h"

#include <thread>

namespace jostle::test {

namespace {

constexpr auto poll_period = std::chrono::milliseconds(5);

bool poll(const std::function<bool()>& condition, std::chrono::milliseconds patience) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (!condition()) {
        if (std::chrono::steady_clock::now() >= deadline) return false;
        std::this_thread::sleep_for(poll_period);
    }
    return true;
}

}  // namespace

std::optional<std::string> Player::end() const {
    const std::lock_guard lock(mutex_);
    return end_;
}

bool Player::wait_until(const std::function<bool(const PlayState&)>& condition,
                        std::chrono::milliseconds patience) const {
    return poll([&] { return with_state(condition); }, patience);
}

bool Player::wait_for_end(std::chrono::milliseconds patience) const {
    return poll([&] { return end().has_value(); }, patience);
}

void Player::hello(const std::string& world, const std::string& name, bool events) {
    {
        const std::lock_guard lock(mutex_);
        state_.wants_events = events;
    }
    v1::ClientMessage message;
    message.mutable_hello()->set_protocol(1);
    message.mutable_hello()->set_world(world);
    message.mutable_hello()->set_name(name);
    message.mutable_hello()->set_events(events);
    message.mutable_hello()->set_codec(2);
    send(message);
}

void Player::send_inputs(std::vector<v1::Input> inputs) {
    v1::ClientMessage message;
    v1::InputBatch& batch = *message.mutable_input();
    batch.set_first_sequence(next_sequence_);
    for (v1::Input& input : inputs) {
        *batch.add_inputs() = input;
        sent_[next_sequence_++] = std::move(input);
    }
    batch.mutable_ack()->set_frame(with_state([](const PlayState& s) { return s.newest_frame; }));
    send(message);
}

void Player::leave() {
    v1::ClientMessage message;
    message.mutable_leave();
    send(message);
}

void Player::take(const v1::ServerMessage& message) {
    const std::lock_guard lock(mutex_);
    state_.take(message);
}

void Player::ended(std::string how) {
    const std::lock_guard lock(mutex_);
    end_ = std::move(how);
}

v1::Input spawn_box(double x, double y, double z, double half) {
    v1::Input input;
    v1::SpawnInput& spawn = *input.mutable_spawn();
    v1::Vec3& size = *spawn.mutable_shape()->mutable_box()->mutable_half_extents();
    size.set_x(half);
    size.set_y(half);
    size.set_z(half);
    spawn.mutable_position()->set_x(x);
    spawn.mutable_position()->set_y(y);
    spawn.mutable_position()->set_z(z);
    return input;
}

v1::Input spawn_ball(double x, double y, double z, double radius) {
    v1::Input input;
    v1::SpawnInput& spawn = *input.mutable_spawn();
    spawn.mutable_shape()->mutable_sphere()->set_radius(radius);
    spawn.mutable_position()->set_x(x);
    spawn.mutable_position()->set_y(y);
    spawn.mutable_position()->set_z(z);
    return input;
}

v1::Input impulse(std::uint32_t entity, double x, double y, double z) {
    v1::Input input;
    input.mutable_impulse()->set_entity(entity);
    input.mutable_impulse()->mutable_impulse()->set_x(x);
    input.mutable_impulse()->mutable_impulse()->set_y(y);
    input.mutable_impulse()->mutable_impulse()->set_z(z);
    return input;
}

v1::Input remove_body(std::uint32_t entity) {
    v1::Input input;
    input.mutable_delete_()->set_entity(entity);
    return input;
}

}  // namespace jostle::test
