#include "viewer/schema/format_schema.h"

#include <map>
#include <nlohmann/json.hpp>

#include "graph/parse/grammar_tables.h"
#include "weft/registry.h"
#include "weft/render/import_catalog.h"

namespace weft::viewer {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* kRef = "$ref";
constexpr const char* kText = "markdownDescription";
const std::string kDefinitions = "#/definitions/";

Json reference(const std::string& definition) {
    return {{kRef, kDefinitions + definition}};
}

// Completes the definition of one kind of pass or resource. Its schema allows only the keys that this kind
// may have, not all keys of passes or resources.
void complete_kind(const GrammarTable& kind, Json& definitions) {
    const Json& all = definitions.at(kind.kind_of).at("properties");
    Json& definition = definitions[kind.place];
    Json properties = Json::object();
    for (const std::string& key : kind.words) {
        properties[key] = reference(kind.kind_of + "/properties/" + key);
        if (!definition.contains("properties") || !definition["properties"].contains(key)) continue;
        properties[key] = definition["properties"][key];
        properties[key][kText] = all.at(key).at(kText);
    }
    definition["type"] = "object";
    definition["properties"] = std::move(properties);
    definition["additionalProperties"] = false;
    definition["required"] = kind.required;
}

// Returns the schema of a format: one name such as "rgba16f", or several names separated by "|".
Json format_choice(const std::vector<std::string>& names) {
    std::string one;
    for (const std::string& name : names) one += (one.empty() ? "(" : "|") + name;
    one += ")";
    return {
        {"anyOf", {{{"enum", names}}, {{"type", "string"}, {"pattern", "^" + one + "(\\|" + one + ")+$"}}}}};
}

void add_pass_types(const std::vector<std::string>& builtin, Json& definitions) {
    std::vector<std::string> types = builtin;
    for (const auto& [name, unused] : registered_passes()) types.push_back(name);
    definitions["passType"] = {{"enum", types}};
    for (const std::string& type : builtin)
        definitions["pass"]["allOf"].push_back(
            {{"if", {{"required", {"type"}}, {"properties", {{"type", {{"const", type}}}}}}},
             {"then", reference(type + "Pass")}});
}

void add_words(Json& definitions) {
    for (const GrammarTable& words : grammar_tables()) {
        if (!words.kind_of.empty()) {
            complete_kind(words, definitions);
        } else if (words.place == "builtinType") {
            definitions[words.place] = {{"enum", words.words}};
            add_pass_types(words.words, definitions);
        } else if (words.place == "formatName") {
            definitions["format"] = format_choice(words.words);
        } else if (words.place == "plainElement") {
            std::vector<std::string> elements = words.words;
            for (const auto& [name, unused] : render::scene_imports({1, 1, 1}).strides)
                elements.push_back(name);
            definitions["element"] = {{"enum", elements}};
        } else if (!words.are_keys) {
            definitions[words.place]["enum"] = words.words;
        }
    }
}

// Converts schemas for objects to schemas for patches. A patch changes an existing object: it requires no
// key, and null removes a member.
class PatchForms {
 public:
    explicit PatchForms(Json& definitions) : definitions_(definitions) {}

    Json of(const Json& schema) {
        if (schema.contains(kRef)) return of_reference(schema);
        Json form = Json::object();
        for (const auto& [key, value] : schema.items()) {
            if (key == "required" || key == "dependencies" || key == "minProperties") continue;
            if (key == "properties")
                for (const auto& [name, property] : value.items()) form[key][name] = or_null(property);
            else if (key == "additionalProperties" && value.is_object())
                form[key] = or_null(value);
            else if (key == "anyOf" || key == "allOf")
                for (const Json& part : value) form[key].push_back(of(part));
            else if (key == "then" || key == "else")
                form[key] = of(value);
            else
                form[key] = value;
        }
        return form;
    }

 private:
    Json of_reference(const Json& schema) {
        std::string target = schema.at(kRef).get<std::string>().substr(kDefinitions.size());
        const size_t slash = target.find('/');
        const std::string rest = slash == std::string::npos ? "" : target.substr(slash);
        Json form = schema;
        form[kRef] = kDefinitions + of_definition(target.substr(0, slash)) + rest;
        return form;
    }

    std::string of_definition(const std::string& name) {
        const auto known = names_.find(name);
        if (known != names_.end()) return known->second;
        // Enter a preliminary name, so that the recursion ends. Definitions can refer to each other in a
        // cycle: "pass" refers to the definition of each kind of pass, and that definition refers to "pass".
        names_[name] = name + ".patch";
        const Json strict = definitions_.at(name);
        Json form = of(strict);
        const std::string form_name = form == strict ? name : name + ".patch";
        if (form != strict) definitions_[form_name] = std::move(form);
        return names_[name] = form_name;
    }

    Json or_null(const Json& property) {
        Json form = of(property);
        const bool has_null =
            form.contains(kRef) && form[kRef].get<std::string>().find(".patch/") != std::string::npos;
        if (has_null) return form;
        Json text = form.contains(kText) ? form[kText] : Json();
        form.erase(kText);
        Json either{{"anyOf", {std::move(form), {{"type", "null"}}}}};
        if (!text.is_null()) either[kText] = std::move(text);
        return either;
    }

    Json& definitions_;
    std::map<std::string, std::string> names_;
};

// Adds the schemas of patches. In a file that includes others, each section may contain patches of the
// included sections.
void add_patches(Json& schema) {
    Json& definitions = schema["definitions"];
    PatchForms forms(definitions);
    Json strict = Json::object(), over = Json::object();
    for (const GrammarTable& words : grammar_tables()) {
        if (words.place != "patch") continue;
        for (const std::string& key : words.words) {
            strict[key] = schema["properties"][key];
            over[key] = {{"anyOf", {forms.of(strict[key]), {{"type", "null"}}}}};
            const std::string definition =
                strict[key].at(kRef).get<std::string>().substr(kDefinitions.size());
            schema["properties"][key] = {{kText, definitions.at(definition).at(kText)}};
        }
    }
    definitions["patch"]["properties"] = over;
    schema["if"] = {{"required", {"include"}}};
    schema["then"] = {{"properties", std::move(over)}};
    schema["else"] = {{"properties", std::move(strict)}, {"required", schema["required"]}};
    schema.erase("required");
}

}  // namespace

std::string format_schema() {
    Json schema = Json::parse(format_description());
    add_words(schema["definitions"]);
    add_patches(schema);
    return schema.dump(1, ' ') + "\n";
}

}  // namespace weft::viewer
