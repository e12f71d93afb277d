// SPDX-License-Identifier: MIT
#include "server/world/player_reports.h"

#include <algorithm>
#include <map>
#include <utility>

#include "server/auth/strict_json.h"
#include "server/util/log.h"
#include "server/util/text.h"

namespace jostle::server {

namespace {

std::string clipped(const std::string& text, std::size_t bytes_max) {
    return std::string(clip_utf8(text, bytes_max));
}

std::string name_of(const Frame& frame, ClientId client) {
    const Player* const player = frame.players ? frame.players->find(client) : nullptr;
    return player ? player->name : std::string();
}

}  // namespace

PlayerReport parse_report(std::string_view data) {
    PlayerReport report;
    const auto json = parse_strict_json(data, 4);
    const std::string* const reason =
        json.ok() && json->is_object() ? string_member(*json, "reason") : nullptr;
    if (!reason) {
        report.reason = printable(data, PlayerReports::reason_bytes_max);
        return report;
    }
    report.reason = clipped(*reason, PlayerReports::reason_bytes_max);
    if (const auto client = json->find("client"); client != json->end() &&
                                                  client->is_number_unsigned() &&
                                                  client->get<std::uint64_t>() <= 0xffffffffu)
        report.client = client->get<ClientId>();
    if (const std::string* const name = string_member(*json, "name"))
        report.name = clipped(*name, PlayerReports::name_bytes_max);
    const auto messages = json->find("messages");
    if (messages == json->end() || !messages->is_array()) return report;
    for (const auto& message : *messages) {
        if (report.messages.size() == PlayerReports::messages_max) break;
        if (message.is_string())
            report.messages.push_back(
                clipped(message.get_ref<const std::string&>(), PlayerReports::message_bytes_max));
    }
    return report;
}

PlayerReports::PlayerReports() : log_lines_(1, 10, Clock::now()) {}

void PlayerReports::add_from(const Frame& frame, const WorldLabel& world, Clock::time_point now) {
    const RecentMessages& recent = *frame.messages;
    if (recent.count == last_message_) return;            // only the tick thread writes it
    if (recent.count < last_message_) last_message_ = 0;  // of a restarted world
    for (const UserMessagePtr& message : recent.messages) {
        if (message->number <= last_message_ || !message->to_server || message->topic != topic)
            continue;
        PlayerReport report = parse_report(message->data);
        report.tick = message->tick;
        report.time = std::chrono::system_clock::now();
        report.from = message->from;
        report.from_name = name_of(frame, message->from);
        if (std::string name = name_of(frame, report.client); !name.empty())
            report.name = std::move(name);
        log(report, world, now);
        add(std::move(report));
    }
    last_message_ = recent.count;
}

void PlayerReports::add(PlayerReport report) {
    const std::lock_guard lock(mutex_);
    report.number = ++count_;
    const auto is_by_same = [&](const PlayerReport& other) { return other.from == report.from; };
    if (std::ranges::count_if(reports_, is_by_same) ==
        static_cast<std::ptrdiff_t>(reports_per_client_max))
        reports_.erase(std::ranges::find_if(reports_, is_by_same));
    if (reports_.size() == reports_max) reports_.pop_front();
    reports_.push_back(std::move(report));
}

void PlayerReports::log(const PlayerReport& report, const WorldLabel& world,
                        Clock::time_point now) {
    if (!log_lines_.take(1, now)) {
        not_logged_++;
        return;
    }
    const std::string unlogged =
        not_logged_ > 0 ? fmt::format("; {} earlier reports were not logged", not_logged_) : "";
    not_logged_ = 0;
    log_info("world {} {}: client {} {} reports client {} {} in tick {}: {}{}", world.id,
             quoted(world.name, 64), report.from, quoted(report.from_name, 64), report.client,
             quoted(report.name, 64), report.tick, quoted(report.reason, 300), unlogged);
}

std::vector<PlayerReport> PlayerReports::list() const {
    const std::lock_guard lock(mutex_);
    return {reports_.begin(), reports_.end()};
}

}  // namespace jostle::server
