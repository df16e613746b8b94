// Purpose: reads the keys of the animations of a glTF. Errors: S115 times or values that are not finite, and
// times that do not ascend; S107 too much memory. Warnings: S152 a rotation of length 0.
#pragma once

#include <span>

#include "scene/gltf/gltf_document.h"
#include "scene/gltf/gltf_fields.h"
#include "scene/loading/gltf_report.h"
#include "scene/loading/memory_budget.h"

namespace weft::scene::gltf {

// Returns for each node of the document whether a channel of an animation moves it.
[[nodiscard]] std::vector<bool> animated_nodes(const Document& document);

// Fills Motion::animations. `moving` has one entry for each node of the document: the index of the node in
// Motion::nodes, or kNone if the shown scene does not contain the node. Channels of nodes with kNone are left
// out.
void build_animations(const Document& document, std::span<const uint32_t> moving, MemoryBudget& memory,
                      Report& report, Motion& motion);

}  // namespace weft::scene::gltf
