// SPDX-License-Identifier: MIT
#include "server/auth/strict_json.h"

#include <set>
#include <vector>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

// Validates without building a document; a false return from any function ends the parse.
class Checker : public nlohmann::json_sax<nlohmann::json> {
public:
    explicit Checker(std::size_t depth_max) : depth_max_(depth_max) {}

    const char* fault = nullptr;

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_object(std::size_t) override { return enter(); }
    bool start_array(std::size_t) override { return enter(); }
    bool end_object() override { return leave(); }
    bool end_array() override { return leave(); }
    bool key(string_t& name) override {
        ASSERT(!keys_.empty());
        return keys_.back().insert(name).second || refuse("an object has a duplicate key");
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
        return refuse("it is not valid JSON");
    }

private:
    bool refuse(const char* why) {
        fault = why;
        return false;
    }
    bool enter() {
        keys_.emplace_back();
        return keys_.size() <= depth_max_ || refuse("it is nested too deeply");
    }
    bool leave() {
        ASSERT(!keys_.empty());
        keys_.pop_back();
        return true;
    }

    const std::size_t depth_max_;
    std::vector<std::set<std::string>> keys_;  // of each open object
};

}  // namespace

Result<nlohmann::json> parse_strict_json(std::string_view text, std::size_t depth_max) {
    // nlohmann::json skips a byte order mark and takes a zero byte for the end.
    if (text.starts_with("\xef\xbb\xbf"))
        return Error{ErrorCode::invalid_argument, "it begins with a byte order mark"};
    if (text.find('\0') != std::string_view::npos)
        return Error{ErrorCode::invalid_argument, "it has a zero byte"};
    Checker checker(depth_max);
    if (!nlohmann::json::sax_parse(text, &checker))
        return Error{ErrorCode::invalid_argument, checker.fault};
    return nlohmann::json::parse(text, nullptr, false);
}

const std::string* string_member(const nlohmann::json& object, const char* name) {
    const auto at = object.find(name);
    return at == object.end() ? nullptr : at->get_ptr<const std::string*>();
}

}  // namespace jostle::server
