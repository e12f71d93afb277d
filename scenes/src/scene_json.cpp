// SPDX-License-Identifier: MIT
#include "scene_json.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

namespace jostle::scenes {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using nlohmann::json;

namespace {

// Edit distance, for "did you mean".
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t k = 0; k <= b.size(); k++) row[k] = k;
    for (std::size_t i = 1; i <= a.size(); i++) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t k = 1; k <= b.size(); k++) {
            const std::size_t above = row[k];
            row[k] =
                std::min({row[k] + 1, row[k - 1] + 1, diagonal + (a[i - 1] != b[k - 1] ? 1 : 0)});
            diagonal = above;
        }
    }
    return row[b.size()];
}

std::string fields_of(const Descriptor& message) {
    std::string names;
    for (int i = 0; i < message.field_count(); i++)
        names += (i == 0 ? "" : ", ") + message.field(i)->name();
    return names;
}

std::string suggestion(const Descriptor& message, const std::string& wrong) {
    std::string best;
    std::size_t nearest = 3;
    for (int i = 0; i < message.field_count(); i++) {
        const std::size_t d = distance(message.field(i)->name(), wrong);
        if (d < nearest) {
            nearest = d;
            best = message.field(i)->name();
        }
    }
    if (!best.empty()) return "did you mean \"" + best + "\"?";
    return "its fields are " + fields_of(message);
}

class Walker {
public:
    explicit Walker(std::string_view text) : text_(text) {}

    std::optional<std::string> walk(const json& value, const Descriptor& message,
                                    const std::string& path) {
        if (!value.is_object())
            return fault(path, std::string("must be an object {...}, not ") + value.type_name());
        for (const auto& [key, inner] : value.items()) {
            const std::string at = path.empty() ? key : path + "." + key;
            const FieldDescriptor* field = message.FindFieldByName(key);
            if (!field) field = message.FindFieldByCamelcaseName(key);
            if (!field) return fault(at, "there is no such field; " + suggestion(message, key));
            if (auto found = check_field(inner, *field, at)) return found;
        }
        return {};
    }

private:
    std::optional<std::string> fault(const std::string& path, const std::string& what) const {
        const int line = line_of(text_, path);
        return (line > 0 ? "line " + std::to_string(line) + ": " : std::string()) +
               (path.empty() ? "the scene" : path) + ": " + what;
    }

    std::optional<std::string> check_field(const json& value, const FieldDescriptor& field,
                                           const std::string& path) {
        if (!field.is_repeated()) return check_value(value, field, path);
        if (!value.is_array())
            return fault(path, std::string("must be a list [...], not ") + value.type_name());
        for (std::size_t i = 0; i < value.size(); i++)
            if (auto found = check_value(value[i], field, path + "[" + std::to_string(i) + "]"))
                return found;
        return {};
    }

    std::optional<std::string> check_value(const json& value, const FieldDescriptor& field,
                                           const std::string& path) {
        switch (field.cpp_type()) {
            case FieldDescriptor::CPPTYPE_MESSAGE:
                return walk(value, *field.message_type(), path);
            case FieldDescriptor::CPPTYPE_DOUBLE:
            case FieldDescriptor::CPPTYPE_FLOAT:
                if (value.is_number()) return {};
                return fault(path, std::string("must be a number, not ") + value.type_name());
            case FieldDescriptor::CPPTYPE_BOOL:
                if (value.is_boolean()) return {};
                return fault(path, std::string("must be true or false, not ") + value.type_name());
            case FieldDescriptor::CPPTYPE_STRING:
                if (value.is_string()) return {};
                return fault(path,
                             std::string("must be a text in quotes, not ") + value.type_name());
            case FieldDescriptor::CPPTYPE_ENUM:
                return check_enum(value, field, path);
            default:
                if (value.is_number_unsigned() && value.get<std::uint64_t>() <= 0xffffffffull)
                    return {};
                return fault(path, "must be a whole number from 0 to 4294967295");
        }
    }

    std::optional<std::string> check_enum(const json& value, const FieldDescriptor& field,
                                          const std::string& path) {
        std::string names;
        for (int i = 1; i < field.enum_type()->value_count(); i++) {
            const std::string& name = field.enum_type()->value(i)->name();
            if (value.is_string() && value.get<std::string>() == name) return {};
            names += (i == 1 ? "" : ", ") + name;
        }
        return fault(path, "must be one of " + names);
    }

    std::string_view text_;
};

// Walks JSON text that is known to be well-formed, far enough to find one value.
class Locator {
public:
    explicit Locator(std::string_view text) : text_(text) {}

    int find(std::string_view path) {
        skip_space();
        while (!path.empty()) {
            if (path.front() == '.') path.remove_prefix(1);
            const std::size_t end = path.front() == '['
                                        ? path.find(']') + 1
                                        : std::min(path.find_first_of(".["), path.size());
            const std::string_view step = path.substr(0, end);
            path.remove_prefix(end);
            if (!(step.front() == '[' ? enter_item(std::stoul(std::string(step.substr(1))))
                                      : enter_key(step)))
                return 0;
        }
        return 1 + static_cast<int>(std::count(
                       text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n'));
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
    bool enter_key(std::string_view key) {
        if (now() != '{') return false;
        at_++;
        for (skip_space(); now() == '"'; skip_space()) {
            const std::string_view found = take_string();
            skip_space();
            at_++;  // the colon
            skip_space();
            if (found == key) return true;
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

int line_of(std::string_view text, std::string_view path) {
    return Locator(text).find(path);
}

std::optional<std::string> find_json_fault(std::string_view text, const Descriptor& message) {
    json parsed;
    try {
        parsed = json::parse(text);
    } catch (const json::parse_error& error) {
        // "[json.exception.parse_error.101] parse error at line 3, column 5: ...": what stands
        // behind the bracket.
        const std::string what = error.what();
        const std::size_t at = what.find("] ");
        return "this is not JSON: " + (at == std::string::npos ? what : what.substr(at + 2));
    }
    return Walker(text).walk(parsed, message, {});
}

}  // namespace jostle::scenes
