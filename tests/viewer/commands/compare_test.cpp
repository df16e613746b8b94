// Tests `weft compare`: its numbers and limits, the picture formats, and damaged or too large pictures.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/viewer/pictures/picture_files.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

using Json = nlohmann::json;
constexpr uint32_t kWidth_px = 13, kHeight_px = 9;

// Returns a picture with random 8-bit values, 0 to 255.
std::vector<Texel> noise(uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<Texel> texels(size_t{kWidth_px} * kHeight_px);
    for (Texel& texel : texels)
        for (float& value : texel) value = static_cast<float>(random() % 256);
    return texels;
}

std::vector<Texel> map_values(std::vector<Texel> texels, float (*function)(float)) {
    for (Texel& texel : texels)
        for (float& value : texel) value = function(value);
    return texels;
}

// Converts an 8-bit sRGB value, 0 to 255, to a linear value, 0 to 1.
float to_linear(float step) {
    const float v = step / 255;
    return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

class Compare : public testing::Test {
 protected:
    Compare() {
        scratch_.write("a.png", png_file(kWidth_px, kHeight_px, noise(1)));
        scratch_.write("b.png", png_file(kWidth_px, kHeight_px, noise(2)));
    }

    [[nodiscard]] RunResult compare(const std::string& a, const std::string& b,
                                    const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"compare", a, b};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_weft(arguments, {}, scratch_.path());
    }

    void write_raw(const std::string& name, std::vector<Texel> texels) const {
        const auto file = name.ends_with(".exr") ? exr_file(kWidth_px, kHeight_px, texels)
                                                 : pfm_file(kWidth_px, kHeight_px, texels);
        scratch_.write(name, file);
    }

    // Expects exit code 3, an error with this code and a help text, and no data on stdout.
    void expect_refused(const std::string& a, const std::string& b, const std::string& code,
                        const std::vector<std::string>& more = {}) const {
        const RunResult run = compare(a, b, more);
        EXPECT_EQ(run.exit_code, 3) << run.text();
        EXPECT_NE(run.err.find("error[" + code + "]"), std::string::npos) << run.text();
        EXPECT_NE(run.err.find("help: "), std::string::npos) << run.text();
        EXPECT_TRUE(run.out.empty()) << run.text();
    }

    ScratchFolder scratch_;
};

TEST_F(Compare, TheSamePictureHasNoDifference) {
    EXPECT_EQ(compare("a.png", "a.png").out, "0\n");
    EXPECT_EQ(compare("a.png", "a.png", {"--metric", "psnr"}).out, "inf\n");
    EXPECT_EQ(compare("a.png", "a.png", {"--metric", "max"}).out, "0\n");
    EXPECT_EQ(compare("a.png", "a.png", {"--max", "0"}).exit_code, 0);
    EXPECT_EQ(compare("a.png", "a.png", {"--metric", "psnr", "--min", "1000"}).exit_code, 0);
}

TEST_F(Compare, ALimitDecidesTheExitCode) {
    const double flip = std::stod(compare("a.png", "b.png").out);
    EXPECT_GT(flip, 0.05);
    EXPECT_LT(flip, 1);
    EXPECT_EQ(compare("a.png", "b.png", {"--max", std::to_string(flip + 0.001)}).exit_code, 0);
    const RunResult over = compare("a.png", "b.png", {"--max", std::to_string(flip - 0.001)});
    EXPECT_EQ(over.exit_code, 6) << over.text();
    EXPECT_EQ(std::stod(over.out), flip);
    EXPECT_NE(over.err.find("b.png differs too much from a.png"), std::string::npos) << over.text();

    const double psnr = std::stod(compare("a.png", "b.png", {"--metric", "psnr"}).out);
    EXPECT_EQ(compare("a.png", "b.png", {"--metric", "psnr", "--min", std::to_string(psnr - 0.1)}).exit_code,
              0);
    EXPECT_EQ(compare("a.png", "b.png", {"--metric", "psnr", "--min", std::to_string(psnr + 0.1)}).exit_code,
              6);
    EXPECT_EQ(compare("a.png", "b.png", {"--metric", "max", "--max", "255"}).exit_code, 0);
    EXPECT_EQ(compare("a.png", "b.png", {"--metric", "max", "--max", "100"}).exit_code, 6);
}

