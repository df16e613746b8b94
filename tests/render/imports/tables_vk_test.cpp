// Tests tables of textures on the device: tables of the program, of files and of the scene. Most drivers have
// them; on a driver without them, only arrays with a size and constant indices are tested.
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>

#include "render/imports/material_textures.h"
#include "tests/render/files/picture_bytes.h"
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;

// Adds the texel (0, 0) of three textures, and the widths of the textures.
constexpr const char* kConstantIndices = R"(#version 460
layout(local_size_x = 1) in;
uniform sampler2D pictures[4];
writeonly buffer Sums { vec4 sum; vec4 widths; } sums;
layout(push_constant) uniform Params { uint picturesCount; } params;
void main() {
    sums.sum = texelFetch(pictures[0], ivec2(0), 0) + 2.0 * texelFetch(pictures[1], ivec2(0), 0) +
               4.0 * texelFetch(pictures[2], ivec2(0), 0);
    sums.widths = vec4(textureSize(pictures[0], 0).x, textureSize(pictures[1], 0).x, textureSize(pictures[3], 0).x,
                       params.picturesCount);
}
)";

constexpr const char* kSumGraph = R"({
  "version": 1, "name": "tables", "imports": { "pictures": "textures" },
  "resources": { "sums": { "buffer": "vec4", "count": 2, "keep": true } },
  "passes": {
    "add":  { "type": "compute", "shader": "add.comp", "groups": [1, 1, 1], "in": ["pictures"], "out": ["sums"], "rest": true },
    "read": { "type": "readback", "in": ["sums"] }
  }
})";

// Draws the scene twice: with the textures of the material sets, and with the textures of the table.
constexpr const char* kSceneGraph = R"({
  "version": 1, "name": "indexed",
  "imports": { "opaque": "drawlist", "materials": "buffer", "materialTextures": "textures" COMMANDS },
  "resources": { "bound": "rgba16f", "indexed": "rgba16f", "a": "d32f", "b": "d32f", "number": { "buffer": "u32", "count": 1 } },
  "passes": {
    "count":   { "type": "clear", "out": ["number"], "clear": "opaqueDraws" },
    "sets":    { "type": "raster", "draws": ["opaque"], "shader": "sets", "out": { "color": "bound" }, "depth": "a",
                 "state": { "cull": "none" } },
    "table":   { "type": "raster", "draws": DRAWS, "shader": "table", "out": { "color": "indexed" }, "depth": "b",
                 "in": { "materials": "materials",
                         "materialTextures": { "ref": "materialTextures", "sampler": { "wrap": "repeat" } } },
                 "state": { "cull": "none" } },
    "number":  { "type": "readback", "in": ["number"] },
    "bound":   { "type": "readback", "in": ["bound"] },
    "indexed": { "type": "readback", "in": ["indexed"] }
  }
})";

constexpr const char* kVertex = R"(#version 460
#include "frame_set.glsl"
#include "surface_vertex.glsl"
layout(location = 5) flat out uint material_number;
void main() {
    const Instance instance = place_surface();
    material_number = instance.material;
    gl_Position = view.view_projection * (instance.object_to_world * vec4(position.xyz, 1.0));
}
)";
constexpr const char* kSets = R"(#version 460
#include "material_set.glsl"
layout(location = 2) in vec2 surface_uv;
layout(location = 0) out vec4 color;
void main() {
    color = material.base_color * texture(base_color_texture, transformed(material.base_color_uv, surface_uv));
}
)";
constexpr const char* kTable = R"(#version 460
#extension GL_EXT_nonuniform_qualifier : require
#include "material_set.glsl"
layout(location = 2) in vec2 surface_uv;
layout(location = 5) flat in uint material_number;
layout(location = 0) out vec4 color;
readonly buffer Materials { Material items[]; } materials;
uniform sampler2D materialTextures[];
void main() {
    const Material own = materials.items[material_number];
    color = own.base_color * texture(materialTextures[nonuniformEXT(own.base_color_texture)],
                                     transformed(own.base_color_uv, surface_uv));
}
)";

