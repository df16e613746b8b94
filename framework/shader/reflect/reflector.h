// Purpose: holds the handles of SPIRV-Cross and the results while one stage is reflected. Only the source
// files of the reflection include this header.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "shader/reflect/interface_types.h"
#include "shader/reflect/reflect_stage.h"

namespace weft::shader {

class Reflector {
 public:
    Reflector(ShaderStage stage, const std::vector<uint32_t>& spirv, InterfaceFaults& faults);
    ~Reflector();
    Reflector(const Reflector&) = delete;
    Reflector& operator=(const Reflector&) = delete;

    StageReflection run();

 private:
    [[nodiscard]] bool list_resources();
    [[nodiscard]] std::span<const spvc_reflected_resource> of_type(spvc_resource_type type) const;
    void refuse_foreign_kinds();
    void reflect_images();
    void reflect_buffers();
    void add_frame_ranges(const ShaderBinding& block, spvc_variable_id id);
    void reflect_push_constants();
    void reflect_spec_constants();
    void reflect_variables(spvc_resource_type type, std::vector<ReflectedVariable>& variables);
    void reflect_execution();
    void scan_instructions();

    [[nodiscard]] ReflectedBinding start_binding(const spvc_reflected_resource& resource, BindingKind kind);
    void describe_image(ReflectedBinding& reflected, spvc_type type);
    void describe_access(ShaderBinding& binding, spvc_variable_id id, bool is_buffer);
    [[nodiscard]] std::vector<BlockMember> members_of(const spvc_reflected_resource& block);
    [[nodiscard]] uint32_t size_of(const spvc_reflected_resource& block) const;
    [[nodiscard]] std::string name_of(const spvc_reflected_resource& resource) const;
    [[nodiscard]] WordIndex word_of(spvc_variable_id id, SpvDecoration decoration) const;
    void fault(std::string subject, std::string message, std::string help);

    const std::vector<uint32_t>& spirv_;
    InterfaceFaults& faults_;
    StageReflection result_;
    spvc_context context_ = nullptr;
    spvc_compiler compiler_ = nullptr;
    spvc_resources resources_ = nullptr;
    std::set<SpvId> used_;
};

}  // namespace weft::shader
