// SPDX-License-Identifier: MIT
#include "server/metrics/chrome_trace.h"

#include <charconv>
#include <cmath>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

constexpr std::size_t span_bytes = 110;  // typical size of one span

void append_text(std::string& out, std::string_view text) {
    static constexpr char digits[] = "0123456789abcdef";
    out += '"';
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            (out += '\\') += c;
        } else if (byte < 0x20) {
            out += "\\u00";
            (out += digits[byte >> 4]) += digits[byte & 15];
        } else {
            out += c;
        }
    }
    out += '"';
}

// At most three decimals: nanoseconds, because the unit is a microsecond.
void append_number(std::string& out, double number) {
    char text[40];
    const int digits = number == std::floor(number) ? 0 : 3;
    const auto [end, error] =
        std::to_chars(text, text + sizeof text, number, std::chars_format::fixed, digits);
    if (error == std::errc{})
        out.append(text, end);
    else
        out += '0';
}

void append_title(std::string& out, std::string_view kind, int row, std::string_view title) {
    out += R"({"ph":"M","pid":1,"tid":)" + std::to_string(row) + R"(,"name":")";
    (out += kind) += R"(","args":{"name":)";
    append_text(out, title);
    out += "}},\n";
}

void append_span(std::string& out, const TraceSpan& span) {
    out += R"({"ph":"X","pid":1,"tid":)" + std::to_string(span.row) + R"(,"name":)";
    append_text(out, span.name);
    out += R"(,"ts":)";
    append_number(out, span.start_us);
    out += R"(,"dur":)";
    append_number(out, span.duration_us);
    for (std::size_t i = 0; i < span.details.size(); i++) {
        out += i == 0 ? R"(,"args":{)" : ",";
        append_text(out, span.details[i].first);
        out += ':';
        append_number(out, span.details[i].second);
    }
    out += span.details.empty() ? "}" : "}}";
}

}  // namespace

std::string write_chrome_trace(const TraceRows& titles, const std::vector<TraceSpan>& spans) {
    std::string out;
    out.reserve(span_bytes * (spans.size() + 8));
    out += "{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n";
    append_title(out, "process_name", 0, titles.process);
    for (std::size_t row = 0; row < titles.rows.size(); row++)
        append_title(out, "thread_name", static_cast<int>(row), titles.rows[row]);
    for (const TraceSpan& span : spans) {
        append_span(out, span);
        out += ",\n";
    }
    // the comma after the last entry; at least one title is always written
    ASSERT(out.ends_with(",\n"));
    out.resize(out.size() - 2);
    out += "\n]}\n";
    return out;
}

}  // namespace jostle::server
