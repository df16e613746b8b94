// Tests where the files of modules are searched: shaders, files of resources and included graphs, and the
// folders of the graph path. Also tests which values the shaders of a module get.
#include <algorithm>

#include "shader/shader_memory.h"
#include "tests/shader/shader_folder.h"
#include "weft/load/load_graph.h"

namespace weft {
namespace {

namespace fs = std::filesystem;

// A shader that writes one number. The name of the member of Params tells the programs apart.
std::string shader_with(const std::string& member) {
    return "#version 460\n#include \"shape.glsl\"\nwriteonly uniform image2D made;\n"
           "layout(push_constant) uniform Params { float " +
           member +
           "; } params;\nvoid main() { imageStore(made, ivec2(gl_GlobalInvocationID.xy), vec4(params." +
           member + ")); }\n";
}

constexpr const char* kFog = R"({
  "version": 1, "imports": { "backbuffer": "output" }, "params": { "own": 3 }, "resources": { "made": "r32f" },
  "passes": {
    "make": { "type": "compute", "shader": "make.comp", "out": ["made"] },
    "show": { "type": "fullscreen", "shader": "show.frag", "in": ["made"], "out": ["backbuffer"] }
  }
})";

class ModuleFiles : public ShaderFolder {
 protected:
    ModuleFiles() {
        fill("lib/fogbank");
        ImportDecl output;
        output.name = "backbuffer";
        output.kind = ImportKind::output;
        output.resource.name = "backbuffer";
        output.resource.lifetime = ResourceLifetime::imported;
        output.resource.format = Format::rgba8;
        output.resource.extent = {64, 64, 1};
        output.resource.import = ImportState{};
        imports_.imports.emplace("backbuffer", output);
        settings_.reader = [](const std::string& path) -> std::optional<std::string> {
            std::ifstream in(path);
            if (!in) return std::nullopt;
            return std::string(std::istreambuf_iterator<char>(in), {});
        };
        settings_.reads_disk = true;
        settings_.shader_root = base_ / "shaders";
        const FormatFeatureMask all = ~FormatFeatureMask{0};
        profile_.formats = {{Format::rgba8, all}, {Format::r32f, all}};
    }

    // Writes a folder with a graph and its shaders.
    void fill(const std::string& folder) const {
        write(folder + "/fog.json", kFog);
        write(folder + "/make.comp", shader_with("own"));
        write(folder + "/shape.glsl", "layout(local_size_x = 8, local_size_y = 8) in;\n");
        write(folder + "/show.frag",
              "#version 460\nlayout(location = 0) out vec4 backbuffer;\nuniform sampler2D made;\n"
              "void main() { backbuffer = texelFetch(made, ivec2(0), 0); }\n");
    }

    Result<LoadedGraph> load(const std::string& path) {
        const LoadInput input{.request = {.path = (base_ / path).string(), .size = {64, 64, 1}},
                              .settings = settings_,
                              .passes = passes_,
                              .imports = imports_,
                              .profile = profile_,
                              .memory = &memory_};
        Result<ParsedGraph> parsed = parse_graph(input.request, settings_);
        if (!parsed) return parsed.take_errors();
        files_ = parsed->files;
        Diagnostics warnings;
        return load_graph(*parsed, input, warnings);
    }

    // Loads a graph with these items of "include" and no pass of its own. `more` are further sections.
    Result<LoadedGraph> load_including(const std::string& items, const std::string& more = "") {
        write("graph/g.json", R"({ "version": 1, "include": [)" + items + "], \"passes\": {}" + more + "}");
        return load("graph/g.json");
    }

    static std::string shader_of(const LoadedGraph& loaded, const std::string& pass) {
        return loaded.desc.passes.at(pass).shader;
    }
    // The member of the block Params of the shader of a pass.
    static std::string member_of(const LoadedGraph& loaded, const std::string& pass) {
        return loaded.shaders.at(shader_of(loaded, pass)).interface.params.members.at(0).name;
    }
    static double param_of(const LoadedGraph& loaded, const std::string& pass) {
        for (const PassDecl& decl : loaded.graph.passes)
            if (decl.name == pass) return decl.params.at(0).value[0];
        ADD_FAILURE() << "no pass " << pass;
        return -1;
    }

    LoadSettings settings_;
    PassCatalog passes_;
    ImportCatalog imports_;
    DeviceProfile profile_;
    ShaderMemory memory_;
    std::set<fs::path> files_;
};

