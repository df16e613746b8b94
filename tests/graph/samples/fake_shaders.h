// Makes shader interfaces by hand, so that tests of the graph compiler need no shader compiler.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "weft/shader_interface.h"

namespace weft::test {

inline ShaderBinding sampled(std::string name) {
    ShaderBinding b;
    b.name = std::move(name);
    b.set = 1;
    b.kind = BindingKind::sampled_image;
    return b;
}

inline ShaderBinding storage_image(std::string name, Format format, bool reads, bool writes) {
    ShaderBinding b = sampled(std::move(name));
    b.kind = BindingKind::storage_image;
    b.storage_format = format;
    b.numeric = format == Format::undefined ? NumericClass::float_like : format_info(format).numeric;
    b.reads = reads;
    b.writes = writes;
    return b;
}
inline ShaderBinding image_out(std::string name, Format format = Format::rgba16f) {
    return storage_image(std::move(name), format, false, true);
}
inline ShaderBinding image_in(std::string name, Format format = Format::rgba16f) {
    return storage_image(std::move(name), format, true, false);
}
inline ShaderBinding image_in_out(std::string name, Format format = Format::rgba16f) {
    return storage_image(std::move(name), format, true, true);
}

inline ShaderBinding buffer(std::string name, bool reads, bool writes) {
    ShaderBinding b = sampled(std::move(name));
    b.kind = BindingKind::storage_buffer;
    b.reads = reads;
    b.writes = writes;
    return b;
}

inline BlockMember member(std::string name, uint8_t rows = 1, ScalarType scalar = ScalarType::f32) {
    BlockMember m;
    m.name = std::move(name);
    m.rows = rows;
    m.scalar = scalar;
    m.size_bytes = 4u * rows;
    return m;
}

inline ShaderProgram program(ShaderStageMask stages, std::initializer_list<ShaderBinding> bindings) {
    ShaderProgram p;
    p.modules.resize(1);
    p.interface.stages = stages;
    p.interface.local_size = {8, 8, 1};
    for (const ShaderBinding& binding : bindings) {
        p.interface.bindings.push_back(binding);
        p.interface.bindings.back().stages = stages;
        p.interface.bindings.back().binding = static_cast<uint32_t>(p.interface.bindings.size() - 1);
    }
    return p;
}

inline ShaderProgram compute(std::initializer_list<ShaderBinding> bindings) {
    return program(stage_bit(ShaderStage::compute), bindings);
}

inline ShaderProgram with_params(ShaderProgram p, std::initializer_list<BlockMember> members) {
    p.interface.has_params = true;
    p.interface.params.push_constants = true;
    uint32_t offset = 0;
    for (BlockMember m : members) {
        m.offset_bytes = offset;
        offset += m.size_bytes;
        p.interface.params.members.push_back(m);
    }
    p.interface.params.size_bytes = offset;
    return p;
}

inline ShaderProgram with_constants(ShaderProgram p,
                                    std::initializer_list<std::pair<const char*, ScalarType>> constants) {
    for (const auto& [name, type] : constants) {
        const auto id = static_cast<uint32_t>(p.interface.spec_constants.size());
        p.interface.spec_constants.push_back({name, id, type, 0});
    }
    return p;
}

// Returns a program with a vertex and a fragment stage. The outputs get the locations 0, 1, 2, ... in the
// given order.
inline ShaderProgram fragment(std::initializer_list<const char*> outputs,
                              std::initializer_list<ShaderBinding> bindings = {}) {
    ShaderProgram p = program(stage_bit(ShaderStage::fragment), bindings);
    p.interface.stages |= stage_bit(ShaderStage::vertex);
    for (const char* name : outputs) {
        StageVariable output;
        output.name = name;
        output.location = static_cast<uint32_t>(p.interface.fragment_outputs.size());
        p.interface.fragment_outputs.push_back(output);
    }
    return p;
}

}  // namespace weft::test
