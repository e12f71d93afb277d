// SPDX-License-Identifier: MIT
#include "jostle/client/client.h"

#include "loop_impl.h"

namespace jostle::client {

namespace {

// Client::Impl belongs to Client and to the loop: the last of the two lets go.
template <class T>
std::unique_lock<std::mutex> locked(const T& impl) {
    return std::unique_lock(impl.mutex);
}

}  // namespace

Client::Client(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}
Client::~Client() {
    impl_->gone = true;
}

std::shared_ptr<Client> Client::connect(Loop& loop, ClientOptions options) {
    auto impl = std::make_shared<Impl>(std::move(options));
    loop.impl_->add(impl);
    return std::shared_ptr<Client>(new Client(std::move(impl)));
}

std::uint32_t Client::send(v1::Input input) {
    const auto lock = locked(*impl_);
    return impl_->conversation.send(std::move(input));
}

void Client::leave() {
    const auto lock = locked(*impl_);
    impl_->conversation.leave();
}

void Client::read(const std::function<void(const WorldView&)>& reader) const {
    const auto lock = locked(*impl_);
    reader(impl_->conversation.view());
}

std::vector<SmoothPose> Client::interpolated(Clock::time_point now) const {
    const auto lock = locked(*impl_);
    const Conversation& c = impl_->conversation;
    return c.buffer().sample(c.clock().server_us(now), c.view().spec());
}

std::vector<v1::InputResult> Client::take_results() {
    const auto lock = locked(*impl_);
    return impl_->conversation.take_results();
}

std::vector<v1::Events> Client::take_events() {
    const auto lock = locked(*impl_);
    return impl_->conversation.take_events();
}

std::vector<float> Client::take_ages_ms() {
    const auto lock = locked(*impl_);
    return impl_->conversation.take_ages_ms();
}

ClientStats Client::stats() const {
    const auto lock = locked(*impl_);
    return impl_->conversation.stats();
}

std::optional<v1::WorldStats> Client::world_stats() const {
    const auto lock = locked(*impl_);
    return impl_->conversation.world_stats();
}

}  // namespace jostle::client
