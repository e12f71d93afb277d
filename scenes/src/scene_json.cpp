// SPDX-License-Identifier: MIT
#include "scenes/src/scene_json.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "jostle/base/nearest_name.h"
#include "scenes/src/field_reader.h"
#include "scenes/src/json_path.h"

namespace jostle::scenes {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using nlohmann::json;

namespace {

std::string fields_of(const Descriptor& message) {
    std::string names;
    for (int i = 0; i < message.field_count(); i++)
        names += (i == 0 ? "" : ", ") + message.field(i)->name();
    return names;
}

std::string suggestion(const Descriptor& message, const std::string& wrong) {
    std::vector<std::string> names;
    for (int i = 0; i < message.field_count(); i++) names.push_back(message.field(i)->name());
    const std::string near = did_you_mean(wrong, names);
    return near.empty() ? "; must be one of " + fields_of(message) : near;
}

std::string error_at(std::string_view text, const JsonPath& path, const std::string& what) {
    return position_of(text, path) + (path.empty() ? "scene" : to_text(path)) + ": " + what;
}

// Tracks the position of the parser in the text. It provides the position of a parse error and
// detects duplicate keys, of which the parsed value contains only one.
class Follower {
public:
    void on(json::parse_event_t event, const json& parsed) {
        switch (event) {
            case json::parse_event_t::object_start:
                levels_.push_back({});
                return;
            case json::parse_event_t::array_start:
                levels_.push_back({.step = {.key = {}, .in_list = true}, .keys = {}});
                return;
            case json::parse_event_t::key:
                levels_.back().step.key = parsed.get<std::string>();
                if (!levels_.back().keys.insert(levels_.back().step.key).second && !twice_)
                    twice_ = current_path();
                return;
            case json::parse_event_t::object_end:
            case json::parse_event_t::array_end:
                levels_.pop_back();
                break;
            case json::parse_event_t::value:
                break;
        }
        if (!levels_.empty() && levels_.back().step.in_list) levels_.back().step.index++;
    }
    JsonPath current_path() const {
        JsonPath path;
        for (const Level& level : levels_) path.push_back(level.step);
        return path;
    }
    const std::optional<JsonPath>& twice() const { return twice_; }

private:
    struct Level {
        JsonPathStep step;
        std::set<std::string> keys;
    };
    std::vector<Level> levels_;
    std::optional<JsonPath> twice_;
};

class Walker {
public:
    explicit Walker(std::string_view text) : text_(text) {}

    void walk(const json& value, const Descriptor& message) {
        if (!value.is_object())
            return error(std::string("must be an object {...}, not ") + value.type_name());
        std::set<int> seen_numbers;  // numbers of fields, and of oneofs
        for (const auto& [key, inner] : value.items()) {
            path_.push_back({.key = key});
            walk_field(key, inner, message, seen_numbers);
            path_.pop_back();
        }
    }
    // One line per error; empty if there is none.
    std::string errors() const { return errors_.text(); }

private:
    void error(const std::string& what) {
        if (!errors_.full()) errors_.add(error_at(text_, path_, what));
    }

    void walk_field(const std::string& key, const json& value, const Descriptor& message,
                    std::set<int>& seen_numbers) {
        // Names the schema of the file, for editors.
        if (key == "$schema" && message.full_name() == "jostle.v1.Scene") {
            if (!value.is_string())
                error(std::string("must be a string in quotes, not ") + value.type_name());
            return;
        }
        const FieldDescriptor* field = message.FindFieldByName(key);
        if (!field) field = message.FindFieldByCamelcaseName(key);
        if (!field) return error("unknown field" + suggestion(message, key));
        if (!seen_numbers.insert(field->number()).second)
            return error("is a duplicate in another spelling; remove one of them");
        const auto* choice = field->real_containing_oneof();
        if (choice && !seen_numbers.insert(-1 - choice->index()).second)
            return error("is a second " + choice->name() + "; only one is allowed");
        check_field(value, *field);
    }

    void check_field(const json& value, const FieldDescriptor& field) {
        if (field.is_map()) return check_map(value, *field.message_type()->map_value());
        if (!field.is_repeated()) return check_value(value, field);
        if (!value.is_array())
            return error(std::string("must be a list [...], not ") + value.type_name());
        for (std::size_t i = 0; i < value.size() && !errors_.full(); i++) {
            path_.push_back({.key = {}, .index = i, .in_list = true});
            check_value(value[i], field);
            path_.pop_back();
        }
    }

