#include <sys/stat.h>

#include "tests/scene/gltf/gltf_fixture.h"
#include "tests/scene/measured_child.h"
#include "tests/viewer/pictures/bit_png.h"

namespace weft::scene::test {
namespace {

class GltfHostile : public GltfTest {
 protected:
    // Returns a glTF file in which `to` replaces the first `from` in the top-level JSON member `member`.
    static GltfText with(const std::string& member, const std::string& from, const std::string& to) {
        GltfText text;
        std::string& json = text.members.at(member);
        const size_t at = json.find(from);
        EXPECT_NE(at, std::string::npos) << member << " has no " << from;
        json.replace(at, from.size(), to);
        return text;
    }
    static GltfText with_buffer_uri(const std::string& uri) {
        GltfText text;
        text.members["buffers"] = R"([{"byteLength":104,"uri":")" + uri + R"("}])";
        return text;
    }
};

TEST_F(GltfHostile, MissingFiles) {
    EXPECT_EQ(fail_file("nothing.gltf").code, "S101");
    EXPECT_EQ(where(fail(with_buffer_uri("gone.bin"))), "S101 /buffers/0/uri");
    GltfText image;
    image.members["images"] = R"([{"uri":"gone.png"}])";
    EXPECT_EQ(where(fail(image)), "S101 /images/0/uri");
    std::filesystem::remove(folder_ / "scene.gltf");
    EXPECT_EQ(fail_file(".").code, "S101");
}

TEST_F(GltfHostile, NothingOutsideTheFolderIsOpened) {
    const GltfText text;
    write("../secret.bin", text.buffer);
    std::filesystem::create_symlink("../secret.bin", folder_ / "link.bin");
    std::filesystem::create_directory_symlink("..", folder_ / "up");
    const std::string absolute = (folder_.parent_path() / "secret.bin").string();
    for (const std::string& uri : {std::string("../secret.bin"), std::string("%2e%2e/secret.bin"),
                                   std::string("a/../../secret.bin"), std::string("..\\\\secret.bin"),
                                   absolute, "file://" + absolute, std::string("http://127.0.0.1/secret.bin"),
                                   std::string("link.bin"), std::string("up/secret.bin")}) {
        EXPECT_EQ(where(fail(with_buffer_uri(uri))), "S103 /buffers/0/uri") << uri;
        GltfText image;
        image.members["images"] = R"([{"uri":")" + uri + R"("}])";
        EXPECT_EQ(where(fail(image)), "S103 /images/0/uri") << uri;
    }
}

TEST_F(GltfHostile, LinksAndDetoursInsideTheFolderAreFine) {
    const GltfText text;
    std::filesystem::create_directory(folder_ / "data");
    write("data/real.bin", text.buffer);
    std::filesystem::create_symlink("data/real.bin", folder_ / "link.bin");
    EXPECT_EQ(load(with_buffer_uri("link.bin")).meshes.size(), 1u);
    EXPECT_EQ(load(with_buffer_uri("data/../data/./real.bin")).meshes.size(), 1u);
}

TEST_F(GltfHostile, OnlyPlainFilesAreRead) {
    std::filesystem::create_directory(folder_ / "folder.bin");
    EXPECT_EQ(fail(with_buffer_uri("folder.bin")).code, "S101");
    ASSERT_EQ(mkfifo((folder_ / "pipe.bin").c_str(), 0600), 0);
    EXPECT_EQ(fail(with_buffer_uri("pipe.bin")).code, "S101");
}

TEST_F(GltfHostile, CountsPastTheirBytes) {
    EXPECT_EQ(where(fail(with("accessors", R"("count":3)", R"("count":4)"))), "S104 /accessors/0/count");
    EXPECT_EQ(where(fail(with("accessors", R"("count":3)", R"("count":4000000000)"))),
              "S104 /accessors/0/count");
    EXPECT_EQ(where(fail(with("accessors", R"("count":3)", R"("count":9007199254740992)"))),
              "S104 /accessors/0/count");
    EXPECT_EQ(fail(with("accessors", R"("count":3)", R"("count":18446744073709551615)")).code, "S108");
    EXPECT_EQ(fail(with("accessors", R"("count":3)", R"("count":-3)")).code, "S108");
    EXPECT_EQ(where(fail(with("accessors", R"("count":3)", R"("count":3,"byteOffset":9007199254740000)"))),
              "S104 /accessors/0/count");
    EXPECT_EQ(where(fail(with("accessors", R"("bufferView":0,"componentType":5126,"count":3)",
                              R"("componentType":5126,"count":4000000000)"))),
              "S107 /accessors/0/count");
    EXPECT_EQ(where(fail(with("bufferViews", R"("byteLength":36)", R"("byteLength":105)"))),
              "S104 /bufferViews/0/byteLength");
    EXPECT_EQ(where(fail(with("bufferViews", R"("byteOffset":36)", R"("byteOffset":9007199254740991)"))),
              "S104 /bufferViews/1/byteLength");
    GltfText small;
    small.members["buffers"] = R"([{"byteLength":4000000000,"uri":")" + data_uri(small.buffer) + R"("}])";
    EXPECT_EQ(where(fail(small)), "S104 /buffers/0/byteLength");
}

TEST_F(GltfHostile, SparsePartsPastTheirBytes) {
    const std::string sparse = R"("sparse":{"count":COUNT,"indices":{"bufferView":3,"componentType":5123},)"
                               R"("values":{"bufferView":VALUES}},"bufferView":0)";
    const auto broken = [&](const std::string& count, const std::string& values) {
        std::string text = sparse;
        text.replace(text.find("COUNT"), 5, count);
        text.replace(text.find("VALUES"), 6, values);
        return with("accessors", R"("bufferView":0)", text);
    };
    EXPECT_EQ(where(fail(broken("4000000000", "0"))), "S108 /accessors/0/sparse/count");
    EXPECT_EQ(where(fail(broken("3", "2"))), "S104 /accessors/0/sparse/values");
    EXPECT_EQ(where(fail(broken("3", "77"))), "S110 /accessors/0/sparse/values/bufferView");
    GltfText order = broken("2", "0");
    // The sparse indices 2, 1 are wrong, because sparse indices must ascend.
    append<uint16_t>(order.buffer, {2, 1});
    order.members["bufferViews"].insert(order.members["bufferViews"].size() - 1,
                                        R"(,{"buffer":0,"byteOffset":104,"byteLength":4})");
    std::string& accessors = order.members["accessors"];
    accessors.replace(accessors.find(R"("bufferView":3)"), 14, R"("bufferView":4)");
    EXPECT_EQ(where(fail(order)), "S104 /meshes/0/primitives/0/attributes/POSITION");
}

TEST_F(GltfHostile, IndicesPastTheVertices) {
    GltfText text;
    text.buffer[96] = 3;
    EXPECT_EQ(where(fail(text)), "S111 /meshes/0/primitives/0/indices");
}

TEST_F(GltfHostile, IndicesThatNameNothing) {
    EXPECT_EQ(where(fail(with("nodes", R"("mesh":0)", R"("mesh":1)"))), "S110 /nodes/0/mesh");
    EXPECT_EQ(where(fail(with("nodes", R"("mesh":0)", R"("mesh":4294967296)"))), "S110 /nodes/0/mesh");
    EXPECT_EQ(where(fail(with("nodes", R"("mesh":0)", R"("mesh":0.5)"))), "S110 /nodes/0/mesh");
    EXPECT_EQ(where(fail(with("scenes", "[0]", "[-1]"))), "S110 /scenes/0/nodes/0");
    EXPECT_EQ(where(fail(with("meshes", R"("NORMAL":1)", R"("NORMAL":9)"))),
              "S110 /meshes/0/primitives/0/attributes/NORMAL");
    EXPECT_EQ(where(fail(with("materials", R"("name")", R"("normalTexture":{"index":0},"name")"))),
              "S110 /materials/0/normalTexture/index");
}

TEST_F(GltfHostile, WrongTypesAreAllNamedAtOnce) {
    GltfText text = with("nodes", R"("mesh":0)", R"("mesh":0,"scale":[1,2],"name":7)");
    text.members["materials"] = R"([{"doubleSided":"yes"}])";
    fail(text);
    std::vector<std::string> found;
    for (const Diagnostic& error : errors_) found.push_back(where(error));
    EXPECT_EQ(found, (std::vector<std::string>{"S108 /materials/0/doubleSided", "S108 /nodes/0/name",
                                               "S108 /nodes/0/scale"}));
}

TEST_F(GltfHostile, ErrorsDoNotGrowWithoutBound) {
    GltfText text;
    text.members["nodes"] = "[0";
    for (int i = 0; i < 5000; ++i) text.members["nodes"] += ",0";
    text.members["nodes"] += "]";
    fail(text);
    EXPECT_LE(errors_.size(), 50u);
    EXPECT_FALSE(errors_.back().notes.empty());
}

TEST_F(GltfHostile, TruncatedAndMalformedFiles) {
    const GltfText text;
    const std::string json = text.json();
    write("cut.gltf", json.substr(0, json.size() / 2));
    EXPECT_EQ(fail_file("cut.gltf").code, "S102");
    write("comma.gltf", std::string("{\n  \"asset\": {,}\n}"));
    const Diagnostic comma = fail_file("comma.gltf");
    EXPECT_EQ(comma.code, "S102");
    EXPECT_EQ(comma.line, 2u);
    EXPECT_EQ(comma.column, 13u);
    for (const char* content : {"", "[]", "hello", "{}", "\xff\xfe"}) {
        write("bad.gltf", std::string(content));
        EXPECT_EQ(fail_file("bad.gltf").code, content == std::string("{}") ? "S108" : "S102") << content;
    }
    const Bytes glb = text.glb(text.buffer);
    for (size_t size = 0; size < glb.size(); size += 13) {
        write("cut.glb", std::span(glb).first(size));
        EXPECT_EQ(fail_file("cut.glb").code, "S102") << size;
    }
}

TEST_F(GltfHostile, AGlbWhoseChunksLie) {
    const GltfText text;
    const Bytes good = text.glb(text.buffer);
    for (const size_t at : {size_t{8}, size_t{12}}) {
        Bytes bad = good;
        bad[at + 3] = 0xff;
        write("bad.glb", bad);
        EXPECT_EQ(fail_file("bad.glb").code, "S102");
    }
    Bytes version = good;
    version[4] = 1;
    write("bad.glb", version);
    EXPECT_EQ(fail_file("bad.glb").code, "S113");
    Bytes shorter = text.buffer;
    shorter.resize(60);
    GltfText promise = text;
    promise.members["buffers"] = R"([{"byteLength":104}])";
    write("bad.glb", promise.glb(shorter));
    EXPECT_EQ(where(fail_file("bad.glb")), "S104 /buffers/0/byteLength");
}

TEST_F(GltfHostile, DepthBombs) {
    const std::string open(200'000, '[');
    write("bomb.gltf", R"({"asset":{"version":"2.0"},"extras":)" + open + std::string(200'000, ']') + "}");
    EXPECT_EQ(fail_file("bomb.gltf").code, "S107");
    write("bomb.gltf", R"({"a":)" + open);
    EXPECT_EQ(fail_file("bomb.gltf").code, "S107");
    // Brackets inside a string are only text and do not count for the limit of the depth.
    GltfText text;
    text.members["extras"] = "\"\\\"" + open + "\"";
    EXPECT_EQ(load(text).meshes.size(), 1u);
}

TEST_F(GltfHostile, WideBombs) {
    std::string many = "[0";
    for (int i = 0; i < 2'000'001; ++i) many += ",0";
    GltfText text;
    text.members["extras"] = many + "]";
    EXPECT_EQ(fail(text).code, "S107");
    SceneLimits limits;
    limits.array_items = 3;
    EXPECT_EQ(where(fail(GltfText(), limits)), "S107 /bufferViews");
}

TEST_F(GltfHostile, TotalsHaveLimits) {
    SceneLimits limits;
    limits.vertices = 2;
    EXPECT_EQ(where(fail(GltfText(), limits)), "S107 /meshes/0/primitives/0");
    limits = {};
    limits.triangles = 0;
    EXPECT_EQ(fail(GltfText(), limits).code, "S107");
    limits = {};
    limits.resource_bytes = 50;
    limits.json_bytes = 10'000;
    EXPECT_EQ(where(fail(GltfText(), limits)), "S107 /buffers/0/uri");
    limits = {};
    limits.instances = 1;
    GltfText text;
    text.members["nodes"] = R"([{"mesh":0,"children":[1]},{"mesh":0}])";
    EXPECT_EQ(where(fail(text, limits)), "S107 /nodes/1");
}

TEST_F(GltfHostile, UnknownExtensions) {
    GltfText text;
    text.members["extensionsUsed"] = R"(["EXT_shiny"])";
    load(text);
    ASSERT_TRUE(warned("S150"));
    EXPECT_NE(warnings_[0].message.find("EXT_shiny"), std::string::npos);
    text.members["extensionsRequired"] = R"(["KHR_texture_transform","EXT_shiny"])";
    EXPECT_EQ(where(fail(text)), "S105 /extensionsRequired/1");
}

TEST_F(GltfHostile, OtherVersions) {
    GltfText text;
    text.members["asset"] = R"({"version":"1.0"})";
    EXPECT_EQ(where(fail(text)), "S113 /asset/version");
}

TEST_F(GltfHostile, HugeImagesAreRefusedByTheirHeader) {
    GltfText text;
    text.members["materials"] = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])";
    text.members["textures"] = R"([{"source":0}])";
    text.members["images"] = R"([{"uri":"big.png"}])";
    write("big.png", png(20'000, 20'000, {}));
    EXPECT_EQ(where(fail(text)), "S106 /images/0");
    write("big.png", png(16'000, 16'000, {}));
    EXPECT_EQ(where(fail(text)), "S106 /images/0") << "one GiB decoded";
    write("big.png", png(4, 4, {}));
    EXPECT_EQ(where(fail(text)), "S112 /images/0") << "no pixels";
    write("big.png", std::string("not an image"));
    EXPECT_EQ(where(fail(text)), "S112 /images/0");
}

TEST_F(GltfHostile, EveryTruncationAndManyMutationsEndInAResult) {
    GltfText text;
    text.members["images"] = R"([{"uri":")" + data_uri(png(2, 2, Bytes(16, 128))) + R"("}])";
    text.members["textures"] = R"([{"source":0}])";
    text.members["materials"] = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])";
    const Bytes good = text.glb(text.buffer);
    uint32_t state = 12345;
    for (int i = 0; i < 400; ++i) {
        Bytes bad = good;
        for (int k = 0; k < 3; ++k) {
            state = state * 1664525u + 1013904223u;
            bad[(state >> 8) % bad.size()] = static_cast<uint8_t>(state >> 3);
        }
        write("mutant.glb", bad);
        Diagnostics warnings;
        const Result<Scene> result = load_gltf(folder_ / "mutant.glb", warnings);
        if (!result.ok()) {
            EXPECT_FALSE(result.errors().front().message.empty());
        }
    }
}

TEST_F(GltfHostile, KeysThatStandTwiceAreRefusedWithTheirPlace) {
    write(
        "twice.gltf",
        "{\n\"asset\":{\"version\":\"2.0\"},\n\"nodes\":[{\"mesh\":0},{\"name\":\"a\",\n \"name\":\"b\"}]}");
    Diagnostic fault = fail_file("twice.gltf");
    EXPECT_EQ(fault.code, "S114");
    EXPECT_EQ(fault.line, 4u);
    EXPECT_EQ(fault.column, 2u);
    EXPECT_NE(fault.message.find("\"name\""), std::string::npos) << fault.message;
    // The key "a" occurs twice, once with an escape. Keys are also compared inside members that are never
    // read, such as extras.
    write("escaped.gltf", R"({"asset":{"version":"2.0"},"extras":{"a":1,"\u0061":2}})");
    EXPECT_EQ(fail_file("escaped.gltf").code, "S114");
    // The same text is no duplicate if it is a value or a key of another object.
    write("fine.gltf", R"({"asset":{"version":"2.0"},"extras":{"a":"a","b":{"a":["a","a"]},"\"":0,"\\":0}})");
    (void)load_file("fine.gltf");
}

