// SPDX-License-Identifier: MIT
#include "server/auth/ban_list.h"

#include <fcntl.h>
#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <set>

#include "jostle/base/check.h"
#include "server/auth/identity.h"
#include "server/auth/json_web_token.h"
#include "server/auth/strict_json.h"
#include "server/util/text.h"
#include "server/util/watched_file.h"

namespace jostle::server {

namespace {

using nlohmann::json;
using std::chrono::seconds;

constexpr std::size_t bans_bytes_max = 16u << 20;
constexpr std::size_t bans_depth_max = 4;
constexpr int bans_version = 1;

Status check_text(const char* what, const std::string& text, std::size_t bytes_max) {
    if (text.size() > bytes_max)
        return invalid_argument(fmt::format("the {} has {} bytes; at most {} are allowed", what,
                                            text.size(), bytes_max));
    if (has_control_character(text))
        return invalid_argument(fmt::format("the {} contains a control character", what));
    return {};
}

Status check_ban(const Ban& ban) {
    if (ban.target.subject.empty() == !ban.target.network)
        return invalid_argument("name either a subject or a network");
    if (Status s = check_text("subject", ban.target.subject, 2 * subject_bytes_max); !s.ok())
        return s;
    if (ban.target.subject == anonymous_subject)
        return invalid_argument(
            "all anonymous callers share the subject \"anonymous\"; ban a network instead");
    return check_text("reason", ban.reason, BanList::reason_bytes_max);
}

std::int64_t seconds_of(WallTime time) {
    return std::chrono::floor<seconds>(time).time_since_epoch().count();
}

Result<WallTime> time_in(const json& entry, const char* name) {
    const auto at = entry.find(name);
    if (at == entry.end() || !at->is_number_integer() || at->get<double>() < 0 ||
        at->get<double>() > static_cast<double>(wall_seconds_max))
        return invalid_argument(fmt::format("{} is not a time in seconds since 1970", name));
    return WallTime(seconds(at->get<std::int64_t>()));
}

Result<Ban> read_ban(const json& entry) {
    static constexpr std::array names = {"subject", "network", "reason",
                                         "by",      "created", "expires"};
    if (!entry.is_object()) return invalid_argument("it is not an object");
    for (const auto& [name, value] : entry.items())
        if (std::ranges::find(names, name) == names.end())
            return invalid_argument("it has the unknown member " + server::in_quotes(name));
    Ban ban;
    for (const auto& [name, field] : {std::pair("subject", &ban.target.subject),
                                      std::pair("reason", &ban.reason), std::pair("by", &ban.by)}) {
        if (!entry.contains(name)) continue;
        const std::string* text = string_member(entry, name);
        if (!text) return invalid_argument(fmt::format("{} is not a string", name));
        *field = *text;
    }
    if (entry.contains("network")) {
        const std::string* text = string_member(entry, "network");
        if (!text) return invalid_argument("network is not a string");
        Result<Network> network = parse_network(*text);
        if (!network.ok()) return network.error();
        ban.target.network = *network;
    }
    const Result<WallTime> created = time_in(entry, "created");
    if (!created.ok()) return created.error();
    ban.created = *created;
    if (entry.contains("expires")) {
        const Result<WallTime> expires = time_in(entry, "expires");
        if (!expires.ok()) return expires.error();
        ban.expires = *expires;
    }
    if (Status s = check_ban(ban); !s.ok()) return s.error();
    return ban;
}

// Writes to a temporary file and renames it, so that a crash leaves the old or the new list.
Status write_file(const std::string& path, const std::string& text) {
    const auto failed = [&](const std::string& what) {
        return Error{ErrorCode::unavailable,
                     fmt::format("cannot write the bans to {}: {}: {}; nothing changed", path, what,
                                 std::strerror(errno))};
    };
    const std::string temporary = path + ".new";
    const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file < 0) return failed("open");
    bool good = true;
    for (std::size_t offset = 0; good && offset < text.size();) {
        const ssize_t written = ::write(file, text.data() + offset, text.size() - offset);
        if (written < 0 && errno == EINTR) continue;
        good = written > 0;
        if (good) offset += static_cast<std::size_t>(written);
    }
    good = good && ::fsync(file) == 0;
    const int error = errno;
    ::close(file);
    errno = error;
    if (!good) return failed("write");
    if (std::rename(temporary.c_str(), path.c_str()) != 0) return failed("rename");
    const std::string folder = path.substr(0, path.rfind('/') + 1);
    const int directory =
        ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (directory >= 0) {
        ::fsync(directory);
        ::close(directory);
    }
    return {};
}

}  // namespace

std::string text_of(const BanTarget& target) {
    return target.network ? "network " + text_of(*target.network) : "subject " + target.subject;
}

std::string refusal_text(const Ban& ban) {
    std::string text =
        ban.target.network ? "this network is banned" : "the subject of the token is banned";
    if (ban.expires != WallTime::max()) text += " until " + rfc3339(ban.expires);
    return text + (ban.reason.empty() ? "" : ": " + ban.reason);
}

std::string write_bans(const std::vector<Ban>& bans) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Ban& ban : bans) {
        nlohmann::ordered_json entry;
        if (ban.target.network)
            entry["network"] = text_of(*ban.target.network);
        else
            entry["subject"] = ban.target.subject;
        entry["reason"] = ban.reason;
        entry["by"] = ban.by;
        entry["created"] = seconds_of(ban.created);
        if (ban.expires != WallTime::max()) entry["expires"] = seconds_of(ban.expires);
        list.push_back(std::move(entry));
    }
    return nlohmann::ordered_json{{"version", bans_version}, {"bans", std::move(list)}}.dump(2) +
           "\n";
}

