// Purpose: tests the decoding of images on several threads: scene and messages must be the same as with one
// thread.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <random>
#include <thread>

#include "scene/loading/worker_threads.h"
#include "tests/scene/gltf/gltf_fixture.h"

namespace weft::scene::test {
namespace {

class GltfThreads : public GltfTest {
 protected:
    // Returns a glTF file with `count` images of noise. For each image there is a material that uses the
    // image twice: as an sRGB colour (emissive) and as linear data (occlusion).
    static GltfText with_images(int count, uint32_t side_px) {
        GltfText text;
        std::mt19937 random(7);
        std::string images, textures, materials;
        for (int i = 0; i < count; ++i) {
            Bytes rgba(size_t{side_px} * side_px * 4);
            for (uint8_t& byte : rgba) byte = static_cast<uint8_t>(random());
            const std::string comma = i == 0 ? "" : ",", index = std::to_string(i);
            images += comma + R"({"name":"i)" + index + R"(","uri":")" +
                      data_uri(png(side_px, side_px, rgba)) + R"("})";
            textures += comma + R"({"source":)" + index + "}";
            materials += comma + R"({"emissiveTexture":{"index":)" + index +
                         R"(},"occlusionTexture":{"index":)" + index + "}}";
        }
        text.members["images"] = "[" + images + "]";
        text.members["textures"] = "[" + textures + "]";
        text.members["materials"] = "[" + materials + "]";
        return text;
    }
    Result<Scene> load_with(uint32_t threads, const std::function<void(const LoadProgress&)>& progress = {}) {
        warnings_.clear();
        return load_gltf(folder_ / "scene.gltf", warnings_, {}, {threads, progress});
    }
};

TEST_F(GltfThreads, TheSceneIsThatOfOneThread) {
    write("scene.gltf", with_images(9, 16).json());
    const Result<Scene> one = load_with(1);
    ASSERT_TRUE(one);
    ASSERT_EQ(one->textures.size(), 18u);
    for (const uint32_t threads : {2u, 7u, 0u}) {
        const Result<Scene> many = load_with(threads);
        ASSERT_TRUE(many);
        ASSERT_EQ(many->textures.size(), one->textures.size());
        for (size_t i = 0; i < one->textures.size(); ++i) {
            EXPECT_EQ(many->textures[i].name, one->textures[i].name);
            EXPECT_EQ(many->textures[i].color_space, one->textures[i].color_space);
            EXPECT_EQ(many->textures[i].mips, one->textures[i].mips);
        }
        for (size_t i = 0; i < one->materials.size(); ++i)
            EXPECT_EQ(many->materials[i].emissive_texture.texture,
                      one->materials[i].emissive_texture.texture);
    }
}

TEST_F(GltfThreads, EveryBrokenImageIsReportedInTheFilesOrder) {
    GltfText text = with_images(6, 8);
    std::string& images = text.members["images"];
    // The headers of the two broken images are valid, so the fault appears only while the images are decoded.
    const Bytes cut = png(8, 8, Bytes(8, 1));
    for (const char* name : {"i1", "i4"}) {
        const size_t begin = images.find("data:", images.find(std::string("\"") + name + "\""));
        images.replace(begin, images.find('"', begin) - begin, data_uri(cut));
    }
    write("scene.gltf", text.json());
    for (const uint32_t threads : {1u, 4u}) {
        const Result<Scene> result = load_with(threads);
        ASSERT_FALSE(result);
        ASSERT_EQ(result.errors().size(), 2u);
        EXPECT_EQ(where(result.errors()[0]), "S112 /images/1");
        EXPECT_EQ(where(result.errors()[1]), "S112 /images/4");
    }
}

TEST_F(GltfThreads, ProgressCountsEveryStepOnce) {
    write("scene.gltf", with_images(5, 4).json());
    std::vector<std::string> steps;
    ASSERT_TRUE(load_with(3, [&](const LoadProgress& now) {
        steps.push_back(now.what + (" " + std::to_string(now.done)) + "/" + std::to_string(now.total));
    }));
    EXPECT_EQ(steps, (std::vector<std::string>{"meshes 1/1", "textures 1/5", "textures 2/5", "textures 3/5",
                                               "textures 4/5", "textures 5/5"}));
}

TEST(WorkerThreads, EveryJobRunsOnce) {
    for (const uint32_t threads : {0u, 1u, 3u, 64u}) {
        std::vector<std::atomic<int>> runs(50);
        run_on_threads(runs.size(), threads, [&](size_t i) { ++runs[i]; });
        EXPECT_TRUE(std::ranges::all_of(runs, [](const auto& r) { return r == 1; })) << threads;
    }
    run_on_threads(0, 4, [](size_t) { FAIL(); });
}

TEST(WorkerThreads, TheBudgetHoldsAndOneLargeJobStillRuns) {
    ByteBudget budget(100);
    std::atomic<uint64_t> now = 0, most = 0, ran = 0;
    run_on_threads(200, 4, [&](size_t i) {
        const uint64_t bytes = i % 50 == 0 ? 500 : 40;
        const ByteBudget::Share share(budget, bytes);
        const uint64_t taken = now += bytes;
        if (bytes < 500) {
            uint64_t seen = most;
            while (taken > seen && !most.compare_exchange_weak(seen, taken)) {
            }
        } else {
            EXPECT_EQ(taken, 500u) << "alone";
        }
        // Each job takes some time, so that jobs on different threads overlap.
        std::this_thread::sleep_for(std::chrono::microseconds(100));
        ++ran;
        now -= bytes;
    });
    EXPECT_EQ(ran, 200u);
    EXPECT_LE(most, 100u);
}

}  // namespace
}  // namespace weft::scene::test