    void check_map(const json& value, const FieldDescriptor& item) {
        if (!value.is_object())
            return error(std::string("must be an object {...}, not ") + value.type_name());
        for (const auto& [key, inner] : value.items()) {
            path_.push_back({.key = key});
            check_value(inner, item);
            path_.pop_back();
        }
    }

    void check_value(const json& value, const FieldDescriptor& field) {
        switch (field.cpp_type()) {
            case FieldDescriptor::CPPTYPE_MESSAGE:
                return walk(value, *field.message_type());
            case FieldDescriptor::CPPTYPE_DOUBLE:
            case FieldDescriptor::CPPTYPE_FLOAT:
                if (value.is_number()) return;
                return error(std::string("must be a number, not ") + value.type_name());
            case FieldDescriptor::CPPTYPE_BOOL:
                if (value.is_boolean()) return;
                return error(std::string("must be true or false, not ") + value.type_name());
            case FieldDescriptor::CPPTYPE_STRING:
                if (field.type() == FieldDescriptor::TYPE_BYTES && !is_base64(value))
                    return error("must be base64 bytes, a string in quotes");
                if (value.is_string()) return;
                return error(std::string("must be a string in quotes, not ") + value.type_name());
            case FieldDescriptor::CPPTYPE_ENUM:
                return check_enum(value, field);
            case FieldDescriptor::CPPTYPE_INT32:
                if (is_whole(value, -2147483648.0, 2147483647.0)) return;
                return error("must be an integer from -2147483648 to 2147483647");
            default:
                if (is_whole(value, 0, 4294967295.0)) return;
                return error("must be an integer from 0 to 4294967295");
        }
    }

    // Accepts both alphabets, padded or not, as protobuf does.
    static bool is_base64(const json& value) {
        if (!value.is_string()) return false;
        std::string text = value.get<std::string>();
        for (int k = 0; k < 2 && !text.empty() && text.back() == '='; k++) text.pop_back();
        const auto fits = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                   c == '+' || c == '/' || c == '-' || c == '_';
        };
        return text.size() % 4 != 1 && std::all_of(text.begin(), text.end(), fits);
    }

    // 8 and 8.0 are the same number.
    static bool is_whole(const json& value, double low, double high) {
        if (!value.is_number()) return false;
        const double x = value.get<double>();
        return x == std::floor(x) && low <= x && x <= high;
    }

    void check_enum(const json& value, const FieldDescriptor& field) {
        std::string names;
        for (int i = 1; i < field.enum_type()->value_count(); i++) {
            const auto& choice = *field.enum_type()->value(i);
            if (value.is_string() && value.get<std::string>() == choice.name()) return;
            // A second name of a number is an alias for older files: accepted, but not listed.
            if (field.enum_type()->FindValueByNumber(choice.number()) == &choice)
                names += (names.empty() ? "" : ", ") + choice.name();
        }
        return error("must be one of " + names);
    }

    std::string_view text_;
    JsonPath path_;
    ErrorLines errors_;
};

// Removes the prefix of nlohmann errors: "[json.exception.parse_error.101] parse error at line 3,
// column 5: ...".
std::string without_prefix(const std::string& what) {
    const std::size_t at = what.find("] ");
    return at == std::string::npos ? what : what.substr(at + 2);
}

}  // namespace

std::optional<std::string> find_json_errors(std::string_view text, const Descriptor& message) {
    Follower follower;
    json parsed;
    try {
        parsed = json::parse(text, [&](int, json::parse_event_t event, const json& value) {
            follower.on(event, value);
            return true;
        });
    } catch (const json::out_of_range&) {
        return error_at(text, follower.current_path(), "is a number that is too large");
    } catch (const json::exception& error) {
        return "not valid JSON: " + without_prefix(error.what());
    }
    if (follower.twice())
        return error_at(text, *follower.twice(), "is a duplicate; remove one of them");
    Walker walker(text);
    walker.walk(parsed, message);
    if (std::string errors = walker.errors(); !errors.empty()) return errors;
    return std::nullopt;
}

}  // namespace jostle::scenes
