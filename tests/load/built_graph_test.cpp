// Tests graphs that are made in C++ and loaded with shaders from disk: a graph has the same plan as the same
// graph in a file, may include files in memory, and its errors name the line of the faulty key.
#include "tests/shader/shader_folder.h"
#include "weft/compile.h"
#include "weft/graph_builder.h"
#include "weft/load/plan_graph.h"
#include "weft/memory_files.h"

namespace weft {
namespace {

class BuiltGraph : public ShaderFolder {
 protected:
    BuiltGraph() {
        write(
            "graph/make.comp",
            "#version 460\nlayout(local_size_x = 8, local_size_y = 8) in;\nwriteonly uniform image2D made;\n"
            "layout(push_constant) uniform Params { float reach; } params;\n"
            "void main() { imageStore(made, ivec2(gl_GlobalInvocationID.xy), vec4(params.reach)); }\n");
        write("graph/show.frag",
              "#version 460\nlayout(location = 0) out vec4 color;\nuniform sampler2D far;\n"
              "void main() { color = texelFetch(far, ivec2(0), 0); }\n");
        settings_.shader_root = base_ / "shaders";
        settings_.reader = files_.reader([](const std::string&) { return std::nullopt; });
        profile_.formats = {{Format::rgba8, ~FormatFeatureMask{0}}, {Format::r32f, ~FormatFeatureMask{0}}};
        ImportDecl& output = imports_.imports["backbuffer"];
        output.name = output.resource.name = "backbuffer";
        output.kind = ImportKind::output;
        output.resource.lifetime = ResourceLifetime::imported;
        output.resource.format = Format::rgba8;
        output.resource.extent = {64, 64, 1};
        output.resource.import = ImportState{};
    }

    // Puts a graph into the folder of the shaders, in memory, and compiles it to a plan.
    Result<PlannedGraph> plan(const std::string& name, std::string text) {
        const LoadInput input{.request = {.path = (base_ / "graph" / name).string(), .size = {64, 64, 1}},
                              .settings = settings_,
                              .passes = passes_,
                              .imports = imports_,
                              .profile = profile_};
        files_.put(input.request.path, std::move(text));
        const Result<JsonDoc> document = read_graph(input.request.path, settings_);
        if (!document) return document.errors();
        Diagnostics warnings;
        return plan_graph(*document, input, 1, warnings);
    }

    MemoryFiles files_;
    LoadSettings settings_;
    PassCatalog passes_;
    ImportCatalog imports_;
    DeviceProfile profile_;
};

// Makes a graph with one compute pass, whose shader is `shader`, and one fullscreen pass.
GraphBuilder fog(const std::string& shader) {
    GraphBuilder graph("fog");
    graph.import("backbuffer", "output");
    graph.param("reach", 12).range(1, 100);
    graph.image("made", "r32f").size("output / 2").mips(2);
    graph.compute("make", shader).out("made", "made.mip(1)").threads("output.x / 4", "output.y / 4");
    graph.fullscreen("show", "show.frag").in("far", "made.mip(1)").out("color", "backbuffer");
    return graph;
}

TEST_F(BuiltGraph, HasTheSamePlanAsTheGraphInAFile) {
    const Result<PlannedGraph> file = plan("fog.json", R"json({
      "version": 1, "name": "fog", "imports": { "backbuffer": "output" },
      "params": { "reach": { "default": 12, "range": [1, 100] } },
      "resources": { "made": { "format": "r32f", "size": "output / 2", "mips": 2 } },
      "passes": {
        "show": { "type": "fullscreen", "shader": "show.frag", "in": { "far": "made.mip(1)" },
                  "out": { "color": "backbuffer" } },
        "make": { "type": "compute", "shader": "make.comp", "out": { "made": "made.mip(1)" },
                  "threads": ["output.x / 4", "output.y / 4", 1] }
      } })json");
    ASSERT_TRUE(file) << to_text(file.errors());
    const GraphBuilder graph = fog("make.comp");
    const Result<PlannedGraph> built = plan(graph.file_name(), graph.to_json());
    ASSERT_TRUE(built) << to_text(built.errors()) << graph.to_json();
    EXPECT_EQ(plan_hash(built->plan), plan_hash(file->plan));
    GraphBuilder other = fog("make.comp");
    other.compute("again", "make.comp").out("made", "made.mip(0)");
    other.pass("read", "readback").set("in", {"made.mip(0)"});
    const Result<PlannedGraph> more = plan(other.file_name(), other.to_json());
    ASSERT_TRUE(more) << to_text(more.errors()) << other.to_json();
    EXPECT_NE(plan_hash(more->plan), plan_hash(file->plan));
}

TEST_F(BuiltGraph, AMissingShaderIsAnErrorAtItsLine) {
    const GraphBuilder graph = fog("fake.comp");
    const Result<PlannedGraph> built = plan(graph.file_name(), graph.to_json());
    ASSERT_FALSE(built);
    ASSERT_EQ(built.errors().size(), 1u) << to_text(built.errors());
    const Diagnostic& fault = built.errors().front();
    EXPECT_EQ(fault.code, "W201");
    EXPECT_EQ(fault.file, (base_ / "graph/fog (made in C++)").string());
    EXPECT_EQ(fault.source_line, "      \"shader\": \"fake.comp\",");
    EXPECT_EQ(fault.pointer, "/passes/make/shader");
}

TEST_F(BuiltGraph, IncludesFilesInMemory) {
    files_.put((base_ / "graph/part.json").string(), fog("make.comp").to_json());
    GraphBuilder graph("whole");
    graph.include({"part.json"}).set_json("passes", "{}");
    graph.param("reach", 13);
    const Result<PlannedGraph> built = plan(graph.file_name(), graph.to_json());
    ASSERT_TRUE(built) << to_text(built.errors());
    ASSERT_EQ(built->loaded.graph.params.size(), 1u);
    EXPECT_EQ(built->loaded.graph.passes.size(), 2u);
    EXPECT_EQ(built->plan.graph.passes.at(0).params.at(0).value[0], 13);
}

TEST_F(BuiltGraph, ReadsFilesOfResourcesInMemory) {
    files_.put((base_ / "graph/ramp.txt").string(), "sixteen letters.");
    GraphBuilder graph("ramp");
    graph.entry("resources", "ramp").set("file", "ramp.txt").set("buffer", "u32");
    graph.pass("read", "readback").set("in", {"ramp"});
    const Result<PlannedGraph> built = plan(graph.file_name(), graph.to_json());
    ASSERT_TRUE(built) << to_text(built.errors());
    ASSERT_EQ(built->plan.graph.resources.size(), 1u);
    EXPECT_EQ(built->plan.graph.resources[0].size_bytes, 16u);
}

}  // namespace
}  // namespace weft