std::string replaced_text(std::string text, const std::string& from, const std::string& to) {
    for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

// The spheres, each with one of five textures of different sizes.
scene::Scene textured_spheres() {
    scene::Scene scene = std::move(*scene::make_builtin("spheres"));
    scene.textures.clear();
    for (uint32_t i = 0; i < 5; ++i) {
        scene::Texture& texture = scene.textures.emplace_back();
        texture.name = "texture " + std::to_string(i);
        texture.width_px = texture.height_px = 4u << i;
        texture.color_space = i % 2 == 0 ? scene::ColorSpace::srgb : scene::ColorSpace::linear;
        for (uint32_t side = texture.width_px; side > 0; side /= 2) {
            std::vector<uint8_t>& mip = texture.mips.emplace_back();
            for (uint32_t at = 0; at < side * side; ++at) {
                const bool light = (at % side * 4 / side + at / side * 4 / side) % 2 == 0;
                for (const uint32_t value : {light ? 250u : 40u, 50 * i, light ? 30 * i : 200u, 255u})
                    mip.push_back(static_cast<uint8_t>(value));
            }
        }
    }
    for (size_t i = 0; i < scene.materials.size(); ++i)
        if (i % 6 < 5) scene.materials[i].base_color_texture.texture = static_cast<uint32_t>(i % 6);
    return scene;
}

class Tables : public SessionTest {
 protected:
    Tables() : folder_(fs::path(testing::TempDir()) / ("weft_tables_" + std::to_string(getpid()))) {
        fs::create_directories(folder_ / "sets");
        fs::create_directories(folder_ / "table");
        write("graph.json", kSumGraph);
        write("add.comp", kConstantIndices);
    }
    ~Tables() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Tables(const Tables&) = delete;
    Tables& operator=(const Tables&) = delete;

    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
    }

    // Makes an image of one colour, `side_px` texels wide.
    vk::Image picture(Format format, uint32_t side_px, std::array<uint8_t, 4> texel) {
        ResourceDecl decl;
        decl.name = "picture";
        decl.format = format;
        decl.extent = {side_px, side_px, 1};
        decl.usage = usage::kSampled | usage::kTransferDst;
        Result<vk::Image> image = vk::Image::create(*device_, decl);
        EXPECT_TRUE(image);
        std::vector<uint8_t> texels;
        for (uint32_t i = 0; i < side_px * side_px; ++i)
            texels.insert(texels.end(), texel.begin(), texel.end());
        const std::vector<std::span<const std::byte>> levels{std::as_bytes(std::span(texels))};
        EXPECT_TRUE(vk::upload_image(*device_, *image, levels));
        return std::move(*image);
    }

    Result<std::unique_ptr<render::Session>> begin(
        std::map<std::string, std::vector<VkImageView>, std::less<>> tables) {
        render::SessionInput input;
        passes_ = registered_passes();
        input.request.path = (folder_ / "graph.json").string();
        input.request.size = {16, 16, 1};
        input.load.reader = read_text;
        input.load.reads_disk = true;
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.passes = &passes_;
        input.check_plan = true;
        input.queues = queues_;
        input.textures = std::move(tables);
        return render::Session::create(*device_, *scene::make_builtin("spheres"), input, warnings_);
    }
    static std::vector<float> floats(const std::vector<std::byte>& bytes) {
        std::vector<float> values(bytes.size() / sizeof(float));
        std::memcpy(values.data(), bytes.data(), bytes.size());
        return values;
    }
    // Renders one frame and returns the content of `sums`. Adds the passes that ran to `ran`.
    std::vector<float> sums(render::Session& session, std::set<std::string>& ran) {
        ran.clear();
        EXPECT_TRUE(session.render_frame({.camera = {}}));
        EXPECT_TRUE(session.finish());
        for (const vk::FrameTiming& timing : session.take_timings())
            for (const vk::PassTiming& pass : timing.passes)
                if (!pass.woken_by.empty()) ran.insert(pass.pass);
        std::vector<float> found;
        for (const vk::ReadbackData& data : session.take_readbacks()) found = floats(data.bytes);
        return found;
    }

    fs::path folder_;
};

