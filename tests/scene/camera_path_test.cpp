// Purpose: tests camera paths: the curve through the keys, cuts, and faults of the file with their places.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "weft/scene/camera_path.h"

namespace weft::scene {
namespace {

Result<CameraPath> read(const std::string& text) {
    const FileReader reader = [&](const std::string& path) {
        return path == "walk.json" ? std::optional(text) : std::nullopt;
    };
    return read_camera_path("walk.json", reader);
}

CameraPath path_of(const std::string& keys) {
    Result<CameraPath> path = read("{ \"version\": 1, \"keys\": [\n" + keys + "\n] }");
    EXPECT_TRUE(path) << to_text(path.errors());
    return path ? std::move(*path) : CameraPath{};
}

glm::vec3 eye_at(const CameraPath& path, double time_s) {
    return glm::vec3(camera_at(path, time_s).transform[3]);
}

void expect_near(const glm::vec3& found, const glm::vec3& wanted) {
    EXPECT_LE(glm::distance(found, wanted), 1e-4f) << found.x << " " << found.y << " " << found.z;
}

TEST(CameraPath, MovesEvenlyBetweenTwoKeysAndStandsOutsideThem) {
    const CameraPath path = path_of(R"({ "time": 1, "eye": [0, 1, 0], "at": [0, 1, -5], "fovY": 40 },
                                       { "time": 3, "eye": [4, 1, 2], "at": [4, 1, -5], "fovY": 60 })");
    for (const double time_s : {0.0, 1.0}) expect_near(eye_at(path, time_s), {0, 1, 0});
    expect_near(eye_at(path, 1.5), {1, 1, 0.5});
    expect_near(eye_at(path, 2), {2, 1, 1});
    for (const double time_s : {3.0, 99.0}) expect_near(eye_at(path, time_s), {4, 1, 2});
    EXPECT_NEAR(camera_at(path, 2).fov_y_rad, glm::radians(50.0f), 1e-5f);
    EXPECT_NEAR(camera_at(path, 9).fov_y_rad, glm::radians(60.0f), 1e-5f);
}

// A key without "fovY" has the field of view of the key before it.
TEST(CameraPath, LooksAtThePointOfTheKey) {
    const CameraPath path = path_of(R"({ "time": 0, "eye": [0, 0, 0], "at": [3, 0, 0] },
                                       { "time": 1, "eye": [0, 0, 0], "at": [0, 0, 7], "fovY": 30 },
                                       { "time": 2, "eye": [0, 2, 0], "at": [0, 0, 0] })");
    const auto forward = [&](double time_s) { return -glm::vec3(camera_at(path, time_s).transform[2]); };
    expect_near(forward(0), {1, 0, 0});
    expect_near(forward(1), {0, 0, 1});
    expect_near(forward(2), {0, -1, 0});
    EXPECT_NEAR(camera_at(path, 0).fov_y_rad, glm::radians(50.0f), 1e-5f);
    EXPECT_NEAR(camera_at(path, 2).fov_y_rad, glm::radians(30.0f), 1e-5f);
}

// Sixteen keys on a circle: the curve stays near the circle, and its speed changes nowhere by a jump.
TEST(CameraPath, IsSmoothAtTheKeys) {
    std::string keys;
    const auto on_circle = [](double turn) {
        const double angle = turn * 2 * glm::pi<double>();
        return glm::vec3(5 * std::cos(angle), 1, 5 * std::sin(angle));
    };
    for (int i = 0; i <= 16; ++i) {
        const glm::vec3 eye = on_circle(i / 16.0);
        keys += (i == 0 ? "" : ",\n") + std::string("{ \"time\": ") + std::to_string(i / 16.0) +
                ", \"eye\": [" + std::to_string(eye.x) + ", 1, " + std::to_string(eye.z) +
                "], \"at\": [0, 1, 0] }";
    }
    const CameraPath path = path_of(keys);
    constexpr double kStep_s = 1e-3;
    for (double time_s = 2.0 / 16; time_s < 14.0 / 16; time_s += kStep_s) {
        const glm::vec3 before = eye_at(path, time_s - kStep_s), here = eye_at(path, time_s),
                        after = eye_at(path, time_s + kStep_s);
        EXPECT_LE(glm::distance(here, on_circle(time_s)), 0.01f) << time_s;
        EXPECT_LE(glm::length((after - here) - (here - before)), 1e-3f) << time_s;
    }
}

TEST(CameraPath, ACameraThatStandsDoesNotDrift) {
    const CameraPath path = path_of(R"({ "time": 0, "eye": [0, 0, 0], "at": [0, 0, -1] },
                                       { "time": 1, "eye": [5, 0, 0], "at": [5, 0, -1] },
                                       { "time": 2, "eye": [5, 0, 0], "at": [5, 0, -1] },
                                       { "time": 3, "eye": [9, 0, 0], "at": [9, 0, -1] })");
    for (double time_s = 1; time_s <= 2; time_s += 0.05) EXPECT_EQ(eye_at(path, time_s), glm::vec3(5, 0, 0));
}

TEST(CameraPath, JumpsAtACut) {
    const CameraPath path = path_of(R"({ "time": 0, "eye": [0, 0, 0], "at": [0, 0, -1] },
                                       { "time": 1, "eye": [1, 0, 0], "at": [1, 0, -1] },
                                       { "time": 2, "eye": [8, 0, 0], "at": [8, 0, -1], "cut": true },
                                       { "time": 3, "eye": [9, 0, 0], "at": [9, 0, -1] })");
    ASSERT_EQ(path.shots.size(), 2u);
    expect_near(eye_at(path, 1.999), {1, 0, 0});
    expect_near(eye_at(path, 2), {8, 0, 0});
    expect_near(eye_at(path, 2.5), {8.5, 0, 0});
    EXPECT_EQ(shot_at(path, 0), 0u);
    EXPECT_EQ(shot_at(path, 1.999), 0u);
    EXPECT_EQ(shot_at(path, 2), 1u);
}

// The camera passes through the point that it looks at. Its transform stays finite.
TEST(CameraPath, IsFiniteWhereTheCameraPassesItsTarget) {
    const CameraPath path = path_of(R"({ "time": 0, "eye": [-1, 0, 0], "at": [0, 0, 0] },
                                       { "time": 2, "eye": [1, 0, 0], "at": [0, 0, 0] })");
    const glm::mat4 transform = camera_at(path, 1).transform;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) EXPECT_TRUE(std::isfinite(transform[column][row]));
}

struct Fault {
    const char* name;
    const char* text;
    uint32_t line;
    const char* words;
};
class CameraPathFault : public testing::TestWithParam<Fault> {};

TEST_P(CameraPathFault, NamesItsPlaceAndARemedy) {
    const Result<CameraPath> path = read(GetParam().text);
    ASSERT_FALSE(path);
    ASSERT_EQ(path.errors().size(), 1u) << to_text(path.errors());
    const Diagnostic& fault = path.errors()[0];
    EXPECT_EQ(fault.code, "S195");
    EXPECT_EQ(fault.file, "walk.json");
    EXPECT_EQ(fault.line, GetParam().line) << to_text(fault);
    EXPECT_NE(fault.message.find(GetParam().words), std::string::npos) << to_text(fault);
    EXPECT_FALSE(fault.help.empty()) << to_text(fault);
}

INSTANTIATE_TEST_SUITE_P(
    All, CameraPathFault,
    testing::Values(
        Fault{"NoVersion", "{\n\"keys\": [{ \"time\": 0, \"eye\": [0,0,0], \"at\": [0,0,1] }] }", 1,
              "\"version\""},
        Fault{"NoKeys", "{ \"version\": 1,\n\"keys\": [] }", 2, "no keys"},
        Fault{"List", "[]", 1, "type array"},
        Fault{"UnknownKey",
              "{ \"version\": 1, \"keys\": [\n{ \"time\": 0, \"eye\": [0,0,0], \"att\": 1, \"at\": [0,0,1] "
              "}] }",
              2, "\"att\""},
        Fault{"NoTarget", "{ \"version\": 1, \"keys\": [\n{ \"time\": 0, \"eye\": [0,0,0] }] }", 2,
              "\"at\" is missing"},
        Fault{"TwoNumbers",
              "{ \"version\": 1, \"keys\": [\n{ \"time\": 0, \"eye\": [0,0], \"at\": [0,0,1] }] }", 2,
              "2 numbers"},
        Fault{"TooFar",
              "{ \"version\": 1, \"keys\": [\n{ \"time\": 0, \"eye\": [0,1e10,0], \"at\": [0,0,1] }] }", 2,
              "out of range"},
        Fault{"WideView",
              "{ \"version\": 1, \"keys\": [\n{ \"time\": 0, \"eye\": [0,0,0], \"at\": [0,0,1], \"fovY\": "
              "180 }] }",
              2, "180"},
        Fault{"Backwards",
              "{ \"version\": 1, \"keys\": [{ \"time\": 1, \"eye\": [0,0,0], \"at\": [0,0,1] },\n{ \"time\": "
              "1, \"eye\": [0,0,0], \"at\": [0,0,1] }] }",
              2, "not after"},
        Fault{"NoDirection",
              "{ \"version\": 1, \"keys\": [\n{ \"time\": 0, \"eye\": [0,2,0], \"at\": [0,2,0] }] }", 2,
              "its own position"},
        Fault{"CutIsANumber",
              "{ \"version\": 1, \"keys\": [\n{ \"time\": 0, \"eye\": [0,0,0], \"at\": [0,0,1], \"cut\": 1 "
              "}] }",
              2, "true or false"}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace weft::scene
