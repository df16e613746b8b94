// Purpose: tests the interpolation of animations and the transforms of moving nodes, against known values and
// against a reference in double precision that multiplies the matrices of each node's whole chain.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>

#include "weft/scene/motion.h"

namespace weft::scene {
namespace {

constexpr float kHalf = 0.70710678f;

MotionSampler ramp(Interpolation interpolation) {
    return {interpolation, false, {1, 3}, {{0, 10, 0, 0}, {4, 30, -8, 0}}};
}

void expect_close(const glm::vec4& found, const glm::vec4& wanted, float tolerance = 1e-5f) {
    EXPECT_LE(glm::length(found - wanted), tolerance)
        << found.x << " " << found.y << " " << found.z << " " << found.w;
}

TEST(Motion, LinearMixesBetweenTheKeysAndHoldsTheEnds) {
    const MotionSampler sampler = ramp(Interpolation::linear);
    expect_close(value_at(sampler, 0), {0, 10, 0, 0});
    expect_close(value_at(sampler, 1), {0, 10, 0, 0});
    expect_close(value_at(sampler, 1.5), {1, 15, -2, 0});
    expect_close(value_at(sampler, 3), {4, 30, -8, 0});
    expect_close(value_at(sampler, 99), {4, 30, -8, 0});
}

TEST(Motion, StepHoldsEachKey) {
    const MotionSampler sampler = ramp(Interpolation::step);
    expect_close(value_at(sampler, 2.999), {0, 10, 0, 0});
    expect_close(value_at(sampler, 3), {4, 30, -8, 0});
}

// A rotation about z by `degrees`.
glm::vec4 about_z(double degrees) {
    const double half = degrees * std::acos(-1.0) / 360;
    return {0, 0, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half))};
}

TEST(Motion, LinearRotationsTurnEvenlyOnTheShorterWay) {
    MotionSampler sampler{Interpolation::linear, true, {0, 1}, {about_z(0), about_z(90)}};
    expect_close(value_at(sampler, 1.0 / 3), about_z(30));
    expect_close(value_at(sampler, 0.5), about_z(45));
    // The same rotation with the opposite sign: the way must not become 270 degrees.
    sampler.values[1] = -sampler.values[1];
    const glm::vec4 half = value_at(sampler, 0.5);
    expect_close(half * (half.w < 0 ? -1.0f : 1.0f), about_z(45));
}

TEST(Motion, SlerpAgreesWithAReferenceInDouble) {
    std::mt19937 random(7);
    std::normal_distribution<float> normal;
    for (int i = 0; i < 200; ++i) {
        const auto any = [&] {
            return glm::normalize(glm::vec4(normal(random), normal(random), normal(random), normal(random)));
        };
        MotionSampler sampler{Interpolation::linear, true, {2, 4}, {any(), any()}};
        const glm::dvec4 from = sampler.values[0];
        glm::dvec4 to = sampler.values[1];
        if (glm::dot(from, to) < 0) to = -to;
        const double angle = std::acos(std::min(1.0, glm::dot(from, to)));
        const double u = 0.25;
        const glm::dvec4 wanted = (std::sin((1 - u) * angle) * from + std::sin(u * angle) * to) / std::sin(angle);
        expect_close(value_at(sampler, 2.5), glm::vec4(glm::normalize(wanted)), 2e-5f);
    }
}

TEST(Motion, CubicSplinesUseTheirTangentsPerSecond) {
    // Keys at 1 s and 3 s. The polynomial x(t) = t³ − t has these values and derivatives, so the spline is
    // the polynomial itself.
    const auto x = [](double t) { return t * t * t - t; };
    const auto slope = [](double t) { return 3 * t * t - 1; };
    const auto key = [](double v) { return glm::vec4(static_cast<float>(v), 0, 0, 0); };
    const MotionSampler sampler{
        Interpolation::cubic_spline,
        false,
        {1, 3},
        {key(77), key(x(1)), key(slope(1)), key(slope(3)), key(x(3)), key(88)}};
    for (const double t : {1.0, 1.25, 2.0, 2.9, 3.0}) EXPECT_NEAR(value_at(sampler, t).x, x(t), 1e-4) << t;
    EXPECT_NEAR(value_at(sampler, 0).x, 0, 1e-5) << "before the first key";
    EXPECT_NEAR(value_at(sampler, 5).x, 24, 1e-5) << "after the last key";
}

