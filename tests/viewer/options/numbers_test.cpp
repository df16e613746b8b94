// Tests the texts that the command line accepts as numbers.
#include "viewer/options/numbers.h"

#include <gtest/gtest.h>

namespace weft::viewer {
namespace {

TEST(Numbers, AreFiniteAndDecimal) {
    EXPECT_EQ(finite_number("-0.5"), -0.5);
    EXPECT_EQ(finite_number("+2e3"), 2000);
    EXPECT_EQ(finite_number("010"), 10);
    for (const char* text : {"nan", "-nan", "inf", "-inf", "infinity", "1e999", "1e-999", "0x1p1", " 1", "1 ",
                             "", "+", "-", "+-1", "1,5", "one", "1e"})
        EXPECT_FALSE(finite_number(text)) << text;
}

TEST(Numbers, MayBeFractionsWhereTheFlagSaysSo) {
    EXPECT_EQ(finite_fraction("1/60"), 1.0 / 60);
    EXPECT_EQ(finite_fraction("-3/2"), -1.5);
    EXPECT_EQ(finite_fraction("0.25"), 0.25);
    for (const char* text :
         {"1/0", "0/0", "nan/1", "1/inf", "1/2/3", "/2", "1/", "/", "1e300/1e-300", "1 / 2"})
        EXPECT_FALSE(finite_fraction(text)) << text;
    // decimal() must write enough digits that reading its text gives the same number again.
    EXPECT_EQ(finite_number(decimal(1.0 / 60)), 1.0 / 60);
}

TEST(Numbers, WholeOnesHaveNoSignAndNoFraction) {
    EXPECT_EQ(whole_number("4294967296"), 4294967296u);
    EXPECT_EQ(whole_number("007"), 7u);
    for (const char* text : {"-1", "+1", "1.0", "1e3", "0x10", "", " 1", "18446744073709551616", "nan"})
        EXPECT_FALSE(whole_number(text)) << text;
}

TEST(Numbers, FaultsNameTheRangeAndTheUnit) {
    const NumberRange range{0.001, 3600, "s"};
    EXPECT_EQ(number_fault("0.001", range), "");
    EXPECT_EQ(number_fault("3600", range), "");
    EXPECT_EQ(number_fault("nan", range), "\"nan\" is not a finite number; wanted 0.001 to 3600 s");
    EXPECT_EQ(number_fault("4000", range), "\"4000\" is out of range; wanted 0.001 to 3600 s");
    EXPECT_EQ(whole_number_fault("5", 1, 4), "\"5\" is not a whole number of 1 to 4");
}

}  // namespace
}  // namespace weft::viewer
