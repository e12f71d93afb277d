// SPDX-License-Identifier: MIT
#include "server/metrics/chrome_trace.h"

#include <gtest/gtest.h>

namespace jostle::server {

TEST(ChromeTrace, writes_spans_as_events_in_microseconds_with_titles) {
    const std::vector<TraceSpan> spans = {
        {.name = "tick",
         .start_us = 0,
         .duration_us = 1200.5,
         .row = 0,
         .details = {{"bodies", 3}}},
        {.name = "solve", .start_us = 100.25, .duration_us = 1000, .row = 1}};
    EXPECT_EQ(write_chrome_trace({.process = "arena", .rows = {"ticks", "stages"}}, spans),
              R"({"displayTimeUnit":"ms","traceEvents":[
{"ph":"M","pid":1,"tid":0,"name":"process_name","args":{"name":"arena"}},
{"ph":"M","pid":1,"tid":0,"name":"thread_name","args":{"name":"ticks"}},
{"ph":"M","pid":1,"tid":1,"name":"thread_name","args":{"name":"stages"}},
{"ph":"X","pid":1,"tid":0,"name":"tick","ts":0,"dur":1200.500,"args":{"bodies":3}},
{"ph":"X","pid":1,"tid":1,"name":"solve","ts":100.250,"dur":1000}
]}
)");
}

// A client chooses the name of a world.
TEST(ChromeTrace, escapes_text) {
    const std::string trace = write_chrome_trace({.process = "a\"},\n\\{\x01", .rows = {}}, {});
    EXPECT_NE(trace.find(R"("name":"a\"},\u000a\\{\u0001"}})"), std::string::npos) << trace;
    EXPECT_NE(write_chrome_trace({}, {{.name = "x", .start_us = 1e300}}).find("\"ts\":0"),
              std::string::npos)
        << "an unrepresentable time must be written as 0";
}

}  // namespace jostle::server
