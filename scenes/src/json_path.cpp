// SPDX-License-Identifier: MIT
#include "scenes/src/json_path.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace jostle::scenes {

namespace {

// The other spelling that protobuf's JSON accepts: halfLength for half_length.
std::string camel_case(const std::string& key) {
    std::string out;
    bool upper = false;
    for (const char c : key) {
        if (c == '_') {
            upper = true;
            continue;
        }
        out += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        upper = false;
    }
    return out;
}

// A key as displayed in a message: without control characters, and with limited length.
std::string shown(const std::string& key) {
    constexpr std::size_t longest = 64;
    std::string out = key.substr(0, longest);
    for (char& c : out)
        if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = '?';
    return key.size() > longest ? out + "..." : out;
}

// Walks well-formed JSON text to the position of one value.
class Locator {
public:
    explicit Locator(std::string_view text) : text_(text) {}

    // Returns the offset of the value.
    std::optional<std::size_t> find(const JsonPath& path) {
        skip_space();
        for (const JsonPathStep& step : path)
            if (!(step.in_list ? enter_item(step.index) : enter_key(step.key))) return std::nullopt;
        return std::min(at_, text_.size());
    }

private:
    char now() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    void skip_space() {
        while (at_ < text_.size() &&
               (now() == ' ' || now() == '\n' || now() == '\t' || now() == '\r'))
            at_++;
    }
    std::string_view take_string() {
        const std::size_t begin = ++at_;
        while (at_ < text_.size() && now() != '"') at_ += now() == '\\' ? 2 : 1;
        const std::string_view inside = text_.substr(begin, std::min(at_, text_.size()) - begin);
        at_++;
        return inside;
    }
    void skip_value() {
        int depth = 0;
        do {
            skip_space();
            if (now() == '"') {
                take_string();
            } else if (now() == '{' || now() == '[') {
                depth++;
                at_++;
            } else if (now() == '}' || now() == ']') {
                depth--;
                at_++;
            } else if (now() == ',' || now() == ':') {
                at_++;
                continue;
            } else {
                while (at_ < text_.size() &&
                       std::string_view(",:]} \n\t\r").find(now()) == std::string_view::npos)
                    at_++;
            }
        } while (depth > 0 && at_ < text_.size());
    }
    bool enter_key(const std::string& key) {
        if (now() != '{') return false;
        const std::string other = camel_case(key);
        at_++;
        for (skip_space(); now() == '"'; skip_space()) {
            const std::string_view found = take_string();
            skip_space();
            at_++;  // the colon
            skip_space();
            if (found == key || found == other) return true;
            skip_value();
            skip_space();
            if (now() == ',') at_++;
        }
        return false;
    }
    bool enter_item(std::size_t index) {
        if (now() != '[') return false;
        at_++;
        skip_space();
        for (std::size_t i = 0; i < index; i++) {
            skip_value();
            skip_space();
            if (now() != ',') return false;
            at_++;
            skip_space();
        }
        return now() != ']';
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

std::string to_text(const JsonPath& path) {
    std::string out;
    for (const JsonPathStep& step : path) {
        if (step.in_list)
            out += "[" + std::to_string(step.index) + "]";
        else
            out += (out.empty() ? "" : ".") + shown(step.key);
    }
    return out;
}

JsonPath parse_json_path(std::string_view path) {
    JsonPath result;
    std::size_t at = 0;
    while (at < path.size()) {
        if (path[at] == '[') {
            std::size_t index = 0;
            for (at++; at < path.size() && path[at] != ']'; at++)
                index = 10 * index + static_cast<std::size_t>(path[at] - '0');
            at++;
            result.push_back({.key = {}, .index = index, .in_list = true});
            continue;
        }
        if (path[at] == '.') at++;
        const std::size_t end = std::min(path.find_first_of(".[", at), path.size());
        result.push_back({.key = std::string(path.substr(at, end - at))});
        at = end;
    }
    return result;
}

std::string position_of(std::string_view text, const JsonPath& path) {
    const std::optional<std::size_t> at = Locator(text).find(path);
    if (!at) return {};
    const std::string_view before = text.substr(0, *at);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t column = *at - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0
    return "line " + std::to_string(line) + ", column " + std::to_string(column) + ": ";
}

}  // namespace jostle::scenes