TEST_F(Compare, JsonHoldsTheNumbersAndTheVerdict) {
    const Json flip = Json::parse(compare("a.png", "b.png", {"--json"}).out);
    EXPECT_EQ(flip.at("metric"), "flip");
    EXPECT_EQ(flip.at("value"), flip.at("mean"));
    EXPECT_LE(flip.at("median"), flip.at("max"));
    EXPECT_EQ(flip.at("weighted_quartiles").size(), 3u);
    EXPECT_EQ(flip.at("width"), kWidth_px);
    EXPECT_EQ(flip.at("height"), kHeight_px);
    EXPECT_TRUE(flip.at("limit").is_null());
    EXPECT_TRUE(flip.at("passed").is_null());
    const RunResult over = compare("a.png", "b.png", {"--json", "--max", "0.01"});
    EXPECT_EQ(over.exit_code, 6) << over.text();
    EXPECT_EQ(Json::parse(over.out).at("passed"), false);
    EXPECT_EQ(Json::parse(over.out).at("limit"), 0.01);
    const Json psnr =
        Json::parse(compare("a.png", "a.png", {"--json", "--metric", "psnr", "--min", "9"}).out);
    EXPECT_TRUE(psnr.at("value").is_null()) << "JSON has no infinity";
    EXPECT_EQ(psnr.at("unit"), "dB");
    EXPECT_EQ(psnr.at("passed"), true);
}

TEST_F(Compare, PsnrAndMaxAreSymmetric) {
    for (const char* metric : {"psnr", "max"})
        EXPECT_EQ(compare("a.png", "b.png", {"--metric", metric}).out,
                  compare("b.png", "a.png", {"--metric", metric}).out);
}

TEST_F(Compare, TheHeatMapHasThePicturesSize) {
    for (const char* metric : {"flip", "psnr", "max"}) {
        const RunResult run = compare("a.png", "b.png", {"--metric", metric, "-o", "heat.png"});
        EXPECT_EQ(run.exit_code, 0) << run.text();
        const Json heat = Json::parse(compare("heat.png", "heat.png", {"--json"}).out);
        EXPECT_EQ(heat.at("width"), kWidth_px);
        EXPECT_EQ(heat.at("height"), kHeight_px);
    }
    // The heat map is written even if the difference exceeds the limit. Its darkest colour means no
    // difference; in 8-bit RGB this colour is (0, 0, 4).
    EXPECT_EQ(compare("a.png", "b.png", {"--max", "0", "--output", "over.png"}).exit_code, 6);
    EXPECT_EQ(compare("over.png", "over.png").exit_code, 0);
    EXPECT_EQ(compare("a.png", "a.png", {"-o", "none.png"}).exit_code, 0);
    scratch_.write("dark.png", png_file(kWidth_px, kHeight_px,
                                        std::vector<Texel>(size_t{kWidth_px} * kHeight_px, {0, 0, 4})));
    EXPECT_EQ(compare("none.png", "dark.png", {"--metric", "max"}).out, "0\n");
    const RunResult nowhere = compare("a.png", "b.png", {"-o", "no/folder/heat.png"});
    EXPECT_EQ(nowhere.exit_code, 1) << nowhere.text();
    EXPECT_NE(nowhere.err.find("error[X510]"), std::string::npos) << nowhere.text();
}

TEST_F(Compare, ReadsRawPicturesOfAllKinds) {
    const auto raw = map_values(noise(1), [](float v) { return v * 7.25f - 300; });
    write_raw("a.exr", raw);
    write_raw("a.pfm", raw);
    scratch_.write("big.pfm", pfm_file(kWidth_px, kHeight_px, raw, /*big_endian=*/true));
    auto off = raw;
    off[20][1] += 2.5f;
    write_raw("off.exr", off);
    EXPECT_EQ(compare("a.exr", "a.pfm", {"--metric", "max"}).out, "0\n");
    EXPECT_EQ(compare("big.pfm", "a.pfm", {"--metric", "max"}).out, "0\n");
    EXPECT_EQ(compare("off.exr", "a.pfm", {"--metric", "max"}).out, "2.5\n");
    scratch_.write("grey.pfm", std::string("Pf\n1 1\n-1\n\0\0\x80\x3f", 15));
    scratch_.write("white.pfm", pfm_file(1, 1, std::vector<Texel>{{1, 1, 1}}));
    EXPECT_EQ(compare("grey.pfm", "white.pfm", {"--metric", "max"}).out, "0\n");
}

