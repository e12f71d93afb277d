// SPDX-License-Identifier: MIT
#include "server/util/network.h"

#include <arpa/inet.h>
#include <spdlog/fmt/fmt.h>

#include <charconv>
#include <cstring>

#include "jostle/base/check.h"
#include "server/util/text.h"

namespace jostle::server {

namespace {

constexpr int ipv4_bits = 32, ipv6_bits = 128, ipv6_customer_bits = 64;

int bits_of(const Network& network) {
    return network.is_ipv6 ? ipv6_bits : ipv4_bits;
}

Error bad_network(std::string_view text, const std::string& why) {
    return invalid_argument(fmt::format(
        "{} is not a network: {}; write an address such as 192.0.2.7 or 2001:db8::1, or a prefix "
        "such as 192.0.2.0/24 or 2001:db8::/48",
        in_quotes(text), why));
}

}  // namespace

Network masked(Network network, int prefix) {
    network.prefix = prefix;
    for (int bit = prefix; bit < ipv6_bits; bit++)
        network.address[static_cast<std::size_t>(bit / 8)] &=
            static_cast<std::uint8_t>(~(0x80u >> (bit % 8)));
    return network;
}

bool contains(const Network& network, const Network& address) {
    return network.is_ipv6 == address.is_ipv6 && network.prefix <= address.prefix &&
           masked(address, network.prefix) == network;
}

std::optional<Network> parse_address(std::string_view view) {
    if (view.find(char{}) != std::string_view::npos) return std::nullopt;
    const std::string text(view);
    Network network;
    if (inet_pton(AF_INET, text.c_str(), network.address.data()) == 1) {
        network.prefix = ipv4_bits;
        return network;
    }
    in6_addr six{};
    if (inet_pton(AF_INET6, text.c_str(), &six) != 1) return std::nullopt;
    if (IN6_IS_ADDR_V4MAPPED(&six)) {
        std::memcpy(network.address.data(), six.s6_addr + 12, 4);
        network.prefix = ipv4_bits;
        return network;
    }
    std::memcpy(network.address.data(), six.s6_addr, 16);
    network.is_ipv6 = true;
    network.prefix = ipv6_bits;
    return network;
}

Result<Network> parse_network(std::string_view text) {
    const std::size_t slash = text.find('/');
    const std::string address(text.substr(0, slash));
    const std::optional<Network> parsed = parse_address(address);
    if (!parsed) return bad_network(text, "the address is invalid");
    const bool is_mapped = !parsed->is_ipv6 && address.find(':') != std::string::npos;
    if (slash == std::string_view::npos)
        return masked(*parsed, parsed->is_ipv6 ? ipv6_customer_bits : ipv4_bits);
    const std::string_view digits = text.substr(slash + 1);
    int prefix = -1;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), prefix);
    const int high = is_mapped ? ipv6_bits : bits_of(*parsed),
              low = is_mapped ? ipv6_bits - ipv4_bits : 0;
    if (error != std::errc{} || end != digits.data() + digits.size() || digits.empty() ||
        prefix < low || prefix > high)
        return bad_network(text,
                           fmt::format("the prefix is not a number from {} to {}", low, high));
    const Network network = masked(*parsed, prefix - low);
    if (network.address != parsed->address)
        return bad_network(text, fmt::format("the address has bits beyond the prefix; the network "
                                             "is {}",
                                             text_of(network)));
    return network;
}

Result<Network> parse_exact_network(std::string_view text) {
    if (text.find('/') == std::string_view::npos)
        if (const auto address = parse_address(text)) return *address;
    return parse_network(text);
}

std::string address_text(const Network& network) {
    char text[INET6_ADDRSTRLEN] = {};
    const char* const done =
        inet_ntop(network.is_ipv6 ? AF_INET6 : AF_INET, network.address.data(), text, sizeof text);
    ASSERT(done);
    return done ? text : "unknown";
}

std::string text_of(const Network& network) {
    if (!network.is_ipv6 && network.prefix == ipv4_bits) return address_text(network);
    return fmt::format("{}/{}", address_text(network), network.prefix);
}

}  // namespace jostle::server