constexpr const char* kInclude = R"({ "file": "fogbank/fog.json", "as": "a" })";

TEST_F(ModuleFiles, AFolderRunsWhereverItIs) {
    const Result<LoadedGraph> alone = load("lib/fogbank/fog.json");
    ASSERT_TRUE(alone) << to_text(alone.errors());
    EXPECT_EQ(shader_of(*alone, "make"), "make.comp");

    settings_.graph_path = {base_ / "lib"};
    const Result<LoadedGraph> found = load_including(kInclude);
    ASSERT_TRUE(found) << to_text(found.errors());
    EXPECT_EQ(shader_of(*found, "a::make"), "fogbank/make.comp");
    EXPECT_EQ(member_of(*found, "a::make"), "own");
    EXPECT_TRUE(files_.contains(base_ / "lib/fogbank/fog.json")) << "an edit must be noticed";

    settings_.graph_path = {};
    fill("graph/fogbank");
    const Result<LoadedGraph> copied = load_including("\"fogbank/fog.json\"");
    ASSERT_TRUE(copied) << to_text(copied.errors());
    EXPECT_EQ(shader_of(*copied, "make"), "fogbank/make.comp");
    EXPECT_EQ(copied->shaders.at("fogbank/make.comp").content_hash,
              found->shaders.at("fogbank/make.comp").content_hash)
        << "the program does not depend on the place of the folder";
}

TEST_F(ModuleFiles, EachFileGetsTheShaderBesideIt) {
    settings_.graph_path = {base_ / "lib"};
    write("graph/make.comp", shader_with("graphs"));
    write("graph/shape.glsl", "layout(local_size_x = 4, local_size_y = 4) in;\n");
    write("graph/g.json", std::string(R"({ "version": 1, "include": [)") + kInclude + R"(],
        "resources": { "made": "r32f" }, "params": { "graphs": 5 },
        "passes": { "mine": { "type": "compute", "shader": "make.comp", "out": ["made"] },
                    "a::show": { "in": { "made": "made" } } } })");
    const Result<LoadedGraph> both = load("graph/g.json");
    ASSERT_TRUE(both) << to_text(both.errors());
    EXPECT_EQ(shader_of(*both, "mine"), "make.comp");
    EXPECT_EQ(member_of(*both, "mine"), "graphs");
    EXPECT_EQ(member_of(*both, "a::make"), "own");
    EXPECT_EQ(both->shaders.at("make.comp").interface.local_size[0], 4u) << "includes are beside the shader";
    EXPECT_EQ(both->shaders.at("fogbank/make.comp").interface.local_size[0], 8u);
}

TEST_F(ModuleFiles, ThenTheGraphsFolderAndTheShippedShadersAreSearched) {
    settings_.graph_path = {base_ / "lib"};
    fs::remove(base_ / "lib/fogbank/make.comp");
    write("shaders/make.comp", shader_with("shipped"));
    write("shaders/shape.glsl", "layout(local_size_x = 8, local_size_y = 8) in;\n");
    const Result<LoadedGraph> shipped = load_including(kInclude, R"(, "params": { "a::shipped": 1 })");
    ASSERT_TRUE(shipped) << to_text(shipped.errors());
    EXPECT_EQ(shader_of(*shipped, "a::make"), "make.comp");
    EXPECT_EQ(member_of(*shipped, "a::make"), "shipped");
    fs::remove(base_ / "shaders/make.comp");
    const Result<LoadedGraph> none = load_including(kInclude);
    ASSERT_FALSE(none);
    const Diagnostic& fault = none.errors().front();
    EXPECT_EQ(fault.code, "W201");
    EXPECT_EQ(fs::path(fault.file).filename(), "fog.json");
    const std::string help = fault.help.at(0);
    const size_t first = help.find("lib/fogbank"), second = help.find("graph,"), third = help.find("shaders");
    EXPECT_LT(first, second) << help;
    EXPECT_LT(second, third) << help;
}