TEST_F(Tables, TheProgramGivesTextures) {
    const vk::Image a = picture(Format::rgba8, 4, {255, 0, 0, 255}),
                    b = picture(Format::rgba8_srgb, 8, {0, 255, 0, 0}),
                    c = picture(Format::rgba8, 1, {51, 0, 255, 0});
    const auto session = begin({{"pictures", {a.view(), b.view(), c.view()}}});
    ASSERT_TRUE(session) << to_text(session.errors());
    std::set<std::string> ran;
    const std::vector<float> wanted{1.8f, 2, 4, 1, 4, 8, 1, 3};
    const std::vector<float> first = sums(**session, ran);
    ASSERT_EQ(first.size(), wanted.size());
    for (size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(first[i], wanted[i], 1e-5) << i;
    EXPECT_EQ(ran, std::set<std::string>{"add"});
    EXPECT_EQ(sums(**session, ran), first);
    EXPECT_TRUE(ran.empty()) << "the textures of a table do not change, so the pass rests";
}

TEST_F(Tables, OnThreeQueuesToo) {
    queues_ = 3;
    device_.reset();
    make_device(true);
    write("graph.json", replaced_text(kSumGraph, "\"compute\"", "\"compute\", \"queue\": \"async\""));
    const vk::Image a = picture(Format::rgba8, 4, {255, 0, 0, 255});
    const auto session = begin({{"pictures", {a.view(), a.view(), a.view()}}});
    ASSERT_TRUE(session) << to_text(session.errors());
    std::set<std::string> ran;
    EXPECT_EQ(sums(**session, ran).at(0), 7);
}

TEST_F(Tables, AMissingTextureIsAnError) {
    const vk::Image a = picture(Format::rgba8, 4, {255, 0, 0, 255});
    for (const std::vector<VkImageView>& views : {std::vector<VkImageView>{}, {a.view(), VK_NULL_HANDLE}}) {
        const auto session = begin({{"pictures", views}});
        ASSERT_FALSE(session);
        ASSERT_EQ(session.errors().size(), 1u) << to_text(session.errors());
        EXPECT_EQ(session.errors()[0].code, "V414");
        EXPECT_NE(session.errors()[0].message.find("\"pictures\""), std::string::npos);
    }
    const auto unknown = begin({});
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.errors()[0].code, "W118");
}

TEST_F(Tables, FilesGiveTextures) {
    write(
        "graph.json",
        replaced_text(
            replaced_text(kSumGraph, "\"imports\": { \"pictures\": \"textures\" },", ""), "\"resources\": {",
            R"("resources": { "pictures": { "textures": ["a.png", "b.png", "a.png"], "format": "rgba8", "mips": "full" },)"));
    write("a.png", plain_png(4, 2, 8, 1, {51, 0, 0, 0, 0, 0, 0, 0}));
    write("b.png", plain_png(2, 1, 8, 3, {0, 255, 102, 0, 0, 0}));
    const auto session = begin({});
    ASSERT_TRUE(session) << to_text(session.errors());
    std::set<std::string> ran;
    const std::vector<float> wanted{1, 3, 1.8f, 7, 4, 2, 4, 3};
    const std::vector<float> first = sums(**session, ran);
    ASSERT_EQ(first.size(), wanted.size());
    for (size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(first[i], wanted[i], 1e-5) << i;
    sums(**session, ran);
    EXPECT_TRUE(ran.empty());
    const ResourceDecl& table =
        (*session)->plan().graph.resources[find_resource((*session)->plan().graph, "pictures")];
    ASSERT_EQ(table.texture_files.size(), 3u);
    EXPECT_EQ(table.texture_files[0].mips, 3u);
    EXPECT_EQ(table.texture_files[1].mips, 2u);

    // A changed file wakes the pass. The size of the picture is part of the plan.
    write("b.png", plain_png(2, 1, 8, 3, {255, 255, 102, 0, 0, 0}));
    render::PrepareResult made = (*session)->prepare((*session)->selection());
    ASSERT_TRUE(made.result) << to_text(made.result.errors());
    EXPECT_TRUE(made.files.contains(folder_ / "b.png")) << "the file is watched";
    EXPECT_FALSE(made.result->rebuilt().nothing());
    ASSERT_TRUE((*session)->swap_in(std::move(*made.result)));
    EXPECT_NEAR(sums(**session, ran).at(0), 3, 1e-5);
    EXPECT_EQ(ran, std::set<std::string>{"add"});
}

TEST_F(Tables, MaterialsHaveTheNumbersOfTheirTextures) {
    const scene::Scene scene = textured_spheres();
    const render::MaterialTextures order = render::order_textures(scene);
    EXPECT_EQ(order.count(), 7u);
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        const uint32_t texture = scene.materials[i].base_color_texture.texture;
        const uint32_t number = order.materials[i][0];
        if (texture < scene.textures.size())
            EXPECT_EQ(order.textures.at(number - render::kFirstTexture), texture);
        else
            EXPECT_EQ(number, render::kWhiteEntry);
        EXPECT_EQ(order.materials[i][2], render::kFlatNormalEntry);
        EXPECT_EQ(render::gpu_materials(scene)[i].base_color_texture, number);
    }
    // The table contains no textures of parts that a program adds to the scene.
    for (const shared::Material& material : render::gpu_materials_without_table(scene)) {
        EXPECT_EQ(material.base_color_texture, render::kWhiteEntry);
        EXPECT_EQ(material.normal_texture, render::kFlatNormalEntry);
    }
}

// Draws a scene by material sets and by the table. The pictures must be equal.
class SceneTables : public Tables {
 protected:
    void SetUp() override {
        Tables::SetUp();
        if (!device_->optional().texture_tables()) GTEST_SKIP() << "the device has no tables of textures";
    }

