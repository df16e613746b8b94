// Purpose: converts the corners of a glTF triangle list, strip or fan to triangles of three corners each. In
// a strip, every second triangle has the opposite winding; the conversion gives all triangles the same
// winding. Source: glTF 2.0, 3.7.2.1 "Overview".
#pragma once

#include <cstdint>
#include <vector>

namespace weft::scene::gltf {

[[nodiscard]] bool has_triangles(uint32_t mode);
// Returns the number of triangles for this number of corners. Corners of an incomplete last triangle are
// ignored.
[[nodiscard]] uint64_t triangle_count(uint32_t mode, uint64_t corners);
// Returns three corners for each triangle. Triangles of a strip or fan that use one corner twice are omitted:
// they have no area and only connect other triangles.
[[nodiscard]] std::vector<uint32_t> triangle_list(uint32_t mode, std::vector<uint32_t> corners);

}  // namespace weft::scene::gltf
