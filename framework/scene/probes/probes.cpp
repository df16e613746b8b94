#include "weft/scene/probes.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/probes/probe_grid.h"

namespace weft::scene {
glm::mat3 yaw_rotation(float yaw_deg) {
    if (yaw_deg == 0) return glm::mat3(1);
    return glm::mat3(glm::rotate(glm::dmat4(1), glm::radians(double{yaw_deg}), glm::dvec3(0, 1, 0)));
}

glm::vec3 position_of(const ProbeVolume& volume, const Probe& probe) {
    const glm::vec3 way = glm::vec3(probe.at) * volume.spacing_m + probe.offset;
    return volume.origin + (volume.yaw_deg == 0 ? way : yaw_rotation(volume.yaw_deg) * way);
}

uint32_t count_of(const ProbeVolume& volume, ProbeState state) {
    return static_cast<uint32_t>(std::ranges::count(volume.probes, state, &Probe::state));
}

std::vector<ProbeCell> cells_of(const ProbeVolume& volume) {
    std::map<glm::ivec3, uint32_t, PointOrder> indices;
    for (uint32_t i = 0; i < volume.probes.size(); ++i) indices[volume.probes[i].at] = i;
    // Returns the index of the probe that gives the light of the grid point `index`: the probe of the point,
    // or its substitute if that probe is dropped. Returns kNoProbe if there is no such probe, or if the probe
    // of the point has moved by more than `reach_m`.
    const auto probe_for = [&](uint32_t index, float reach_m) {
        const Probe& probe = volume.probes[index];
        if (probe.state != ProbeState::dropped)
            return glm::length(probe.offset) <= reach_m ? index : ProbeCell::kNoProbe;
        const auto found = probe.substitute ? indices.find(*probe.substitute) : indices.end();
        if (found == indices.end() || volume.probes[found->second].state == ProbeState::dropped)
            return ProbeCell::kNoProbe;
        return found->second;
    };
    std::vector<ProbeCell> cells;
    for (uint32_t level = 0; level < volume.strides.size(); ++level) {
        const int stride = static_cast<int>(volume.strides[level]);
        const float reach_m = kMostOffset * volume.spacing_m * static_cast<float>(stride);
        for (const auto& [at, first] : indices) {
            if (at.x % stride != 0 || at.y % stride != 0 || at.z % stride != 0) continue;
            ProbeCell cell{at, level, {}};
            bool complete = true;
            for (int corner = 0; corner < 8 && complete; ++corner) {
                const auto found = indices.find(corner_of({at, stride}, corner));
                complete = found != indices.end();
                if (!complete) break;
                cell.corners[static_cast<size_t>(corner)] = probe_for(found->second, reach_m);
            }
            if (complete) cells.push_back(cell);
        }
    }
    return cells;
}

ProbeMemory memory_of(const Probes& probes) {
    // Bytes for one texel of the images that show what a probe sees: albedo and metalness (4), normal (4),
    // distance with the side of the surface (4), emission (8).
    constexpr uint64_t kSeenTexelBytes = 20;
    // Bytes for one texel of the light that a reflection probe shows (four half floats). Its mips add a
    // third.
    constexpr uint64_t kLightTexelBytes = 8;
    constexpr uint64_t kFaces = 6;
    constexpr uint64_t kProbeSide_px = 32;
    constexpr uint64_t kReflectionSide_px = 128;
    // Bytes for an octahedral map of 32 × 32 texels with a border of one texel. Each texel has, in four half
    // floats, the plane of the surface that the probe sees there, and the deviation of the surface from this
    // plane.
    constexpr uint64_t kMomentBytes = 34ull * 34 * 8;
    // Bytes for nine coefficients of spherical harmonics, each with three colours in four floats. A probe has
    // 16 such elements, but the last seven are not used; see kProbeShStride.
    constexpr uint64_t kHarmonicsBytes = 16ull * 16;
    const uint64_t count = probes.volume.probes.size() - count_of(probes.volume, ProbeState::dropped);
    const uint64_t seen = kFaces * kProbeSide_px * kProbeSide_px * kSeenTexelBytes;
    const uint64_t texels = kFaces * kReflectionSide_px * kReflectionSide_px;
    return {count * (seen + kMomentBytes + kHarmonicsBytes),
            probes.reflections.size() * (texels * kSeenTexelBytes + texels * kLightTexelBytes * 4 / 3)};
}

}  // namespace weft::scene
