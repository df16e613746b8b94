// Purpose: the triangles of a glTF primitive, three corners each, from the corners of a list, a strip or a
// fan. Source: glTF 2.0, 3.7.2.1 "Overview": winding alternates along a strip and is turned back here.
#pragma once

#include <cstdint>
#include <vector>

namespace weft::scene::gltf {

[[nodiscard]] bool has_triangles(uint32_t mode);
// Without the corners of a last, unfinished one.
[[nodiscard]] uint64_t triangle_count(uint32_t mode, uint64_t corners);
// Triangles of a strip or fan that use one corner twice only join others, and are left out.
[[nodiscard]] std::vector<uint32_t> triangle_list(uint32_t mode, std::vector<uint32_t> corners);

}  // namespace weft::scene::gltf
