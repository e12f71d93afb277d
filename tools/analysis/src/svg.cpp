// SPDX-License-Identifier: MIT
#include "jostle/analysis/svg.h"

#include <cstdio>

namespace jostle::plots {
namespace {

// A resolution of 0.1 px is sufficient and keeps files and their differences small.
std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + value + "\"";
}

std::string list_of(std::span<const SvgPoint> points) {
    std::string list;
    for (const SvgPoint& p : points)
        list += (list.empty() ? "" : " ") + number(p.x) + "," + number(p.y);
    return list;
}

std::string escaped(const std::string& words) {
    std::string safe;
    for (const char c : words) {
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else if (c == '>')
            safe += "&gt;";
        else
            safe += c;
    }
    return safe;
}

const char* name_of(TextAnchor anchor) {
    return anchor == TextAnchor::start ? "start" : anchor == TextAnchor::middle ? "middle" : "end";
}

}  // namespace

Svg::Svg(double width, double height) {
    const std::string size = number(width) + " " + number(height);
    body_ = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", number(width)) +
            attribute("height", number(height)) + attribute("viewBox", "0 0 " + size) +
            attribute("font-family", "sans-serif") + ">\n";
    rectangle({0, 0}, width, height, "#fff");
}

void Svg::rectangle(SvgPoint corner, double width, double height, const char* color) {
    body_ += "<rect" + attribute("x", number(corner.x)) + attribute("y", number(corner.y)) +
             attribute("width", number(width)) + attribute("height", number(height)) +
             attribute("fill", color) + "/>\n";
}

void Svg::line(SvgPoint from, SvgPoint to, const char* color, double width) {
    body_ += "<line" + attribute("x1", number(from.x)) + attribute("y1", number(from.y)) +
             attribute("x2", number(to.x)) + attribute("y2", number(to.y)) +
             attribute("stroke", color) + attribute("stroke-width", number(width)) + "/>\n";
}

void Svg::polyline(std::span<const SvgPoint> points, const char* color) {
    body_ += "<polyline" + attribute("points", list_of(points)) + attribute("fill", "none") +
             attribute("stroke", color) + attribute("stroke-width", "1.5") + "/>\n";
}

void Svg::marker(SvgPoint at, int shape, const char* color) {
    const double r = 4.5, x = at.x, y = at.y;
    if (shape % 4 == 0) {
        body_ += "<circle" + attribute("cx", number(x)) + attribute("cy", number(y)) +
                 attribute("r", number(r)) + attribute("fill", color) + "/>\n";
        return;
    }
    const SvgPoint square[] = {{x - 4, y - 4}, {x + 4, y - 4}, {x + 4, y + 4}, {x - 4, y + 4}};
    const SvgPoint triangle[] = {{x, y - 5}, {x + 5, y + 4}, {x - 5, y + 4}};
    const SvgPoint diamond[] = {{x, y - 6}, {x + 6, y}, {x, y + 6}, {x - 6, y}};
    const std::span<const SvgPoint> outlines[] = {square, triangle, diamond};
    body_ += "<polygon" + attribute("points", list_of(outlines[shape % 4 - 1])) +
             attribute("fill", color) + "/>\n";
}

void Svg::ring(SvgPoint at, const char* color) {
    body_ += "<circle" + attribute("cx", number(at.x)) + attribute("cy", number(at.y)) +
             attribute("r", "8") + attribute("fill", "none") + attribute("stroke", color) + "/>\n";
}

void Svg::text(SvgPoint at, const std::string& words, const TextStyle& style) {
    const std::string x = number(at.x), y = number(at.y);
    body_ += "<text" + attribute("x", x) + attribute("y", y) +
             attribute("font-size", number(style.size)) + attribute("fill", style.color) +
             attribute("text-anchor", name_of(style.anchor));
    if (style.bold) body_ += attribute("font-weight", "bold");
    if (style.vertical) body_ += attribute("transform", "rotate(-90 " + x + " " + y + ")");
    body_ += ">" + escaped(words) + "</text>\n";
}

std::string Svg::str() const {
    return body_ + "</svg>\n";
}

}  // namespace jostle::plots
