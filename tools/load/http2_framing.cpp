// SPDX-License-Identifier: MIT
#include "tools/load/http2_framing.h"

#include <algorithm>
#include <utility>

namespace jostle::load {

using http2::FrameType, http2::Setting, http2::big_endian, http2::frame_bytes_max,
    http2::frame_header_bytes;
namespace flags = http2::flags;

namespace {

constexpr std::string_view play_path = "/jostle.v1.PlayService/Play";
constexpr std::uint32_t call_stream = 1;

constexpr std::size_t message_head_size = 5;
constexpr std::size_t waiting_bytes_max = 1 << 20;

// RFC 7541, section 5.1: an integer after `prefix_bits` bits of a byte whose other bits are
// `first`.
void put_hpack_number(std::string& out, std::uint8_t first, unsigned prefix_bits,
                      std::size_t value) {
    const std::size_t full = (std::size_t{1} << prefix_bits) - 1;
    out.push_back(static_cast<char>(first | std::min(value, full)));
    if (value < full) return;
    for (value -= full; value >= 0x80; value >>= 7)
        out.push_back(static_cast<char>(0x80 | (value & 0x7f)));
    out.push_back(static_cast<char>(value));
}

void put_hpack_text(std::string& out, std::string_view text) {
    put_hpack_number(out, 0, 7, text.size());
    out += text;
}

// A literal without indexing, with its name in the static table (RFC 7541, appendix A).
void put_header(std::string& out, std::size_t name_index, std::string_view value) {
    put_hpack_number(out, 0, 4, name_index);
    put_hpack_text(out, value);
}

std::string header_block(const Http2Request& request) {
    std::string block;
    put_hpack_number(block, 0x80, 7, 3);  // :method POST
    put_hpack_number(block, 0x80, 7, 6);  // :scheme http
    put_header(block, 4, play_path);
    put_header(block, 1, request.authority);
    put_header(block, 31, "application/grpc");
    put_header(block, 58, "jostle-load");
    put_hpack_number(block, 0, 4, 0);
    put_hpack_text(block, "te");
    put_hpack_text(block, "trailers");
    if (!request.token.empty()) put_header(block, 23, "Bearer " + request.token);
    return block;
}

Error broken(const std::string& what) {
    return {ErrorCode::corrupt_data, "HTTP/2 protocol error: " + what};
}

// Size of a message including its header, of which `begun` is the start; with less than a header,
// the size of the header.
Result<std::size_t> whole_size(Bytes begun) {
    if (begun[0] != 0) return broken("compressed message");
    if (begun.size() < message_head_size) return message_head_size;
    const std::size_t size = big_endian(begun.subspan(1, 4));
    if (size > message_bytes_max) return broken("message of " + std::to_string(size) + " bytes");
    return message_head_size + size;
}

}  // namespace

Http2Framing::Http2Framing(const Http2Request& request) : window_(request.window) {
    out_ = http2::preface;
    http2::put_frame_header(out_,
                            {.length = 2 * http2::setting_bytes, .type = FrameType::settings});
    put_setting(out_, Setting::enable_push, 0);
    put_setting(out_, Setting::initial_window, window_);
    if (window_ > Http2Request::default_window)
        put_window_update(0, window_ - Http2Request::default_window);
    const std::string block = header_block(request);
    http2::put_frame_header(out_, {.length = static_cast<std::uint32_t>(block.size()),
                                   .type = FrameType::headers,
                                   .flags = flags::end_headers,
                                   .stream = call_stream});
    out_ += block;
}

// --- sending ---

void Http2Framing::put_window_update(std::uint32_t stream, std::uint32_t increment) {
    http2::put_frame_header(out_,
                            {.length = 4, .type = FrameType::window_update, .stream = stream});
    http2::put_big_endian(out_, increment, 4);
}

void Http2Framing::send(std::string_view message) {
    std::string framed(1, '\0');  // not compressed
    http2::put_big_endian(framed, message.size(), 4);
    framed += message;
    for (std::size_t at = 0; at < framed.size(); at += frame_bytes_max) {
        waiting_.push_back(framed.substr(at, frame_bytes_max));
        waiting_bytes_ += waiting_.back().size();
    }
    send_waiting();
}

void Http2Framing::send_waiting() {
    while (!waiting_.empty()) {
        const std::string& next = waiting_.front();
        const auto size = static_cast<std::int64_t>(next.size());
        if (size > std::min(connection_credit_, stream_credit_)) return;
        connection_credit_ -= size;
        stream_credit_ -= size;
        http2::put_frame_header(out_, {.length = static_cast<std::uint32_t>(next.size()),
                                       .type = FrameType::data,
                                       .stream = call_stream});
        out_ += next;
        waiting_bytes_ -= next.size();
        waiting_.pop_front();
    }
}

void Http2Framing::consume(std::size_t message_bytes) {
    const std::size_t size = message_bytes + message_head_size;
    if (!is_large(size)) replenish_window(size);
}

// The server can send the end of a message larger than the window only after the window was
// replenished, so such a message is consumed as it arrives.
bool Http2Framing::is_large(std::size_t size) const {
    return size > window_ / 2;
}

// Sent after half of the window: one WINDOW_UPDATE per message would cost the server as much as its
// own frame.
void Http2Framing::replenish_window(std::size_t bytes) {
    unreported_bytes_ += static_cast<std::uint32_t>(bytes);
    if (unreported_bytes_ < window_ / 2) return;
    put_window_update(0, unreported_bytes_);
    put_window_update(call_stream, unreported_bytes_);
    unused_ -= unreported_bytes_;
    unreported_bytes_ = 0;
}

// --- receiving ---

Status Http2Framing::take(Bytes bytes, Reader& reader) {
    if (!partial_.empty()) {
        partial_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        const std::string all = std::move(partial_);
        partial_.clear();
        return take({reinterpret_cast<const std::uint8_t*>(all.data()), all.size()}, reader);
    }
    const Result<std::size_t> consumed = take_frames(bytes, reader);
    if (!consumed.ok()) return consumed.error();
    partial_.assign(reinterpret_cast<const char*>(bytes.data()) + *consumed,
                    bytes.size() - *consumed);
    if (waiting_bytes_ > waiting_bytes_max || out_.size() > outgoing_bytes_max)
        return Error{ErrorCode::resource_exhausted, "the server does not read the stream"};
    return {};
}

Result<std::size_t> Http2Framing::take_frames(Bytes bytes, Reader& reader) {
    std::size_t consumed = 0;
    while (bytes.size() - consumed >= frame_header_bytes) {
        const Bytes at = bytes.subspan(consumed);
        const Head head = http2::read_frame_header(at.first<frame_header_bytes>());
        if (head.length > frame_bytes_max)
            return broken("frame of " + std::to_string(head.length) + " bytes");
        if (at.size() < frame_header_bytes + head.length) break;
        if (Status s = on_frame(head, at.subspan(frame_header_bytes, head.length), reader); !s.ok())
            return s.error();
        consumed += frame_header_bytes + head.length;
    }
    return consumed;
}

Status Http2Framing::on_frame(const Head& head, Bytes payload, Reader& reader) {
    if (header_block_open_ && head.type != FrameType::continuation)
        return broken("truncated header block");
    switch (head.type) {
        case FrameType::data:
            return on_data(head, payload, reader);
        case FrameType::headers:
        case FrameType::continuation:
            return on_headers(head);
        case FrameType::rst_stream:
            if (payload.size() != 4) return broken("RST_STREAM");
            return Error{ErrorCode::aborted, "the server reset the stream, code " +
                                                 std::to_string(big_endian(payload))};
        case FrameType::settings:
            return on_settings(head, payload);
        case FrameType::push_promise:
            return broken("PUSH_PROMISE");
        case FrameType::ping:
            if (payload.size() != 8) return broken("PING");
            if (head.has(flags::acknowledged)) return {};
            http2::put_frame_header(
                out_, {.length = 8, .type = FrameType::ping, .flags = flags::acknowledged});
            out_.append(reinterpret_cast<const char*>(payload.data()), payload.size());
            return {};
        case FrameType::goaway:
            if (payload.size() < 8) return broken("GOAWAY");
            return Error{ErrorCode::unavailable,
                         "the server sent GOAWAY, code " +
                             std::to_string(big_endian(payload.subspan(4, 4)))};
        case FrameType::window_update:
            return on_window_update(head, payload);
        default:
            return {};  // PRIORITY and unknown types
    }
}

Status Http2Framing::on_data(const Head& head, Bytes payload, Reader& reader) {
    if (head.stream != call_stream) return broken("DATA on an unknown stream");
    unused_ += head.length;
    if (unused_ > window_) return broken("DATA exceeds the window");
    if (head.has(flags::padded)) {
        if (payload.empty() || payload[0] >= payload.size()) return broken("padding");
        const std::size_t padding = payload[0];
        payload = payload.subspan(1, payload.size() - 1 - padding);
        replenish_window(1 + padding);
    }
    if (Status s = on_messages(payload, reader); !s.ok()) return s;
    if (head.has(flags::end_stream)) return broken("DATA with END_STREAM");
    return {};
}

// Each message consists of a compression flag, its length and its bytes.
Status Http2Framing::on_messages(Bytes bytes, Reader& reader) {
    while (!bytes.empty()) {
        const Result<std::size_t> size = whole_size(message_.empty() ? bytes : partial_message());
        if (!size.ok()) return size.error();
        if (message_.empty() && bytes.size() >= *size) {
            reader.on_message(bytes.first(*size).subspan(message_head_size));
            if (is_large(*size)) replenish_window(*size);
            bytes = bytes.subspan(*size);
            continue;
        }
        const std::size_t piece = std::min(*size - message_.size(), bytes.size());
        message_.append(reinterpret_cast<const char*>(bytes.data()), piece);
        bytes = bytes.subspan(piece);
        if (Status s = on_piece(reader); !s.ok()) return s;
    }
    return {};
}

Status Http2Framing::on_piece(Reader& reader) {
    if (message_.size() < message_head_size) return {};
    const Result<std::size_t> size = whole_size(partial_message());
    if (!size.ok()) return size.error();
    if (is_large(*size))
        replenish_window(message_.size() - std::exchange(replenished_bytes_, message_.size()));
    if (message_.size() < *size) return {};
    reader.on_message(partial_message().subspan(message_head_size));
    message_.clear();
    replenished_bytes_ = 0;
    return {};
}

Bytes Http2Framing::partial_message() const {
    return {reinterpret_cast<const std::uint8_t*>(message_.data()), message_.size()};
}

Status Http2Framing::on_headers(const Head& head) {
    if (head.type == FrameType::continuation && !header_block_open_)
        return broken("CONTINUATION without HEADERS");
    if (head.type == FrameType::headers) header_ends_stream_ = head.has(flags::end_stream);
    header_block_open_ = !head.has(flags::end_headers);
    if (!header_block_open_ && header_ends_stream_)
        return Error{ErrorCode::aborted, "the server ended the stream"};
    return {};
}

Status Http2Framing::on_settings(const Head& head, Bytes payload) {
    if (head.has(flags::acknowledged)) return {};
    if (payload.size() % http2::setting_bytes != 0) return broken("SETTINGS");
    for (; !payload.empty(); payload = payload.subspan(http2::setting_bytes)) {
        if (Setting{static_cast<std::uint16_t>(big_endian(payload.first(2)))} !=
            Setting::initial_window)
            continue;
        const std::uint32_t window = big_endian(payload.subspan(2, 4));
        if (window > Http2Request::window_max)
            return broken("initial window of " + std::to_string(window));
        stream_credit_ += static_cast<std::int64_t>(window) - server_window_;
        server_window_ = window;
    }
    http2::put_frame_header(out_, {.type = FrameType::settings, .flags = flags::acknowledged});
    send_waiting();
    return {};
}

Status Http2Framing::on_window_update(const Head& head, Bytes payload) {
    if (payload.size() != 4) return broken("WINDOW_UPDATE");
    const std::uint32_t increment = big_endian(payload) & 0x7fff'ffff;
    if (increment == 0) return broken("WINDOW_UPDATE of 0");
    std::int64_t& credit = head.stream == 0 ? connection_credit_ : stream_credit_;
    credit += increment;
    if (credit > Http2Request::window_max) return broken("window overflow");
    send_waiting();
    return {};
}

}  // namespace jostle::load
