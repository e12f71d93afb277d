// SPDX-License-Identifier: MIT
#include "server/grpc_web/grpc_web_framing.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "jostle/base/base64.h"

namespace jostle::server {

namespace {

constexpr std::size_t frame_header_bytes = 5;
constexpr char data_flag = 0, compressed_flag = 1;
constexpr auto trailers_flag = static_cast<char>(0x80);

void add_frame(std::string& out, char flag, std::string_view bytes) {
    out += flag;
    for (int shift = 24; shift >= 0; shift -= 8)
        out += static_cast<char>(static_cast<std::uint32_t>(bytes.size()) >> shift);
    out += bytes;
}

std::string base64_of(std::string_view bytes) {
    return encode_base64(std::as_bytes(std::span(bytes)));
}

// Clients may concatenate encoded pieces, each of which ends with its padding.
std::optional<std::string> decode_pieces(std::string_view text) {
    std::string bytes;
    while (!text.empty()) {
        const std::size_t padding = text.find('=');
        std::size_t end = text.size();
        if (padding != std::string_view::npos) end = std::min(text.size(), (padding / 4 + 1) * 4);
        const auto piece = decode_base64<std::string>(text.substr(0, end));
        if (!piece.ok()) return std::nullopt;
        bytes += *piece;
        text.remove_prefix(end);
    }
    return bytes;
}

// Trailers are lines: everything but printable ASCII is escaped as %XX, also '%'.
std::string percent_encoded(std::string_view text) {
    std::string out;
    for (const char c : text)
        if (c >= ' ' && c <= '~' && c != '%')
            out += c;
        else
            out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    return out;
}

}  // namespace

std::optional<GrpcWebForm> grpc_web_form(std::string_view content_type) {
    content_type = content_type.substr(0, content_type.find(';'));
    for (const auto& [name, form] : {std::pair("application/grpc-web", GrpcWebForm::binary),
                                     std::pair("application/grpc-web-text", GrpcWebForm::text)})
        if (content_type == name || content_type == std::string(name) + "+proto") return form;
    return std::nullopt;
}

std::string content_type_of(GrpcWebForm form) {
    return form == GrpcWebForm::text ? "application/grpc-web-text+proto"
                                     : "application/grpc-web+proto";
}

Result<std::string> read_grpc_web_request(std::string_view body, GrpcWebForm form) {
    std::string decoded;
    if (form == GrpcWebForm::text) {
        auto bytes = decode_pieces(body);
        if (!bytes) return invalid_argument("the body is not base64");
        decoded = *std::move(bytes);
        body = decoded;
    }
    if (body.size() < frame_header_bytes)
        return invalid_argument(fmt::format("the body has {} bytes; a message has a header of {}",
                                            body.size(), frame_header_bytes));
    if (body[0] == compressed_flag)
        return invalid_argument("the message is compressed; send it without compression");
    if (body[0] != data_flag)
        return invalid_argument(fmt::format("the message has the flags {:#04x}; they must be 0",
                                            static_cast<unsigned char>(body[0])));
    std::uint32_t length = 0;
    for (std::size_t i = 1; i < frame_header_bytes; i++)
        length = length << 8 | static_cast<unsigned char>(body[i]);
    body.remove_prefix(frame_header_bytes);
    if (body.size() != length)
        return invalid_argument(
            fmt::format("the header of the message announces {} bytes, and {} follow; a request "
                        "has one message",
                        length, body.size()));
    return std::string(body);
}

std::string write_grpc_web_response(const std::optional<std::string_view>& message, int code,
                                    std::string_view text, std::string_view details,
                                    GrpcWebForm form) {
    std::string body;
    if (message) add_frame(body, data_flag, *message);
    std::string trailers = fmt::format("grpc-status: {}\r\n", code);
    if (!text.empty()) trailers += fmt::format("grpc-message: {}\r\n", percent_encoded(text));
    if (!details.empty())
        trailers += fmt::format("grpc-status-details-bin: {}\r\n", base64_of(details));
    add_frame(body, trailers_flag, trailers);
    return form == GrpcWebForm::text ? base64_of(body) : body;
}

std::optional<std::chrono::nanoseconds> parse_grpc_timeout(std::string_view text) {
    constexpr std::size_t digits_max = 8;
    static constexpr std::array units = {std::pair('H', std::int64_t{3'600'000'000'000}),
                                         std::pair('M', std::int64_t{60'000'000'000}),
                                         std::pair('S', std::int64_t{1'000'000'000}),
                                         std::pair('m', std::int64_t{1'000'000}),
                                         std::pair('u', std::int64_t{1'000}),
                                         std::pair('n', std::int64_t{1})};
    if (text.size() < 2 || text.size() > digits_max + 1) return std::nullopt;
    std::int64_t value = 0;
    for (const char c : text.substr(0, text.size() - 1)) {
        if (c < '0' || c > '9') return std::nullopt;
        value = 10 * value + (c - '0');
    }
    // 10^8 hours exceed the range; a year is as good.
    constexpr std::int64_t nanoseconds_max = std::int64_t{365} * 24 * 3'600'000'000'000;
    for (const auto& [unit, nanoseconds] : units)
        if (unit == text.back())
            return std::chrono::nanoseconds(
                value > nanoseconds_max / nanoseconds ? nanoseconds_max : value * nanoseconds);
    return std::nullopt;
}

}  // namespace jostle::server
