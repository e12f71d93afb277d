// SPDX-License-Identifier: MIT
//
// The datagram path of one client: its session key, its validated address and its received
// messages. An unvalidated address is sent only a challenge of 41 bytes until a holder of the key
// responds from there; so a spoofed source address receives no more bytes than the attacker sent.
// When the client's newest packet comes from another address, that address is challenged, and the
// previous address continues to receive snapshots until it responds.
//
// Threads: the server's thread passes packets in; the session's thread sends, and takes received
// messages.
#pragma once

#include <netinet/in.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/datagram/content.h"
#include "jostle/datagram/packet.h"
#include "server/metrics/metrics.h"
#include "server/util/clock.h"

namespace jostle::server {

struct DatagramAddress {
    sockaddr_storage bytes{};
    socklen_t size = 0;

    bool operator==(const DatagramAddress& other) const;
};

class DatagramConnection {
public:
    static constexpr std::size_t received_max = 256;  // queued; further messages are dropped
    // A client that was silent for this long is sent nothing.
    static constexpr auto receive_timeout = std::chrono::seconds(2);

    // `on_message`: called on any thread for each queued message; must be fast.
    DatagramConnection(std::unique_ptr<datagram::PacketCipher> cipher, int socket,
                       std::function<void(std::string_view)> on_message, Metrics* metrics);

    const datagram::Credentials& credentials() const { return cipher_->credentials(); }

    // Whether a holder of the key has responded and was heard within receive_timeout.
    bool is_open(Clock::time_point now) const;
    // Sends nothing until the client responds to a new challenge; used when it seems to receive
    // nothing.
    void restart_path_validation();
    // Sends a message, given in pieces. It is lost silently if there is no validated address, if it
    // needs more than datagram::fragments_max fragments, or if the socket buffer is full.
    void send(std::span<const std::string_view> pieces, Clock::time_point now);

    struct ReceivedMessage {
        std::string message;
        Clock::time_point at;
    };
    bool has_messages() const { return has_messages_.load(std::memory_order_acquire); }
    std::vector<ReceivedMessage> take_messages();

    // A packet with this session's id; the sender is not trusted.
    void receive(std::string_view packet, const DatagramAddress& from, Clock::time_point now);

private:
    bool take_packet(std::string_view packet, const DatagramAddress& from, Clock::time_point now,
                     std::string& message);
    void send_challenge(const DatagramAddress& where, std::uint64_t token, Clock::time_point now);
    void validate_address(const datagram::Content& content, const DatagramAddress& from,
                          bool newest, Clock::time_point now);
    void transmit(std::span<const std::string> packets, const DatagramAddress& to,
                  Clock::time_point now);

    struct PendingChallenge {
        DatagramAddress where;
        std::uint64_t token = 0;  // secret: only a receiver at `where` can respond
    };

    mutable std::mutex mutex_;
    const std::unique_ptr<datagram::PacketCipher> cipher_;
    const int socket_;
    const std::function<void(std::string_view)> on_message_;
    Metrics* const metrics_;
    std::optional<DatagramAddress> address_;  // validated
    // of a new address that has not responded yet
    std::optional<PendingChallenge> pending_challenge_;
    Clock::time_point received_at_{}, sent_{};
    std::uint32_t messages_ = 0;  // number of messages sent
    std::vector<ReceivedMessage> received_;
    std::atomic<bool> has_messages_{false};
};

}  // namespace jostle::server
