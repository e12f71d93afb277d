// SPDX-License-Identifier: MIT
#include "tools/sim/trace.h"

namespace jostle::sim {
namespace {

// Quotes a CSV field if necessary; quotes are doubled.
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + "\"";
}

}  // namespace

std::unique_ptr<Trace> Trace::open(const std::string& path) {
    std::FILE* file = std::fopen(path.c_str(), "w");
    if (!file) return nullptr;
    std::fputs("tick,body,name,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz\n", file);
    return std::unique_ptr<Trace>(new Trace(file));
}

Trace::~Trace() {
    close();
}

bool Trace::close() {
    if (!file_) return true;
    const bool good = std::ferror(file_) == 0;
    const bool closed = std::fclose(file_) == 0;
    file_ = nullptr;
    return good && closed;
}

void Trace::write(std::uint64_t tick, const scenes::BuiltScene& scene,
                  const scenes::SceneDescription& description) {
    for (std::size_t i = 0; i < scene.bodies.size(); i++) {
        const auto body = scene.world.body(scene.bodies[i]);
        if (!body.ok() || body->type == physics::BodyType::static_body) continue;
        const auto &p = body->pose.position, &v = body->linear_velocity,
                   &w = body->angular_velocity;
        const auto& q = body->pose.rotation;
        std::fprintf(
            file_,
            "%llu,%zu,%s,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.9g,%.9g,%.9g,%.9g,%.9g,"
            "%.9g\n",
            static_cast<unsigned long long>(tick), i, quoted(description.bodies[i].name).c_str(),
            p.x, p.y, p.z, q.x, q.y, q.z, q.w, v.x, v.y, v.z, w.x, w.y, w.z);
    }
}

}  // namespace jostle::sim
