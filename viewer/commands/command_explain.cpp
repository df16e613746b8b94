// `weft explain`: answers one question about a plan, such as "why was this pass culled?".
#include <array>
#include <cstdio>

#include "graph/diagnostics/diagnostic_text.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/offline_graph.h"
#include "viewer/output/output.h"
#include "viewer/output/report.h"
#include "weft/report/plan_explain.h"

namespace weft::viewer {
namespace {

struct Question {
    const char* name;
    size_t names;  // Number of names that the user must give for this question.
    Result<std::string> (*answer)(const FramePlan& plan, const std::vector<std::string>& names);
};

using Names = std::vector<std::string>;
const std::array kQuestions{
    Question{"culled", 1, [](const FramePlan& p, const Names& n) { return explain_culled(p, n[0]); }},
    Question{"barrier", 2, [](const FramePlan& p, const Names& n) { return explain_barrier(p, n[0], n[1]); }},
    Question{"alias", 2, [](const FramePlan& p, const Names& n) { return explain_alias(p, n[0], n[1]); }},
    Question{"wait", 1, [](const FramePlan& p, const Names& n) { return explain_wait(p, n[0]); }},
    Question{"rest", 1, [](const FramePlan& p, const Names& n) { return explain_rest(p, n[0]); }},
    Question{"switch", 1, [](const FramePlan& p, const Names& n) { return explain_switch(p, n[0]); }},
    Question{"views", 1, [](const FramePlan& p, const Names& n) { return explain_views(p, n[0]); }},
    Question{"resource", 1, [](const FramePlan& p, const Names& n) { return explain_resource(p, n[0]); }},
};

const Question* find_question(const ExplainOptions& options) {
    for (const Question& question : kQuestions)
        if (options.question == question.name && options.names.size() == question.names) return &question;
    return nullptr;
}

}  // namespace

ExitCode run_explain(const ExplainOptions& options) {
    const Question* question = find_question(options);
    if (question == nullptr) {
        std::fputs(
            "weft: the question has a wrong number of names; ask culled PASS, barrier PASS PASS, alias "
            "RESOURCE RESOURCE, wait PASS, rest PASS, switch PASS, views PASS or resource RESOURCE\n",
            stderr);
        return ExitCode::usage;
    }
    Diagnostics warnings;  // The command does not print warnings of the graph; `weft check` prints them.
    const Result<OfflinePlan> made = compile_offline(options.file, options.offline, warnings);
    if (!made) {
        report(made.errors());
        return exit_code_for(made.errors());
    }
    const Result<std::string> answer = question->answer(made->plan, options.names);
    if (!answer) {
        report(answer.errors());
        return exit_code_for(answer.errors());
    }
    return print_data(printable(*answer));
}

}  // namespace weft::viewer