// All pictures here have the same colours as a.png. linear.exr and linear.pfm store linear values, so
// `weft compare` must encode them as sRGB first. png.exr is a PNG file: the content of a file determines its
// format, not its name.
TEST_F(Compare, EncodesRawPicturesToCompareThemWithDisplayValues) {
    write_raw("linear.exr", map_values(noise(1), to_linear));
    write_raw("linear.pfm", map_values(noise(1), to_linear));
    scratch_.write("png.exr", png_file(kWidth_px, kHeight_px, noise(1)));
    for (const char* other : {"linear.exr", "linear.pfm", "png.exr"}) {
        EXPECT_EQ(compare("a.png", other, {"--metric", "max"}).out, "0\n") << other;
        EXPECT_EQ(compare("a.png", other, {"--metric", "psnr"}).out, "inf\n") << other;
        EXPECT_EQ(compare("a.png", other, {"--max", "1e-3"}).exit_code, 0) << other;
    }
}

TEST_F(Compare, NamesEveryPictureThatItCannotRead) {
    const RunResult run = compare("gone.png", "missing.exr");
    EXPECT_EQ(run.exit_code, 3) << run.text();
    for (const char* part : {"gone.png: error[X530]", "missing.exr: error[X530]", "help: "})
        EXPECT_NE(run.err.find(part), std::string::npos) << run.text();
    scratch_.write("text.png", "hello");
    scratch_.write("empty.png", "");
    expect_refused("text.png", "a.png", "X530");
    expect_refused("a.png", "empty.png", "X530");
    expect_refused("a.png", ".", "X530");
}

TEST_F(Compare, RefusesPicturesOfTwoSizes) {
    scratch_.write("small.png", png_file(1, 1, std::vector<Texel>{{1, 2, 3}}));
    expect_refused("a.png", "small.png", "X532");
    EXPECT_NE(compare("a.png", "small.png").err.find("1x1, but the size of a.png is 13x9"),
              std::string::npos);
}

TEST_F(Compare, RefusesTexelsThatAreNoNumbersUnlessRawOnesAreCompared) {
    auto raw = map_values(noise(1), to_linear);
    raw[2 * kWidth_px + 5][1] = std::numeric_limits<float>::quiet_NaN();
    write_raw("nan.pfm", raw);
    write_raw("nan.exr", raw);
    expect_refused("a.png", "nan.pfm", "X533");
    expect_refused("nan.exr", "nan.pfm", "X533", {"--metric", "psnr"});
    EXPECT_NE(compare("a.png", "nan.exr").err.find("texel (5, 2)"), std::string::npos);
    EXPECT_EQ(compare("nan.exr", "nan.pfm", {"--metric", "max"}).out, "0\n");
    write_raw("good.pfm", map_values(noise(1), to_linear));
    EXPECT_EQ(compare("nan.exr", "good.pfm", {"--metric", "max"}).out, "inf\n");
    EXPECT_EQ(compare("nan.exr", "good.pfm", {"--metric", "max", "--max", "1e30"}).exit_code, 6);
}

// `weft compare` must check the size in a file's header before it allocates memory for that size.
TEST_F(Compare, RefusesHugePicturesByTheirHeaders) {
    const std::vector<Texel> one{{0, 0, 0}};
    scratch_.write("wide.png", png_file(16385, 1, one));
    scratch_.write("all.png", png_file(16384, 16384, one));
    scratch_.write("wide.pfm", "PF\n16385 1\n-1.0\n");
    scratch_.write("overflow.pfm", "PF\n4294967297 4294967297\n-1.0\n");
    scratch_.write("negative.pfm", "PF\n-5 5\n-1.0\n");
    std::string exr = exr_file(1, 1, one);
    // Start of the value of the attribute dataWindow, after "box2i", a zero byte and the 4-byte size. The
    // value has the four 32-bit integers xMin, yMin, xMax and yMax.
    const size_t window = exr.find("box2i") + 6 + 4;
    exr.replace(window + 8, 8, "\xff\xff\xff\x7e\xff\xff\xff\x7e");
    scratch_.write("huge.exr", exr);
    for (const char* name : {"wide.png", "all.png", "wide.pfm", "overflow.pfm", "negative.pfm", "huge.exr"}) {
        const RunResult run = compare(name, "a.png");
        EXPECT_EQ(run.exit_code, 3) << run.text();
        EXPECT_NE(run.err.find("error[X531]"), std::string::npos) << run.text();
        EXPECT_LT(run.max_rss_bytes, 100u << 20) << name;
    }
}

