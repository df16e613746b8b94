#include "shader/reflect/interface_merge.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "shader/reflect/reflect_stage.h"
#include "shader/reflect/used_ranges.h"

namespace weft::shader {

namespace {

bool same_member(const BlockMember& a, const BlockMember& b) {
    const auto fields = [](const BlockMember& m) {
        return std::tie(m.name, m.offset_bytes, m.size_bytes, m.scalar, m.rows, m.columns, m.array_count,
                        m.array_stride_bytes, m.is_runtime_array);
    };
    return fields(a) == fields(b) && std::ranges::equal(a.members, b.members, same_member);
}

bool same_binding(const ShaderBinding& a, const ShaderBinding& b) {
    const auto fields = [](const ShaderBinding& x) {
        return std::tie(x.name, x.set, x.binding, x.kind, x.count, x.is_array, x.dim, x.arrayed,
                        x.multisampled, x.shadow, x.numeric, x.storage_format, x.block_bytes,
                        x.is_runtime_array);
    };
    return fields(a) == fields(b) && std::ranges::equal(a.members, b.members, same_member);
}

void fault(InterfaceFaults& faults, ShaderStage stage, const std::string& name, const std::string& what) {
    faults.push_back({"W205", stage, name,
                      what + " \"" + name + "\" is declared differently in the two stages",
                      "declare \"" + name + "\" once, in a file that both stages include"});
}

void merge_binding(ShaderInterface& all, const ShaderBinding& binding, ShaderStage stage,
                   InterfaceFaults& faults) {
    const auto known = std::ranges::find_if(all.bindings, [&](const ShaderBinding& other) {
        return other.set == binding.set && other.binding == binding.binding;
    });
    if (known == all.bindings.end()) {
        all.bindings.push_back(binding);
    } else if (stage_bit(stage) == known->stages) {
        faults.push_back({"W205", stage, binding.name,
                          "\"" + known->name + "\" and \"" + binding.name + "\" both have set " +
                              std::to_string(binding.set) + ", binding " + std::to_string(binding.binding),
                          "remove `set` and `binding`, or give each resource a different binding"});
    } else if (!same_binding(*known, binding)) {
        fault(faults, stage, binding.name, "the resource");
    } else {
        known->stages |= binding.stages;
        known->reads = known->reads || binding.reads;
        known->writes = known->writes || binding.writes;
        known->filters = known->filters || binding.filters;
    }
}

void merge_params(ShaderInterface& all, const ParamsBlock& params, ShaderStage stage,
                  InterfaceFaults& faults) {
    if (!all.has_params) {
        all.has_params = true;
        all.params = params;
        return;
    }
    const bool same = all.params.push_constants == params.push_constants &&
                      all.params.size_bytes == params.size_bytes &&
                      std::ranges::equal(all.params.members, params.members, same_member);
    if (!same) fault(faults, stage, "Params", "the block");
    all.params.stages |= params.stages;
}

void merge_spec_constant(ShaderInterface& all, const SpecConstant& constant, ShaderStage stage,
                         InterfaceFaults& faults) {
    const auto clash = std::ranges::find_if(all.spec_constants, [&](const SpecConstant& other) {
        return other.name == constant.name || other.id == constant.id;
    });
    if (clash == all.spec_constants.end()) {
        all.spec_constants.push_back(constant);
        return;
    }
    const auto fields = [](const SpecConstant& c) { return std::tie(c.name, c.id, c.type, c.default_bits); };
    if (fields(*clash) == fields(constant)) return;
    faults.push_back({"W205", stage, constant.name,
                      "the specialisation constant \"" + constant.name + "\" (id " +
                          std::to_string(constant.id) + ") differs from \"" + clash->name + "\" (id " +
                          std::to_string(clash->id) + "), which has the same name or id",
                      "declare one name with the same constant_id, type and default in all stages; give "
                      "different names different ids"});
}

void take_variables(std::vector<StageVariable>& into, const std::vector<ReflectedVariable>& variables,
                    ShaderStage stage, InterfaceFaults& faults) {
    for (const ReflectedVariable& variable : variables) {
        if (!variable.used) continue;
        into.push_back(variable.variable);
        if (variable.location_count() == 1 && variable.array_count == 0) continue;
        faults.push_back({"W206", stage, variable.variable.name,
                          "\"" + variable.variable.name +
                              "\" is an array or a matrix; wanted a scalar or vector for a vertex input or "
                              "fragment output",
                          "declare one variable for each element of the array or column of the matrix"});
    }
    std::ranges::sort(into, {}, &StageVariable::location);
}

void merge_stage(ShaderInterface& all, const StageReflection& stage, InterfaceFaults& faults) {
    all.stages |= stage_bit(stage.stage);
    all.needs_texture_tables |= stage.needs_texture_tables;
    all.frame_ranges.insert(all.frame_ranges.end(), stage.frame_ranges.begin(), stage.frame_ranges.end());
    if (stage.push_constants) merge_params(all, *stage.push_constants, stage.stage, faults);
    for (const ReflectedBinding& reflected : stage.bindings) {
        const ShaderBinding& binding = reflected.binding;
        if (!reflected.used) continue;
        if (reflected.is_params) {
            merge_params(all, {false, binding.binding, binding.block_bytes, binding.stages, binding.members},
                         stage.stage, faults);
        } else {
            merge_binding(all, binding, stage.stage, faults);
        }
    }
    for (const SpecConstant& constant : stage.spec_constants) {
        merge_spec_constant(all, constant, stage.stage, faults);
    }
    if (stage.stage == ShaderStage::vertex) {
        take_variables(all.vertex_inputs, stage.inputs, stage.stage, faults);
        all.writes_point_size = stage.writes_point_size;
    }
    if (stage.stage == ShaderStage::fragment) {
        take_variables(all.fragment_outputs, stage.outputs, stage.stage, faults);
        all.discards = stage.discards;
        all.writes_depth = stage.writes_depth;
    }
    if (stage.stage == ShaderStage::compute) all.local_size = stage.local_size;
}

}  // namespace

ShaderInterface reflect_program(const std::vector<ShaderModule>& modules, InterfaceFaults& faults) {
    ShaderInterface all;
    for (const ShaderModule& module : modules) {
        merge_stage(all, reflect_stage(module.stage, module.spirv, faults), faults);
    }
    merge_ranges(all.frame_ranges);
    std::ranges::sort(all.bindings, {}, [](const ShaderBinding& b) { return std::pair(b.set, b.binding); });
    std::ranges::sort(all.spec_constants, {}, &SpecConstant::name);
    return all;
}

}  // namespace weft::shader
