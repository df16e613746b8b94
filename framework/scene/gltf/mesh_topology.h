// Purpose: converts the corners of a glTF list, strip or fan to triangles of three corners each. Source: glTF
// 2.0, 3.7.2.1 "Overview": winding alternates along a strip; here all triangles get the same winding.
#pragma once

#include <cstdint>
#include <vector>

namespace weft::scene::gltf {

[[nodiscard]] bool has_triangles(uint32_t mode);
// Corners of an incomplete last triangle are ignored.
[[nodiscard]] uint64_t triangle_count(uint32_t mode, uint64_t corners);
// Triangles of a strip or fan that use one corner twice only connect other triangles and are omitted.
[[nodiscard]] std::vector<uint32_t> triangle_list(uint32_t mode, std::vector<uint32_t> corners);

}  // namespace weft::scene::gltf
