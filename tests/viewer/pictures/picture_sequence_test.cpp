// Purpose: tests the names of the pictures of a sequence.
#include <gtest/gtest.h>

#include "viewer/pictures/picture_sequence.h"

namespace weft::viewer {
namespace {

using Names = std::vector<std::string>;

Names names(const std::string& pattern, uint32_t first, uint32_t last) {
    Result<Names> found = picture_sequence(pattern, first, last);
    EXPECT_TRUE(found) << pattern;
    return found ? std::move(*found) : Names{};
}

TEST(PictureSequence, WritesTheNumberOfTheFrameIntoTheName) {
    EXPECT_EQ(names("seq%04d.png", 9, 11), (Names{"seq0009.png", "seq0010.png", "seq0011.png"}));
    EXPECT_EQ(names("a/b%d-x.exr", 9, 10), (Names{"a/b9-x.exr", "a/b10-x.exr"}));
    EXPECT_EQ(names("%02d.pfm", 99, 101), (Names{"99.pfm", "100.pfm", "101.pfm"}));
    EXPECT_EQ(names("100%%-%d.png", 1, 1), (Names{"100%-1.png"}));
    EXPECT_EQ(names("one.png", 7, 7), (Names{"one.png"}));
}

TEST(PictureSequence, ANameWithoutTheNumberIsAFaultWithAProposal) {
    for (const char* pattern :
         {"seq.png", "%d%d.png", "%s%d.png", "%04x.png", "%0d.png", "%10d.png", "%", "a%4d.png"}) {
        const Result<Names> found = picture_sequence(pattern, 1, 2);
        ASSERT_FALSE(found) << pattern;
        EXPECT_EQ(found.errors()[0].code, "X524");
        EXPECT_FALSE(found.errors()[0].help.empty());
    }
    EXPECT_NE(picture_sequence("out/seq.png", 1, 2).errors()[0].help[0].find("-o out/seq%04d.png"),
              std::string::npos);
}

}  // namespace
}  // namespace weft::viewer
