// SPDX-License-Identifier: MIT
#include "jostle/modules/controlled_entity_state.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace jostle::modules {

using namespace physics;

namespace {

constexpr std::size_t motion_word_count = 13;
// The ranges that World accepts: m; m/s and rad/s.
constexpr double coordinate_max = 1e7, velocity_max = 1e4;
constexpr double float_max = std::numeric_limits<float>::max();

std::uint32_t word_of(double x) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(clamp(x, -float_max, float_max)));
}

class WordWriter final : public StateVisitor {
public:
    WordWriter(const World& world, const BodyNameLookup& name_of)
        : world_(world), name_of_(name_of) {}

    using StateVisitor::field;
    bool loading() const override { return false; }
    void fail(std::string_view, std::string_view) override {}
    bool failed() const override { return false; }
    void field(std::string_view, bool& x) override { words.push_back(x ? 1 : 0); }
    void field(std::string_view, std::uint8_t& x) override { words.push_back(x); }
    void field(std::string_view, std::uint16_t& x) override { words.push_back(x); }
    void field(std::string_view, std::uint32_t& x) override { words.push_back(x); }
    void field(std::string_view, std::uint64_t& x) override { write_long(x); }
    void field(std::string_view, std::int32_t& x) override {
        words.push_back(static_cast<std::uint32_t>(x));
    }
    void field(std::string_view, std::int64_t& x) override {
        write_long(static_cast<std::uint64_t>(x));
    }
    void field(std::string_view, float& x) override { words.push_back(word_of(x)); }
    void field(std::string_view, double& x) override { words.push_back(word_of(x)); }
    void field(std::string_view, BodyId& id) override {
        words.push_back(world_.contains(id) ? name_of_(id) : 0);
    }
    void field(std::string_view name, ShapeId& id) override {
        const Result<ShapeState> shape = world_.shape(id);
        BodyId body = shape.ok() ? shape->body : BodyId{};
        field(name, body);
        words.push_back(shape.ok() ? shape_index(*shape) : 0);
    }
    void field(std::string_view, JointId&) override {}
    std::size_t count(std::string_view, std::size_t size) override {
        words.push_back(static_cast<std::uint32_t>(size));
        return size;
    }
    void enter(std::string_view) override {}
    void enter(std::size_t) override {}
    void leave() override {}

    std::vector<std::uint32_t> words;

private:
    void write_long(std::uint64_t x) {
        words.push_back(static_cast<std::uint32_t>(x));
        words.push_back(static_cast<std::uint32_t>(x >> 32));
    }
    std::uint32_t shape_index(const ShapeState& shape) const {
        const std::vector<ShapeId> all = world_.shapes_of(shape.body);
        const auto at = std::find(all.begin(), all.end(), shape.id);
        return static_cast<std::uint32_t>(at - all.begin());
    }

    const World& world_;
    const BodyNameLookup& name_of_;
};

class WordReader final : public StateVisitor {
public:
    WordReader(const World& world, std::span<const std::uint32_t> words, const BodyLookup& body_of)
        : world_(world), words_(words), body_of_(body_of) {}

