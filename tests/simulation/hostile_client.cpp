// SPDX-License-Identifier: MIT
#include "tests/simulation/hostile_client.h"

#include <utility>

namespace jostle::simulation {

HostileClient::HostileClient(std::uint64_t seed, Tally& tally)
    : chance_(seed),
      tally_(tally),
      kind_(static_cast<Kind>(chance_.below(static_cast<std::uint64_t>(Kind::count)))) {}

void HostileClient::connect(std::shared_ptr<NetworkLine> line) {
    line_ = std::move(line);
    sequence_ = 1;
    ticks_ = 0;
    patience_ = static_cast<int>(chance_.below(600));
}

void HostileClient::act(Clock::time_point now) {
    if (!line_) return;
    if (kind_ != Kind::deaf)
        while (const std::optional<std::string> message = line_->receive(now))
            if (kind_ == Kind::liar) frame_++;
    // The deaf client detects the end of its connection only when it sends.
    if (line_->is_over() || (kind_ == Kind::deaf && line_->is_closed())) {
        line_ = nullptr;
        return;
    }
    if (ticks_ == 0 && !(kind_ == Kind::silent && chance_.one_in(2))) send_message(hello(), now);
    ticks_++;
    misbehave(now);
    if (ticks_ > patience_) {
        line_->close_by_client(now);
        line_ = nullptr;
    }
}

void HostileClient::misbehave(Clock::time_point now) {
    switch (kind_) {
        case Kind::garbage:
            if (chance_.one_in(4)) send_message(chance_.bytes(chance_.below(400)), now);
            return;
        case Kind::mutant: {
            std::string bytes =
                (chance_.one_in(4) ? hello() : inputs(1 + static_cast<int>(chance_.below(4))))
                    .SerializeAsString();
            for (std::uint64_t changes = chance_.below(3); changes > 0 && !bytes.empty(); changes--)
                bytes[chance_.below(bytes.size())] ^= static_cast<char>(1 << chance_.below(8));
            return send_message(std::move(bytes), now);
        }
        case Kind::flooder:
            if (chance_.one_in(50)) sequence_ = static_cast<std::uint32_t>(chance_.bits());
            for (int i = 0; i < 3; i++) send_message(inputs(20), now);
            return;
        case Kind::hoarder:
            return send_message(inputs(4), now);
        case Kind::deaf:
        case Kind::liar: {
            v1::ClientMessage ack;
            ack.mutable_ack()->set_frame(
                chance_.one_in(20) ? static_cast<std::uint32_t>(chance_.bits()) : ++frame_);
            ack.mutable_ack()->set_need_keyframe(chance_.one_in(3));
            return send_message(ack, now);
        }
        case Kind::silent:
        case Kind::count:
            return;
    }
}

void HostileClient::send_message(const google::protobuf::Message& message, Clock::time_point now) {
    send_message(message.SerializeAsString(), now);
}

void HostileClient::send_message(std::string bytes, Clock::time_point now) {
    tally_.hostile_messages++;
    line_->send(std::move(bytes), now);
}

v1::ClientMessage HostileClient::hello() const {
    v1::ClientMessage message;
    message.mutable_hello()->set_protocol(1);
    message.mutable_hello()->set_name("\u202ehostile\n\xff");
    message.mutable_hello()->set_events(kind_ == Kind::deaf);
    return message;
}

v1::ClientMessage HostileClient::inputs(int count) {
    v1::ClientMessage message;
    v1::InputBatch& batch = *message.mutable_input();
    batch.set_first_sequence(sequence_);
    sequence_ += static_cast<std::uint32_t>(count);
    for (int i = 0; i < count; i++) *batch.add_inputs() = some_input();
    return message;
}

v1::Input HostileClient::some_input() {
    v1::Input input;
    const auto put = [&](v1::Vec3& to, double reach) {
        to.set_x(chance_.in(-reach, reach));
        to.set_y(chance_.in(0, reach));
        to.set_z(chance_.in(-reach, reach));
    };
    const auto entity = static_cast<std::uint32_t>(chance_.below(40));
    switch (chance_.below(7)) {
        case 0:
        case 1: {
            v1::SpawnInput& spawn = *input.mutable_spawn();
            const double size = chance_.one_in(10) ? chance_.in(-1, 1e3) : 0.3;
            if (chance_.one_in(2))
                spawn.mutable_shape()->mutable_sphere()->set_radius(size);
            else
                put(*spawn.mutable_shape()->mutable_box()->mutable_half_extents(), size);
            put(*spawn.mutable_position(), kind_ == Kind::hoarder ? 0.1 : 10);
            put(*spawn.mutable_linear_velocity(), chance_.one_in(20) ? 1e9 : 5);
            return input;
        }
        case 2:
            input.mutable_impulse()->set_entity(entity);
            put(*input.mutable_impulse()->mutable_impulse(), chance_.one_in(10) ? 1e9 : 50);
            return input;
        case 3:
            input.mutable_grab()->set_entity(entity);
            return input;
        case 4:
            put(*input.mutable_drag()->mutable_target(), chance_.one_in(10) ? 1e6 : 5);
            return input;
        case 5:
            input.mutable_delete_()->set_entity(entity);
            return input;
        default:
            put(*input.mutable_explode()->mutable_center(), 3);
            input.mutable_explode()->set_radius(5);
            input.mutable_explode()->set_speed(chance_.one_in(10) ? 1e6 : 10);
            return input;
    }
}

}  // namespace jostle::simulation
