// SPDX-License-Identifier: MIT
#include "server/auth/key_set.h"

#include <spdlog/fmt/fmt.h>

#include "jostle/base/base64.h"
#include "jostle/base/check.h"
#include "server/auth/strict_json.h"
#include "server/util/log.h"

namespace jostle::server {

namespace {

using nlohmann::json;

constexpr std::size_t file_bytes_max = 1 << 18;
constexpr std::size_t keys_max = 100;
constexpr std::size_t id_bytes_max = 256;
constexpr std::size_t set_depth_max = 8;  // keys of other types may have nested members

Error broken(std::string message) {
    return {ErrorCode::invalid_argument, std::move(message)};
}

// Whether the member `name` is the string `text`.
bool has_text(const json& key, const char* name, std::string_view text) {
    const std::string* found = string_member(key, name);
    return found && *found == text;
}

// Why a key cannot verify tokens; empty if it can.
std::string rejection_reason(const json& key) {
    if (!key.is_object()) return "it is not a JSON object";
    if (!has_text(key, "kty", "EC") || !has_text(key, "crv", "P-256"))
        return "it is not an EC key on the curve P-256";
    if (key.contains("d")) return "it is a private key; only the issuer may hold it";
    if (key.contains("use") && !has_text(key, "use", "sig")) return "its use is not sig";
    if (key.contains("alg") && !has_text(key, "alg", "ES256")) return "its alg is not ES256";
    const std::string* id = string_member(key, "kid");
    if (!id || id->empty() || id->size() > id_bytes_max) return "it has no kid of 1 to 256 bytes";
    return {};
}

std::optional<VerifyKey> point_of(const json& key) {
    const std::string *x = string_member(key, "x"), *y = string_member(key, "y");
    if (!x || !y) return std::nullopt;
    const Result<std::string> x_bytes = decode_base64<std::string>(*x, Base64::url),
                              y_bytes = decode_base64<std::string>(*y, Base64::url);
    if (!x_bytes.ok() || !y_bytes.ok()) return std::nullopt;
    return VerifyKey::from_point(*x_bytes, *y_bytes);
}

}  // namespace

Result<ParsedKeySet> read_key_set(std::string_view text) {
    const Result<json> set = parse_strict_json(text, set_depth_max);
    if (!set.ok()) return broken("it cannot be parsed: " + set.error().message);
    const auto list = set->is_object() ? set->find("keys") : set->end();
    if (list == set->end() || !list->is_array())
        return broken("it is not a JSON object with an array \"keys\"");
    if (list->size() > keys_max) return broken("it contains more than 100 keys");
    ParsedKeySet out;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const json& key = (*list)[i];
        std::string fault = rejection_reason(key);
        const std::optional<VerifyKey> point = fault.empty() ? point_of(key) : std::nullopt;
        if (fault.empty() && !point) fault = "its x and y are not a point of the curve";
        if (!fault.empty()) {
            out.warnings.push_back(fmt::format("key {} is skipped: {}", i + 1, fault));
            continue;
        }
        ASSERT(point && string_member(key, "kid"));
        if (!out.keys.emplace(*string_member(key, "kid"), *point).second)
            return broken(fmt::format("key {} has the kid of an earlier key", i + 1));
    }
    if (out.keys.empty()) return broken("it contains no EC key on P-256 with a kid");
    return out;
}

Result<std::unique_ptr<KeySet>> KeySet::open(std::string path) {
    std::unique_ptr<KeySet> set(new KeySet(std::move(path)));
    if (Status s = set->read(); !s.ok()) return s.error();
    return set;
}

std::shared_ptr<const VerifyKeys> KeySet::keys() const {
    const std::lock_guard lock(mutex_);
    ASSERT(keys_);
    return keys_;
}

bool KeySet::poll(Clock::time_point now) {
    {
        const std::lock_guard lock(reading_);
        if (now < next_poll_) return true;
        next_poll_ = now + std::chrono::seconds(1);
        if (stamp_of(path_) == stamp_) return true;
    }
    return reload();
}

bool KeySet::reload() {
    const Status s = read();
    if (!s.ok()) log_error("{}; the previous keys stay in force", s.error().message);
    return s.ok();
}

Status KeySet::read() {
    const std::lock_guard reading(reading_);
    // taken before the read: a change in between is detected by the next poll
    stamp_ = stamp_of(path_);
    const Result<std::string> text = read_bounded(path_, file_bytes_max);
    if (!text.ok()) return text.error();
    Result<ParsedKeySet> read = read_key_set(*text);
    if (!read.ok()) return broken("the key set " + path_ + " is invalid: " + read.error().message);
    for (const std::string& warning : read->warnings) log_warn("{}: {}", path_, warning);
    log_info("token keys in force: {}", read->keys.size());
    auto keys = std::make_shared<const VerifyKeys>(std::move(read->keys));
    const std::lock_guard lock(mutex_);
    keys_ = std::move(keys);
    ASSERT(!keys_->empty());
    return {};
}

}  // namespace jostle::server
