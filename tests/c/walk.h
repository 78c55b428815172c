/* A world to plan in: a lamp is lit by walking to it. A walk has a parameter, the
 * speed, and works from 0.5 on. */
#ifndef WALK_H
#define WALK_H

#include "expect.h"

static const char WALK[] =
    "(define (domain walk)\n"
    "  (:types place)\n"
    "  (:predicates (At ?p - place) (Lit ?p - place))\n"
    "  (:action Walk :parameters (?from ?to - place) :precondition (At ?from)\n"
    "    :effect (and (At ?to) (not (At ?from))))\n"
    "  (:action Light :parameters (?p - place) :precondition (At ?p) :effect (Lit ?p)))";
static const char TO_B[] =
    "(define (problem light-b) (:domain walk) (:objects b a - place)\n"
    "  (:init (At a)) (:goal (Lit b)))";

/* Where one is, and whether each of two places is lit. */
#define STATE 3
static const double DARK[STATE] = {0.0, 0.0, 0.0};

/* What the callbacks count, and in which call one fails: -1 for never. */
typedef struct {
    int executes, holds, samples, advices;
    int fail_execute, fail_holds, fail_sample, fail_advise;
    critreg_status status;
} walker;

static const walker CALM = {0, 0, 0, 0, -1, -1, -1, -1, CRITREG_OK};

static inline critreg_status walk(void *user_data, const critreg_ground *ground,
                                  const double *parameters, const double *before, double *after,
                                  size_t len, uint32_t *actions)
{
    walker *own = (walker *)user_data;
    if (own->executes++ == own->fail_execute)
        return own->status;
    EXPECT_TRUE(len == STATE && memcmp(before, after, STATE * sizeof *after) == 0);
    EXPECT_TRUE(*actions == 0);
    if (strcmp(ground->name, "Light") == 0) {
        EXPECT_TRUE(ground->index == 1 && ground->object_count == 1);
        EXPECT_TRUE(ground->object_names[1] == NULL && ground->objects[1] == 0);
        after[1 + ground->objects[0]] = 1.0;
        *actions = 1;
    } else if (parameters[0] >= 0.5) {
        EXPECT_TRUE(strcmp(ground->name, "Walk") == 0 && ground->index == 0);
        EXPECT_TRUE(strcmp(ground->object_names[1], ground->objects[1] == 0 ? "a" : "b") == 0);
        after[0] = ground->objects[1];
        *actions = 2;
    }
    return CRITREG_OK;
}

static inline critreg_status is_so(void *user_data, const critreg_ground *ground,
                                   const double *state, size_t len, int32_t *holds)
{
    walker *own = (walker *)user_data;
    if (own->holds++ == own->fail_holds)
        return own->status;
    EXPECT_TRUE(len == STATE && ground->object_count == 1);
    if (ground->index == 0)
        *holds = state[0] == (double)ground->objects[0];
    else
        *holds = state[1 + ground->objects[0]] > 0.5;
    return CRITREG_OK;
}

static inline critreg_status any_speed(void *user_data, const critreg_draw *draw,
                                       critreg_rng *rng, critreg_drawn *drawn)
{
    walker *own = (walker *)user_data;
    if (own->samples++ == own->fail_sample)
        return own->status;
    EXPECT_TRUE(draw->step < draw->length && draw->state_len == STATE && draw->attempt > 0);
    EXPECT_TRUE(draw->parameter_count == (draw->skeleton[draw->step].index == 0));
    EXPECT_TRUE(isnan(drawn->parameters[0]) && drawn->informed == 0);
    EXPECT_TRUE(drawn->reason == CRITREG_NO_REASON);
    return critreg_rng_uniform(rng, &drawn->parameters[0]);
}

static inline critreg_status no_walk_in_place(void *user_data, const critreg_ground *prefix,
                                              size_t length, const double *initial, size_t len,
                                              critreg_advice *advice, uint32_t *reason)
{
    walker *own = (walker *)user_data;
    const critreg_ground *last = &prefix[length - 1];
    if (own->advices++ == own->fail_advise)
        return own->status;
    EXPECT_TRUE(len == STATE && initial[0] == 0.0);
    EXPECT_TRUE(*advice == CRITREG_KEEP && *reason == CRITREG_NO_REASON);
    if (last->index == 0 && last->objects[0] == last->objects[1]) {
        *advice = CRITREG_PRUNE;
        *reason = 3;
    }
    return CRITREG_OK;
}

static inline critreg_callbacks all_callbacks(void)
{
    critreg_callbacks callbacks;
    OK(critreg_callbacks_init(&callbacks, sizeof callbacks));
    callbacks.execute = walk;
    callbacks.holds = is_so;
    callbacks.sample = any_speed;
    callbacks.advise = no_walk_in_place;
    return callbacks;
}

static inline critreg_planner_config walk_config(void)
{
    critreg_planner_config config;
    OK(critreg_planner_config_init(&config, sizeof config));
    config.state_len = STATE;
    return config;
}

static inline critreg_planner *walk_planner(uint64_t *memory, size_t memory_len)
{
    static const double speed[2] = {0.0, 1.0};
    critreg_planner_config config = walk_config();
    critreg_planner *planner = NULL;
    OK(critreg_planner_init(memory, memory_len, WALK, TO_B, &config, &planner));
    OK(critreg_planner_set_ranges(planner, "Walk", speed, 1));
    return planner;
}

/* The planner finds the plan: walk to b, light it. */
static inline void expect_plan(critreg_planner *planner)
{
    critreg_callbacks callbacks = all_callbacks();
    critreg_step step;
    walker own = CALM;
    size_t length = 0;
    OK(critreg_plan(planner, &callbacks, DARK, 1, &own, &length));
    EXPECT_TRUE(length == 2);
    OK(critreg_step_init(&step, sizeof step));
    OK(critreg_planner_step(planner, 0, &step));
    EXPECT_TRUE(strcmp(step.ground.name, "Walk") == 0 && step.ground.object_count == 2);
    EXPECT_TRUE(step.parameter_count == 1 && step.parameters[0] >= 0.5 && step.actions == 2);
    EXPECT_TRUE(step.state[0] == 1.0 && step.state[2] == 0.0);
    OK(critreg_planner_step(planner, 1, &step));
    EXPECT_TRUE(strcmp(step.ground.object_names[0], "b") == 0 && step.parameter_count == 0);
    EXPECT_TRUE(step.state[2] == 1.0);
}

#endif
