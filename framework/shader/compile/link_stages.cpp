#include "shader/compile/link_stages.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "shader/reflect/reflect_stage.h"

namespace weft::shader {

namespace {

std::string key_of(const ReflectedBinding& reflected) {
    return reflected.is_params ? "Params" : reflected.binding.name;
}

// Assigns binding numbers to the resources of set 1, sorted by name. Resources that no stage uses get the
// numbers after the used ones: their declarations stay in the SPIR-V, but no descriptor set layout contains
// them.
std::map<std::string, uint32_t> number_ports(const std::vector<StageReflection>& reflections) {
    std::set<std::string> used;
    std::set<std::string> unused;
    for (const StageReflection& reflection : reflections) {
        for (const ReflectedBinding& reflected : reflection.bindings) {
            if (reflected.binding.set == kPortSet) (reflected.used ? used : unused).insert(key_of(reflected));
        }
    }
    std::map<std::string, uint32_t> numbers;
    uint32_t next = 0;
    for (const auto* names : {&used, &unused}) {
        for (const std::string& name : *names) next += numbers.emplace(name, next).second ? 1 : 0;
    }
    return numbers;
}

void place_ports(CompiledStage& stage, const StageReflection& reflection,
                 const std::map<std::string, uint32_t>& numbers) {
    for (const ReflectedBinding& reflected : reflection.bindings) {
        if (reflected.binding.set != kPortSet || !reflected.binding_word) continue;
        stage.spirv[*reflected.binding_word] = numbers.at(key_of(reflected));
    }
}

void move_to(CompiledStage& stage, ReflectedVariable& variable, uint32_t location) {
    variable.variable.location = location;
    if (variable.location_word) stage.spirv[*variable.location_word] = location;
}

// Assigns locations to the variables that have none, sorted by name. Each variable gets the lowest
// consecutive free locations that suffice. For example, a mat4 needs four locations.
void place_free_variables(CompiledStage& stage, std::vector<ReflectedVariable>& variables) {
    std::set<uint32_t> taken;
    std::vector<ReflectedVariable*> free;
    for (ReflectedVariable& variable : variables) {
        if (stage.unplaced.contains(variable.variable.name)) {
            free.push_back(&variable);
            continue;
        }
        for (uint32_t i = 0; i < variable.location_count(); ++i) taken.insert(variable.variable.location + i);
    }
    std::ranges::sort(free, {}, [](const ReflectedVariable* variable) { return variable->variable.name; });
    for (ReflectedVariable* variable : free) {
        uint32_t location = 0;
        for (uint32_t run = 0; run < variable->location_count();) {
            run = taken.contains(location + run) ? (location += run + 1, 0) : run + 1;
        }
        for (uint32_t i = 0; i < variable->location_count(); ++i) taken.insert(location + i);
        move_to(stage, *variable, location);
    }
}

std::string type_name(const ReflectedVariable& variable) {
    static constexpr const char* kScalars[] = {"float", "int", "uint", "bool"};
    static constexpr const char* kVectors[] = {"vec", "ivec", "uvec", "bvec"};
    const auto scalar = static_cast<size_t>(variable.variable.scalar);
    const std::string rows = std::to_string(variable.variable.components);
    std::string name = variable.variable.components == 1 ? kScalars[scalar] : kVectors[scalar] + rows;
    if (variable.columns > 1) name = "mat" + std::to_string(variable.columns) + "x" + rows;
    if (variable.array_count > 0) name.append("[").append(std::to_string(variable.array_count)).append("]");
    return name;
}

std::string list_of(const std::vector<ReflectedVariable>& outputs) {
    std::string text;
    for (const ReflectedVariable& output : outputs) {
        text += (text.empty() ? "" : ", ") + type_name(output) + " " + output.variable.name +
                " at location " + std::to_string(output.variable.location);
    }
    return text.empty() ? "write the variable in the vertex stage, which writes only gl_Position"
                        : "read a variable that the vertex stage writes: " + text;
}

// Gives each input without a location the location of the output that has the same name in the previous
// stage.
void join_by_name(CompiledStage& stage, std::vector<ReflectedVariable>& inputs,
                  const std::vector<ReflectedVariable>& outputs, InterfaceFaults& faults) {
    for (ReflectedVariable& input : inputs) {
        const std::string& name = input.variable.name;
        if (!stage.unplaced.contains(name)) continue;
        const auto output = std::ranges::find(outputs, name, [](const auto& it) { return it.variable.name; });
        if (output != outputs.end()) {
            move_to(stage, input, output->variable.location);
            continue;
        }
        faults.push_back({"W205", stage.stage, name,
                          "the fragment stage reads \"" + name + "\", which the vertex stage does not write",
                          list_of(outputs)});
        stage.unplaced.erase(name);
        input.location_word.reset();
        // The error of this input is already reported. If `columns` is 0, check_inputs() skips the input.
        input.columns = 0;
    }
}

void check_inputs(ShaderStage stage, const std::vector<ReflectedVariable>& inputs,
                  const std::vector<ReflectedVariable>& outputs, InterfaceFaults& faults) {
    for (const ReflectedVariable& input : inputs) {
        if (input.columns == 0) continue;
        const auto output = std::ranges::find_if(outputs, [&](const ReflectedVariable& candidate) {
            return candidate.variable.location == input.variable.location &&
                   candidate.component == input.component;
        });
        const std::string wanted = type_name(input) + " " + input.variable.name;
        const std::string place = " at location " + std::to_string(input.variable.location);
        if (output == outputs.end()) {
            faults.push_back(
                {"W205", stage, input.variable.name,
                 "the fragment stage reads " + wanted + place + ", where the vertex stage writes nothing",
                 list_of(outputs)});
        } else if (type_name(*output) != type_name(input)) {
            faults.push_back({"W205", stage, input.variable.name,
                              "the fragment stage reads " + wanted + place +
                                  ", but the vertex stage writes " + type_name(*output) + " " +
                                  output->variable.name + " there",
                              "declare both variables with the same type"});
        }
    }
}

void link_variables(std::vector<CompiledStage>& stages, std::vector<StageReflection>& reflections,
                    InterfaceFaults& faults) {
    const std::vector<ReflectedVariable>* written = nullptr;
    for (size_t i = 0; i < stages.size(); ++i) {
        if (written == nullptr) {
            place_free_variables(stages[i], reflections[i].inputs);
        } else {
            join_by_name(stages[i], reflections[i].inputs, *written, faults);
            check_inputs(stages[i].stage, reflections[i].inputs, *written, faults);
        }
        place_free_variables(stages[i], reflections[i].outputs);
        written = &reflections[i].outputs;
    }
}

}  // namespace

void link_stages(std::vector<CompiledStage>& stages, InterfaceFaults& faults) {
    std::vector<StageReflection> reflections;
    for (const CompiledStage& stage : stages) {
        InterfaceFaults reported_when_merging;
        reflections.push_back(reflect_stage(stage.stage, stage.spirv, reported_when_merging));
    }
    const std::map<std::string, uint32_t> numbers = number_ports(reflections);
    for (size_t i = 0; i < stages.size(); ++i) place_ports(stages[i], reflections[i], numbers);
    link_variables(stages, reflections, faults);
}

}  // namespace weft::shader
