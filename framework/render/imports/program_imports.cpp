#include "render/imports/program_imports.h"

#include <algorithm>

#include "graph/diagnostics/make_error.h"
#include "render/imports/vertex_format_faults.h"
#include "weft/render/import_catalog.h"

namespace weft::render {
namespace {

// Sets 2 (material) and 3 (draw) belong to the draws. Sets 0 and 1 belong to Weft.
constexpr uint32_t kFirstDrawSet = 2, kLastDrawSet = 3;

Diagnostic taken(const std::string& name, const char* member) {
    return make_error("W245",
                      std::string("SessionInput::") + member + " contains \"" + name +
                          "\", but there is already another import of this name",
                      {"choose another name, and use it in \"imports\" of the graph"});
}

}  // namespace

Diagnostics program_import_faults(const vk::Device& device, const SessionInput& input,
                                  const scene::Scene& scene) {
    const ImportCatalog offered = scene_imports(input.request.size, &scene, &input.probes);
    const auto is_taken = [&](const std::string& name) {
        return offered.imports.contains(name) || input.views.contains(name) || input.textures.contains(name);
    };
    Diagnostics faults;
    for (const auto& [name, unused] : input.imports)
        if (is_taken(name)) faults.push_back(taken(name, "imports"));
    for (const auto& [name, own] : input.draw_lists) {
        const bool replaces =
            scene.instances.empty() && std::ranges::find(kDrawLists, name) != kDrawLists.end();
        if ((is_taken(name) && !replaces) || input.imports.contains(name))
            faults.push_back(taken(name, "draw_lists"));
        for (Diagnostic& wrong : vertex_format_faults(device, name, own.vertex_format))
            faults.push_back(std::move(wrong));
        if (own.list == nullptr)
            faults.push_back(make_error("W245", "the draw list \"" + name + "\" has no DrawList",
                                        {"set OwnDrawList::list to an object that outlives the session"}));
    }
    for (const auto& [set, unused] : input.draw_sets)
        if (set < kFirstDrawSet || set > kLastDrawSet || !scene.instances.empty())
            faults.push_back(
                make_error("W246",
                           "SessionInput::draw_sets replaces set " + std::to_string(set) +
                               (scene.instances.empty() ? ", which belongs to Weft"
                                                        : ", but the scene has instances, which need it"),
                           {"replace only the sets 2 and 3, and only for a scene without instances"}));
    return faults;
}

void add_program_imports(const SessionInput& input, ImportCatalog& catalog) {
    for (const auto& [name, own] : input.imports) {
        ImportDecl decl = own.decl;
        decl.name = decl.resource.name = name;
        // After a frame, the program can read an import that passes write. So these passes must run, even if
        // no other pass reads the import.
        decl.observed = !decl.read_only;
        catalog.imports.insert_or_assign(name, decl);
    }
    uint32_t draw_sets = 0;
    for (const auto& [set, unused] : input.draw_sets) draw_sets |= 1u << set;
    for (const auto& [name, own] : input.draw_lists) {
        ImportDecl list;
        list.name = name;
        list.kind = ImportKind::draw_list;
        list.variants = own.variants;
        list.vertex_format = own.vertex_format;
        list.draws = static_cast<uint32_t>(std::max<uint64_t>(1, own.list->count()));
        list.draw_sets = draw_sets;
        catalog.imports.insert_or_assign(name, list);
    }
    for (const auto& [set, own] : input.draw_sets) {
        std::erase_if(catalog.bindings, [&](const OfferedBinding& offered) { return offered.set == set; });
        catalog.bindings.insert(catalog.bindings.end(), own.bindings.begin(), own.bindings.end());
    }
}

}  // namespace weft::render