    void expect_same_picture(const std::string& draws, const std::string& commands) {
        write("scene.json", replaced_text(replaced_text(kSceneGraph, "DRAWS", draws), "COMMANDS", commands));
        for (const char* name : {"sets/sets.vert", "table/table.vert"}) write(name, kVertex);
        write("sets/sets.frag", kSets);
        write("table/table.frag", kTable);
        const scene::Scene scene = textured_spheres();
        const auto session = start(scene, scene::framing_camera(scene, 1.5f),
                                   (folder_ / "scene.json").string(), {96, 64, 1}, {});
        ASSERT_TRUE(session);
        for (int frame = 0; frame < 2; ++frame) ASSERT_TRUE(draw_frame(*session));
        ASSERT_TRUE(session->finish());
        std::map<std::string, std::vector<glm::vec4>> pictures;
        for (const vk::ReadbackData& data : session->take_readbacks())
            if (data.pass != "number") pictures[data.pass] = render::decode_texels(data.format, data.bytes);
        ASSERT_EQ(pictures.size(), 2u);
        std::set<float> reds;
        float worst = 0;
        for (size_t i = 0; i < pictures["bound"].size(); ++i) {
            const glm::vec4 difference = glm::abs(pictures["bound"][i] - pictures["indexed"][i]);
            worst = std::max({worst, difference.r, difference.g, difference.b});
            reds.insert(pictures["bound"][i].r);
        }
        EXPECT_EQ(worst, 0);
        EXPECT_GT(reds.size(), 20u) << "a plain picture proves nothing";
    }
};

TEST_F(SceneTables, ATableGivesThePictureOfTheMaterialSets) {
    expect_same_picture(R"(["opaque"])", "");
}

TEST_F(SceneTables, OneCommandDrawsTheWholeScene) {
    if (!device_->optional().draw_indirect_count) GTEST_SKIP() << "the device lacks drawIndirectCount";
    expect_same_picture(R"({ "list": "opaque", "indirect": "opaqueCommands", "count": "number" })",
                        R"(, "opaqueCommands": "buffer")");
}

// Two passes with the same shader and tables of different sizes need different pipeline layouts.
TEST_F(SceneTables, EachPassHasTheSizeOfItsTable) {
    write("graph.json", R"({
  "version": 1, "name": "sizes", "imports": { "few": "textures", "many": "textures" },
  "resources": { "a": { "buffer": "f32", "count": 8 }, "b": { "buffer": "f32", "count": 8 } },
  "passes": {
    "few":   { "type": "compute", "shader": "fetch.comp", "groups": [1, 1, 1], "in": { "pictures": "few" }, "out": { "found": "a" } },
    "many":  { "type": "compute", "shader": "fetch.comp", "groups": [1, 1, 1], "in": { "pictures": "many" }, "out": { "found": "b" } },
    "readA": { "type": "readback", "in": ["a"] }, "readB": { "type": "readback", "in": ["b"] }
  }
})");
    write("fetch.comp", R"(#version 460
#extension GL_EXT_nonuniform_qualifier : require
layout(local_size_x = 8) in;
uniform sampler2D pictures[];
writeonly buffer Found { float items[]; } found;
layout(push_constant) uniform Params { uint picturesCount; } params;
void main() {
    const uint i = gl_LocalInvocationIndex;
    found.items[i] = textureLod(pictures[nonuniformEXT(i % params.picturesCount)], vec2(0.5), 0.0).r * 255.0;
}
)");
    std::vector<vk::Image> images;
    std::vector<VkImageView> views;
    for (uint8_t i = 0; i < 6; ++i) {
        images.push_back(picture(Format::rgba8, 1u + i, {static_cast<uint8_t>(10 + i), 0, 0, 255}));
        views.push_back(images.back().view());
    }
    const auto session = begin({{"few", {views[0], views[1], views[2]}}, {"many", views}});
    ASSERT_TRUE(session) << to_text(session.errors());
    ASSERT_TRUE((*session)->render_frame({.camera = {}}));
    ASSERT_TRUE((*session)->finish());
    size_t read = 0;
    for (const vk::ReadbackData& data : (*session)->take_readbacks()) {
        const std::vector<float> found = floats(data.bytes);
        for (uint32_t i = 0; i < 8; ++i)
            EXPECT_NEAR(found.at(i), 10 + i % (data.pass == "readA" ? 3 : 6), 0.01) << data.pass << " " << i;
        ++read;
    }
    EXPECT_EQ(read, 2u);
}

}  // namespace
}  // namespace weft::test