    using StateVisitor::field;
    bool loading() const override { return true; }
    void fail(std::string_view, std::string_view) override { failed_ = true; }
    bool failed() const override { return failed_; }
    void field(std::string_view, bool& x) override {
        const std::uint32_t word = next();
        if (word > 1) failed_ = true;
        x = word == 1;
    }
    void field(std::string_view, std::uint8_t& x) override { read_narrow(x); }
    void field(std::string_view, std::uint16_t& x) override { read_narrow(x); }
    void field(std::string_view, std::uint32_t& x) override { x = next(); }
    void field(std::string_view, std::uint64_t& x) override { x = next_long(); }
    void field(std::string_view, std::int32_t& x) override {
        x = static_cast<std::int32_t>(next());
    }
    void field(std::string_view, std::int64_t& x) override {
        x = static_cast<std::int64_t>(next_long());
    }
    void field(std::string_view, float& x) override { x = next_number(); }
    void field(std::string_view, double& x) override { x = next_number(); }
    void field(std::string_view, BodyId& id) override {
        const std::uint32_t name = next();
        id = name == 0 ? BodyId{} : body_of_(name);
    }
    void field(std::string_view name, ShapeId& id) override {
        BodyId body;
        field(name, body);
        const std::uint32_t index = next();
        const std::vector<ShapeId> shapes = world_.shapes_of(body);
        id = index < shapes.size() ? shapes[index] : ShapeId{};
    }
    void field(std::string_view, JointId& id) override { id = {}; }
    // An array has at most as many elements as there are words left, so untrusted words cannot
    // cause a large allocation.
    std::size_t count(std::string_view, std::size_t) override {
        const std::uint32_t size = next();
        if (size <= words_.size()) return size;
        failed_ = true;
        return 0;
    }
    void enter(std::string_view) override {}
    void enter(std::size_t) override {}
    void leave() override {}

private:
    std::uint32_t next() {
        if (failed_ || words_.empty()) {
            failed_ = true;
            return 0;
        }
        const std::uint32_t word = words_.front();
        words_ = words_.subspan(1);
        return word;
    }
    std::uint64_t next_long() {
        const std::uint64_t low = next();
        return low | std::uint64_t{next()} << 32;
    }
    float next_number() {
        const auto x = std::bit_cast<float>(next());
        if (is_finite(double{x})) return x;
        failed_ = true;
        return 0;
    }
    template <class T>
    void read_narrow(T& x) {
        const std::uint32_t word = next();
        if (word > std::numeric_limits<T>::max()) failed_ = true;
        x = static_cast<T>(word);
    }

    const World& world_;
    std::span<const std::uint32_t> words_;
    const BodyLookup& body_of_;
    bool failed_ = false;
};

}  // namespace

std::optional<std::vector<std::uint32_t>> encode_controlled_entity(World& world, Module& module,
                                                                   BodyId body,
                                                                   const BodyNameLookup& name_of) {
    const Result<BodyState> state = world.body(body);
    if (!state.ok()) return std::nullopt;
    WordWriter writer(world, name_of);
    const auto& [p, q] = state->pose;
    const Vec3 &v = state->linear_velocity, &w = state->angular_velocity;
    for (const double x : {p.x, p.y, p.z, q.x, q.y, q.z, q.w, v.x, v.y, v.z, w.x, w.y, w.z})
        writer.words.push_back(word_of(x));
    if (!module.visit_controlled_entity(world, body, writer)) return std::nullopt;
    if (writer.words.size() > controlled_entity_words_max) return std::nullopt;
    return std::move(writer.words);
}

std::optional<ControlledEntityMotion> decode_controlled_motion(
    std::span<const std::uint32_t> words) {
    if (words.size() < motion_word_count) return std::nullopt;
    double n[motion_word_count];
    for (std::size_t k = 0; k < motion_word_count; k++) {
        n[k] = std::bit_cast<float>(words[k]);
        const double most = k < 3 ? coordinate_max : velocity_max;
        if (!(absolute(n[k]) <= most)) return std::nullopt;
    }
    const Quat rotation{n[3], n[4], n[5], n[6]};
    const double size = norm_squared(rotation);
    if (!(size > 0.9 && size < 1.1)) return std::nullopt;
    return ControlledEntityMotion{
        .pose = {.position = {n[0], n[1], n[2]}, .rotation = normalized(rotation)},
        .linear = {n[7], n[8], n[9]},
        .angular = {n[10], n[11], n[12]}};
}

bool apply_controlled_entity(World& world, Module& module, BodyId body,
                             std::span<const std::uint32_t> words, const BodyLookup& body_of) {
    const std::optional<ControlledEntityMotion> motion = decode_controlled_motion(words);
    if (!motion) return false;
    WordReader reader(world, words.subspan(motion_word_count), body_of);
    if (!module.visit_controlled_entity(world, body, reader)) return false;
    return world.set_pose(body, motion->pose).ok() &&
           world.set_velocity(body, motion->linear, motion->angular).ok();
}

}  // namespace jostle::modules
