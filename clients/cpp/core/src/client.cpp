// SPDX-License-Identifier: MIT
#include "jostle/client/client.h"

#include "clients/cpp/core/src/client_state.h"
#include "clients/cpp/core/src/loop_thread.h"

namespace jostle::client {

namespace {

std::unique_lock<std::mutex> locked(const ClientState& state) {
    return std::unique_lock(state.mutex);
}

}  // namespace

Client::Client(std::shared_ptr<ClientState> state) : state_(std::move(state)) {}
Client::~Client() {
    state_->destroyed = true;
}

std::shared_ptr<Client> Client::connect(Loop& loop, ClientOptions options) {
    auto state = std::make_shared<ClientState>(std::move(options));
    loop.thread_->add(state);
    return std::shared_ptr<Client>(new Client(std::move(state)));
}

std::uint32_t Client::send(v1::Input input) {
    const auto lock = locked(*state_);
    PlayProtocol& c = state_->protocol;
    if (c.options().timed_inputs && input.tick() == 0)
        input.set_tick(c.input_clock().tick(static_cast<std::int64_t>(to_us(Clock::now()))));
    return c.send(std::move(input));
}

double Client::input_position(Clock::time_point now) {
    const auto lock = locked(*state_);
    return state_->protocol.input_clock().position(static_cast<std::int64_t>(to_us(now)));
}

std::uint32_t Client::input_tick(Clock::time_point now) {
    const auto lock = locked(*state_);
    return state_->protocol.input_clock().tick(static_cast<std::int64_t>(to_us(now)));
}

void Client::set_interest(const AreaOfInterest& interest) {
    const std::lock_guard lock(state_->mutex);
    state_->protocol.set_interest(interest);
}

void Client::request_keyframe() {
    const auto lock = locked(*state_);
    state_->protocol.request_keyframe();
}

void Client::leave() {
    const auto lock = locked(*state_);
    state_->protocol.leave();
}

void Client::read(const std::function<void(const WorldView&)>& reader) const {
    const auto lock = locked(*state_);
    reader(state_->protocol.view());
}

std::vector<SmoothPose> Client::interpolated(Clock::time_point now) {
    const auto lock = locked(*state_);
    PlayProtocol& c = state_->protocol;
    return c.buffer().sample(static_cast<std::int64_t>(to_us(now)), c.view().spec());
}

std::vector<SmoothPoints> Client::interpolated_points() {
    const auto lock = locked(*state_);
    return state_->protocol.interpolated_points();
}

v1::ViewTime Client::rendered_time() const {
    const auto lock = locked(*state_);
    return state_->protocol.rendered_time();
}

std::vector<v1::InputResult> Client::take_results() {
    const auto lock = locked(*state_);
    return state_->protocol.take_results();
}

std::vector<v1::Events> Client::take_events() {
    const auto lock = locked(*state_);
    return state_->protocol.take_events();
}

std::vector<v1::UserMessage> Client::take_messages() {
    const auto lock = locked(*state_);
    return state_->protocol.take_messages();
}

std::vector<v1::PlayerEvent> Client::take_player_events() {
    const auto lock = locked(*state_);
    return state_->protocol.take_player_events();
}

std::vector<float> Client::take_ages_ms() {
    const auto lock = locked(*state_);
    return state_->protocol.take_ages_ms();
}

ClientStats Client::stats() const {
    const auto lock = locked(*state_);
    return state_->protocol.stats();
}

std::optional<v1::WorldStats> Client::world_stats() const {
    const auto lock = locked(*state_);
    return state_->protocol.world_stats();
}

}  // namespace jostle::client
