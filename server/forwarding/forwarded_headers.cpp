// SPDX-License-Identifier: MIT
#include "server/forwarding/forwarded_headers.h"

#include <algorithm>
#include <string>

namespace jostle::server {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

// RFC 9110, 5.6.2.
bool is_token_character(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
}

// ":4711", or ":_name" in RFC 7239.
bool is_port_suffix(std::string_view text) {
    if (text.size() < 2 || text[0] != ':') return false;
    const std::string_view port = text.substr(1);
    if (port[0] == '_')
        return std::ranges::all_of(
            port, [](char c) { return c != '~' && c != '|' && is_token_character(c); });
    return port.size() <= 5 && std::ranges::all_of(port, is_digit);
}

// "192.0.2.7", "192.0.2.7:80", "[2001:db8::1]", "[2001:db8::1]:80".
std::optional<Network> parse_node(std::string_view text) {
    if (text.starts_with('[')) {
        const std::size_t end = text.find(']');
        if (end == std::string_view::npos) return std::nullopt;
        const std::string_view port = text.substr(end + 1), inside = text.substr(1, end - 1);
        if (!port.empty() && !is_port_suffix(port)) return std::nullopt;
        return inside.find(':') == std::string_view::npos ? std::nullopt : parse_address(inside);
    }
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return parse_address(text);
    return is_port_suffix(text.substr(colon)) ? parse_address(text.substr(0, colon)) : std::nullopt;
}

bool is_equal_ignoring_case(std::string_view a, std::string_view lower) {
    return std::ranges::equal(a, lower, [](char x, char y) {
        return (x >= 'A' && x <= 'Z' ? static_cast<char>(x - 'A' + 'a') : x) == y;
    });
}

// Reads the grammar of RFC 7239: elements between commas, pairs between semicolons.
class ForwardedParser {
public:
    explicit ForwardedParser(std::string_view text) : text_(text) {}

    std::optional<ForwardedAddresses> parse() {
        for (;;) {
            // Empty elements of a list are skipped (RFC 9110, 5.6.1).
            skip_blanks();
            if (at_end()) return std::move(addresses_);
            if (skip(',')) continue;
            if (!parse_element()) return std::nullopt;
            skip_blanks();
            if (!at_end() && !skip(',')) return std::nullopt;
        }
    }

private:
    bool at_end() const { return at_ == text_.size(); }
    void skip_blanks() {
        while (!at_end() && is_blank(text_[at_])) at_++;
    }
    bool skip(char c) {
        if (at_end() || text_[at_] != c) return false;
        at_++;
        return true;
    }

    std::string_view token() {
        const std::size_t start = at_;
        while (!at_end() && is_token_character(text_[at_])) at_++;
        return text_.substr(start, at_ - start);
    }

    // A token or a quoted string; nothing: neither.
    std::optional<std::string> value() {
        if (!skip('"')) {
            const std::string_view plain = token();
            return plain.empty() ? std::nullopt : std::optional(std::string(plain));
        }
        std::string quoted;
        while (!at_end() && text_[at_] != '"') {
            if (text_[at_] == '\\' && ++at_ == text_.size()) return std::nullopt;
            quoted += text_[at_++];
        }
        return skip('"') ? std::optional(std::move(quoted)) : std::nullopt;
    }

    // An element without "for" has no address.
    bool parse_element() {
        std::optional<Network> address;
        bool has_for = false;
        do {
            skip_blanks();
            if (at_end() || text_[at_] == ',' || text_[at_] == ';') continue;  // an empty pair
            const std::string_view name = token();
            if (name.empty() || !skip('=')) return false;
            const std::optional<std::string> text = value();
            if (!text) return false;
            skip_blanks();
            if (!is_equal_ignoring_case(name, "for")) continue;
            if (has_for) return false;
            has_for = true;
            address = parse_node(*text);
        } while (skip(';'));
        addresses_.push_back(address);
        return true;
    }

    const std::string_view text_;
    std::size_t at_ = 0;
    ForwardedAddresses addresses_;
};

}  // namespace

ForwardedAddresses parse_x_forwarded_for(std::string_view value) {
    ForwardedAddresses addresses;
    while (!value.empty()) {
        const std::size_t comma = value.find(',');
        const std::string_view entry = trimmed(value.substr(0, comma));
        value = comma == std::string_view::npos ? std::string_view{} : value.substr(comma + 1);
        if (entry.empty()) continue;
        std::optional<Network> address = parse_address(entry);  // IPv6 without brackets
        addresses.push_back(address ? address : parse_node(entry));
    }
    return addresses;
}

std::optional<ForwardedAddresses> parse_forwarded(std::string_view value) {
    return ForwardedParser(value).parse();
}

}  // namespace jostle::server
