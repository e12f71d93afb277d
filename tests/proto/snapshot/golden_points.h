// SPDX-License-Identifier: MIT
//
// The golden point objects: one of each form, with keyframes, refinements and baselines, so that
// they exercise every path of the codec. C++ and TypeScript decode the same file.
//
// proto/golden/points.jpnt, all numbers little-endian: "JPNT", u32 version 1, u32 objects; per
// object u32 form, points, columns, strands and their sizes, triangle corners and the corners, u32
// updates; per update u32 number, back, levels, crc, bytes, values, links; then the values and the
// links (PointState::previous) as i32, and the bytes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "jostle/snapshot/point_codec.h"

namespace jostle::snapshot {

struct PointUpdate {
    std::uint32_t number = 0, back = 0;
    std::size_t levels = point_levels;
    PackedPoints packed;
    PointState state;
};

struct GoldenPoints {
    std::string name;
    PointLayout layout;
    std::vector<PointUpdate> updates;
};

// Waves that travel through the points of an object, and loose points that come and go. The same
// seed generates the same points on every machine.
class MovingPointObject {
public:
    MovingPointObject(std::uint32_t seed, PointLayout layout)
        : layout_(std::move(layout)),
          order_(layout_.form == PointForm::loose ? PointOrder() : PointOrder(layout_)),
          random_(seed) {
        for (std::uint32_t k = 0; k < layout_.points; k++) add_point();
    }

    const PointLayout& layout() const { return layout_; }

    // The state after `ticks` of motion, coded against the one before it, or as a keyframe.
    PointUpdate next(bool is_keyframe, std::size_t levels = point_levels) {
        move();
        return encode(++number_, is_keyframe ? 0 : 2, levels);
    }
    // The last state again, with more levels.
    PointUpdate refined(std::size_t levels) { return encode(number_, 1, levels); }

private:
    struct Sent {
        PointState state;
        std::vector<std::uint32_t> ids;
    };

    std::int32_t noise(std::int32_t most) {
        return static_cast<std::int32_t>(random_() % (2u * static_cast<std::uint32_t>(most) + 1)) -
               most;
    }
    void add_point() {
        const auto at = static_cast<std::int32_t>(ids_.size());
        for (std::size_t c = 0; c < components_of(layout_.form); c++) {
            values_.push_back(c == 0 ? 40 * at : noise(50));
            speeds_.push_back(noise(30));
        }
        ids_.push_back(next_id_++);
    }
    void move() {
        const std::size_t components = components_of(layout_.form);
        const std::int32_t wind = noise(12);
        for (std::size_t k = 0; k < values_.size(); k++) {
            speeds_[k] =
                std::clamp(speeds_[k] + noise(2) + (k % components == 1 ? wind : 0), -300, 300);
            if (random_() % 400 == 0) speeds_[k] += noise(1 << 20);
            values_[k] =
                std::clamp(values_[k] + speeds_[k], -point_coordinate_max, point_coordinate_max);
        }
        if (layout_.form != PointForm::loose) return;
        for (std::size_t k = ids_.size(); k-- > 0;)
            if (random_() % 12 == 0) {
                const auto from = static_cast<std::ptrdiff_t>(k * components),
                           to = from + static_cast<std::ptrdiff_t>(components);
                values_.erase(values_.begin() + from, values_.begin() + to);
                speeds_.erase(speeds_.begin() + from, speeds_.begin() + to);
                ids_.erase(ids_.begin() + static_cast<std::ptrdiff_t>(k));
            }
        for (std::uint32_t born = random_() % 8; born > 0; born--) add_point();
    }

    // As a server does: fewer levels of loose points have fewer points.
    Sent at_levels(std::uint32_t number, std::size_t levels) const {
        Sent sent{{.number = number, .values = values_, .previous = {}}, ids_};
        if (layout_.form != PointForm::loose) {
            coarse_points(layout_, order_, sent.state.values, levels);
            return sent;
        }
        const std::uint32_t mask = (1u << (point_levels - levels)) - 1;
        const std::size_t components = components_of(layout_.form);
        sent.state.values.clear();
        sent.ids.clear();
        for (std::size_t k = 0; k < ids_.size(); k++) {
            if ((ids_[k] & mask) != 0) continue;
            sent.ids.push_back(ids_[k]);
            for (std::size_t c = 0; c < components; c++)
                sent.state.values.push_back(values_[components * k + c]);
        }
        return sent;
    }

