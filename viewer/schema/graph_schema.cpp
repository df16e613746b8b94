#include "viewer/schema/graph_schema.h"

#include <nlohmann/json.hpp>

#include "viewer/schema/format_schema.h"

namespace weft::viewer {
namespace {

using Json = nlohmann::ordered_json;
using Names = std::set<std::string>;
constexpr const char* kWordEnds = "(?![A-Za-z0-9_])";

Json one_of(const Names& names) {
    return {{"enum", names}};
}

// Returns the regular expression "(a|b)" for the names a and b. Without names, the returned expression
// matches no text.
std::string any_of(const Names& names) {
    if (names.empty()) return "(?!)";
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "(" : "|") + name;
    return text + ")";
}

// Returns the schema of a reference to a resource. The reference is either a name, which editors suggest, or
// a longer text that starts with a name, such as "hdr@lighting".
Json reference_to(const Names& resources, const Names& passes) {
    const std::string more = "(@" + any_of(passes) + kWordEnds +
                             "|\\[-([1-9]|1[0-6])\\]|\\.(mip|layer)\\(.+\\)|\\.(depth|stencil))";
    return {{"anyOf",
             {one_of(resources), {{"type", "string"}, {"pattern", "^" + any_of(resources) + more + "+$"}}}}};
}

// Returns the schema of ports. In an object, the port names are the keys; null removes a port of an included
// pass, also a port that this pass no longer has because it uses another shader. In a list, each entry is a
// reference that begins with the port name, such as "depth" or "depth@gbuffer.mip(1)".
Json ports(const Names& names) {
    Json known = Json::object();
    for (const std::string& name : names) known[name] = true;
    return {{"properties", std::move(known)},
            {"additionalProperties", {{"type", "null"}}},
            {"items", {{"pattern", "^" + any_of(names) + kWordEnds}}}};
}

Json pass_schema(const PassNames& pass) {
    Names blended = pass.attachments;
    blended.insert({"color", "alpha"});
    Json properties{
        {"resolve", {{"additionalProperties", {{"anyOf", {one_of(pass.attachments), {{"type", "null"}}}}}}}},
        {"state",
         {{"properties",
           {{"blend", {{"propertyNames", one_of(blended)}}},
            {"writeMask", {{"propertyNames", one_of(pass.attachments)}}}}}}}};
    if (!pass.is_open) {
        properties["in"] = ports(pass.in);
        properties["out"] = ports(pass.out);
        properties["params"] = {{"propertyNames", one_of(pass.params)}};
        properties["constants"] = {{"propertyNames", one_of(pass.constants)}};
    }
    return {{"properties", std::move(properties)}};
}

Json passes_schema(const std::map<std::string, PassNames>& passes) {
    Json properties = Json::object();
    for (const auto& [name, pass] : passes) properties[name] = pass_schema(pass);
    return {{"properties", std::move(properties)}};
}

Json groups_schema(const GraphNames& names) {
    Json properties = Json::object();
    for (const auto& [name, passes] : names.groups)
        properties[name] = {{"properties", {{"passes", passes_schema(passes)}}}};
    return {{"properties", std::move(properties)}};
}

}  // namespace

std::string graph_schema(const GraphNames& names) {
    Json schema = Json::parse(format_schema());
    Json& definitions = schema["definitions"];
    definitions["reference"] = reference_to(names.resources, names.pass_names);
    definitions["passName"] = one_of(names.pass_names);
    definitions["turnsName"] = one_of(names.turns);
    definitions["viewsName"] = one_of(names.views);
    definitions["tierName"] = one_of(names.tiers);
    definitions["drawList"] = one_of(names.draw_lists);
    definitions["paramName"] = one_of(names.params);
    definitions["computeShader"] = one_of(names.compute_shaders);
    definitions["fullscreenShader"] = one_of(names.fullscreen_shaders);
    definitions["rasterShader"] = one_of(names.raster_shaders);
    definitions["ownPasses"] = passes_schema(names.passes);
    definitions["ownGroups"] = groups_schema(names);
    const Json own{{"properties",
                    {{"passes", {{"$ref", "#/definitions/ownPasses"}}},
                     {"groups", {{"$ref", "#/definitions/ownGroups"}}}}}};
    schema["allOf"] = {own};
    schema["allOf"].push_back(
        {{"properties", {{"tiers", {{"additionalProperties", {{"properties", {{"patch", own}}}}}}}}}});
    return schema.dump(1, ' ') + "\n";
}

}  // namespace weft::viewer
