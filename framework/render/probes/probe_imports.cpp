#include "render/probes/probe_imports.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "render/imports/scene_buffers.h"
#include "render/views/frame_views.h"
#include "render/views/view_matrices.h"
#include "weft/render/import_catalog.h"

namespace weft::render {
namespace {

// Numbers of probes and of cells in a catalogue without a scene.
constexpr uint32_t kAssumedProbes = 1;
constexpr size_t kAssumedCells = 1;

}  // namespace

void add_probe_imports(ImportCatalog& catalog, const scene::Probes* probes) {
    const uint32_t count = probes != nullptr ? count_probes(probes->volume) : kAssumedProbes;
    const auto reflections =
        probes != nullptr ? static_cast<uint32_t>(probes->reflections.size()) : kAssumedProbes;
    const size_t slots =
        probes != nullptr ? probe_tables(probes->volume).cells.size() : slots_for(kAssumedCells);
    const auto add = [&](const char* name, const char* element, size_t elements, size_t stride_bytes) {
        catalog.imports.emplace(name, scene_buffer(name, elements, stride_bytes));
        catalog.strides.emplace(element, static_cast<uint32_t>(stride_bytes));
    };
    const auto add_faces = [&](const char* name, uint32_t views) {
        ImportDecl faces = view_list(name, views);
        faces.assumes_views = probes == nullptr;
        catalog.imports.emplace(name, std::move(faces));
    };
    add("probePoints", "ProbePoint", count, sizeof(shared::ProbePoint));
    add("probeCells", "ProbeCell", slots, sizeof(shared::ProbeCell));
    add("probeGrid", "ProbeGrid", 1, sizeof(shared::ProbeGrid));
    add("reflectionPoints", "ProbePoint", reflections, sizeof(shared::ProbePoint));
    add("reflectionBoxes", "ReflectionBox", reflections, sizeof(shared::ReflectionBox));
    add_faces(kProbeFaceViews, count * kCubeFaces);
    add_faces(kReflectionFaceViews, reflections * kCubeFaces);
    catalog.numbers.emplace("irradianceProbes", count);
    catalog.numbers.emplace("reflectionProbes", reflections);
    catalog.numbers.emplace("probeCellSlots", static_cast<double>(slots));
}

bool is_probe_import(std::string_view name) {
    return name == kProbeFaceViews || name == kReflectionFaceViews || name == kProbeTurns ||
           name == kReflectionTurns || std::ranges::find(kProbeBuffers, name) != kProbeBuffers.end();
}

Result<GpuProbes> GpuProbes::create(vk::Device& device, const scene::Probes& scene) {
    GpuProbes probes;
    ProbeTables tables = probe_tables(scene.volume);
    ReflectionTables reflections = reflection_tables(scene.reflections);
    probes.points_ = tables.points;
    probes.faces_ = probe_face_views(tables.points);
    probes.reflection_points_ = reflections.points;
    probes.reflection_faces_ = probe_face_views(reflections.points);
    // Vulkan has no empty buffers, so an empty list gets one unused element.
    if (tables.points.empty()) tables.points.emplace_back();
    if (reflections.points.empty()) {
        reflections.points.emplace_back();
        reflections.boxes.emplace_back();
    }
    const auto add = [&](const char* name, std::span<const std::byte> bytes) -> Status {
        Result<vk::Buffer> buffer = make_scene_buffer(device, bytes, name);
        if (!buffer) return buffer.take_errors();
        probes.buffers_.emplace(name, std::move(*buffer));
        return Unit{};
    };
    if (Status s = add("probePoints", std::as_bytes(std::span(tables.points))); !s) return s.take_errors();
    if (Status s = add("probeCells", std::as_bytes(std::span(tables.cells))); !s) return s.take_errors();
    if (Status s = add("probeGrid", std::as_bytes(std::span(&tables.grid, 1))); !s) return s.take_errors();
    if (Status s = add("reflectionPoints", std::as_bytes(std::span(reflections.points))); !s)
        return s.take_errors();
    if (Status s = add("reflectionBoxes", std::as_bytes(std::span(reflections.boxes))); !s)
        return s.take_errors();
    return probes;
}

void GpuProbes::bind(vk::ImportBindings& to) const {
    for (const auto& [name, buffer] : buffers_) to.buffers.emplace(name, buffer.handle());
}

void GpuProbes::add_versions(std::map<std::string, uint64_t, std::less<>>& to) {
    for (const char* name : kProbeBuffers) to.emplace(name, 0);
}

}  // namespace weft::render
