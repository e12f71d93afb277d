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
    static constexpr auto silence_max = std::chrono::milliseconds(1000);

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
        return heard_ != Clock::time_point{} && now - heard_ < silence_max;
    }
    // It was tried for so long, and the server was not heard.
    bool given_up(Clock::time_point now) const {
        return !alive(now) && now - std::max(opened_, heard_) > silence_max;
    }

private:
    DatagramSocket(int descriptor, std::unique_ptr<datagram::PacketCipher> cipher, Clock::time_point now)
        : descriptor_(descriptor), cipher_(std::move(cipher)), opened_(now) {}
    std::optional<std::string> take(const std::string& content);
    void transmit(const std::string& content);

    const int descriptor_;
    const std::unique_ptr<datagram::PacketCipher> cipher_;
    datagram::Reassembly reassembly_;
    const Clock::time_point opened_;
    Clock::time_point heard_{};
};

}  // namespace jostle::client
