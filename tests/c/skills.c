/* Learns the skills of the built-in environment and plans with them, and prints what came of
 * it: tests/tests/c_interface/skills.rs compares that with the core. The texts of the skills
 * are the arguments. */
#include "../../c_examples/stick_button.h"
#include "expect.h"

#define TRAINING 40
#define TASKS 20
#define NUMBERS 22

static uint64_t planner_memory[CRITREG_PLANNER_WORDS_FOR(8192, 256, 10000, 32, NUMBERS)];

static critreg_callbacks callbacks_of(critreg_skills *skills)
{
    critreg_callbacks callbacks;
    OK(critreg_callbacks_init(&callbacks, sizeof callbacks));
    callbacks.execute = critreg_stick_button_execute;
    callbacks.holds = critreg_stick_button_holds;
    callbacks.skills = skills;
    return callbacks;
}

static critreg_skills *make(char **texts)
{
    static const double along[2] = {0.0, 1.0}, across[2] = {-1.0, 1.0};
    critreg_config learner;
    critreg_skills_config config;
    critreg_skills *skills = NULL;
    uint64_t *memory;
    size_t bytes;
    uint32_t i;
    OK(critreg_config_init(&learner, sizeof learner));
    learner.seed = 3;
    learner.forms = 4096;
    learner.calls = 100;
    OK(critreg_skills_config_init(&config, sizeof config));
    config.state_len = NUMBERS;
    config.learner = &learner;
    config.chained = 120;
    config.situations = 12;
    config.states = TRAINING;
    bytes = critreg_skills_size(&config);
    EXPECT_TRUE(bytes > 0 && critreg_skills_align() == sizeof(uint64_t));
    memory = (uint64_t *)malloc(bytes);
    OK(critreg_skills_init(memory, bytes, STICK_BUTTON, LAYOUT, &config, &skills));
    OK(critreg_skills_add_controller(skills, "PickStick",
        "PickStickFromButton PickStickFromNothing", "?r ?s", along, 1));
    OK(critreg_skills_add_controller(skills, "PlaceStick",
        "placestickfrombutton PlaceStickFromNothing", "r s", across, 1));
    OK(critreg_skills_add_controller(skills, "RobotPressButton",
        "RobotPressButtonFromButton RobotPressButtonFromNothing", "?r ?b ?s", NULL, 0));
    OK(critreg_skills_add_controller(skills, "StickPressButton",
        "StickPressButtonFromButton StickPressButtonFromNothing", "?r ?s ?b", NULL, 0));
    OK(critreg_skills_add(skills, "PickStick", NULL, NULL, texts[0]));
    OK(critreg_skills_add(skills, "RobotPressButton", NULL, "", texts[1]));
    OK(critreg_skills_add(skills, "PlaceStick", NULL, NULL, texts[2]));
    OK(critreg_skills_add(skills, "PickStick", "StickPressButton", NULL, texts[3]));
    for (i = 0; i < TRAINING; i++) {
        uint32_t buttons = 1 + i % 2;
        double state[NUMBERS];
        char problem[512];
        write_problem(buttons, problem, sizeof problem);
        OK(critreg_stick_button_task(1000 + i, 0, buttons, state, NUMBERS));
        OK(critreg_skills_add_task(skills, problem, state,
                                   critreg_stick_button_state_len(buttons)));
    }
    return skills;
}

static void print_skill(critreg_skills *skills, size_t index)
{
    critreg_skill_report report;
    char text[4096] = "";
    critreg_status status;
    OK(critreg_skill_report_init(&report, sizeof report));
    OK(critreg_skills_report(skills, index, &report));
    status = critreg_skills_format(skills, index, text, sizeof text, NULL);
    EXPECT_TRUE(status == (report.has_region ? CRITREG_OK : CRITREG_NO_REGION));
    EXPECT_TRUE(report.finished == 1);
    printf("%" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32
           " %" PRIu32 " %" PRIu32 " %" PRIu32 " %s\n", report.has_region, report.quality,
           report.tasks, report.situations, report.runs, report.calls, report.feasible,
           report.infeasible, report.certificate_draws, report.certificate_feasible, text);
}

static void plan_task(uint32_t task, const critreg_callbacks *callbacks)
{
    uint32_t buttons = 1 + task % BUTTONS;
    double initial[NUMBERS];
    critreg_planner_config config;
    critreg_planner *planner = NULL;
    critreg_metrics metrics;
    char text[512], words[CRITREG_REASON_MAX];
    write_problem(buttons, text, sizeof text);
    OK(critreg_planner_config_init(&config, sizeof config));
    config.state_len = (uint32_t)critreg_stick_button_state_len(buttons);
    config.nodes = 10000;
    config.skeletons_per_state = 0;
    OK(critreg_planner_init(planner_memory, sizeof planner_memory, STICK_BUTTON, text, &config,
                            &planner));
    OK(critreg_stick_button_task(task, 0, buttons, initial, NUMBERS));
    OK(critreg_plan(planner, callbacks, initial, task, NULL, NULL));
    OK(critreg_metrics_init(&metrics, sizeof metrics));
    OK(critreg_planner_metrics(planner, &metrics));
    OK(critreg_planner_reason_text(planner, words, sizeof words, NULL));
    EXPECT_TRUE((words[0] != '\0') == (metrics.main_reason != CRITREG_NO_REASON));
    printf("%" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32
           " %s\n", metrics.samples, metrics.plan_length, metrics.nodes_expanded,
           metrics.nodes_created, metrics.postponed, metrics.informed_draws,
           metrics.empty_draws, words);
}

int main(int argc, char **argv)
{
    critreg_callbacks callbacks = callbacks_of(NULL);
    critreg_skills *skills;
    uint32_t i;
    if (argc != 5)
        return EXIT_FAILURE;
    skills = make(argv + 1);
    OK(critreg_skills_learn(skills, &callbacks, NULL));
    for (i = 0; i < 4; i++)
        print_skill(skills, i);
    callbacks = callbacks_of(skills);
    for (i = 0; i < TASKS; i++)
        plan_task(i, &callbacks);
    free(skills);
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