TEST_F(GltfHostile, AThousandKeysThatStandTwiceAreNotAThousandMessages) {
    std::string json = R"({"asset":{"version":"2.0"},"extras":{"a":0)";
    for (int i = 0; i < 200'000; ++i) json += ",\"a\":0";
    write("many.gltf", json + "}}");
    EXPECT_EQ(fail_file("many.gltf").code, "S114");
    EXPECT_LE(errors_.size(), 20u);
}

TEST_F(GltfHostile, AFileOfTheFirstVersionIsNamedAsSuch) {
    write("old.gltf", R"({"asset":{"version":"1.0"},"meshes":{"a":{}},"nodes":{"b":{}},"buffers":{}})");
    const Diagnostic fault = fail_file("old.gltf");
    EXPECT_EQ(where(fault), "S113 /asset/version");
    EXPECT_NE(fault.message.find("glTF 1.0"), std::string::npos) << fault.message;
    EXPECT_NE(fault.help.at(0).find("convert"), std::string::npos);
    EXPECT_EQ(errors_.size(), 1u) << "all else is a consequence";
    // In glTF 1.0, `asset` is optional. If a file of this version has no `asset`, the error names /asset.
    write("older.gltf", R"({"meshes":{"a":{}},"nodes":{"b":{}}})");
    EXPECT_EQ(where(fail_file("older.gltf")), "S113 /asset");
    EXPECT_EQ(errors_.size(), 1u);
}

// 20,000 primitives with three vertices each share one accessor with 100,000 sparse values. The sparse values
// must be checked only once, or loading would take too long.
TEST_F(GltfHostile, SparseValuesAreNotReadAgainByEachPrimitive) {
    constexpr uint32_t kValues = 100'000;
    Bytes bytes;
    for (uint32_t i = 0; i < kValues; ++i) append<uint32_t>(bytes, {i});
    append<uint16_t>(bytes, {0, 1, 2, 0});
    write("values.bin", bytes);
    std::string primitives;
    for (int i = 0; i < 20'000; ++i)
        primitives +=
            std::string(i > 0 ? "," : "") + R"({"attributes":{"POSITION":0,"NORMAL":0},"indices":1})";
    write(
        "sparse.gltf",
        R"({"asset":{"version":"2.0"},"buffers":[{"uri":"values.bin","byteLength":400008}],)"
        R"("bufferViews":[{"buffer":0,"byteLength":400000},{"buffer":0,"byteOffset":400000,"byteLength":6}],)"
        R"("accessors":[{"componentType":5121,"count":100000,"type":"VEC3","sparse":{"count":100000,)"
        R"("indices":{"bufferView":0,"componentType":5125},"values":{"bufferView":0}}},)"
        R"({"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],)"
        R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[)" +
            primitives + "]}]}");
    const weft::test::Cost cost =
        weft::test::cost_of([&] { return load_file("sparse.gltf").meshes.size() == 20'000 ? 0 : 1; });
    EXPECT_EQ(cost.answer, 0);
    EXPECT_LE(cost.cpu_s, 2);
}

// 2,000 materials that may be transparent share one large opaque picture. The alpha of the picture must be
// inspected only once, or loading would take too long.
TEST_F(GltfHostile, APictureIsNotSearchedForHolesByEachMaterial) {
    const std::string picture = weft::test::black_png(4096, 1024);
    write("a.png", Bytes(picture.begin(), picture.end()));
    std::string materials;
    for (int i = 0; i < 2'000; ++i)
        materials += std::string(i > 0 ? "," : "") +
                     R"({"alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
    write("blend.gltf",
          R"({"asset":{"version":"2.0"},"images":[{"uri":"a.png"}],"textures":[{"source":0}],"materials":[)" +
              materials + "]}");
    const weft::test::Cost cost =
        weft::test::cost_of([&] { return load_file("blend.gltf").materials.size() == 2'000 ? 0 : 1; });
    EXPECT_EQ(cost.answer, 0);
    EXPECT_LE(cost.cpu_s, 2);
}

// Every instance has its own name, which may be a copy of the mesh's name. The copies must count for the
// memory limit.
TEST_F(GltfHostile, NamesAreCountedWhereverTheyAreCopied) {
    std::string nodes;
    for (int i = 0; i < 10'000; ++i) nodes += std::string(i > 0 ? "," : "") + R"({"mesh":0})";
    write(
        "names.gltf",
        R"({"asset":{"version":"2.0"},"accessors":[{"componentType":5126,"count":3,"type":"VEC3"}],"meshes":[{"name":")" +
            std::string(1'000'000, 'n') + R"(","primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[)" +
            nodes + "]}");
    const weft::test::Cost cost = weft::test::cost_of([&] {
        const Diagnostic fault = fail_file("names.gltf");
        return fault.code == "S107" && fault.pointer.starts_with("/nodes/") ? 0 : 1;
    });
    EXPECT_EQ(cost.answer, 0);
    EXPECT_LE(cost.grown_bytes, uint64_t{1} << 30);
}

}  // namespace
}  // namespace weft::scene::test
