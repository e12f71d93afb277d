// SPDX-License-Identifier: MIT
//
// Packed points from a stranger: an object with any connections, then its states. What could be
// read says the same when it is packed and read again. The CRC is put right, or nothing would come
// past it.
#include "jostle/snapshot/point_history.h"
#include "tests/fuzz/reader.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {
namespace {

using namespace snapshot;

// Any layout with up to a few hundred points; most of them are valid.
PointLayout take_layout(Reader& in) {
    PointLayout layout{.form = static_cast<PointForm>(in.number<std::uint8_t>() % 7)};
    const std::uint32_t points = in.number<std::uint16_t>() % 400;
    const std::uint32_t columns = in.number<std::uint8_t>();
    if (layout.form == PointForm::loose) return layout;
    layout.points = points;
    if (layout.form == PointForm::grid || layout.form == PointForm::heights) {
        layout.columns = columns;
        if (columns % 16 != 0) layout.points = columns * (points % 16);
    } else if (layout.form == PointForm::strands) {
        for (std::uint32_t left = points; left > 0 && layout.strands.size() < 400;) {
            layout.strands.push_back(in.number<std::uint8_t>() % (left + 1));
            left -= layout.strands.back();
        }
    } else if (layout.form == PointForm::triangles) {
        for (std::uint32_t k = 0; k < 3 * columns; k++)
            layout.triangles.push_back(in.number<std::uint16_t>() % (points + 1));
    }
    return layout;
}

// The same state again, without baselines.
void expect_round_trip(const PointLayout& layout, const PointOrder& order,
                       const DecodedPoints& points) {
    PointState alone{points.state.number, points.state.values, {}};
    if (layout.form == PointForm::loose)
        alone.previous.assign(points.state.previous.size(), no_point);
    const PackedPoints packed = encode_points(layout, order, alone, {}, points.levels);
    const auto again = read_points(layout, order, alone.number, packed.bytes, {});
    expect(again.ok() && again->state.values == alone.values && again->crc == points.crc,
           "points are the same when they were sent on");
}

}  // namespace

void run(Bytes input) {
    Reader in(input);
    const PointLayout layout = take_layout(in);
    Result<PointHistory> made = PointHistory::create(layout);
    if (!made.ok()) return expect(!made.error().message.empty(), "a refusal has a reason");
    PointHistory& history = *made;
    const PointOrder order = layout.form == PointForm::loose ? PointOrder() : PointOrder(layout);
    while (!in.done()) {
        const Record record = take_record(in);
        const auto bytes = bytes_of(record.bytes);
        const std::uint32_t known =
            history.states().empty() ? 0 : history.states().back().points.state.number;
        // A keyframe, a refinement, a state after the newest one, or one after a lost one.
        const std::uint32_t back = record.kind % 4;
        const std::uint32_t number = known + (back > 1 ? 1 + record.kind / 32 : 1 - back);
        const std::uint32_t named = back < 2 ? back : back == 2 ? number - known + 1 : number + 2;
        const auto told = history.read(number, named, bytes);
        const Status added = history.add(number, number, named, bytes, told.ok() ? told->crc : 0);
        expect(told.ok() == added.ok(), "what can be read is taken with its CRC");
        if (!added.ok()) {
            expect(!added.error().message.empty(), "a refusal has a reason");
            continue;
        }
        const DecodedPoints& points = history.states().back().points;
        expect(points.state.values.size() <= 3 * points_max, "no more points than allowed");
        expect_round_trip(layout, order, points);
    }
}

}  // namespace jostle::fuzz