// The memory limit covers all memory of a comparison: files, pictures, and maps of differences.
TEST_F(Compare, TakesNoMoreMemoryThanTheLimitSays) {
    const auto black = [&](const char* name, const std::string& size, uint64_t texels) {
        scratch_.write(name, "PF\n" + size + "\n-1.0\n");
        const std::filesystem::path file = scratch_.path() / name;
        std::filesystem::resize_file(file,
                                     // Adds three zero floats per texel. The file is sparse, so it uses
                                     // no disk space for them.
                                     std::filesystem::file_size(file) + texels * 12);
    };
    black("more.pfm", "8192 4096", uint64_t{8192} * 4096);
    const RunResult refused = compare("more.pfm", "more.pfm");
    EXPECT_EQ(refused.exit_code, 3) << refused.text();
    EXPECT_NE(refused.err.find("raise picture.memoryBytes with --limits"), std::string::npos)
        << refused.text();
    black("most.pfm", "4096 2048", uint64_t{4096} * 2048);
    for (const char* metric : {"flip", "psnr", "max"}) {
        // FLIP takes seconds for a picture of this size.
        if (!extended() && std::string(metric) == "flip") continue;
        const RunResult run = compare("most.pfm", "most.pfm", {"--metric", metric});
        EXPECT_EQ(run.exit_code, 0) << run.text();
        EXPECT_LE(run.max_rss_bytes, uint64_t{768} << 20) << metric;
    }
}

TEST_F(Compare, RefusesPicturesThatAreCutShort) {
    const auto raw = map_values(noise(1), to_linear);
    const std::string pfm = pfm_file(kWidth_px, kHeight_px, raw), exr = exr_file(kWidth_px, kHeight_px, raw),
                      png = read_text(scratch_.path() / "a.png");
    for (const std::string* whole : {&pfm, &exr, &png})
        for (const size_t length : {size_t{4}, size_t{9}, size_t{30}, whole->size() / 2}) {
            scratch_.write("cut", whole->substr(0, length));
            expect_refused("cut", "a.png", "X530");
        }
    std::string garbled = png;
    garbled.replace(12, 4, "\x80\x1b[m");
    scratch_.write("garbled.png", garbled);
    expect_refused("garbled.png", "a.png", "X530");
    EXPECT_EQ(compare("garbled.png", "a.png").err.find('\x1b'), std::string::npos);
    for (const char* header : {"PF\n13 9\n0\n", "PF\nx 9\n-1\n", "PF\n13 9\nnan\n", "PF 13"}) {
        scratch_.write("bad.pfm", header);
        expect_refused("bad.pfm", "a.png", "X530");
    }
}

TEST_F(Compare, AgreesWithImageMagickOnPsnr) {
    const auto output_of = [](const std::string& command) {
        std::string text;
        FILE* pipe = popen((command + " 2>&1").c_str(), "r");
        for (int c = pipe ? std::fgetc(pipe) : EOF; c != EOF; c = std::fgetc(pipe))
            text += static_cast<char>(c);
        if (pipe) pclose(pipe);
        return text;
    };
    if (output_of("compare -version").find("ImageMagick") == std::string::npos)
        GTEST_SKIP() << "ImageMagick's compare is not there (apt-get install imagemagick)";
    const std::string theirs =
        output_of("compare -metric PSNR '" + (scratch_ / "a.png") + "' '" + (scratch_ / "b.png") + "' null:");
    const RunResult ours = compare("a.png", "b.png", {"--metric", "psnr"});
    EXPECT_NEAR(std::stod(ours.out), std::strtod(theirs.c_str(), nullptr), 0.01) << theirs;
}

// `weft compare` must read all picture formats that `weft render` writes.
TEST_F(Compare, ReadsWhatRenderWrites) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    for (const char* name : {"r.png", "r.exr", "r.pfm"}) {
        const RunResult run =
            run_weft({"render", "builtin:spheres", "--size", "64x40", "-o", name}, {}, scratch_.path());
        ASSERT_EQ(run.exit_code, 0) << run.text();
    }
    EXPECT_EQ(compare("r.exr", "r.pfm", {"--metric", "max"}).out, "0\n");
    EXPECT_EQ(compare("r.png", "r.png", {"--max", "0"}).exit_code, 0);
}

}  // namespace
}  // namespace weft::test
