// SPDX-License-Identifier: MIT
#include "tools/load/data_traffic.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

#include "jostle/client/world_data.h"

namespace jostle::load {

namespace {

// A chat message has the length of a short sentence.
constexpr std::string_view chat_text = " a sentence of about the length of chat messages";
// Attributes in one input (SetAttributesInput).
constexpr int attributes_per_input = 64;

}  // namespace

v1::Input DataTraffic::attributes(std::uint32_t client_id, int first, int count) {
    std::vector<v1::Attribute> changed;
    for (int k = first; k < first + count; k++) {
        v1::Attribute attribute;
        attribute.set_key("load." + std::to_string(k));
        const auto value = static_cast<std::int64_t>(changes_ + static_cast<std::uint64_t>(k));
        // Of every type.
        switch (k % 5) {
            case 0:
                attribute.set_integer(value);
                break;
            case 1:
                attribute.set_number(static_cast<double>(value) / 8);
                break;
            case 2:
                attribute.set_boolean(value % 2 == 0);
                break;
            case 3:
                attribute.set_text("state " + std::to_string(value));
                break;
            default:
                attribute.mutable_vector()->set_x(static_cast<double>(value));
        }
        changed.push_back(std::move(attribute));
    }
    return client::attributes_input(client::AttributeTarget::player(client_id), changed);
}

std::vector<v1::Input> DataTraffic::take(Clock::time_point now, std::uint32_t client_id) {
    std::vector<v1::Input> inputs;
    if (!options_.is_on()) return inputs;
    if (!began_) {
        began_ = now;
        for (int first = 0; first < options_.attributes; first += attributes_per_input)
            inputs.push_back(attributes(
                client_id, first, std::min(attributes_per_input, options_.attributes - first)));
    }
    const double seconds = std::chrono::duration<double>(now - *began_).count();
    const double shift = (number_ % 97) / 97.0;
    const auto due = [&](double rate) {
        return static_cast<std::uint64_t>(std::max(0.0, seconds * rate + shift));
    };
    for (; messages_ < due(options_.messages_per_second); messages_++)
        inputs.push_back(client::message_input(
            chat_topic, std::to_string(client::to_us(now)) + std::string(chat_text)));
    if (options_.attributes == 0) return inputs;
    for (; changes_ < due(options_.attribute_changes_per_second); changes_++)
        inputs.push_back(attributes(
            client_id, static_cast<int>(changes_ % static_cast<std::uint64_t>(options_.attributes)),
            1));
    return inputs;
}

std::optional<std::uint64_t> sent_us(std::string_view data) {
    std::uint64_t us = 0;
    const auto parsed = std::from_chars(data.data(), data.data() + data.size(), us);
    if (parsed.ec != std::errc() || !data.ends_with(chat_text)) return std::nullopt;
    return us;
}

}  // namespace jostle::load
