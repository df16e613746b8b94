// Purpose: makes a temporary folder with the shaders of a graph, shared shaders, includes and a cache. The
// folder is removed after the test.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>  // mkdtemp

#include <filesystem>
#include <fstream>
#include <string>

#include "weft/shader/compile_shader.h"

namespace weft {

class ShaderFolder : public testing::Test {
 protected:
    ShaderFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "weft_shader_XXXXXX").string();
        base_ = ::mkdtemp(pattern.data());
        roots_.roots = {base_ / "graph", base_ / "shaders"};
        roots_.include_root = base_ / "shaders/include";
        std::filesystem::create_directories(base_ / "graph");
        std::filesystem::create_directories(roots_.include_root);
        std::filesystem::copy(std::filesystem::path(WEFT_SOURCE_DIR) / "shaders/include/fullscreen.vert",
                              roots_.include_root);
    }
    ~ShaderFolder() override {
        std::error_code error;
        std::filesystem::remove_all(base_, error);
    }

    void write(const std::string& path, const std::string& text) const {
        std::filesystem::create_directories((base_ / path).parent_path());
        std::ofstream(base_ / path, std::ios::binary) << text;
    }

    [[nodiscard]] Result<ShaderProgram> compile(const std::string& reference, ProgramKind kind) const {
        return compile_shader(reference, kind, roots_);
    }

    // Compiles a program and expects success. Returns the program.
    [[nodiscard]] ShaderProgram program(const std::string& reference, ProgramKind kind) const {
        auto result = compile(reference, kind);
        if (!result) {
            ADD_FAILURE() << to_text(result.errors());
            return {};
        }
        return std::move(*result);
    }

    // Compiles a program and expects errors. Returns the errors.
    [[nodiscard]] Diagnostics errors(const std::string& reference, ProgramKind kind) const {
        auto result = compile(reference, kind);
        if (result) {
            ADD_FAILURE() << reference << " compiled";
            return {Diagnostic{}};
        }
        return result.take_errors();
    }

    std::filesystem::path base_;
    ShaderRoots roots_;
};

}  // namespace weft
