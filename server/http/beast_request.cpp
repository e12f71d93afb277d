// SPDX-License-Identifier: MIT
#include "server/http/beast_request.h"

#include <arpa/inet.h>

#include <algorithm>
#include <boost/beast/core/string.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <iterator>
#include <string>
#include <string_view>

namespace jostle::server {

namespace {

using boost::beast::http::field;

constexpr std::size_t host_bytes_max = 255;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_port(std::string_view port) {
    return port.size() <= 5 && std::ranges::all_of(port, is_digit) &&
           (port.empty() || std::stoi(std::string(port)) <= 65535);
}

bool is_host_name(std::string_view name) {
    return !name.empty() && std::ranges::all_of(name, [](char c) {
        return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
               c == '.' || c == '_';
    });
}

bool is_ipv6_address(std::string_view address) {
    in6_addr out{};
    return inet_pton(AF_INET6, std::string(address).c_str(), &out) == 1;
}

// "play.example.org", "192.0.2.7:8080", "[2001:db8::1]:8080".
bool is_host(std::string_view host) {
    if (host.size() > host_bytes_max) return false;
    if (host.starts_with('[')) {
        const std::size_t end = host.find(']');
        if (end == std::string_view::npos || !is_ipv6_address(host.substr(1, end - 1)))
            return false;
        const std::string_view rest = host.substr(end + 1);
        return rest.empty() || (rest[0] == ':' && is_port(rest.substr(1)));
    }
    const std::size_t colon = host.find(':');
    if (colon == std::string_view::npos) return is_host_name(host);
    return is_host_name(host.substr(0, colon)) && is_port(host.substr(colon + 1));
}

std::size_t count_of(const BeastRequest& request, field name) {
    const auto [first, last] = request.equal_range(name);
    return static_cast<std::size_t>(std::distance(first, last));
}

bool has_control_character(boost::beast::string_view text) {
    return std::any_of(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f;
    });
}

std::string_view view(boost::beast::string_view text) {
    return {text.data(), text.size()};
}

boost::beast::string_view beast_view(std::string_view text) {
    return {text.data(), text.size()};
}

// How long the body is must be beyond doubt: a proxy and this server that disagree would take part
// of a body for another request.
std::optional<std::string_view> framing_fault(const BeastRequest& request) {
    const std::size_t lengths = count_of(request, field::content_length);
    const std::size_t codings = count_of(request, field::transfer_encoding);
    if (lengths > 1) return "The Content-Length header is repeated.";
    if (lengths == 1) {
        const std::string_view length = view(request[field::content_length]);
        if (length.empty() || length.size() > 18 || !std::ranges::all_of(length, is_digit))
            return "The Content-Length header is not a number in decimal digits.";
    }
    if (codings == 0) return std::nullopt;
    if (lengths > 0) return "Content-Length and Transfer-Encoding exclude each other.";
    if (codings > 1) return "The Transfer-Encoding header is repeated.";
    if (request.version() != 11) return "Transfer-Encoding requires HTTP/1.1.";
    if (view(request[field::transfer_encoding]) != "chunked")
        return "The Transfer-Encoding header has a coding other than chunked.";
    return std::nullopt;
}

}  // namespace

std::optional<RequestTarget> parse_target(std::string_view method, std::string_view target) {
    if (target.starts_with('/')) return RequestTarget{std::string(target), {}};
    const bool is_about_server = method == "OPTIONS";
    if (target == "*")
        return is_about_server ? std::optional(RequestTarget{"*", {}}) : std::nullopt;
    for (const std::string_view scheme : {"http://", "https://"}) {
        if (!boost::beast::iequals(beast_view(target.substr(0, scheme.size())), beast_view(scheme)))
            continue;
        const std::string_view rest = target.substr(scheme.size());
        const std::size_t end = std::min(rest.find_first_of("/?#"), rest.size());
        const std::string_view authority = rest.substr(0, end);
        if (!is_host(authority)) return std::nullopt;
        std::string path(rest.substr(end));
        if (path.empty() && is_about_server) path = "*";
        if (!path.starts_with('/') && path != "*") path.insert(path.begin(), '/');
        return RequestTarget{std::move(path), std::string(authority)};
    }
    return std::nullopt;
}

std::string joined_header(const BeastRequest& request, std::string_view name) {
    std::string joined;
    const auto [first, last] = request.equal_range(beast_view(name));
    for (auto at = first; at != last; ++at)
        joined.append(joined.empty() ? "" : ",").append(at->value().data(), at->value().size());
    return joined;
}

bool has_folded_header(std::string_view bytes) {
    bytes = bytes.substr(0, bytes.find("\r\n\r\n"));
    return bytes.find("\r\n ") != std::string_view::npos ||
           bytes.find("\r\n\t") != std::string_view::npos;
}

std::optional<std::string_view> request_fault(const BeastRequest& request) {
    if (request.version() != 10 && request.version() != 11)
        return "Only HTTP/1.0 and HTTP/1.1 are supported.";
    if (!parse_target(view(request.method_string()), view(request.target())))
        return "The target of the request must be a path, or an http or https URI.";
    for (const auto& entry : request)
        if (has_control_character(entry.value())) return "A header has a control character.";
    const std::size_t hosts = count_of(request, field::host);
    if (hosts > 1) return "The Host header is repeated.";
    if (hosts == 0 && request.version() == 11) return "The Host header is missing.";
    if (hosts == 1 && !is_host(view(request[field::host])))
        return "The Host header is not HOST or HOST:PORT.";
    for (const field name : {field::authorization, field::origin, field::content_type})
        if (count_of(request, name) > 1)
            return "An Authorization, Origin or Content-Type header is repeated.";
    if (const auto fault = framing_fault(request)) return fault;
    // Bytes of a body would be read as WebSocket frames.
    if (boost::beast::websocket::is_upgrade(request) &&
        (count_of(request, field::content_length) > 0 ||
         count_of(request, field::transfer_encoding) > 0))
        return "A WebSocket upgrade has no body.";
    return std::nullopt;
}

}  // namespace jostle::server
