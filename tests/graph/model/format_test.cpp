// Tests the names of formats in graphs.
#include <gtest/gtest.h>

#include <algorithm>

#include "weft/format.h"

namespace weft::test {
namespace {

TEST(Formats, GraphsNameOnlyFormatsOfImages) {
    const std::vector<std::string> names = format_names();
    for (const std::string& name : names) {
        const std::optional<Format> format = format_from_name(name);
        ASSERT_TRUE(format) << name;
        EXPECT_FALSE(format_info(*format).vertex_only) << name;
    }
    for (const Format format : {Format::rgb32f, Format::rgb32u, Format::rgb32i}) {
        const FormatInfo& info = format_info(format);
        EXPECT_TRUE(info.vertex_only);
        EXPECT_EQ(info.bytes_per_texel, 12);
        EXPECT_EQ(info.components, 3);
        EXPECT_FALSE(format_from_name(info.name)) << info.name;
        EXPECT_EQ(std::ranges::count(names, info.name), 0) << info.name;
    }
    EXPECT_FALSE(format_from_name("undefined"));
}

}  // namespace
}  // namespace weft::test
