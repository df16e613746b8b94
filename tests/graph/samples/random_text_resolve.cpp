// Provides the shaders and imports that random texts use, and converts a text to a resolved graph.
#include "graph/parse/parse.h"
#include "graph/resolve/resolve.h"
#include "graph/syntax/merge.h"
#include "tests/graph/samples/fake_shaders.h"
#include "tests/graph/samples/random_text.h"

namespace weft::test {
namespace {

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

ShaderCatalog make_shaders() {
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
    shaders["draw_1.frag"] = seeded(fragment({"color"}, {a}));
    shaders["draw_2.frag"] = with_switches(seeded(fragment({"color"}, {a, b})), false);
    shaders["scene"] = fragment({"color"});
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
    const auto add = [&](const char* name, ImportKind kind) -> ImportDecl& {
        ImportDecl& import = catalog.imports[name];
        import.name = import.resource.name = name;
        import.kind = kind;
        import.resource.lifetime = ResourceLifetime::imported;
        import.resource.import = ImportState{};
        return import;
    };
    add("opaque", ImportKind::draw_list);
    add("backbuffer", ImportKind::output).resource.format = Format::rgba8;
    ImportDecl& noise = add("noise", ImportKind::image);
    noise.resource.format = Format::rgba8;
    noise.resource.extent = {64, 64, 1};
    noise.resource.import->entry =
        noise.resource.import->exit = {stage::kComputeShader, access::kSampledRead, Layout::shader_read_only};
    noise.resource.import->concurrent = true;
    ImportDecl& instances = add("instances", ImportKind::buffer);
    instances.resource.kind = ResourceKind::buffer;
    instances.resource.size_bytes = 6400;
    return catalog;
}

}  // namespace

Result<ResolvedGraph> resolve_text(const std::string& text, const std::map<std::string, double>& params,
                                   const DeviceProfile& profile,
                                   const std::map<std::string, ExportUse>& exports) {
    const FileReader reader = [&](const std::string&) { return std::optional<std::string>(text); };
    Result<JsonDoc> document = read_json("random.json", reader);
    if (!document) return document.take_errors();
    Result<JsonDoc> merged = merge(std::move(document).value());
    if (!merged) return merged.take_errors();
    Result<GraphDesc> graph = parse(*merged);
    if (!graph) return graph.take_errors();
    const ShaderCatalog shaders = make_shaders();
    const ImportCatalog imports = make_imports();
    const PassCatalog passes;
    Diagnostics warnings;
    return resolve({.graph = *graph,
                    .passes = passes,
                    .shaders = shaders,
                    .imports = imports,
                    .profile = profile,
                    .request = {.params = params, .size = {64, 64, 1}, .exports = exports}},
                   warnings);
}

}  // namespace weft::test