TEST_F(ModuleFiles, LinksMustNotLeadOut) {
    settings_.graph_path = {base_ / "lib"};
    write("elsewhere/secret.comp", shader_with("own"));
    fs::remove(base_ / "lib/fogbank/make.comp");
    fs::create_symlink(base_ / "elsewhere/secret.comp", base_ / "lib/fogbank/make.comp");
    const Result<LoadedGraph> shader = load_including(kInclude);
    ASSERT_FALSE(shader);
    EXPECT_EQ(shader.errors().front().code, "W201");
    EXPECT_NE(to_text(shader.errors()).find("link to a place outside"), std::string::npos);

    fill("elsewhere/fogbank");
    fs::remove_all(base_ / "lib/fogbank");
    fs::create_symlink(base_ / "elsewhere/fogbank", base_ / "lib/fogbank");
    const Result<LoadedGraph> folder = load_including(kInclude);
    ASSERT_FALSE(folder);
    EXPECT_EQ(folder.errors().front().code, "W126") << to_text(folder.errors());
    // The file itself leads back inside, but its folder is outside.
    fs::remove(base_ / "elsewhere/fogbank/fog.json");
    write("lib/real.json", kFog);
    fs::create_symlink(base_ / "lib/real.json", base_ / "elsewhere/fogbank/fog.json");
    const Result<LoadedGraph> back = load_including(kInclude);
    ASSERT_FALSE(back);
    EXPECT_EQ(back.errors().front().code, "W126") << to_text(back.errors());
    // Links between the allowed folders are fine.
    fs::remove(base_ / "lib/fogbank");
    fill("lib/fogbank");
    fs::rename(base_ / "lib/fogbank/make.comp", base_ / "lib/make.comp");
    fs::create_symlink(base_ / "lib/make.comp", base_ / "lib/fogbank/make.comp");
    const Result<LoadedGraph> inside = load_including(kInclude);
    EXPECT_TRUE(inside) << to_text(inside.errors());
}

TEST_F(ModuleFiles, FilesOfResourcesAreBesideTheModule) {
    settings_.graph_path = {base_ / "lib"};
    std::string text = kFog;
    text.replace(text.find("\"r32f\""), 6, R"({ "format": "r32f", "size": [2, 2], "file": "table.raw" })");
    text.replace(text.find("\"make\""), text.find("\"show\"") - text.find("\"make\""), "");
    write("lib/fogbank/fog.json", text);
    write("lib/fogbank/table.raw", std::string(16, '\0'));
    const Result<LoadedGraph> loaded = load_including(kInclude);
    ASSERT_TRUE(loaded) << to_text(loaded.errors());
    EXPECT_EQ(loaded->desc.resources.at("a::made").file.path, (base_ / "lib/fogbank/table.raw").string());
}

TEST_F(ModuleFiles, ShadersGetTheValuesOfTheirInstance) {
    settings_.graph_path = {base_ / "lib"};
    std::string text = kFog;
    text.insert(1, R"( "ports": ["own"],)");
    write("lib/fogbank/fog.json", text);
    const auto item = [](const std::string& name, const std::string& with) {
        return R"({ "file": "fogbank/fog.json", "as": ")" + name + "\"" + with + " }";
    };
    write("graph/g.json",
          R"({ "version": 1, "params": { "own": 100, "mine": 7, "b::own": 4 }, "include": [)" +
              item("a", "") + ", " + item("b", "") + ", " + item("c", R"(, "with": { "own": "mine" })") +
              R"(],
        "passes": { "b::show": null, "c::show": null,
            "keepA": { "type": "readback", "in": ["a::made"] }, "keepB": { "type": "readback", "in": ["b::made"] },
            "keepC": { "type": "readback", "in": ["c::made"] } } })");
    const Result<LoadedGraph> loaded = load("graph/g.json");
    ASSERT_TRUE(loaded) << to_text(loaded.errors());
    EXPECT_EQ(param_of(*loaded, "a::make"), 3);
    EXPECT_EQ(param_of(*loaded, "b::make"), 4);
    EXPECT_EQ(param_of(*loaded, "c::make"), 7);
    EXPECT_EQ(memory_.misses(), 2u) << "all instances use the same two programs";
}

TEST_F(ModuleFiles, AShaderOfAModuleDoesNotSeeTheParametersOfTheGraph) {
    settings_.graph_path = {base_ / "lib"};
    write("lib/fogbank/make.comp", shader_with("foreign"));
    const Result<LoadedGraph> loaded = load_including(kInclude, R"(, "params": { "foreign": 1 })");
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.errors().front().code, "W113") << to_text(loaded.errors());
}

}  // namespace
}  // namespace weft
