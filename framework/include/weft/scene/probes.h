// Purpose: light probes as plain data. An irradiance probe gives the diffuse light of a place, a reflection
// probe gives the specular light. The irradiance probes are points of a grid with several levels. Units:
// metres, world space.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string>
#include <vector>

namespace weft::scene {

inline constexpr uint32_t kMostIrradianceProbes = 255;
inline constexpr uint32_t kMostReflectionProbes = 24;
// The largest number of grid points that a volume lists. Dropped grid points count, too.
inline constexpr uint32_t kMostGridPoints = 16'384;
// The largest distance between a probe and its grid point, divided by the grid spacing of the cell's level. A
// probe that is farther away does not belong to this cell.
inline constexpr float kMostOffset = 0.45f;

// kept: the probe is at its grid point. moved: the grid point is inside of an object or at a surface, and
// the probe is near by. dropped: there is no probe at this grid point.
enum class ProbeState : uint8_t { kept, moved, dropped };

// A point of the grid of a volume.
struct Probe {
    glm::ivec3 at{0};    // Grid point, in units of ProbeVolume::spacing_m.
    uint32_t level = 0;  // The coarsest level that has this grid point.
    glm::vec3 offset{0};
    ProbeState state = ProbeState::kept;
    // For a dropped grid point: another grid point, whose probe gives the light here instead. If a corner of
    // a cell is at the dropped grid point, cells_of() returns the probe of the other grid point for this
    // corner.
    std::optional<glm::ivec3> substitute = {};
};

// A cube of the grid whose eight corners are listed in ProbeVolume::probes.
struct ProbeCell {
    static constexpr uint32_t kNoProbe = UINT32_MAX;

    glm::ivec3 at{0};    // The corner with the smallest coordinates, in units of ProbeVolume::spacing_m.
    uint32_t level = 0;  // An index into ProbeVolume::strides.
    // Indices into ProbeVolume::probes. Bit 0 of the index of a corner: +x, bit 1: +y, bit 2: +z. kNoProbe:
    // the probe was dropped without a substitute, or is farther than kMostOffset from its grid point.
    std::array<uint32_t, 8> corners{};
};

// Irradiance probes. Point `at` of the grid is at origin + R × at × spacing_m, where R is the rotation by
// yaw_deg. Level i uses the points whose coordinates are multiples of strides[i]. Level 0 is the finest.
struct ProbeVolume {
    glm::vec3 origin{0};
    float spacing_m = 1;
    std::vector<uint32_t> strides{1};
    std::vector<Probe> probes;   // Sorted by z, then y, then x of `at`.
    bool around_camera = false;  // True: the scene is large, so the levels surround a camera.
    // The angle by which the grid, and the offsets of the probes, are turned around +y, counter-clockwise as
    // seen from above. In degrees, −180 to 180.
    float yaw_deg = 0;
};

// Returns the rotation by an angle around +y.
[[nodiscard]] glm::mat3 yaw_rotation(float yaw_deg);
[[nodiscard]] glm::vec3 position_of(const ProbeVolume& volume, const Probe& probe);
// Returns the number of probes in this state.
[[nodiscard]] uint32_t count_of(const ProbeVolume& volume, ProbeState state);
// Returns all cells of all levels, the fine levels first. The cells of each level are sorted by z, y and x.
[[nodiscard]] std::vector<ProbeCell> cells_of(const ProbeVolume& volume);

struct ProbeBox {
    glm::vec3 center{0};
    glm::vec3 half_size_m{1};
    glm::quat rotation{1, 0, 0, 0};
};

struct ReflectionProbe {
    std::string name;
    glm::vec3 position{0};
    // The part of the scene in which surfaces use the probe. Without a box, all surfaces that the probe sees
    // use it.
    std::optional<ProbeBox> box;
};

struct Probes {
    ProbeVolume volume;
    std::vector<ReflectionProbe> reflections;
};

// Memory on the GPU for what the probes see and for the light that is computed from it, in bytes.
struct ProbeMemory {
    uint64_t volume_bytes = 0;
    uint64_t reflection_bytes = 0;
};
[[nodiscard]] ProbeMemory memory_of(const Probes& probes);

}  // namespace weft::scene
