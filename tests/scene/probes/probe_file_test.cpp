// Purpose: tests files with light probes: what is written can be read, and each fault is named with its
// place.
#include <gtest/gtest.h>

#include <map>

#include "tests/scene/probes/probe_scenes.h"
#include "weft/scene/place_probes.h"

namespace weft::scene::test {
namespace {

Result<Probes> read(const std::string& text, const Scene& scene = {}) {
    const FileReader reader = [&](const std::string& path) {
        return path == "hall.probes.json" ? std::optional(text) : std::nullopt;
    };
    return read_probes("hall.probes.json", reader, scene);
}

// Expects one error with this code in this line.
void expect_fault(const std::string& text, const std::string& code, uint32_t line, const std::string& words) {
    const Result<Probes> probes = read(text);
    ASSERT_FALSE(probes) << text;
    ASSERT_EQ(probes.errors().size(), 1u) << to_text(probes.errors());
    const Diagnostic& fault = probes.errors()[0];
    EXPECT_EQ(fault.code, code) << to_text(fault);
    EXPECT_EQ(fault.file, "hall.probes.json");
    EXPECT_EQ(fault.line, line) << to_text(fault);
    EXPECT_NE(fault.message.find(words), std::string::npos) << to_text(fault);
    EXPECT_FALSE(fault.help.empty()) << to_text(fault);
}

std::string with_volume(const std::string& members) {
    return "{ \"version\": 1,\n\"volume\": { \"origin\": [0, 0, 0], \"spacing\": 2,\n" + members + "\n} }";
}

TEST(ProbeFile, WhatIsWrittenCanBeRead) {
    const BoxScene scene = open_court();
    Probes placed = *place_probes(scene.scene);
    const glm::quat turn = glm::angleAxis(0.7f, glm::normalize(glm::vec3(1, 2, 3)));
    placed.reflections.push_back({"\"hall\"\n", {1, 2, 3}, ProbeBox{{0.1f, 0, 5}, {1, 2.5f, 0.3f}, turn}});
    const std::string text = probes_to_json(placed);
    const Result<Probes> again = read(text);
    ASSERT_TRUE(again) << to_text(again.errors());
    EXPECT_EQ(probes_to_json(*again), text);
    ASSERT_EQ(again->volume.probes.size(), placed.volume.probes.size());
    for (size_t i = 0; i < placed.volume.probes.size(); ++i) {
        EXPECT_EQ(again->volume.probes[i].level, placed.volume.probes[i].level);
        EXPECT_EQ(again->volume.probes[i].state, placed.volume.probes[i].state);
        EXPECT_EQ(again->volume.probes[i].substitute, placed.volume.probes[i].substitute);
    }
    EXPECT_EQ(cells_of(again->volume).size(), cells_of(placed.volume).size());
}

// Cells use the substitute at a corner without a probe.
TEST(ProbeFile, AGridCanBeTurned) {
    const Result<Probes> probes = read(with_volume("\"yaw\": 90,\n\"probes\": [{ \"at\": [0, 0, 1] }]"));
    ASSERT_TRUE(probes) << to_text(probes.errors());
    const ProbeVolume& volume = probes->volume;
    EXPECT_LE(glm::distance(position_of(volume, volume.probes.at(0)), glm::vec3(2, 0, 0)), 1e-6f);
    EXPECT_EQ(read(probes_to_json(*probes))->volume.yaw_deg, 90);
    expect_fault(with_volume("\"yaw\": 181,\n\"probes\": []"), "S196", 3, "181 is out of range");
    expect_fault(with_volume("\"size\": [2, 2, 2],\n\"yaw\": 5"), "S196", 4, "no \"yaw\"");
}

TEST(ProbeFile, ADroppedPointCanHaveASubstitute) {
    std::string points;
    for (int i = 0; i < 8; ++i)
        points += std::string(i == 0 ? "" : ",") + "\n{ \"at\": [" + std::to_string(i & 1) + ", " +
                  std::to_string(i >> 1 & 1) + ", " + std::to_string(i >> 2) + "]" +
                  (i == 3 ? ", \"dropped\": true, \"substitute\": [0, 0, 1]" : "") +
                  (i == 5 ? ", \"dropped\": true" : "") + " }";
    const Result<Probes> probes = read(with_volume("\"probes\": [" + points + "]"));
    ASSERT_TRUE(probes) << to_text(probes.errors());
    const std::vector<ProbeCell> cells = cells_of(probes->volume);
    ASSERT_EQ(cells.size(), 1u);
    EXPECT_EQ(cells[0].corners[3], 4u);
    EXPECT_EQ(cells[0].corners[4], 4u);
    EXPECT_EQ(cells[0].corners[5], ProbeCell::kNoProbe);
    const auto one = [](const std::string& text) { return with_volume("\"probes\": [" + text + "]"); };
    expect_fault(one("{ \"at\": [0, 0, 0] },\n{ \"at\": [1, 0, 0], \"substitute\": [0, 0, 0] }"), "S196", 4,
                 "only a grid point without a probe");
    expect_fault(
        one("{ \"at\": [0, 0, 0] },\n{ \"at\": [1, 0, 0], \"dropped\": true, \"substitute\": [2, 0, 0] }"),
        "S196", 4, "no probe at the grid point of the substitute");
}

TEST(ProbeFile, ARegularGridIsFittedToTheGeometry) {
    BoxScene scene;
    scene.add({-0.2f, -5, -5}, {1.7f, 5, 5});
    const Result<Probes> probes = read(with_volume("\"size\": [3, 1, 2]"), scene.scene);
    ASSERT_TRUE(probes) << to_text(probes.errors());
    const std::vector<Probe>& all = probes->volume.probes;
    ASSERT_EQ(all.size(), 6u);
    EXPECT_EQ(all[0].state, ProbeState::moved);  // x = 0 is 0.2 m below the surface.
    EXPECT_LT(position_of(probes->volume, all[0]).x, -0.2f);
    EXPECT_EQ(all[1].state, ProbeState::kept);  // x = 2.
    EXPECT_EQ(all[3].at, glm::ivec3(0, 0, 1));
    scene.add({1.5f, -5, -5}, {9, 5, 5});
    const Result<Probes> dropped = read(with_volume("\"size\": [3, 1, 2]"), scene.scene);
    ASSERT_TRUE(dropped);
    EXPECT_EQ(dropped->volume.probes[2].state, ProbeState::dropped);  // x = 4.
}

TEST(ProbeFile, ReflectionProbesOfTheSceneRemainIfTheFileHasNone) {
    Scene scene;
    scene.probes.reflections.push_back({"of the scene", {1, 1, 1}, std::nullopt});
    EXPECT_EQ(read("{ \"version\": 1 }", scene)->reflections.at(0).name, "of the scene");
    const Result<Probes> own = read(R"({ "version": 1, "reflections": [{ "position": [1, 2, 3] }] })", scene);
    ASSERT_TRUE(own);
    EXPECT_EQ(own->reflections.at(0).position, glm::vec3(1, 2, 3));
    EXPECT_EQ(own->reflections.size(), 1u);
}

TEST(ProbeFile, CellsNeedAllCornersAndProbesNearThem) {
    std::string points;
    for (int i = 0; i < 8; ++i)
        points += (i == 0 ? "" : ",\n") + std::string("{ \"at\": [") + std::to_string(i & 1) + ", " +
                  std::to_string(i >> 1 & 1) + ", " + std::to_string(i >> 2) + "]" +
                  (i == 3   ? ", \"dropped\": true }"
                   : i == 5 ? ", \"offset\": [0.5, 0, 0] }"
                            : " }");
    const Result<Probes> whole = read(with_volume("\"probes\": [" + points + "]"));
    ASSERT_TRUE(whole) << to_text(whole.errors());
    const std::vector<ProbeCell> cells = cells_of(whole->volume);
    ASSERT_EQ(cells.size(), 1u);
    EXPECT_EQ(cells[0].corners[3], ProbeCell::kNoProbe);
    EXPECT_EQ(cells[0].corners[5], 5u);
    Probes fewer = *whole;
    fewer.volume.probes.pop_back();
    EXPECT_TRUE(cells_of(fewer.volume).empty());
    Probes far = *whole;
    far.volume.probes[5].offset.x = 1;  // More than 0.45 spacings of 2 m.
    EXPECT_EQ(cells_of(far.volume).at(0).corners[5], ProbeCell::kNoProbe);
}

TEST(ProbeFile, FaultsAreNamedWithTheirPlace) {
    expect_fault("{\n", "W001", 2, "");
    expect_fault("[]", "S196", 1, "array; wanted object");
    expect_fault("{}", "S196", 1, "\"version\" is missing");
    expect_fault("{\n\"version\": 2 }", "S196", 2, "not 1");
    expect_fault("{ \"version\": 1,\n\"volumes\": {} }", "S196", 2, "unknown key \"volumes\"");
    expect_fault(with_volume(""), "S196", 2, "either \"size\" or \"probes\"");
    expect_fault(with_volume("\"size\": [0, 1, 1]"), "S196", 3, "out of range");
    expect_fault(with_volume("\"size\": [1, 1.5, 1]"), "S196", 3, "1.5 is out of range");
    expect_fault(with_volume("\"size\": [1, 1]"), "S196", 3, "2 numbers; wanted 3");
    expect_fault(with_volume("\"size\": [99, 99, 99]"), "S197", 3, "970299 points");
    expect_fault(with_volume("\"size\": [2, 2, 2],\n\"strides\": [1]"), "S196", 4, "no \"strides\"");
    expect_fault(with_volume("\"strides\": [1, 3],\n\"probes\": []"), "S196", 3, "stride 3");
    expect_fault(with_volume("\"strides\": [],\n\"probes\": []"), "S196", 3, "at least one level");
    expect_fault(with_volume("\"strides\": [2],\n\"probes\": [{ \"at\": [1, 0, 0] }]"), "S196", 4,
                 "no level");
    expect_fault(with_volume("\"probes\": [{ \"at\": [1, 0, 0] },\n{ \"at\": [1, 0, 0] }]"), "S196", 4,
                 "twice");
    expect_fault(with_volume("\"probes\": [{ \"at\": [1, 0, 0], \"offset\": [2, 0, 0] }]"), "S196", 3,
                 "0.45 spacings");
    expect_fault(with_volume("\"probes\": [{ \"at\": [1, 0, 0],\n\"dropped\": 1 }]"), "S196", 4,
                 "number; wanted true or false");
    expect_fault("{ \"version\": 1, \"reflections\": [\n{ \"position\": [0, 1e9, 0] }] }", "S196", 2,
                 "1e9 is out of range");
    expect_fault(
        "{ \"version\": 1, \"reflections\": [\n{ \"position\": [0, 1, 0], \"box\": {\n\"center\": [0, 0, 0], "
        "\"size\": [1, 0, 1] } }] }",
        "S196", 3, "0 is out of range");
}

TEST(ProbeFile, TooManyProbesAreNamed) {
    std::string points, boxes;
    for (int i = 0; i < 256; ++i)
        points += (i == 0 ? "" : ",") + std::string("{ \"at\": [") + std::to_string(i) + ", 0, 0] }";
    expect_fault(with_volume("\"probes\": [" + points + "]"), "S197", 2, "256 probes; the limit is 255");
    for (int i = 0; i < 25; ++i) boxes += (i == 0 ? "" : ",") + std::string("{ \"position\": [0, 0, 0] }");
    expect_fault("{ \"version\": 1,\n\"reflections\": [" + boxes + "] }", "S197", 2, "25 reflection probes");
}

TEST(ProbeFile, MemoryIsTheSumOfAllProbes) {
    Probes probes;
    EXPECT_EQ(memory_of(probes).volume_bytes, 0u);
    for (int i = 0; i < 255; ++i)
        probes.volume.probes.push_back({{i, 0, 0}, 0, glm::vec3(0), ProbeState::kept});
    probes.volume.probes.push_back({{255, 0, 0}, 0, glm::vec3(0), ProbeState::dropped});
    // 6 faces of 32² texels with 20 bytes, 18² texels with 4 bytes, and 16 × 16 bytes.
    EXPECT_EQ(memory_of(probes).volume_bytes, 255u * (122'880 + 9248 + 256));
    probes.reflections.resize(2);
    // 6 faces of 128² texels with 20 bytes, and with 8 bytes and their mips.
    EXPECT_EQ(memory_of(probes).reflection_bytes, 2u * (98'304 * 20 + 98'304 * 8 * 4 / 3));
}

}  // namespace
}  // namespace weft::scene::test
