#include "graph/parse/expression.h"

#include <gtest/gtest.h>

#include <map>

#include "graph/parse/reference.h"
#include "graph/syntax/reference_name.h"

namespace weft::test {
namespace {

class TestNames : public ExprNames {
 public:
    std::optional<ExprValue> value(const std::string& name) const override {
        const auto it = values_.find(name);
        return it == values_.end() ? std::nullopt : std::optional(it->second);
    }
    std::optional<uint32_t> mips(const std::string& resource) const override {
        return resource == "hiz" ? std::optional(11u) : std::nullopt;
    }
    std::vector<std::string> known_names() const override { return {"output", "tile", "scale"}; }
    std::vector<std::string> known_resources() const override { return {"hiz"}; }

 private:
    std::map<std::string, ExprValue> values_{
        {"output", size_value(1280, 720)}, {"tile", number_value(16)}, {"scale", number_value(0.5)}};
};

Result<ExprValue> calculate(const std::string& text) {
    const SourceMap sources{{{"graph.json", ""}}};
    const Result<Expr> parsed =
        parse_expression({text, {0, 7, 3, static_cast<uint32_t>(text.size()) + 2}}, sources);
    if (!parsed) return parsed.errors();
    return evaluate(*parsed, TestNames{}, sources);
}

struct Sum {
    const char* text;
    ExprValue value;
};
class ValueTest : public ::testing::TestWithParam<Sum> {};

TEST_P(ValueTest, IsRight) {
    const Result<ExprValue> result = calculate(GetParam().text);
    ASSERT_TRUE(result.ok()) << to_text(result.errors());
    EXPECT_EQ(result->x, GetParam().value.x);
    EXPECT_EQ(result->y, GetParam().value.y);
    EXPECT_EQ(result->is_size, GetParam().value.is_size);
}

INSTANTIATE_TEST_SUITE_P(
    Expressions, ValueTest,
    ::testing::Values(
        Sum{"1 + 2 * 3", number_value(7)}, Sum{"(1 + 2) * 3", number_value(9)},
        Sum{"10 - 4 - 3", number_value(3)}, Sum{"2 * 7 % 4", number_value(2)}, Sum{"-7 % 4", number_value(1)},
        Sum{"--3", number_value(3)}, Sum{"2 * -3", number_value(-6)}, Sum{".5 + 1.25", number_value(1.75)},
        Sum{"ceil(output / tile)", size_value(80, 45)}, Sum{"ceil(output * scale)", size_value(640, 360)},
        Sum{"output.x / output.y * 9", number_value(16)}, Sum{"(output / 2).y", number_value(360)},
        Sum{"min(output, 1000)", size_value(1000, 720)}, Sum{"max(1, 5, 3)", number_value(5)},
        Sum{"log2(8) + floor(1.9)", number_value(4)}, Sum{"mips(hiz) - 1", number_value(10)},
        Sum{"output - output", size_value(0, 0)}));

struct BadSum {
    const char* text;
    const char* code;
    // Column of the error within the text of the expression; the first column is 1.
    uint32_t column;
    const char* message;
};
class BadExpressionTest : public ::testing::TestWithParam<BadSum> {};

TEST_P(BadExpressionTest, IsShownAtTheToken) {
    const Result<ExprValue> result = calculate(GetParam().text);
    ASSERT_FALSE(result.ok());
    const Diagnostic& error = result.errors().front();
    EXPECT_EQ(error.code, GetParam().code);
    EXPECT_EQ(error.line, 7u);
    EXPECT_FALSE(error.help.empty());
    // The expression begins after the opening quote, which is in column 3 of the file.
    EXPECT_EQ(error.column, GetParam().column + 3) << to_text(error);
    EXPECT_NE(error.message.find(GetParam().message), std::string::npos) << to_text(error);
}

INSTANTIATE_TEST_SUITE_P(
    Expressions, BadExpressionTest,
    ::testing::Values(
        BadSum{"", "W106", 1, "ends where a number"}, BadSum{"1 +", "W106", 4, "ends where"},
        BadSum{"1 + * 2", "W106", 5, "found '*'"}, BadSum{"(1 + 2", "W106", 7, "ends where ')'"},
        BadSum{"1 2", "W106", 3, "found '2' where an operator"},
        BadSum{"tile.z", "W106", 5, "without x or y"}, BadSum{"tile.x", "W106", 5, "no .x and .y"},
        BadSum{"1 / 0", "W106", 3, "division by zero"}, BadSum{"5 % (1 - 1)", "W106", 3, "division by zero"},
        BadSum{"log2(0)", "W106", 1, "not positive"}, BadSum{"ciel(1.5)", "W106", 1, "unknown function"},
        BadSum{"min(1)", "W106", 1, "takes 2 to 16 arguments, found 1"},
        BadSum{"ceil(1, 2)", "W106", 1, "takes one argument"}, BadSum{"mips(1)", "W106", 6, "found '1'"},
        BadSum{"2tile", "W106", 1, "cannot begin with a digit"},
        BadSum{"1 + tyle * 2", "W107", 5, "unknown name \"tyle\""},
        BadSum{"mips(hix)", "W107", 6, "unknown image \"hix\""}, BadSum{"a^b", "W106", 2, "found '^'"}));

TEST(Expression, UnknownNamesAreAllReportedAndNearOnesSuggested) {
    const Result<ExprValue> result = calculate("outptu / tiel");
    ASSERT_FALSE(result.ok());
    ASSERT_EQ(result.errors().size(), 2u);
    EXPECT_EQ(result.errors()[0].help.at(0), "did you mean \"output\"?");
    EXPECT_EQ(result.errors()[1].help.at(0), "did you mean \"tile\"?");
    EXPECT_EQ(result.errors()[1].length, 4u);
}

TEST(Expression, LengthAndDepthAreLimited) {
    std::string sum = "1";
    for (int i = 0; i < 511; ++i) sum += "+1";
    EXPECT_TRUE(calculate(sum).ok());
    EXPECT_FALSE(calculate(sum + "+1+1").ok());
    EXPECT_FALSE(calculate(std::string(100'000, '(')).ok());
    EXPECT_FALSE(calculate(std::string(100'000, '-') + "1").ok());
    EXPECT_FALSE(calculate("9" + std::string(400, '9')).ok());
}

TEST(Expression, ResultsAreFinite) {
    std::string big = "1" + std::string(300, '0');
    EXPECT_EQ(calculate(big + " * " + big).errors().front().code, "W106");
}

Result<RefDesc> refer(const std::string& text) {
    const SourceMap sources{{{"graph.json", ""}}};
    return parse_reference({text, {0, 7, 3, static_cast<uint32_t>(text.size()) + 2}}, sources);
}

TEST(Reference, AllPartsAreRead) {
    const Result<RefDesc> ref = refer("hiz@build.mip(i - 1..mips(hiz)-1).layer(2).depth");
    ASSERT_TRUE(ref.ok()) << to_text(ref.errors());
    EXPECT_EQ(ref->name, "hiz");
    EXPECT_EQ(ref->pass, "build");
    EXPECT_EQ(ref->mip_first->text, "i - 1");
    EXPECT_EQ(ref->mip_last->text, "mips(hiz)-1");
    EXPECT_EQ(ref->mip_last->loc.column, 3u + 1 + 21);
    EXPECT_EQ(ref->layer_first->text, "2");
    EXPECT_FALSE(ref->layer_last.has_value());
    EXPECT_EQ(ref->aspects, aspect::kDepth);
    EXPECT_EQ(refer("hiz.mip(0..3)")->mip_last->postfix.front().number, 3);
    EXPECT_EQ(refer("ssrAcc[-1]")->history, 1u);
    EXPECT_EQ(refer("shadow.stencil")->aspects, aspect::kStencil);
    EXPECT_EQ(reference_name("hiz@a.mip(0)"), "hiz");
}

TEST(Reference, NeedsNoFile) {
    const SourceMap none;
    EXPECT_TRUE(parse_reference({"hdr.mip(1)", {}}, none).ok());
    EXPECT_FALSE(parse_reference({"hdr.", {}}, none).ok());
}

class BadReferenceTest : public ::testing::TestWithParam<BadSum> {};

TEST_P(BadReferenceTest, IsShownAtTheCharacter) {
    const Result<RefDesc> result = refer(GetParam().text);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.errors().front().code, GetParam().code);
    EXPECT_EQ(result.errors().front().column, GetParam().column + 3) << to_text(result.errors());
    EXPECT_NE(result.errors().front().message.find(GetParam().message), std::string::npos)
        << to_text(result.errors());
}

INSTANTIATE_TEST_SUITE_P(
    References, BadReferenceTest,
    ::testing::Values(
        BadSum{"", "W106", 1, "name of a resource"}, BadSum{"2d", "W106", 1, "name of a resource"},
        BadSum{"a@", "W106", 3, "name of a pass"}, BadSum{"a@b@c", "W106", 4, "two passes"},
        BadSum{"a b", "W106", 2, "found ' '"}, BadSum{"a[1]", "W106", 2, "earlier frame"},
        BadSum{"a[-0]", "W106", 4, "1 to 16"}, BadSum{"a[-1", "W106", 5, "ends where ']'"},
        BadSum{"a.mpi(0)", "W106", 3, "unknown selector"}, BadSum{"a.mip", "W106", 6, "ends where '('"},
        BadSum{"a.mip(0", "W106", 8, "ends where ')'"}, BadSum{"a.mip()", "W106", 7, "found ')'"},
        BadSum{"a.mip(0..)", "W106", 10, "found ')'"}, BadSum{"a.mip(0).mip(1)", "W106", 10, ".mip() twice"},
        BadSum{"a.depth.stencil", "W106", 9, "two aspects"}, BadSum{"a.mip(1 + )", "W106", 11, "found ')'"}));

}  // namespace
}  // namespace weft::test
