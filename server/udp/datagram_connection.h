// SPDX-License-Identifier: MIT
//
// One client's way by datagrams: its ticket, where it is, what it sent. Nothing but a question of
// 41 bytes goes to an address before somebody with the key has answered it from there: who names
// another's address sends him no more than he sent himself. When the client's newest packet comes
// from elsewhere, that place is asked in turn, and until it answers the old one keeps its
// snapshots.
//
// Thread rule: the port's thread hands in packets, the link's thread sends and takes mail.
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
    static constexpr std::size_t received_max = 256;  // not taken yet; more is dropped
    // Who has not been heard for so long is not sent to.
    static constexpr auto receive_timeout = std::chrono::seconds(2);

    // `on_message`: any thread, for each message that was put into the mail; it must be quick.
    DatagramConnection(std::unique_ptr<datagram::PacketCipher> cipher, int socket,
                       std::function<void(std::string_view)> on_message, Metrics* metrics);

    const datagram::Credentials& credentials() const { return cipher_->credentials(); }

    // Somebody answered with the key, and was heard lately.
    bool is_open(Clock::time_point now) const;
    // Nothing is sent until the client has answered again: it seems not to get what it is sent.
    void restart_path_validation();
    // A message, given in pieces; lost without a word when there is nobody, when it needs more than
    // datagram::fragments_max parts, or when the system's buffer is full.
    void send(std::span<const std::string_view> pieces, Clock::time_point now);

    struct ReceivedMessage {
        std::string message;
        Clock::time_point at;
    };
    bool has_messages() const { return has_messages_.load(std::memory_order_acquire); }
    std::vector<ReceivedMessage> take_messages();

    // A packet that names the ticket; anybody may have sent it.
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
        std::uint64_t token = 0;  // secret: only who is there can answer
    };

    mutable std::mutex mutex_;
    const std::unique_ptr<datagram::PacketCipher> cipher_;
    const int socket_;
    const std::function<void(std::string_view)> on_message_;
    Metrics* const metrics_;
    std::optional<DatagramAddress> address_;             // that answered
    std::optional<PendingChallenge> pending_challenge_;  // another, that has not yet
    Clock::time_point received_at_{}, sent_{};
    std::uint32_t messages_ = 0;  // sent
    std::vector<ReceivedMessage> received_;
    std::atomic<bool> has_messages_{false};
};

}  // namespace jostle::server
