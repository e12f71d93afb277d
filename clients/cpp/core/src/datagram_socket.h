// SPDX-License-Identifier: MIT
//
// The client's end of the datagrams of one stream (proto/WIRE.md, "Datagrams"): a UDP socket
// connected to the server. It encrypts outgoing packets, decrypts and reassembles incoming ones,
// and answers path challenges. Used by the loop's thread only.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "jostle/base/result.h"
#include "jostle/client/clock_sync.h"
#include "jostle/datagram/packet.h"
#include "jostle/datagram/reassembly.h"
#include "jostle/v1/play.pb.h"

namespace jostle::client {

class DatagramSocket {
public:
    // After this time without a packet the path counts as blocked.
    static constexpr auto receive_timeout = std::chrono::milliseconds(1000);

    // `peer`: address of the stream in gRPC's format, "ipv4:192.0.2.7:50051". Errors name the
    // invalid part of the credentials or the address.
    static Result<std::unique_ptr<DatagramSocket>> open(const v1::DatagramCredentials& ticket,
                                                        const std::string& peer,
                                                        Clock::time_point now);
    ~DatagramSocket();
    DatagramSocket(const DatagramSocket&) = delete;
    DatagramSocket& operator=(const DatagramSocket&) = delete;

    int descriptor() const { return descriptor_; }
    // Returns the next complete message, or nothing.
    std::optional<std::string> receive(Clock::time_point now);
    void send(const std::string& message);

    // A packet was received recently.
    bool alive(Clock::time_point now) const {
        return last_received_ != Clock::time_point{} && now - last_received_ < receive_timeout;
    }
    // No packet was received within the timeout since the start.
    bool timed_out(Clock::time_point now) const {
        return !alive(now) && now - std::max(opened_, last_received_) > receive_timeout;
    }

private:
    DatagramSocket(int descriptor, std::unique_ptr<datagram::PacketCipher> cipher,
                   Clock::time_point now)
        : descriptor_(descriptor), cipher_(std::move(cipher)), opened_(now) {}
    std::optional<std::string> take(const std::string& content);
    void transmit(const std::string& content);

    const int descriptor_;
    const std::unique_ptr<datagram::PacketCipher> cipher_;
    datagram::Reassembly reassembly_;
    const Clock::time_point opened_;
    Clock::time_point last_received_{};
};

}  // namespace jostle::client
