// Provides the shaders and imports that random texts use, and converts a text to a resolved graph.
#include "graph/parse/parse.h"
#include "graph/resolve/resolve.h"
#include "graph/syntax/merge.h"
#include "graph/syntax/read_graph.h"
#include "tests/graph/samples/fake_shaders.h"
#include "tests/graph/samples/random_text.h"

namespace weft::test {
namespace {

constexpr uint32_t kViewBytes = 512;

ShaderProgram seeded(ShaderProgram p) {
    return with_params(std::move(p), {member("seed")});
}

ShaderProgram with_switches(ShaderProgram p, bool c) {
    if (c)
        return with_constants(std::move(p), {{"HAS_b", ScalarType::boolean}, {"HAS_c", ScalarType::boolean}});
    return with_constants(std::move(p), {{"HAS_b", ScalarType::boolean}});
}

ShaderBinding foreign_set(uint32_t set) {
    ShaderBinding binding = buffer("instances", true, false);
    binding.set = set;
    return binding;
}

// Returns an array for a table of three textures: without a size if the device has tables.
ShaderBinding table(const DeviceProfile& profile) {
    ShaderBinding binding = sampled("pictures");
    binding.is_array = true;
    binding.is_runtime_array = profile.texture_table > 0;
    binding.count = binding.is_runtime_array ? 1 : 4;
    return binding;
}

ShaderBinding array_of(ShaderBinding binding) {
    binding.is_array = true;
    binding.count = 4;
    return binding;
}

// The constants of the view, which the vertex stage reads.
ShaderBinding view_block() {
    ShaderBinding binding = buffer("ViewBlock", true, false);
    binding.kind = BindingKind::uniform_buffer;
    binding.set = 0;
    binding.binding = kViewBinding;
    binding.stages = stage_bit(ShaderStage::vertex);
    binding.block_bytes = kViewBytes;
    return binding;
}

ShaderCatalog make_shaders(const DeviceProfile& profile) {
    const ShaderBinding a = sampled("a"), b = sampled("b"), c = sampled("c");
    const ShaderBinding dst = image_out("dst", Format::undefined);
    const ShaderBinding words_in = buffer("a", true, false), words_out = buffer("dst", false, true);
    ShaderCatalog shaders;
    shaders["fill.comp"] = seeded(compute({dst}));
    shaders["mix_1.comp"] = seeded(compute({a, dst}));
    shaders["mix_2.comp"] = with_switches(seeded(compute({a, b, dst})), false);
    shaders["mix_3.comp"] = with_switches(seeded(compute({a, b, c, dst})), true);
    shaders["remember.comp"] =
        with_params(compute({a, b, dst}), {member("seed"), member("bValid", 1, ScalarType::boolean)});
    for (const Format format : {Format::rgba16f, Format::rgba8, Format::r32f})
        shaders["update_" + std::string(format_info(format).name) + ".comp"] =
            seeded(compute({a, image_in_out("x", format)}));
    shaders["look_up.comp"] = seeded(compute({a, table(profile), dst}));
    shaders["look_up.comp"].interface.needs_texture_tables = profile.texture_table > 0;
    shaders["draw_1.frag"] = seeded(fragment({"color"}, {a}));
    shaders["draw_2.frag"] = with_switches(seeded(fragment({"color"}, {a, b})), false);
    shaders["gather.comp"] = seeded(compute({array_of(a), dst}));
    shaders["spread.comp"] = seeded(compute({a, array_of(dst)}));
    shaders["scene"] = fragment({"color"});
    shaders["seen"] = fragment({"color"});
    shaders["seen"].interface.bindings.push_back(view_block());
    shaders["points"] = fragment({"color"});
    shaders["points"].interface.writes_point_size = true;
    shaders["sky_1.frag"] = seeded(fragment({"color"}));
    shaders["sky_2.frag"] = seeded(fragment({"color"}, {sampled("depth")}));
    shaders["pack.comp"] = seeded(compute({a, words_out}));
    shaders["unpack.comp"] = seeded(compute({words_in, dst}));
    shaders["words.comp"] = seeded(compute({words_in, words_out}));
    shaders["words_2.comp"] = seeded(compute({words_in, buffer("b", true, false), words_out}));
    shaders["slice_words.comp"] = seeded(compute({buffer("x", true, true)}));
    shaders["foreign.comp"] = seeded(compute({dst, foreign_set(3)}));
    return shaders;
}

ImportCatalog make_imports() {
    ImportCatalog catalog;
    catalog.views = {"camera", "sun"};
    catalog.imports["sun"] = {.name = "sun", .kind = ImportKind::views, .views = 4};
    catalog.imports["lamps"] = {.name = "lamps", .kind = ImportKind::views, .views = 3};
    catalog.strides = {{"ViewConstants", kViewBytes}, {"DrawCommand", 20}, {"DrawVerticesCommand", 16}};
    const auto add = [&](const char* name, ImportKind kind) -> ImportDecl& {
        ImportDecl& import = catalog.imports[name];
        import.name = import.resource.name = name;
        import.kind = kind;
        import.resource.lifetime = ResourceLifetime::imported;
        import.resource.import = ImportState{};
        return import;
    };
    add("opaque", ImportKind::draw_list).draws = 5;
    add("backbuffer", ImportKind::output).resource.format = Format::rgba8;
    ImportDecl& noise = add("noise", ImportKind::image);
    noise.resource.format = Format::rgba8;
    noise.resource.extent = {64, 64, 1};
    noise.resource.import->entry =
        noise.resource.import->exit = {stage::kComputeShader, access::kSampledRead, Layout::shader_read_only};
    noise.resource.import->concurrent = true;
    catalog.imports["pictures"] = texture_table("pictures", 3);
    ImportDecl& instances = add("instances", ImportKind::buffer);
    instances.resource.kind = ResourceKind::buffer;
    instances.resource.size_bytes = 6400;
    return catalog;
}

// Describes the files of the resources as load_graph() does: a picture of 16 x 16 pixels, and 256 words.
void find_files(GraphDesc& graph) {
    for (auto& [name, resource] : graph.resources) {
        FileDesc& file = resource.file;
        if (file.name.empty()) continue;
        file.path = "/files/" + file.name;
        file.size_bytes = 1024;
        if (file.name.ends_with(".png")) file.width_px = file.height_px = 16;
    }
}

Result<ResolvedGraph> resolve_document(Result<JsonDoc> document, const std::map<std::string, double>& params,
                                       const DeviceProfile& profile, uint32_t output_px,
                                       const std::map<std::string, ExportUse>& exports) {
    if (!document) return document.take_errors();
    Result<JsonDoc> merged = merge(std::move(document).value());
    if (!merged) return merged.take_errors();
    Result<GraphDesc> graph = parse(*merged);
    if (!graph) return graph.take_errors();
    find_files(*graph);
    const ShaderCatalog shaders = make_shaders(profile);
    const ImportCatalog imports = make_imports();
    const PassCatalog passes;
    Diagnostics warnings;
    return resolve({.graph = *graph,
                    .passes = passes,
                    .shaders = shaders,
                    .imports = imports,
                    .profile = profile,
                    .request = {.params = params, .size = {output_px, output_px, 1}, .exports = exports}},
                   warnings);
}

}  // namespace

Result<ResolvedGraph> resolve_text(const std::string& text, const std::map<std::string, double>& params,
                                   const DeviceProfile& profile, uint32_t output_px,
                                   const std::map<std::string, ExportUse>& exports) {
    const FileReader reader = [&](const std::string&) { return std::optional<std::string>(text); };
    return resolve_document(read_json("random.json", reader), params, profile, output_px, exports);
}

Result<ResolvedGraph> resolve_as_module(const std::string& text, const std::map<std::string, double>& params,
                                        const DeviceProfile& profile) {
    const FileReader reader = [&](const std::string& path) -> std::optional<std::string> {
        if (path == "module.json") return text;
        if (path != "random.json") return std::nullopt;
        return R"({"version": 1, "include": [{"file": "module.json", "as": "m"}], "passes": {}})";
    };
    std::map<std::string, double> full;
    for (const auto& [name, value] : params) full["m::" + name] = value;
    constexpr uint32_t kOutput_px = 64;
    return resolve_document(read_graph("random.json", reader), full, profile, kOutput_px, {});
}

}  // namespace weft::test
