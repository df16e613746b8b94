// Purpose: adds boxes, spheres, tori and cards to a MeshBuilder, and makes the finished mesh.
#include <array>
#include <cmath>
#include <utility>

#include "scene/model/mesh_attributes.h"
#include "scene/procedural/procedural_mesh.h"

namespace weft::scene {
namespace {

// The edges of a box face that point right and up, seen from outside the box.
struct FaceAxes {
    glm::vec3 right;
    glm::vec3 up;
};
constexpr std::array<FaceAxes, 6> kBoxFaces{{{{1, 0, 0}, {0, 1, 0}},
                                             {{-1, 0, 0}, {0, 1, 0}},
                                             {{0, 0, -1}, {0, 1, 0}},
                                             {{0, 0, 1}, {0, 1, 0}},
                                             {{1, 0, 0}, {0, 0, -1}},
                                             {{1, 0, 0}, {0, 0, 1}}}};

}  // namespace

void MeshBuilder::add_box_face(glm::vec3 center, glm::vec3 right, glm::vec3 up) {
    add_rectangle(center - right - up, right * 2.0f, up * 2.0f);
}

void MeshBuilder::add_box_bevel(const BoxExtent& box, glm::vec3 a, glm::vec3 b) {
    const glm::vec3 axis = glm::cross(a, b);
    const glm::vec3 along = axis * box.inner;
    const glm::vec3 edge_a = box.center + a * box.half + b * box.inner;
    const glm::vec3 edge_b = box.center + a * box.inner + b * box.half;
    const float u = glm::dot(box.center, axis);
    const float length = glm::length(along);
    const float width = glm::length(edge_b - edge_a);
    const uint32_t v0 = add_vertex(edge_a - along, a, {u - length, 0});
    const uint32_t v1 = add_vertex(edge_b - along, b, {u - length, width});
    const uint32_t v2 = add_vertex(edge_b + along, b, {u + length, width});
    const uint32_t v3 = add_vertex(edge_a + along, a, {u + length, 0});
    add_triangle(v0, v1, v2);
    add_triangle(v0, v2, v3);
}

void MeshBuilder::add_box(glm::vec3 low, glm::vec3 high) {
    add_bevelled_box(low, high, 0);
}

void MeshBuilder::add_bevelled_box(glm::vec3 low, glm::vec3 high, float bevel_m) {
    const glm::vec3 center = 0.5f * (low + high);
    const glm::vec3 half = 0.5f * (high - low);
    const glm::vec3 inner = half - glm::vec3(bevel_m);
    for (const FaceAxes& face : kBoxFaces) {
        const glm::vec3 normal = glm::cross(face.right, face.up);
        add_box_face(center + normal * half, face.right * inner, face.up * inner);
    }
    if (bevel_m <= 0) return;
    // The vertices of a bevel get the normals of the two adjacent faces, so that the bevel is shaded like a
    // round edge.
    for (uint32_t edge = 0; edge < 12; ++edge) {
        const uint32_t first = edge / 4;
        glm::vec3 a{0};
        glm::vec3 b{0};
        a[static_cast<int>(first)] = edge & 1U ? 1.0f : -1.0f;
        b[static_cast<int>((first + 1) % 3)] = edge & 2U ? 1.0f : -1.0f;
        add_box_bevel({center, half, inner}, a, b);
    }
    for (uint32_t corner = 0; corner < 8; ++corner) {
        const glm::vec3 sign{corner & 1U ? 1 : -1, corner & 2U ? 1 : -1, corner & 4U ? 1 : -1};
        const glm::vec3 tip = center + sign * inner;
        const uint32_t x = add_vertex(tip + glm::vec3(sign.x * bevel_m, 0, 0), {sign.x, 0, 0}, {0, 0});
        const uint32_t y = add_vertex(tip + glm::vec3(0, sign.y * bevel_m, 0), {0, sign.y, 0}, {bevel_m, 0});
        const uint32_t z = add_vertex(tip + glm::vec3(0, 0, sign.z * bevel_m), {0, 0, sign.z}, {0, bevel_m});
        if (sign.x * sign.y * sign.z > 0) {
            add_triangle(x, y, z);
        } else {
            add_triangle(x, z, y);
        }
    }
}

void MeshBuilder::add_sphere(glm::vec3 center, float radius_m, uint32_t segments, uint32_t rings) {
    Profile profile;
    for (uint32_t i = 0; i <= rings; ++i) {
        const float angle = 3.14159265f * (static_cast<float>(i) / static_cast<float>(rings) - 0.5f);
        const bool pole = i == 0 || i == rings;
        profile.push_back({pole ? 0.0f : radius_m * std::cos(angle), radius_m * std::sin(angle)});
    }
    const glm::mat4 outer = transform_;
    transform_[3] = outer * glm::vec4(center, 1);
    LatheShape shape;
    shape.segments = segments;
    add_lathe(profile, shape);
    transform_ = outer;
}

void MeshBuilder::add_torus(float radius_m, float tube_m, uint32_t segments, uint32_t tube_segments) {
    Profile profile;
    for (uint32_t i = 0; i <= tube_segments; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(tube_segments);
        profile.push_back({radius_m + tube_m * std::cos(angle), tube_m * std::sin(angle)});
    }
    std::vector<glm::vec2> normals;
    for (const glm::vec2& p : profile) normals.push_back((p - glm::vec2(radius_m, 0)) / tube_m);
    LatheShape shape;
    shape.segments = segments;
    add_lathe_run(profile, normals, 0, shape, std::max(1.0f, std::round(6.2831853f * radius_m)));
}

void MeshBuilder::add_card(const Card& card) {
    const glm::vec3 flat = glm::normalize(glm::cross(card.right, card.up));
    std::array<uint32_t, 4> corners{};
    for (uint32_t i = 0; i < 4; ++i) {
        const float x = i == 1 || i == 2 ? 1.0f : -1.0f;
        const float y = i >= 2 ? 1.0f : -1.0f;
        const glm::vec3 position = card.center + card.right * x + card.up * y;
        glm::vec3 normal = flat;
        if (card.soft_normals) {
            // The normal mostly points away from `normal_center`, for example the middle of a plant. So all
            // cards of a crown together are shaded like one round body. The normal must stay on the front
            // side of the card.
            const glm::vec3 away = glm::normalize(position - card.normal_center);
            normal = glm::normalize(flat * 0.6f + away);
            if (glm::dot(normal, flat) < 0.15f)
                normal = glm::normalize(normal + flat * (0.3f - glm::dot(normal, flat)));
        }
        const glm::vec2 uv{x > 0 ? card.uv_max.x : card.uv_min.x, y > 0 ? card.uv_min.y : card.uv_max.y};
        corners[i] = add_vertex(position, normal, uv);
    }
    add_triangle(corners[0], corners[1], corners[2]);
    add_triangle(corners[0], corners[2], corners[3]);
}

Mesh MeshBuilder::finish(std::string name) {
    generate_tangents(mesh_);
    compute_bounds(mesh_);
    mesh_.name = std::move(name);
    return std::exchange(mesh_, Mesh{});
}

}  // namespace weft::scene
