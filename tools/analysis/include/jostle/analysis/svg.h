// SPDX-License-Identifier: MIT
//
// A drawing as SVG text, with the shapes that the plots need. Units are pixels, y points downwards.
#pragma once

#include <span>
#include <string>

namespace jostle::plots {

struct SvgPoint {
    double x = 0, y = 0;
};

enum class TextAnchor { start, middle, end };

struct TextStyle {
    double size = 12;
    TextAnchor anchor = TextAnchor::start;
    bool vertical = false;  ///< rotated to read from bottom to top
    bool bold = false;
    const char* color = "#222";
};

class Svg {
public:
    Svg(double width, double height);

    void rectangle(SvgPoint corner, double width, double height, const char* color);
    void line(SvgPoint from, SvgPoint to, const char* color, double width = 1);
    void polyline(std::span<const SvgPoint> points, const char* color);
    /// Draws a marker. Shapes repeat after the fourth: disc, square, triangle, diamond.
    void marker(SvgPoint at, int shape, const char* color);
    void ring(SvgPoint at, const char* color);  ///< around a marker
    void text(SvgPoint at, const std::string& words, const TextStyle& style = {});

    std::string str() const;  ///< the complete file

private:
    std::string body_;
};

}  // namespace jostle::plots
