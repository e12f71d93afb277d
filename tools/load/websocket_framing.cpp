// SPDX-License-Identifier: MIT
#include "tools/load/websocket_framing.h"

namespace jostle::load {
namespace {

// The example key of RFC 6455, section 1.3, and the server's response to it.
constexpr std::string_view websocket_key = "dGhlIHNhbXBsZSBub25jZQ==";
constexpr std::string_view websocket_accept = "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=";
constexpr std::size_t response_bytes_max = 16 * 1024;

namespace websocket {
enum Opcode : std::uint8_t { continuation = 0, binary = 2, close = 8, ping = 9, pong = 10 };
constexpr std::uint8_t final_bit = 0x80, masked_bit = 0x80;
constexpr std::uint8_t opcode_bits = 0x0f, reserved_bits = 0x70;
}  // namespace websocket

std::uint64_t number_of(Bytes big_endian) {
    std::uint64_t value = 0;
    for (const std::uint8_t byte : big_endian) value = value << 8 | byte;
    return value;
}

Error broken_socket(const std::string& what) {
    return {ErrorCode::corrupt_data, "WebSocket protocol error: " + what};
}

std::string_view chars_of(Bytes bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// The error of a close frame: a two-byte code, then the reason.
Error closed(Bytes payload) {
    std::string reason = "the server closed the WebSocket";
    if (payload.size() >= 2) reason += ", code " + std::to_string(number_of(payload.first(2)));
    if (payload.size() > 2) reason += ": " + std::string(chars_of(payload.subspan(2)));
    return {ErrorCode::aborted, reason};
}

}  // namespace

WebSocketFraming::WebSocketFraming(const std::string& authority) {
    out_ = "GET /play HTTP/1.1\r\nHost: " + authority +
           "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: " +
           std::string(websocket_key) + "\r\nSec-WebSocket-Version: 13\r\n\r\n";
}

void WebSocketFraming::send(std::string_view message) {
    put_frame(open_ ? out_ : pending_until_open_, websocket::binary, message);
}

void WebSocketFraming::put_frame(std::string& out, std::uint8_t opcode, std::string_view payload) {
    const auto put_number = [&](std::uint64_t value, unsigned bytes) {
        for (unsigned k = bytes; k-- > 0;) out.push_back(static_cast<char>(value >> (8 * k)));
    };
    out.push_back(static_cast<char>(websocket::final_bit | opcode));
    if (payload.size() < 126) {
        put_number(websocket::masked_bit | payload.size(), 1);
    } else if (payload.size() <= 0xffff) {
        put_number(websocket::masked_bit | 126, 1);
        put_number(payload.size(), 2);
    } else {
        put_number(websocket::masked_bit | 127, 1);
        put_number(payload.size(), 8);
    }
    put_number(0, 4);  // masking key
    out += payload;
}

Status WebSocketFraming::take(Bytes bytes, Reader& reader) {
    std::string all;
    if (!partial_.empty()) {
        all = std::move(partial_);
        partial_.clear();
        all += chars_of(bytes);
        bytes = {reinterpret_cast<const std::uint8_t*>(all.data()), all.size()};
    }
    std::size_t consumed = 0;
    if (!open_) {
        const Result<std::size_t> answer = take_response(bytes);
        if (!answer.ok()) return answer.error();
        consumed = *answer;
    }
    if (open_) {
        const Result<std::size_t> frames = take_frames(bytes.subspan(consumed), reader);
        if (!frames.ok()) return frames.error();
        consumed += *frames;
    }
    partial_ = chars_of(bytes.subspan(consumed));
    if (out_.size() > outgoing_bytes_max)
        return Error{ErrorCode::resource_exhausted, "the server does not read the stream"};
    return {};
}

// Reads the HTTP response to the upgrade request. Returns 0 if it is incomplete.
Result<std::size_t> WebSocketFraming::take_response(Bytes bytes) {
    const std::string_view answer = chars_of(bytes);
    const std::size_t end = answer.find("\r\n\r\n");
    if (end == std::string_view::npos) {
        if (bytes.size() > response_bytes_max)
            return broken_socket("the response to the upgrade is too long");
        return std::size_t{0};
    }
    const std::string_view head = answer.substr(0, end);
    const std::string_view first = head.substr(0, head.find("\r\n"));
    if (!first.starts_with("HTTP/1.1 101"))
        return Error{ErrorCode::unavailable,
                     "the server rejected the WebSocket: " + std::string(first.substr(0, 200))};
    if (head.find(websocket_accept) == std::string_view::npos)
        return broken_socket("the response does not match the key");
    open_ = true;
    out_ += pending_until_open_;
    pending_until_open_.clear();
    return end + 4;
}

Result<WebSocketFraming::Head> WebSocketFraming::read_head(Bytes bytes) {
    Head head;
    if (bytes.size() < 2) return head;
    if ((bytes[0] & websocket::reserved_bits) != 0) return broken_socket("reserved bit set");
    if ((bytes[1] & websocket::masked_bit) != 0) return broken_socket("masked frame");
    const std::uint8_t shortly = bytes[1];
    const std::size_t more = shortly == 126 ? 2 : shortly == 127 ? 8 : 0;
    if (bytes.size() < 2 + more) return head;
    head = {.size = 2 + more,
            .payload = more == 0 ? shortly : number_of(bytes.subspan(2, more)),
            .opcode = static_cast<std::uint8_t>(bytes[0] & websocket::opcode_bits),
            .final = (bytes[0] & websocket::final_bit) != 0};
    if (head.payload > message_bytes_max)
        return broken_socket("frame of " + std::to_string(head.payload) + " bytes");
    return head;
}

Result<std::size_t> WebSocketFraming::take_frames(Bytes bytes, Reader& reader) {
    std::size_t consumed = 0;
    for (;;) {
        const Bytes at = bytes.subspan(consumed);
        const Result<Head> head = read_head(at);
        if (!head.ok()) return head.error();
        if (head->size == 0 || at.size() - head->size < head->payload) return consumed;
        const auto payload = static_cast<std::size_t>(head->payload);
        if (Status s = on_frame(*head, at.subspan(head->size, payload), reader); !s.ok())
            return s.error();
        consumed += head->size + payload;
    }
}

Status WebSocketFraming::on_frame(const Head& head, Bytes payload, Reader& reader) {
    switch (head.opcode) {
        case websocket::binary:
            if (continues_) return broken_socket("new message within a fragmented one");
            if (head.final) {
                reader.on_message(payload);
                return {};
            }
            message_ = chars_of(payload);
            continues_ = true;
            return {};
        case websocket::continuation:
            if (!continues_) return broken_socket("continuation without a message");
            message_ += chars_of(payload);
            if (message_.size() > message_bytes_max)
                return broken_socket("the message is too long");
            if (!head.final) return {};
            continues_ = false;
            reader.on_message(
                {reinterpret_cast<const std::uint8_t*>(message_.data()), message_.size()});
            message_.clear();
            return {};
        case websocket::ping:
            if (payload.size() > 125) return broken_socket("ping payload above 125 bytes");
            put_frame(out_, websocket::pong, chars_of(payload));
            return {};
        case websocket::pong:
            return {};
        case websocket::close:
            return closed(payload);
        default:
            return broken_socket("unknown opcode " + std::to_string(head.opcode));
    }
}

}  // namespace jostle::load
