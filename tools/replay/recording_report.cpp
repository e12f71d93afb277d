// SPDX-License-Identifier: MIT
#include "tools/replay/recording_report.h"

#include <ctime>
#include <nlohmann/json.hpp>

#include "jostle/base/format_text.h"
#include "jostle/snapshot/quantize.h"
#include "tools/common/table.h"

namespace jostle::replay {

namespace {

using nlohmann::ordered_json;

std::string utc_text(std::uint64_t unix_us) {
    const auto seconds = static_cast<std::time_t>(unix_us / 1'000'000);
    std::tm parts{};
    char text[32];
    if (gmtime_r(&seconds, &parts) == nullptr ||
        std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts) == 0)
        return "not known";
    return text;
}

double bytes_per_second(const client::RecordingSummary& summary) {
    return summary.seconds > 0 ? static_cast<double>(summary.message_bytes) / summary.seconds : 0;
}

std::string line(const char* name, const std::string& value) {
    return format_text("%-18s %s\n", name, value.c_str());
}

// Names are untrusted: invalid UTF-8 is replaced.
std::string dumped(const ordered_json& json) {
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

struct Known {
    std::string name, type;
    std::uint32_t owner = 0;
};

Known known_of(const client::WorldView& view, std::uint32_t id) {
    const auto found = view.entities().find(id);
    if (found == view.entities().end()) return {.name = "", .type = "unknown"};
    switch (found->second.type()) {
        case v1::BODY_TYPE_STATIC:
            return {found->second.name(), "static", found->second.owner()};
        case v1::BODY_TYPE_KINEMATIC:
            return {found->second.name(), "kinematic", found->second.owner()};
        case v1::BODY_TYPE_UNSPECIFIED:
        case v1::BODY_TYPE_DYNAMIC:
            return {found->second.name(), "dynamic", found->second.owner()};
        default:
            return {found->second.name(), "unknown", found->second.owner()};
    }
}

}  // namespace

std::string to_text(const client::RecordingReader& recording, const client::RecordingSummary& s) {
    const v1::Welcome& welcome = recording.welcome();
    std::string text =
        line("world", common::sanitized(welcome.world_name()) + " (" +
                          common::sanitized(welcome.world_id()) + "), " +
                          common::number_text(welcome.tick_hz(), 6) + " ticks per second");
    text += line("recorded",
                 utc_text(recording.start_unix_us()) + ", " + format_text("%.1f s", s.seconds));
    text += line("ticks", format_text("%u to %u", s.first_tick, s.last_tick));
    text +=
        line("entities", format_text("%zu at the end, maximum %zu", s.entities, s.entities_max));
    text += line("bytes", format_text("%llu in messages, %.0f per second",
                                      static_cast<unsigned long long>(s.message_bytes),
                                      bytes_per_second(s)));
    text += line("keyframes",
                 format_text("%llu, %llu bytes", static_cast<unsigned long long>(s.keyframes),
                             static_cast<unsigned long long>(s.keyframe_bytes)));
    for (const auto& [kind, count] : s.messages)
        text += line((kind + " messages").c_str(),
                     format_text("%llu", static_cast<unsigned long long>(count)));
    const auto count = [](std::uint64_t number) {
        return format_text("%llu", static_cast<unsigned long long>(number));
    };
    if (s.player_events > 0) text += line("player events", count(s.player_events));
    if (s.attribute_updates > 0) text += line("attribute updates", count(s.attribute_updates));
    if (s.user_messages > 0) text += line("user messages", count(s.user_messages));
    if (!recording.truncation_reason().empty())
        text += line("truncated", recording.truncation_reason());
    if (!s.first_error.empty()) text += line("corrupt", s.first_error);
    return text;
}

std::string to_json(const client::RecordingReader& recording, const client::RecordingSummary& s) {
    const v1::Welcome& welcome = recording.welcome();
    return dumped({{"world", welcome.world_name()},
                   {"world_id", welcome.world_id()},
                   {"tick_hz", welcome.tick_hz()},
                   {"recorded", utc_text(recording.start_unix_us())},
                   {"seconds", s.seconds},
                   {"first_tick", s.first_tick},
                   {"last_tick", s.last_tick},
                   {"entities", s.entities},
                   {"entities_max", s.entities_max},
                   {"message_bytes", s.message_bytes},
                   {"bytes_per_second", bytes_per_second(s)},
                   {"keyframes", s.keyframes},
                   {"keyframe_bytes", s.keyframe_bytes},
                   {"messages", s.messages},
                   {"player_events", s.player_events},
                   {"attribute_updates", s.attribute_updates},
                   {"user_messages", s.user_messages},
                   {"truncation", recording.truncation_reason()},
                   {"damaged", s.first_error}});
}

std::string state_text(const client::Playback& playback, std::uint32_t tick) {
    const client::WorldView& view = playback.view();
    std::string text = format_text(
        "tick %u (snapshot of tick %u, %.3f s into the recording): %zu entities, %zu "
        "channels\n",
        tick, view.frame().frame, static_cast<double>(playback.arrived_us()) / 1e6,
        view.frame().entities.size(), view.channels().size());
    using common::Align;
    common::Table table({{"id", Align::right},
                         {"type"},
                         {"x", Align::right},
                         {"y", Align::right},
                         {"z", Align::right},
                         {"qx", Align::right},
                         {"qy", Align::right},
                         {"qz", Align::right},
                         {"qw", Align::right},
                         {"rests"},
                         {"name"}});
    for (const snapshot::EntityState& entity : view.frame().entities) {
        const snapshot::Pose pose = snapshot::dequantize(entity, view.spec());
        const Known known = known_of(view, entity.id);
        std::vector<std::string> cells{std::to_string(entity.id), known.type};
        for (const double p : pose.position) cells.push_back(common::number_text(p, 3));
        for (const double q : pose.rotation) cells.push_back(common::number_text(q, 3));
        cells.emplace_back(entity.at_rest ? "yes" : "no");
        cells.push_back(common::sanitized(known.name));
        table.add(std::move(cells));
    }
    return text + table.text();
}

std::string state_json(const client::Playback& playback, std::uint32_t tick) {
    const client::WorldView& view = playback.view();
    ordered_json entities = ordered_json::array();
    for (const snapshot::EntityState& entity : view.frame().entities) {
        const snapshot::Pose pose = snapshot::dequantize(entity, view.spec());
        const Known known = known_of(view, entity.id);
        entities.push_back(ordered_json{{"id", entity.id},
                                        {"name", known.name},
                                        {"type", known.type},
                                        {"owner", known.owner},
                                        {"position", pose.position},
                                        {"rotation", pose.rotation},
                                        {"rests", entity.at_rest}});
    }
    return dumped({{"tick", tick},
                   {"frame_tick", view.frame().frame},
                   {"seconds", static_cast<double>(playback.arrived_us()) / 1e6},
                   {"entities", entities}});
}

std::string to_text(const client::RecordingVerification& check) {
    std::string text =
        format_text("%llu snapshots decoded and verified, %zu errors\n",
                    static_cast<unsigned long long>(check.snapshots), check.errors.size());
    for (const std::string& fault : check.errors) text += fault + "\n";
    return text;
}

std::string to_json(const client::RecordingVerification& check) {
    return dumped({{"snapshots", check.snapshots}, {"faults", check.errors}});
}

}  // namespace jostle::replay
