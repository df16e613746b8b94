// Purpose: the imports of the program that a session offers to graphs, besides those of the scene: its views,
// images, buffers, draw lists and descriptor sets.
#pragma once

#include "weft/render/session.h"
#include "weft/scene/scene.h"

namespace weft::render {

// Returns an error W245 for each import of the program whose name the scene uses, an error W255 for each
// fault of a vertex format, and an error W246 if the program replaces descriptor sets that the objects of the
// scene need. Draw lists of the program may replace those of a scene without instances.
[[nodiscard]] Diagnostics program_import_faults(const vk::Device& device, const SessionInput& input,
                                                const scene::Scene& scene);
// Adds the imports of the program to those of the scene.
void add_program_imports(const SessionInput& input, ImportCatalog& catalog);

}  // namespace weft::render
