// Tests ShaderMemory, which keeps compiled programs between two loads of a graph and records the files that a
// load read or looked for.
#include "shader/shader_memory.h"

#include "shader/compile/glsl_compile.h"
#include "tests/shader/shader_folder.h"

namespace weft {
namespace {

namespace fs = std::filesystem;

class Memory : public ShaderFolder {
 protected:
    Memory() {
        write("graph/tone.glsl", "const float kTone = 0.5;\n");
        write("graph/a.frag",
              "#version 460\n#include \"tone.glsl\"\nlayout(location = 0) out vec4 color;\n"
              "void main() { color = vec4(kTone); }\n");
        write("graph/b.frag",
              "#version 460\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(1); }\n");
    }
    // Loads both shaders. Returns the number of programs that had to be compiled, or -1 if a shader has an
    // error.
    int load() {
        const uint64_t before = memory_.misses();
        memory_.begin();
        shader::StageCompiler compiler(roots_);
        bool good = true;
        for (const char* reference : {"a.frag", "b.frag"})
            good &= compile_shader(reference, ProgramKind::fullscreen, roots_, compiler, &memory_).ok();
        if (good) memory_.forget_unused();
        return good ? static_cast<int>(memory_.misses() - before) : -1;
    }
    [[nodiscard]] bool looked_at(const std::string& path) const {
        return memory_.files().contains(fs::canonical(base_) / path);
    }

    ShaderMemory memory_;
};

TEST_F(Memory, only_what_changed_is_compiled) {
    EXPECT_EQ(load(), 2);
    EXPECT_EQ(load(), 0);
    write("graph/tone.glsl", "const float kTone = 0.75;\n");
    EXPECT_EQ(load(), 1);
    write("graph/b.frag",
          "#version 460\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(0); }\n");
    EXPECT_EQ(load(), 1);
    EXPECT_EQ(load(), 0);
}

TEST_F(Memory, an_error_that_is_undone_costs_nothing) {
    EXPECT_EQ(load(), 2);
    write("graph/tone.glsl", "const flat kTone = 0.5;\n");
    EXPECT_EQ(load(), -1);
    write("graph/tone.glsl", "const float kTone = 0.5;\n");
    EXPECT_EQ(load(), 0);
}

TEST_F(Memory, knows_what_was_looked_at_and_not_there) {
    EXPECT_EQ(load(), 2);
    EXPECT_TRUE(looked_at("graph/a.frag"));
    EXPECT_TRUE(looked_at("graph/tone.glsl"));
    EXPECT_TRUE(looked_at("shaders/include/fullscreen.vert"));
    EXPECT_FALSE(looked_at("shaders/include/tone.glsl"));
    fs::remove(base_ / "graph/tone.glsl");
    EXPECT_EQ(load(), -1);
    EXPECT_TRUE(looked_at("graph/tone.glsl"));
    EXPECT_TRUE(looked_at("shaders/include/tone.glsl")) << "there it would be found as well";
    write("shaders/include/tone.glsl", "const float kTone = 0.5;\n");
    EXPECT_EQ(load(), 1);
}

TEST_F(Memory, an_include_that_comes_before_another_is_taken) {
    write("shaders/include/tone.glsl", "const float kTone = 0.5;\n");
    fs::remove(base_ / "graph/tone.glsl");
    EXPECT_EQ(load(), 2);
    write("graph/tone.glsl", "const float kTone = 0.25;\n");
    EXPECT_EQ(load(), 1);
}

}  // namespace
}  // namespace weft