Result<std::vector<Ban>> read_bans(std::string_view text) {
    const Result<json> file = parse_strict_json(text, bans_depth_max);
    if (!file.ok()) return file.error();
    if (!file->is_object() || !file->contains("version") || !file->contains("bans") ||
        file->size() != 2 || !(*file)["bans"].is_array())
        return invalid_argument("it is not an object with \"version\" and the array \"bans\"");
    if ((*file)["version"] != bans_version)
        return invalid_argument(fmt::format("its version is not {}", bans_version));
    const json& list = (*file)["bans"];
    if (list.size() > BanList::bans_max)
        return invalid_argument(
            fmt::format("it has {} bans; at most {} are allowed", list.size(), BanList::bans_max));
    std::vector<Ban> bans;
    std::set<BanTarget> targets;
    for (std::size_t i = 0; i < list.size(); i++) {
        Result<Ban> ban = read_ban(list[i]);
        if (!ban.ok()) return invalid_argument(fmt::format("bans[{}]: {}", i, ban.error().message));
        if (!targets.insert(ban->target).second)
            return invalid_argument(fmt::format("bans[{}]: {} is banned twice", i,
                                                printable(text_of(ban->target), 300)));
        bans.push_back(*std::move(ban));
    }
    return bans;
}

Result<std::unique_ptr<BanList>> BanList::open(std::string path) {
    std::unique_ptr<BanList> list(new BanList(path));
    if (path.empty() || !stamp_of(path).exists) return list;
    const Result<std::string> text = read_bounded(path, bans_bytes_max);
    if (!text.ok()) return text.error();
    const Result<std::vector<Ban>> bans = read_bans(*text);
    if (!bans.ok())
        return Error{ErrorCode::corrupt_data,
                     fmt::format("the file of bans {} is damaged: {}; repair it, or move it away "
                                 "to start without bans",
                                 path, bans.error().message)};
    Bans by_target;
    for (const Ban& ban : *bans) by_target[ban.target] = ban;
    const std::lock_guard lock(list->mutex_);
    for (const auto& [target, ban] : by_target)
        if (target.network) list->prefixes_[{target.network->is_ipv6, target.network->prefix}]++;
    list->is_empty_ = by_target.empty();
    list->bans_ = std::move(by_target);
    return list;
}

// The caller holds changing_.
Status BanList::replace(Bans bans) {
    std::map<std::pair<bool, int>, int> prefixes;
    std::vector<Ban> list;
    for (const auto& [target, ban] : bans) {
        list.push_back(ban);
        if (target.network) prefixes[{target.network->is_ipv6, target.network->prefix}]++;
    }
    if (!path_.empty())
        if (Status s = write_file(path_, write_bans(list)); !s.ok()) return s;
    const std::lock_guard lock(mutex_);
    is_empty_ = bans.empty();
    bans_ = std::move(bans);
    prefixes_ = std::move(prefixes);
    revision_.fetch_add(1, std::memory_order_release);
    return {};
}

Status BanList::add(Ban ban, WallTime now) {
    if (Status s = check_ban(ban); !s.ok()) return s;
    const std::lock_guard changing(changing_);
    Bans bans = bans_;  // changes only under changing_
    std::erase_if(bans, [&](const auto& entry) { return entry.second.expires <= now; });
    BanTarget target = ban.target;
    bans.insert_or_assign(std::move(target), std::move(ban));
    if (bans.size() > bans_max)
        return Error{ErrorCode::resource_exhausted,
                     fmt::format("there are {} bans already; remove some, or ban a larger network",
                                 bans_max)};
    return replace(std::move(bans));
}

Status BanList::remove(const BanTarget& target, WallTime now) {
    const std::lock_guard changing(changing_);
    Bans bans = bans_;
    std::erase_if(bans, [&](const auto& entry) { return entry.second.expires <= now; });
    if (bans.erase(target) == 0)
        return Error{ErrorCode::not_found, fmt::format("there is no ban of {}; ListBans lists them",
                                                       printable(text_of(target), 300))};
    return replace(std::move(bans));
}

std::vector<Ban> BanList::list(WallTime now) const {
    const std::lock_guard lock(mutex_);
    std::vector<Ban> networks, bans;
    for (const auto& [target, ban] : bans_)
        if (ban.expires > now) (target.network ? networks : bans).push_back(ban);
    bans.insert(bans.end(), networks.begin(), networks.end());
    return bans;
}

std::optional<Ban> BanList::find(std::string_view subject, std::string_view address,
                                 WallTime now) const {
    if (is_empty_) return std::nullopt;
    const std::optional<Network> caller = parse_address(address.substr(0, address.find('%')));
    const std::lock_guard lock(mutex_);
    const auto in_force = [&](const BanTarget& target) -> std::optional<Ban> {
        const auto at = bans_.find(target);
        return at == bans_.end() || at->second.expires <= now ? std::nullopt
                                                              : std::optional(at->second);
    };
    if (!subject.empty())
        if (auto ban = in_force({std::string(subject), std::nullopt})) return ban;
    if (!caller) return std::nullopt;
    for (const auto& [prefix, count] : prefixes_)
        if (prefix.first == caller->is_ipv6)
            if (auto ban = in_force({{}, masked(*caller, prefix.second)})) return ban;
    return std::nullopt;
}

}  // namespace jostle::server
