// SPDX-License-Identifier: MIT
//
// The client's end of the datagrams of one stream (proto/WIRE.md, "Datagrams"): a UDP socket that
// is connected to the server, seals what goes out, opens and puts together what comes in, and
// answers when it is asked. The loop's thread.
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
    // Who heard nothing for so long takes the way for blocked.
    static constexpr auto receive_timeout = std::chrono::milliseconds(1000);

    // `peer`: where the stream is connected, as gRPC names it: "ipv4:192.0.2.7:50051". An error
    // says what the ticket or the address lacks.
    static Result<std::unique_ptr<DatagramSocket>> open(const v1::DatagramCredentials& ticket,
                                                        const std::string& peer,
                                                        Clock::time_point now);
    ~DatagramSocket();
    DatagramSocket(const DatagramSocket&) = delete;
    DatagramSocket& operator=(const DatagramSocket&) = delete;

    int descriptor() const { return descriptor_; }
    // The next whole message that came; nothing: no more has.
    std::optional<std::string> receive(Clock::time_point now);
    void send(const std::string& message);

    // The server was heard lately.
    bool alive(Clock::time_point now) const {
        return last_received_ != Clock::time_point{} && now - last_received_ < receive_timeout;
    }
    // It was tried for so long, and the server was not heard.
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
