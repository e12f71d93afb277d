// SPDX-License-Identifier: MIT
#include "jostle/analysis/svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jostle::plots {
namespace {

using testing::HasSubstr;

TEST(Svg, is_a_whole_file_of_what_was_drawn) {
    Svg svg(120, 80);
    const SvgPoint points[] = {{1, 2}, {3.25, 4}};
    svg.polyline(points, "#123456");
    svg.text({5, 6}, "a < b & c", {.anchor = TextAnchor::middle, .bold = true});
    for (int shape = 0; shape < 4; shape++) svg.marker({10, 10}, shape, "#000");
    const std::string text = svg.str();
    for (const char* words : {"<svg xmlns", "viewBox=\"0 0 120.0 80.0\"", "1.0,2.0 3.2,4.0",
                              "#123456", "a &lt; b &amp; c", "middle", "</svg>"})
        EXPECT_THAT(text, HasSubstr(words));
}

}  // namespace
}  // namespace jostle::plots