TEST(Motion, CubicRotationsHaveLengthOne) {
    const glm::vec4 none(0);
    const MotionSampler sampler{Interpolation::cubic_spline,
                                true,
                                {0, 1},
                                {none, about_z(0), none, none, about_z(90), none}};
    const glm::vec4 half = value_at(sampler, 0.5);
    EXPECT_NEAR(glm::length(half), 1, 1e-6);
    expect_close(half, about_z(45));
    const MotionSampler nothing{Interpolation::step, true, {0}, {none}};
    expect_close(value_at(nothing, 0), {0, 0, 0, 1});
}

TEST(Motion, AnAnimationRepeatsWithItsLongestChannel) {
    Motion motion;
    motion.nodes = {{}, {}};
    Animation animation;
    animation.length_s = 4;
    animation.samplers = {{Interpolation::linear, false, {0, 4}, {glm::vec4(0), glm::vec4(8, 0, 0, 0)}},
                          {Interpolation::linear, false, {0, 1}, {glm::vec4(0), glm::vec4(0, 5, 0, 0)}}};
    animation.channels = {{0, MotionPath::translation, 0}, {1, MotionPath::translation, 1}};
    motion.animations = {animation};
    const auto place = [&](double t, size_t node) { return glm::vec3(transforms_at(motion, t)[node][3]); };
    EXPECT_EQ(place(3, 0), glm::vec3(6, 0, 0));
    EXPECT_EQ(place(3, 1), glm::vec3(0, 5, 0)) << "the shorter channel holds its last key";
    EXPECT_EQ(place(4, 0), glm::vec3(0)) << "the end is the begin of the next repetition";
    EXPECT_EQ(place(4.5, 0), glm::vec3(1, 0, 0));
    EXPECT_EQ(place(4.5, 1), glm::vec3(0, 2.5f, 0));
    EXPECT_EQ(place(-1, 0), glm::vec3(6, 0, 0));
    EXPECT_EQ(place(std::numeric_limits<double>::infinity(), 0), glm::vec3(0));
}

glm::dmat4 local_of(const MovingNode& node, const std::vector<glm::vec4>& parts) {
    const glm::dquat turn(parts[1].w, parts[1].x, parts[1].y, parts[1].z);
    return glm::dmat4(node.before) * glm::translate(glm::dmat4(1), glm::dvec3(parts[0])) *
           glm::mat4_cast(glm::normalize(turn)) * glm::scale(glm::dmat4(1), glm::dvec3(parts[2]));
}

TEST(Motion, ChildrenFollowTheirParents) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> any(-1, 1);
    Motion motion;
    motion.animations.resize(1);
    motion.animations[0].length_s = 10;
    std::vector<std::vector<glm::vec4>> parts;
    for (uint32_t i = 0; i < 40; ++i) {
        MovingNode node;
        if (i > 0 && i % 7 != 0) node.parent = std::uniform_int_distribution<uint32_t>(0, i - 1)(random);
        node.before = glm::translate(glm::mat4(1), {any(random), any(random), any(random)});
        motion.nodes.push_back(node);
        parts.push_back({});
        for (int path = 0; path < 3; ++path) {
            glm::vec4 value(any(random), any(random), any(random), any(random));
            if (path == 1) value = glm::normalize(value);
            Animation& animation = motion.animations[0];
            animation.channels.push_back({i, static_cast<MotionPath>(path),
                                          static_cast<uint32_t>(animation.samplers.size())});
            animation.samplers.push_back({Interpolation::step, path == 1, {0}, {value}});
            parts.back().push_back(value);
        }
    }
    const std::vector<glm::mat4> found = transforms_at(motion, 3);
    for (uint32_t i = 0; i < motion.nodes.size(); ++i) {
        glm::dmat4 wanted(1);
        for (uint32_t n = i; n != kNone; n = motion.nodes[n].parent)
            wanted = local_of(motion.nodes[n], parts[n]) * wanted;
        for (int column = 0; column < 4; ++column)
            expect_close(found[i][column], glm::vec4(wanted[column]), 1e-4f);
    }
}

TEST(Motion, ATransformThatOverflowsMakesTheNodeInvisible) {
    Motion motion;
    motion.nodes.resize(2);
    motion.nodes[0].scale = glm::vec3(1e14f);
    motion.nodes[1].parent = 0;
    motion.nodes[1].scale = glm::vec3(1e14f);
    const std::vector<glm::mat4> found = transforms_at(motion, 0);
    EXPECT_EQ(found[0][0].x, 1e14f);
    EXPECT_EQ(found[1] * glm::vec4(3, 4, 5, 1), glm::vec4(0, 0, 0, 1));
}

}  // namespace
}  // namespace weft::scene
