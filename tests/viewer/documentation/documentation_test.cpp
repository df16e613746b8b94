// Tests statements in README.md and docs/: quoted messages of the program, the table of shader members, the
// line counts of the gallery, and the example with several queues. These tests need no Vulkan device.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "tests/viewer/gltf_file.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

const std::filesystem::path kRoot = WEFT_SOURCE_DIR;

// A fenced block of a Markdown page. `comment` is the line directly before the block, and `line` is the
// number of the line that opens the block; the first line is 1.
struct Fence {
    std::string page, comment, text;
    size_t line = 0;
};

std::vector<std::filesystem::path> pages() {
    std::vector<std::filesystem::path> found{kRoot / "README.md"};
    for (const auto& entry : std::filesystem::directory_iterator(kRoot / "docs"))
        if (entry.path().extension() == ".md") found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
}

std::vector<Fence> fences_of(const std::filesystem::path& page) {
    std::vector<Fence> fences;
    std::istringstream lines(read_text(page));
    std::string before;
    bool inside = false;
    size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.starts_with("```")) {
            if (!inside) fences.push_back({page.filename().string(), before, "", number});
            inside = !inside;
        } else if (inside) {
            fences.back().text += line + "\n";
        }
        before = line;
    }
    return fences;
}

// Checks a quoted message. The comment "<!-- message of FILE, OLD becomes NEW -->" stands before the quote.
// The program must print the quoted text for a copy of FILE in which OLD is replaced by NEW.
void expect_quote(const Fence& fence) {
    static const std::regex form("<!-- message of ([^,]+), (.+) becomes (.+) -->");
    std::smatch parts;
    ASSERT_TRUE(std::regex_match(fence.comment, parts, form))
        << "a quoted message needs a comment before it: <!-- message of FILE, OLD becomes NEW -->";
    const std::filesystem::path file = kRoot / parts[1].str();
    const ScratchFolder folder;
    std::filesystem::copy(file.parent_path(), folder.path(), std::filesystem::copy_options::recursive);
    folder.write(file.filename().string(), replaced(read_text(file), parts[2], parts[3]));
    const RunResult run = run_weft({"check", file.filename().string()}, {}, folder.path());
    EXPECT_NE(run.err.find(fence.text), std::string::npos) << "it says\n" << run.err;
}

// The tutorial is left out here, because tutorial_vk_test.cpp follows its steps and compares its messages.
TEST(Documentation, QuotedMessagesAreWhatTheProgramPrints) {
    static const std::regex message(R"((error|warning)\[[A-Z]\d{3}\]:)");
    size_t quoted = 0;
    for (const std::filesystem::path& page : pages()) {
        if (page.filename() == "tutorial.md") continue;
        for (const Fence& fence : fences_of(page)) {
            if (!std::regex_search(fence.text, message)) continue;
            SCOPED_TRACE(fence.page + ":" + std::to_string(fence.line));
            expect_quote(fence);
            ++quoted;
        }
    }
    EXPECT_GE(quoted, 2u);
}

// Returns the type, such as "vec4[9]", of each member of a struct that C++ and GLSL share. Members whose
// names begin with "reserved" are left out.
std::map<std::string, std::string> members_of(const std::string& file, const std::string& name) {
    const std::string text = read_text(kRoot / "shaders/include/shared" / file);
    const size_t begin = text.find("struct " + name + " {"), end = text.find("};", begin);
    EXPECT_NE(begin, std::string::npos) << name;
    static const std::regex member(R"(^\s+(\w+) (\w+)(\[\d+\])?;)");
    std::map<std::string, std::string> members;
    std::istringstream lines(text.substr(begin, end - begin));
    for (std::string line; std::getline(lines, line);) {
        std::smatch parts;
        if (std::regex_search(line, parts, member) && !parts[2].str().starts_with("reserved"))
            members[parts[2]] = parts[1].str() + parts[3].str();
    }
    return members;
}

TEST(Documentation, EveryMemberOfTheSetsHasARow) {
    const std::string page = read_text(kRoot / "docs/shaders.md");
    static const std::regex row(R"(\n\| `(frame|view|material|instance|bounds|mesh)\.(\w+)` \| `([^`]+)` \|)");
    std::map<std::string, std::string> documented;
    for (auto it = std::sregex_iterator(page.begin(), page.end(), row); it != std::sregex_iterator(); ++it)
        documented[(*it)[1].str() + "." + (*it)[2].str()] = (*it)[3];
    std::map<std::string, std::string> declared;
    for (const auto& [prefix, file, name] : {std::array{"frame", "frame.glsl", "FrameConstants"},
                                             std::array{"view", "frame.glsl", "ViewConstants"},
                                             std::array{"material", "material.glsl", "Material"},
                                             std::array{"instance", "instance.glsl", "Instance"},
                                             std::array{"bounds", "bounds.glsl", "Bounds"},
                                             std::array{"mesh", "mesh.glsl", "Mesh"}})
        for (const auto& [member, type] : members_of(file, name))
            declared[std::string(prefix) + "." + member] = type;
    EXPECT_GT(declared.size(), 40u);
    EXPECT_EQ(documented, declared);
}

TEST(Documentation, TheGalleryCountsTheLinesOfItsGraphs) {
    const std::string page = read_text(kRoot / "docs/gallery.md");
    static const std::regex row(R"(\[`(graphs/\w+\.json)`\]\([^)]*\), (\d+) lines)");
    size_t graphs = 0;
    for (auto it = std::sregex_iterator(page.begin(), page.end(), row); it != std::sregex_iterator();
         ++it, ++graphs)
        EXPECT_EQ(std::stoi((*it)[2]), std::ranges::count(read_text(kRoot / (*it)[1].str()), '\n'))
            << (*it)[1];
    EXPECT_GE(graphs, 8u);
}

TEST(Documentation, TheExampleOfSeveralQueuesUsesThem) {
    const std::string readme = read_text(kRoot / "README.md");
    static const std::regex command(R"(\./weft plan (\S+) --profile (\S+) --queues 3)");
    std::smatch parts;
    ASSERT_TRUE(std::regex_search(readme, parts, command));
    const RunResult run =
        run_weft({"plan", parts[1], "--profile", parts[2], "--queues", "3", "--format", "json"}, {}, kRoot);
    ASSERT_EQ(run.exit_code, 0) << run.text();
    const auto queues =
        nlohmann::json::parse(run.out).at("schedule").at("queue").get<std::vector<unsigned>>();
    EXPECT_GE(std::set<unsigned>(queues.begin(), queues.end()).size(), 2u) << "it shows nothing of queues";
}

}  // namespace
}  // namespace weft::test
