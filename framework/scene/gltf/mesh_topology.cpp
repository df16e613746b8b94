#include "scene/gltf/mesh_topology.h"

#include "scene/gltf/gltf_document.h"

namespace weft::scene::gltf {

bool has_triangles(uint32_t mode) {
    return mode == kTriangles || mode == kTriangleStrip || mode == kTriangleFan;
}

uint64_t triangle_count(uint32_t mode, uint64_t corners) {
    if (mode == kTriangles) return corners / 3;
    return corners < 3 ? 0 : corners - 2;
}

std::vector<uint32_t> triangle_list(uint32_t mode, std::vector<uint32_t> corners) {
    if (mode == kTriangles) {
        corners.resize(corners.size() / 3 * 3);
        return corners;
    }
    std::vector<uint32_t> list;
    const uint64_t count = triangle_count(mode, corners.size());
    list.reserve(count * 3);
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
        if (a == b || b == c || c == a) return;
        list.insert(list.end(), {a, b, c});
    };
    for (uint64_t i = 0; i < count; ++i) {
        if (mode == kTriangleStrip) {
            add(corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]);
        } else {
            add(corners[i + 1], corners[i + 2], corners[0]);
        }
    }
    return list;
}

}  // namespace weft::scene::gltf
