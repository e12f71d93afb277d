// SPDX-License-Identifier: MIT
#include "server/udp/datagram_connection.h"

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

// A client that receives nothing assumes that the path is blocked, so it is challenged
// periodically.
constexpr auto challenge_interval = std::chrono::milliseconds(250);

std::optional<std::uint64_t> random_token() {
    std::uint64_t token = 0;
    if (getentropy(&token, sizeof token) != 0) return std::nullopt;
    return token;
}

}  // namespace

// Bytes beyond address and port (padding, flow labels) may differ.
bool DatagramAddress::operator==(const DatagramAddress& other) const {
    if (bytes.ss_family != other.bytes.ss_family) return false;
    if (bytes.ss_family == AF_INET) {
        const auto& a = reinterpret_cast<const sockaddr_in&>(bytes);
        const auto& b = reinterpret_cast<const sockaddr_in&>(other.bytes);
        return a.sin_port == b.sin_port && a.sin_addr.s_addr == b.sin_addr.s_addr;
    }
    const auto& a = reinterpret_cast<const sockaddr_in6&>(bytes);
    const auto& b = reinterpret_cast<const sockaddr_in6&>(other.bytes);
    return a.sin6_port == b.sin6_port && a.sin6_scope_id == b.sin6_scope_id &&
           std::memcmp(&a.sin6_addr, &b.sin6_addr, sizeof a.sin6_addr) == 0;
}

DatagramConnection::DatagramConnection(std::unique_ptr<datagram::PacketCipher> cipher, int socket,
                                       std::function<void(std::string_view)> on_message,
                                       Metrics* metrics)
    : cipher_(std::move(cipher)),
      socket_(socket),
      on_message_(std::move(on_message)),
      metrics_(metrics) {}

bool DatagramConnection::is_open(Clock::time_point now) const {
    const std::lock_guard lock(mutex_);
    return address_ && now - received_at_ < receive_timeout;
}

void DatagramConnection::restart_path_validation() {
    const std::lock_guard lock(mutex_);
    address_.reset();
    pending_challenge_.reset();
}

void DatagramConnection::send(std::span<const std::string_view> pieces, Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (!address_) return;
    std::vector<std::string> packets = datagram::encode_message(pieces, ++messages_);
    for (std::string& packet : packets) packet = cipher_->encrypt(packet);
    transmit(packets, *address_, now);
}

std::vector<DatagramConnection::ReceivedMessage> DatagramConnection::take_messages() {
    const std::lock_guard lock(mutex_);
    has_messages_.store(false, std::memory_order_release);
    return std::exchange(received_, {});
}

void DatagramConnection::receive(std::string_view packet, const DatagramAddress& from,
                                 Clock::time_point now) {
    std::string message;
    if (take_packet(packet, from, now, message)) on_message_(message);
}

// Returns true if a message was queued.
bool DatagramConnection::take_packet(std::string_view packet, const DatagramAddress& from,
                                     Clock::time_point now, std::string& message) {
    const std::lock_guard lock(mutex_);
    const auto opened = cipher_->decrypt(packet);
    const auto content = opened ? datagram::decode_content(opened->content)
                                : Result<datagram::Content>(invalid_argument("not authentic"));
    if (metrics_)
        (content.ok() ? metrics_->datagrams_received : metrics_->datagrams_refused).Increment();
    if (!content.ok()) return false;
    received_at_ = std::max(received_at_, now);
    validate_address(*content, from, opened->newest, now);
    const auto* decoded = std::get_if<datagram::Message>(&*content);
    if (!decoded || received_.size() == received_max) return false;
    message = decoded->bytes;
    received_.push_back({message, now});
    ASSERT(received_.size() <= received_max);
    has_messages_.store(true, std::memory_order_release);
    return true;
}

void DatagramConnection::validate_address(const datagram::Content& content,
                                          const DatagramAddress& from, bool newest,
                                          Clock::time_point now) {
    if (address_ && *address_ == from) {
        if (now - sent_ > challenge_interval)
            if (const auto token = random_token()) send_challenge(from, *token, now);
        return;
    }
    if (pending_challenge_ && pending_challenge_->where == from)
        if (const auto* response = std::get_if<datagram::PathResponse>(&content);
            response && response->token == pending_challenge_->token) {
            address_ = from;
            pending_challenge_.reset();
            return;
        }
    // A reordered packet may come from a previous address of the client.
    if (!newest) return;
    if (!pending_challenge_ || !(pending_challenge_->where == from)) {
        const auto token = random_token();
        if (!token) return;
        pending_challenge_ = {from, *token};
    }
    ASSERT(pending_challenge_);
    send_challenge(from, pending_challenge_->token, now);
}

void DatagramConnection::send_challenge(const DatagramAddress& where, std::uint64_t token,
                                        Clock::time_point now) {
    const std::string packet = cipher_->encrypt(datagram::encode(datagram::PathChallenge{token}));
    transmit(std::span(&packet, 1), where, now);
}

// Packets that the kernel does not accept are lost, as on the network.
void DatagramConnection::transmit(std::span<const std::string> packets, const DatagramAddress& to,
                                  Clock::time_point now) {
    ASSERT(packets.size() <= datagram::fragments_max);
    DatagramAddress address = to;
    std::array<mmsghdr, datagram::fragments_max> messages{};
    std::array<iovec, datagram::fragments_max> pieces{};
    for (std::size_t k = 0; k < packets.size(); k++) {
        pieces[k] = {const_cast<char*>(packets[k].data()), packets[k].size()};
        messages[k].msg_hdr.msg_name = &address.bytes;
        messages[k].msg_hdr.msg_namelen = address.size;
        messages[k].msg_hdr.msg_iov = &pieces[k];
        messages[k].msg_hdr.msg_iovlen = 1;
    }
    if (!packets.empty())
        sendmmsg(socket_, messages.data(), static_cast<unsigned>(packets.size()),
                 MSG_DONTWAIT | MSG_NOSIGNAL);
    sent_ = now;
    if (metrics_) metrics_->datagrams_sent.Increment(static_cast<double>(packets.size()));
}

}  // namespace jostle::server