    PointUpdate encode(std::uint32_t number, std::uint32_t back, std::size_t levels) {
        Sent now = at_levels(number, levels);
        if (back == 0 || sent_.empty()) sent_.clear();
        if (sent_.empty()) back = 0;
        if (back == 1) sent_.erase(sent_.begin(), sent_.end() - 1);
        if (layout_.form == PointForm::loose)
            for (const std::uint32_t id : now.ids) {
                std::uint32_t link = no_point;
                if (!sent_.empty()) {
                    const auto& ids = sent_.back().ids;
                    const auto at = std::ranges::lower_bound(ids, id);
                    if (at != ids.end() && *at == id)
                        link = static_cast<std::uint32_t>(at - ids.begin());
                }
                now.state.previous.push_back(link);
            }
        const auto at = [&](std::size_t k) {
            return k <= sent_.size() ? &sent_[sent_.size() - k].state : nullptr;
        };
        PointUpdate update{
            .number = number, .back = back, .levels = levels, .packed = {}, .state = now.state};
        update.packed = encode_points(layout_, order_, now.state, {at(1), at(2), at(3)}, levels);
        if (back == 1) sent_.clear();
        sent_.push_back(std::move(now));
        if (sent_.size() > 3) sent_.erase(sent_.begin());
        return update;
    }

    PointLayout layout_;
    PointOrder order_;
    std::minstd_rand random_;
    std::uint32_t number_ = 0, next_id_ = 1;
    std::vector<std::int32_t> values_, speeds_;
    std::vector<std::uint32_t> ids_;
    std::vector<Sent> sent_;  // the newest last
};

inline PointLayout strand_layout(std::vector<std::uint32_t> sizes) {
    PointLayout layout{
        .form = PointForm::strands, .points = 0, .columns = 0, .strands = sizes, .triangles = {}};
    for (const std::uint32_t size : sizes) layout.points += size;
    return layout;
}

inline PointLayout grid_layout(PointForm form, std::uint32_t columns, std::uint32_t rows) {
    return {
        .form = form, .points = columns * rows, .columns = columns, .strands = {}, .triangles = {}};
}

// A sheet of triangles, with a point in no triangle.
inline PointLayout mesh_layout(std::uint32_t columns, std::uint32_t rows) {
    PointLayout layout{.form = PointForm::triangles,
                       .points = columns * rows + 1,
                       .columns = 0,
                       .strands = {},
                       .triangles = {}};
    for (std::uint32_t row = 0; row + 1 < rows; row++)
        for (std::uint32_t column = 0; column + 1 < columns; column++) {
            const std::uint32_t a = row * columns + column, b = a + columns;
            for (const std::uint32_t corner : {a, b, a + 1, a + 1, b, b + 1})
                layout.triangles.push_back(corner);
        }
    return layout;
}

inline std::vector<GoldenPoints> golden_points() {
    std::vector<GoldenPoints> all = {
        {"loose", {}, {}},
        {"strands", strand_layout({1, 2, 5, 33, 20}), {}},
        {"grid", grid_layout(PointForm::grid, 11, 8), {}},
        {"triangles", mesh_layout(9, 7), {}},
        {"heights", grid_layout(PointForm::heights, 17, 4), {}},
    };
    std::uint32_t seed = 1;
    for (GoldenPoints& object : all) {
        MovingPointObject moving(seed++, object.layout);
        // Coarse first, refined twice, then full, coarser in between, and a keyframe.
        object.updates.push_back(moving.next(true, 1));
        object.updates.push_back(moving.refined(3));
        object.updates.push_back(moving.refined(4));
        for (int k = 0; k < 5; k++) object.updates.push_back(moving.next(false));
        object.updates.push_back(moving.next(false, 2));
        object.updates.push_back(moving.next(false, 3));
        object.updates.push_back(moving.next(false));
        object.updates.push_back(moving.next(true));
        object.updates.push_back(moving.next(false));
    }
    return all;
}

inline std::vector<std::byte> golden_point_file() {
    std::vector<std::byte> file;
    const auto u32 = [&](std::uint64_t value) {
        for (unsigned k = 0; k < 4; k++)
            file.push_back(static_cast<std::byte>(value >> (8 * k) & 0xff));
    };
    const auto list = [&](const auto& values) {
        for (const auto value : values) u32(static_cast<std::uint32_t>(value));
    };
    for (const char letter : {'J', 'P', 'N', 'T'}) file.push_back(static_cast<std::byte>(letter));
    u32(1);
    const std::vector<GoldenPoints> objects = golden_points();
    u32(objects.size());
    for (const GoldenPoints& object : objects) {
        u32(static_cast<std::uint64_t>(object.layout.form));
        u32(object.layout.points);
        u32(object.layout.columns);
        u32(object.layout.strands.size());
        list(object.layout.strands);
        u32(object.layout.triangles.size());
        list(object.layout.triangles);
        u32(object.updates.size());
        for (const PointUpdate& update : object.updates) {
            list(std::array<std::uint64_t, 7>{update.number, update.back, update.levels,
                                              update.packed.crc, update.packed.bytes.size(),
                                              update.state.values.size(),
                                              update.state.previous.size()});
            list(update.state.values);
            list(update.state.previous);
            file.insert(file.end(), update.packed.bytes.begin(), update.packed.bytes.end());
        }
    }
    return file;
}

}  // namespace jostle::snapshot
