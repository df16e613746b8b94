#include "scene/procedural/procedural_mesh.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace weft::scene {
namespace {

// Cosine of the largest angle (about 35°) between two profile segments that are shaded as one smooth surface.
constexpr float kCreaseCosine = 0.82f;

// A part of a profile (the outline of a shape) without sharp corners, with one normal per point.
struct ProfileRun {
    Profile points;
    std::vector<glm::vec2> normals;
    float start_m = 0;  // Distance along the profile from its first point to this part.
};

glm::vec2 segment_normal(glm::vec2 from, glm::vec2 to) {
    const glm::vec2 along = glm::normalize(to - from);
    return {along.y, -along.x};
}

void finish_run(ProfileRun& run) {
    const size_t count = run.points.size();
    run.normals.resize(count);
    for (size_t i = 0; i < count; ++i) {
        glm::vec2 sum{0};
        if (i > 0) sum += segment_normal(run.points[i - 1], run.points[i]);
        if (i + 1 < count) sum += segment_normal(run.points[i], run.points[i + 1]);
        run.normals[i] = glm::normalize(sum);
    }
}

std::vector<ProfileRun> split_at_corners(const Profile& profile) {
    std::vector<ProfileRun> runs;
    float length = 0;
    ProfileRun run{{profile.front()}, {}, 0};
    for (size_t i = 1; i < profile.size(); ++i) {
        run.points.push_back(profile[i]);
        length += glm::length(profile[i] - profile[i - 1]);
        const bool last = i + 1 == profile.size();
        const bool corner = !last && glm::dot(segment_normal(profile[i - 1], profile[i]),
                                              segment_normal(profile[i], profile[i + 1])) < kCreaseCosine;
        if (last || corner) {
            finish_run(run);
            runs.push_back(std::move(run));
            run = ProfileRun{{profile[i]}, {}, length};
        }
    }
    return runs;
}

float mean_radius(const Profile& profile) {
    float sum = 0;
    float length = 0;
    for (size_t i = 1; i < profile.size(); ++i) {
        const float piece = glm::length(profile[i] - profile[i - 1]);
        sum += piece * 0.5f * (profile[i].x + profile[i - 1].x);
        length += piece;
    }
    return length > 0 ? sum / length : 0.0f;
}

glm::vec3 any_perpendicular(glm::vec3 direction) {
    const glm::vec3 axis = std::abs(direction.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    return glm::normalize(glm::cross(axis, direction));
}

// Returns the vector from a corner of the path to a profile point whose outward offset is 1. `before` and
// `after` are the directions of the two path segments. At a bend the vector is longer than 1, so that the
// surfaces of both segments meet at the corner.
glm::vec3 mitre(glm::vec3 before, glm::vec3 after) {
    const glm::vec3 up{0, 1, 0};
    const glm::vec3 a = glm::cross(before, up);
    const glm::vec3 b = glm::cross(after, up);
    const glm::vec3 sum = glm::normalize(a + b);
    return sum / std::max(0.2f, glm::dot(sum, a));
}

}  // namespace

uint32_t MeshBuilder::add_vertex(glm::vec3 position, glm::vec3 normal, glm::vec2 uv) {
    mesh_.positions.push_back(glm::vec3(transform_ * glm::vec4(position, 1)));
    mesh_.normals.push_back(glm::normalize(glm::mat3(transform_) * normal));
    mesh_.uvs.push_back(uv + uv_offset_);
    return static_cast<uint32_t>(mesh_.positions.size() - 1);
}

void MeshBuilder::add_triangle(uint32_t a, uint32_t b, uint32_t c) {
    const glm::vec3 p = mesh_.positions[a];
    const glm::vec3 area = glm::cross(mesh_.positions[b] - p, mesh_.positions[c] - p);
    // Skips triangles without area. Such triangles occur where a turned shape touches its axis.
    if (glm::dot(area, area) < 1e-16f) return;
    mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
}

void MeshBuilder::add_rectangle(glm::vec3 origin, glm::vec3 right, glm::vec3 up) {
    add_strip({origin, origin + right}, {origin + up, origin + right + up}, right, up);
}

void MeshBuilder::add_strip(const std::vector<glm::vec3>& low, const std::vector<glm::vec3>& high,
                            glm::vec3 right, glm::vec3 up) {
    assert(low.size() == high.size());
    const glm::vec3 u = glm::normalize(right);
    const glm::vec3 v = glm::normalize(up);
    const glm::vec3 normal = glm::cross(u, v);
    const auto vertex = [&](glm::vec3 p) { return add_vertex(p, normal, {glm::dot(p, u), -glm::dot(p, v)}); };
    uint32_t low_before = vertex(low[0]);
    uint32_t high_before = vertex(high[0]);
    for (size_t i = 1; i < low.size(); ++i) {
        const uint32_t low_now = vertex(low[i]);
        const uint32_t high_now = vertex(high[i]);
        add_triangle(low_before, low_now, high_now);
        add_triangle(low_before, high_now, high_before);
        low_before = low_now;
        high_before = high_now;
    }
}

void MeshBuilder::add_grid(uint32_t cols, uint32_t rows,
                           const std::function<GridPoint(uint32_t, uint32_t)>& point) {
    std::vector<GridPoint> points(static_cast<size_t>(cols) * rows);
    for (uint32_t j = 0; j < rows; ++j) {
        for (uint32_t i = 0; i < cols; ++i) points[j * cols + i] = point(i, j);
    }
    const auto position = [&](uint32_t i, uint32_t j) { return points[j * cols + i].position; };
    const auto base = static_cast<uint32_t>(mesh_.positions.size());
    for (uint32_t j = 0; j < rows; ++j) {
        for (uint32_t i = 0; i < cols; ++i) {
            const glm::vec3 across = position(std::min(i + 1, cols - 1), j) - position(i > 0 ? i - 1 : 0, j);
            const glm::vec3 along = position(i, std::min(j + 1, rows - 1)) - position(i, j > 0 ? j - 1 : 0);
            add_vertex(position(i, j), glm::cross(across, along), points[j * cols + i].uv);
        }
    }
    for (uint32_t j = 0; j + 1 < rows; ++j) {
        for (uint32_t i = 0; i + 1 < cols; ++i) {
            const uint32_t a = base + j * cols + i;
            add_triangle(a, a + 1, a + cols + 1);
            add_triangle(a, a + cols + 1, a + cols);
        }
    }
}

void MeshBuilder::add_lathe_run(const Profile& run, const std::vector<glm::vec2>& normals, float v_start,
                                const LatheShape& shape, float u_span_m) {
    const auto base = static_cast<uint32_t>(mesh_.positions.size());
    const uint32_t columns = shape.segments + 1;
    float v = v_start;
    for (size_t j = 0; j < run.size(); ++j) {
        if (j > 0) v += glm::length(run[j] - run[j - 1]);
        for (uint32_t i = 0; i < columns; ++i) {
            const float t = static_cast<float>(i) / static_cast<float>(shape.segments);
            const float angle = shape.from_rad + (shape.to_rad - shape.from_rad) * t;
            const glm::vec3 outward{std::sin(angle), 0, std::cos(angle)};
            add_vertex(outward * run[j].x + glm::vec3(0, run[j].y, 0),
                       outward * normals[j].x + glm::vec3(0, normals[j].y, 0), {t * u_span_m, -v});
        }
    }
    for (uint32_t j = 0; j + 1 < run.size(); ++j) {
        for (uint32_t i = 0; i < shape.segments; ++i) {
            const uint32_t a = base + j * columns + i;
            add_triangle(a, a + 1, a + columns + 1);
            add_triangle(a, a + columns + 1, a + columns);
        }
    }
}

void MeshBuilder::add_lathe(const Profile& profile, const LatheShape& shape) {
    float u_span_m = shape.u_span_m;
    if (u_span_m <= 0) {
        const float length = mean_radius(profile) * (shape.to_rad - shape.from_rad);
        u_span_m = std::max(1.0f, std::round(length / shape.period_m)) * shape.period_m;
    }
    for (const ProfileRun& run : split_at_corners(profile)) {
        add_lathe_run(run.points, run.normals, run.start_m, shape, u_span_m);
    }
}

void MeshBuilder::add_sweep(const Profile& profile, const std::vector<glm::vec3>& path, bool closed) {
    const size_t count = path.size();
    const size_t segments = closed ? count : count - 1;
    const auto direction = [&](size_t i) { return glm::normalize(path[(i + 1) % count] - path[i % count]); };
    const std::vector<ProfileRun> runs = split_at_corners(profile);
    float u = 0;
    for (size_t s = 0; s < segments; ++s) {
        const glm::vec3 here = direction(s);
        const glm::vec3 before = s > 0 || closed ? direction(s + count - 1) : here;
        const glm::vec3 after = s + 1 < segments || closed ? direction(s + 1) : here;
        const std::array<glm::vec3, 2> offsets{mitre(before, here), mitre(here, after)};
        const std::array<glm::vec3, 2> ends{path[s], path[(s + 1) % count]};
        const glm::vec3 outward = glm::cross(here, glm::vec3(0, 1, 0));
        for (const ProfileRun& run : runs) {
            float v = run.start_m;
            for (size_t j = 0; j < run.points.size(); ++j) {
                if (j > 0) v += glm::length(run.points[j] - run.points[j - 1]);
                const glm::vec3 normal = outward * run.normals[j].x + glm::vec3(0, run.normals[j].y, 0);
                for (size_t e = 0; e < 2; ++e) {
                    const glm::vec3 p =
                        ends[e] + offsets[e] * run.points[j].x + glm::vec3(0, run.points[j].y, 0);
                    add_vertex(p, normal, {u + glm::dot(p - ends[0], here), -v});
                }
                if (j == 0) continue;
                const auto top = static_cast<uint32_t>(mesh_.positions.size() - 2);
                add_triangle(top - 2, top - 1, top + 1);
                add_triangle(top - 2, top + 1, top);
            }
        }
        u += glm::length(ends[1] - ends[0]);
    }
}

void MeshBuilder::add_tube(const std::vector<glm::vec3>& path, const TubeShape& shape) {
    const auto rows = static_cast<uint32_t>(path.size());
    std::vector<float> along(path.size(), 0.0f);
    for (size_t i = 1; i < path.size(); ++i) along[i] = along[i - 1] + glm::length(path[i] - path[i - 1]);
    const float circumference = 6.2831853f * 0.5f * (shape.radius_start_m + shape.radius_end_m);
    const auto base = static_cast<uint32_t>(mesh_.positions.size());
    glm::vec3 side = any_perpendicular(glm::normalize(path[1] - path[0]));
    for (uint32_t j = 0; j < rows; ++j) {
        const glm::vec3 direction = glm::normalize(path[std::min(j + 1, rows - 1)] - path[j > 0 ? j - 1 : 0]);
        side = glm::normalize(side - direction * glm::dot(side, direction));
        const glm::vec3 other = glm::cross(direction, side);
        const float t = along[j] / along.back();
        const float radius = shape.radius_start_m + (shape.radius_end_m - shape.radius_start_m) * t;
        for (uint32_t i = 0; i <= shape.segments; ++i) {
            const float turn = static_cast<float>(i) / static_cast<float>(shape.segments);
            const glm::vec3 outward =
                side * std::cos(turn * 6.2831853f) + other * std::sin(turn * 6.2831853f);
            add_vertex(path[j] + outward * radius, outward, {turn * circumference, -along[j]});
        }
    }
    const uint32_t columns = shape.segments + 1;
    for (uint32_t j = 0; j + 1 < rows; ++j) {
        for (uint32_t i = 0; i < shape.segments; ++i) {
            const uint32_t a = base + j * columns + i;
            add_triangle(a, a + 1, a + columns + 1);
            add_triangle(a, a + columns + 1, a + columns);
        }
    }
}

}  // namespace weft::scene
