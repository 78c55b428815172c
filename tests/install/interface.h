#ifndef CRITREG_H
#define CRITREG_H
#include <stddef.h>
#include <stdint.h>
#define CRITREG_FAILED_STEP(k) (-(critreg_outcome)(k))
#define CRITREG_LEARNER_DERIVED(forms)                                         \
    ((forms) < 16 ? (size_t)0 : CRITREG_LEARNER_PLAIN(forms))
#define CRITREG_LEARNER_PLAIN(forms)                                           \
    (16 + ((forms) / 128 < 48 ? (size_t)(forms) / 128 : (size_t)48))
#define CRITREG_LEARNER_SUMS(forms)                                            \
    ((forms) / 16 < 512 ? (size_t)(forms) / 16 : (size_t)512)
#define CRITREG_LEARNER_WORDS_FOR(forms, observations, instances, steps)  \
    ((CRITREG_LEARNER_FIXED_BYTES + CRITREG_HANDLE_POINTERS * sizeof(void *)   \
      + ((size_t)(forms) / 8 + 64 + 2 * CRITREG_LEARNER_DERIVED(forms))        \
            * (CRITREG_FEATURE_BYTES + 8 * (size_t)(instances))                \
      + CRITREG_LEARNER_SUMS(forms)                                            \
            * (CRITREG_SUM_BYTES + 8 * (size_t)(instances))                    \
      + (size_t)(instances) * CRITREG_INSTANCE_BYTES                           \
      + ((size_t)(forms) + CRITREG_LEARNER_SUMS(forms))                        \
            * (CRITREG_SPAN_BYTES * (size_t)(steps)                            \
               + 16 * (((size_t)(observations) + 63) / 64))                    \
      + (size_t)(observations)                                                 \
            * (CRITREG_OBSERVATION_BYTES                                       \
               + 8 * (CRITREG_LEARNER_PLAIN(forms)                             \
                      + CRITREG_LEARNER_DERIVED(forms)))                       \
      + (size_t)(steps) * CRITREG_STEP_BYTES + 7) / 8)
#define CRITREG_LEARNER_WORDS(forms, observations)                        \
    CRITREG_LEARNER_WORDS_FOR(forms, observations,                        \
                              CRITREG_DEFAULT_INSTANCES, 1)
#define CRITREG_PLANNER_WORDS_OF(pddl_bytes, operators, nodes, atoms, facts,   \
                                 length, state_len)                            \
    ((CRITREG_PLANNER_FIXED_BYTES + CRITREG_PLANNER_POINTERS * sizeof(void *)  \
      + CRITREG_PLANNER_WORD_BYTES * CRITREG_MORE_WORDS(atoms)                 \
      + 2 * (size_t)(pddl_bytes)                                               \
      + (size_t)(operators)                                                    \
            * (CRITREG_OPERATOR_BYTES + 24 * CRITREG_MORE_WORDS(atoms))        \
      + (size_t)(nodes)                                                        \
            * (CRITREG_NODE_BYTES + 9 * CRITREG_MORE_WORDS(atoms))             \
      + (size_t)(facts) * CRITREG_FACT_BYTES                                   \
      + (size_t)(length)                                                       \
            * (CRITREG_PLAN_STEP_BYTES + 8 * CRITREG_MORE_WORDS(atoms)         \
               + CRITREG_PLAN_STEP_POINTERS * sizeof(void *))                  \
      + 8 * ((size_t)(length) + 1) * (size_t)(state_len) + 7) / 8)
#define CRITREG_MORE_WORDS(atoms)                                              \
    ((size_t)((atoms) <= 128 ? 0 : (atoms) <= 512 ? 6 : 14))
#define CRITREG_PLANNER_WORDS_FOR(pddl_bytes, operators, nodes, length,        \
                                  state_len)                                   \
    CRITREG_PLANNER_WORDS_OF(pddl_bytes, operators, nodes,                     \
                             CRITREG_DEFAULT_ATOMS, CRITREG_DEFAULT_FACTS,     \
                             length, state_len)
#define CRITREG_PLANNER_WORDS(state_len)                                       \
    CRITREG_PLANNER_WORDS_FOR(CRITREG_DEFAULT_PDDL_BYTES,                      \
                              CRITREG_DEFAULT_OPERATORS,                       \
                              CRITREG_DEFAULT_NODES,                           \
                              CRITREG_DEFAULT_PLAN_LENGTH, state_len)
#define CRITREG_REGION_WORDS                                                   \
    ((CRITREG_REGION_FIXED_BYTES + CRITREG_HANDLE_POINTERS * sizeof(void *)) / 8)
#define CRITREG_ABI_VERSION 0
#define CRITREG_VERSION_MAJOR 0
#define CRITREG_VERSION_MINOR 1
#define CRITREG_VERSION_PATCH 0
#define CRITREG_HAS_F64 (1 << 0)
#define CRITREG_HAS_F32 (1 << 1)
#define CRITREG_HAS_MICROMATH (1 << 2)
#define CRITREG_HAS_ALGORITHM1 (1 << 3)
#define CRITREG_HAS_MANY_OBSERVATIONS (1 << 4)
#define CRITREG_HAS_BODIES (1 << 5)
#define CRITREG_HAS_LEARNER (1 << 6)
#define CRITREG_HAS_PLANNER (1 << 7)
#define CRITREG_DOMAIN_TEXT_MAX 2048
#define CRITREG_LEARNER_FIXED_BYTES 23600
#define CRITREG_REGION_FIXED_BYTES 12544
#define CRITREG_HANDLE_POINTERS 656
#define CRITREG_OBSERVATION_BYTES 76
#define CRITREG_QUESTION_BYTES 88
#define CRITREG_FEATURE_BYTES 26
#define CRITREG_SPAN_BYTES 16
#define CRITREG_SUM_BYTES 24
#define CRITREG_INSTANCE_BYTES 16
#define CRITREG_STEP_BYTES 5888
#define CRITREG_PLANNER_FIXED_BYTES 31648
#define CRITREG_PLANNER_POINTERS 3168
#define CRITREG_PLANNER_WORD_BYTES 1320
#define CRITREG_OPERATOR_BYTES 96
#define CRITREG_NODE_BYTES 46
#define CRITREG_FACT_BYTES 20
#define CRITREG_PLAN_STEP_BYTES 136
#define CRITREG_PLAN_STEP_POINTERS 13
#define CRITREG_REASON_MAX 1024
#define CRITREG_MAX_PARAMETERS 6
#define CRITREG_MAX_CONSTRAINTS 32
#define CRITREG_MAX_INTERVALS 33
#define CRITREG_F64 64
#define CRITREG_F32 32
#define CRITREG_NO_QUALITY 0
#define CRITREG_PROVISIONAL 1
#define CRITREG_APPROXIMATE 2
#define CRITREG_EXACT 3
#define CRITREG_WHY_EXPLAINED 0
#define CRITREG_WHY_NOTHING_TOLD 1
#define CRITREG_WHY_NONE_WORKED 2
#define CRITREG_WHY_ALL_WORKED 3
#define CRITREG_WHY_NO_INFLUENCE 4
#define CRITREG_WHY_TOO_FEW 5
#define CRITREG_WHY_CONTRADICTION 6
#define CRITREG_WHY_UNEXPLAINED 7
#define CRITREG_WHY_MAX 384
#define CRITREG_NOT_RUN UINT64_MAX
#define CRITREG_ALGORITHM1 1
#define CRITREG_VERSION_SPACE 2
#define CRITREG_DEFAULT_OBSERVATIONS 256
#define CRITREG_DEFAULT_FORMS 4096
#define CRITREG_MAX_DEFAULT_FORMS (1 << 24)
#define CRITREG_DEFAULT_INSTANCES 16
#define CRITREG_DEFAULT_QUESTIONS 16
#define CRITREG_MAX_QUESTIONS 64
#define CRITREG_MAX_STEPS 4
#define CRITREG_MAX_OBSERVATIONS 2048
#define CRITREG_MAX_REGIONS 32
#define CRITREG_UNDECIDED 0
#define CRITREG_PROVEN 1
#define CRITREG_REFUTED 2
#define CRITREG_LM_CUT 1
#define CRITREG_H_MAX 2
#define CRITREG_H_ADD 3
#define CRITREG_BLIND 4
#define CRITREG_MAX_ARGUMENTS 10
#define CRITREG_MAX_PLAN_LENGTH 128
#define CRITREG_DEFAULT_PLAN_LENGTH 32
#define CRITREG_DEFAULT_PDDL_BYTES 8192
#define CRITREG_DEFAULT_OPERATORS 256
#define CRITREG_DEFAULT_NODES 4096
#define CRITREG_DEFAULT_ATOMS 128
#define CRITREG_MAX_ATOMS 1024
#define CRITREG_DEFAULT_FACTS 512
#define CRITREG_PDDL_TEXT_MAX 65536
#define CRITREG_MAX_REASONS 64
#define CRITREG_NO_REASON 65535
#define CRITREG_NOT_PLANNED 0
#define CRITREG_SOLVED 1
#define CRITREG_EXHAUSTED 2
#define CRITREG_LENGTH_SPENT 3
#define CRITREG_SKELETONS_SPENT 4
#define CRITREG_SAMPLES_SPENT 5
#define CRITREG_MEMORY_FULL 6
#define CRITREG_STOPPED 7
#define CRITREG_WHY_NOTHING 0
#define CRITREG_WHY_UNREACHABLE 1
#define CRITREG_WHY_NO_SKELETON 2
#define CRITREG_WHY_PRUNED 3
#define CRITREG_WHY_LENGTH 4
#define CRITREG_WHY_TRIES 5
#define CRITREG_WHY_WORLD 6
#define CRITREG_WHY_SKELETONS 7
#define CRITREG_WHY_SAMPLES 8
#define CRITREG_WHY_MEMORY 9
#define CRITREG_WHY_STOPPED 10
#define CRITREG_MAX_STATE_NUMBERS 64
#define CRITREG_MAX_STATE_OBJECTS 32
#define CRITREG_MAX_TRAINING_OPERATORS 512
#define CRITREG_DEFAULT_SKILL_TEXTS 65536
#define CRITREG_STICK_BUTTON_ANGLES 1
typedef struct critreg_learner critreg_learner;
typedef struct critreg_planner critreg_planner;
typedef struct critreg_region critreg_region;
typedef struct critreg_skills critreg_skills;
typedef int32_t critreg_status;
typedef struct critreg_report {
    uint32_t struct_size;
    uint32_t quality;
    uint64_t enumerated;
    uint64_t kept;
    uint64_t left_out;
    uint64_t after_negative;
    uint64_t after_positive;
    uint64_t remaining;
    uint64_t calls;
    uint64_t feasible;
    uint64_t infeasible;
    uint64_t unknown;
    uint64_t strays;
    uint64_t constraints_left_out;
    uint64_t certificate_draws;
    uint64_t certificate_feasible;
    double certificate_lower_bound;
    double precision_low;
    double precision_high;
    double recall_low;
    double recall_high;
    uint64_t observed;
} critreg_report;
typedef critreg_status (*critreg_progress)(void *progress_data,
                                           const struct critreg_report *report);
typedef struct critreg_config {
    uint32_t struct_size;
    uint32_t learner;
    uint64_t seed;
    uint32_t forms;
    uint32_t observations;
    uint32_t calls;
    uint32_t certifying;
    uint32_t instances;
    uint32_t steps;
    double noise;
    double exploring;
    double slack;
    double confidence;
    const double *negative;
    const double *positive;
    critreg_progress progress;
    void *progress_data;
    uint32_t tracked;
    uint32_t precision;
    uint32_t sums;
    double precision_wanted;
    uint32_t questions;
} critreg_config;
typedef critreg_status (*critreg_make_instance)(void *user_data,
                                                size_t number,
                                                double *instance);
typedef int32_t critreg_outcome;
typedef critreg_status (*critreg_simulate)(void *user_data,
                                           const double *instance,
                                           const double *theta,
                                           critreg_outcome *outcome);
typedef struct critreg_constraint {
    uint32_t struct_size;
    int32_t has_evidence;
    uint32_t step;
    uint32_t support;
    double feasible;
    double infeasible;
} critreg_constraint;
typedef struct critreg_rng {
    uint64_t state[2];
} critreg_rng;
typedef struct critreg_proof {
    uint32_t struct_size;
    uint32_t max_boxes;
    double tolerance;
    uint32_t verdict;
    uint32_t too_fine;
    uint32_t statement;
    uint32_t boxes;
    double open;
} critreg_proof;
typedef struct critreg_planner_config {
    uint32_t struct_size;
    uint32_t heuristic;
    uint32_t state_len;
    uint32_t max_skeletons;
    uint32_t max_tries;
    uint32_t max_length;
    uint32_t max_actions;
    uint32_t max_samples;
    uint32_t patience;
    uint32_t pddl_bytes;
    uint32_t operators;
    uint32_t nodes;
    uint32_t atoms;
    uint32_t facts;
    uint32_t skeletons_per_state;
    uint32_t lookahead;
} critreg_planner_config;
typedef struct critreg_ground {
    const char *name;
    const char *object_names[CRITREG_MAX_ARGUMENTS];
    uint32_t index;
    uint32_t object_count;
    uint32_t objects[CRITREG_MAX_ARGUMENTS];
} critreg_ground;
typedef critreg_status (*critreg_execute)(void *user_data,
                                          const struct critreg_ground *ground,
                                          const double *parameters,
                                          const double *before,
                                          double *after,
                                          size_t len,
                                          uint32_t *actions);
typedef critreg_status (*critreg_holds)(void *user_data,
                                        const struct critreg_ground *ground,
                                        const double *state,
                                        size_t len,
                                        int32_t *holds);
typedef struct critreg_draw {
    const struct critreg_ground *skeleton;
    size_t length;
    size_t step;
    const double *state;
    size_t state_len;
    size_t parameter_count;
    uint32_t attempt;
    int32_t advised;
} critreg_draw;
typedef struct critreg_drawn {
    double parameters[CRITREG_MAX_PARAMETERS];
    int32_t informed;
    uint32_t reason;
} critreg_drawn;
typedef critreg_status (*critreg_sample)(void *user_data,
                                         const struct critreg_draw *draw,
                                         struct critreg_rng *rng,
                                         struct critreg_drawn *drawn);
typedef int32_t critreg_advice;
typedef critreg_status (*critreg_advise)(void *user_data,
                                         const struct critreg_ground *prefix,
                                         size_t length,
                                         const double *initial,
                                         size_t len,
                                         critreg_advice *advice,
                                         uint32_t *reason);
typedef struct critreg_callbacks {
    uint32_t struct_size;
    uint32_t prune;
    critreg_execute execute;
    critreg_holds holds;
    critreg_sample sample;
    critreg_advise advise;
    struct critreg_skills *skills;
} critreg_callbacks;
typedef struct critreg_step {
    uint32_t struct_size;
    uint32_t actions;
    struct critreg_ground ground;
    size_t parameter_count;
    double parameters[CRITREG_MAX_PARAMETERS];
    const double *state;
} critreg_step;
typedef struct critreg_metrics {
    uint32_t struct_size;
    uint32_t conclusion;
    uint32_t plan_length;
    uint32_t samples;
    uint32_t skeletons;
    uint32_t nodes_expanded;
    uint32_t nodes_created;
    uint32_t pruned;
    uint32_t postponed;
    uint32_t cut_off;
    uint32_t empty_draws;
    uint32_t informed_draws;
    uint32_t patience_ended;
    uint32_t uncounted;
    uint64_t actions;
    const char *most_failed;
    uint32_t main_reason;
    uint32_t repeated;
} critreg_metrics;
typedef struct critreg_training {
    uint32_t struct_size;
    uint32_t skill;
    uint32_t skills;
    uint32_t runs;
} critreg_training;
typedef critreg_status (*critreg_training_progress)(void *progress_data,
                                                    const struct critreg_training *training);
typedef struct critreg_skills_config {
    uint32_t struct_size;
    uint32_t state_len;
    const struct critreg_config *learner;
    uint32_t chained;
    uint32_t budget;
    uint32_t situations;
    uint32_t states;
    uint32_t situation_tasks;
    uint32_t tasks;
    uint32_t controllers;
    uint32_t skills;
    uint32_t texts;
    uint32_t nodes;
    uint32_t facts;
    uint32_t runs;
    uint32_t way;
    critreg_training_progress progress;
    void *progress_data;
} critreg_skills_config;
typedef struct critreg_skill_report {
    uint32_t struct_size;
    uint32_t finished;
    uint32_t has_region;
    uint32_t quality;
    uint32_t why;
    uint32_t tasks;
    uint32_t situations;
    uint32_t runs;
    uint32_t calls;
    uint32_t feasible;
    uint32_t infeasible;
    uint32_t certificate_draws;
    uint32_t certificate_feasible;
    uint32_t reserved;
    double certificate_lower_bound;
} critreg_skill_report;
#define CRITREG_OK 0
#define CRITREG_NULL_POINTER 1
#define CRITREG_MISALIGNED 2
#define CRITREG_TOO_SMALL 3
#define CRITREG_INVALID_ARGUMENT 4
#define CRITREG_NOT_FINITE 5
#define CRITREG_SYNTAX_ERROR 6
#define CRITREG_CAPACITY_EXCEEDED 7
#define CRITREG_EMPTY_REGION 8
#define CRITREG_NO_SAMPLE 9
#define CRITREG_NO_REGION 10
#define CRITREG_OUT_OF_SEQUENCE 11
#define CRITREG_MISMATCH 12
#define CRITREG_CORRUPT 13
#define CRITREG_BUSY 14
#define CRITREG_CANCELLED 15
#define CRITREG_NOT_A_HANDLE 16
#define CRITREG_NO_PLAN 17
#define CRITREG_USER_STATUS 1000
#define CRITREG_INFEASIBLE 0
#define CRITREG_FEASIBLE 1
#define CRITREG_UNKNOWN 2
#define CRITREG_NO_OUTCOME INT32_MIN
#define CRITREG_KEEP 0
#define CRITREG_POSTPONE 1
#define CRITREG_PRUNE 2
#ifdef __cplusplus
extern "C" {
#endif
uint32_t critreg_abi_version(void);
const char *critreg_version(void);
uint32_t critreg_capabilities(void);
const char *critreg_strerror(critreg_status status);
const char *critreg_status_name(critreg_status status);
critreg_status critreg_region_quality(const struct critreg_region *region,
                                      uint32_t *quality);
critreg_status critreg_report_init(struct critreg_report *report, size_t size);
critreg_status critreg_config_init(struct critreg_config *config, size_t size);
critreg_status critreg_check_config(const struct critreg_config *config,
                                    char *text,
                                    size_t len,
                                    size_t *needed);
size_t critreg_learner_size(const struct critreg_config *config);
size_t critreg_learner_align(void);
critreg_status critreg_learner_init(void *memory,
                                    size_t memory_len,
                                    const char *domain,
                                    const struct critreg_config *config,
                                    struct critreg_learner **learner);
critreg_status critreg_learner_instance_len(const struct critreg_learner *learner,
                                            size_t *len);
critreg_status critreg_learner_parameter_count(const struct critreg_learner *learner,
                                               size_t *count);
critreg_status critreg_choose_instances(struct critreg_learner *learner,
                                        size_t offered,
                                        critreg_make_instance make,
                                        void *user_data,
                                        double *instances,
                                        size_t room,
                                        size_t *count);
critreg_status critreg_learn_region(struct critreg_learner *learner,
                                    const double *instances,
                                    size_t count,
                                    critreg_simulate simulate,
                                    void *user_data,
                                    const struct critreg_region **region);
critreg_status critreg_learner_recover(struct critreg_learner *learner);
critreg_status critreg_ask(struct critreg_learner *learner,
                           const double *instances,
                           size_t count,
                           size_t *instance,
                           double *theta);
critreg_status critreg_observe(struct critreg_learner *learner,
                               const double *instances,
                               size_t count,
                               size_t instance,
                               const double *theta,
                               critreg_outcome outcome);
critreg_status critreg_conclude(struct critreg_learner *learner,
                                const double *instances,
                                size_t count);
critreg_status critreg_tell(struct critreg_learner *learner,
                            const double *instances,
                            size_t count,
                            critreg_outcome outcome);
critreg_status critreg_ask_many(struct critreg_learner *learner,
                                const double *instances,
                                size_t count,
                                size_t wanted,
                                uint64_t *ids,
                                size_t *instance_numbers,
                                double *thetas,
                                size_t *given);
critreg_status critreg_tell_id(struct critreg_learner *learner,
                               const double *instances,
                               size_t count,
                               uint64_t id,
                               critreg_outcome outcome);
critreg_status critreg_forget(struct critreg_learner *learner,
                              uint64_t id);
critreg_status critreg_open_questions(struct critreg_learner *learner,
                                      size_t wanted,
                                      uint64_t *ids,
                                      size_t *instance_numbers,
                                      double *thetas,
                                      size_t *given);
critreg_status critreg_is_finished(const struct critreg_learner *learner,
                                   int32_t *finished);
critreg_status critreg_learner_region(struct critreg_learner *learner,
                                      const struct critreg_region **region);
critreg_status critreg_learner_why(struct critreg_learner *learner,
                                   uint32_t *why,
                                   char *text,
                                   size_t len,
                                   size_t *needed);
critreg_status critreg_learner_report(const struct critreg_learner *learner,
                                      struct critreg_report *report);
critreg_status critreg_learner_message(const struct critreg_learner *learner,
                                       char *text,
                                       size_t len,
                                       size_t *needed);
critreg_status critreg_learner_to_svg(struct critreg_learner *learner,
                                      const double *instances,
                                      size_t count,
                                      size_t index,
                                      char *text,
                                      size_t len,
                                      size_t *needed);
critreg_status critreg_learner_save(struct critreg_learner *learner,
                                    const double *instances,
                                    size_t count,
                                    uint8_t *bytes,
                                    size_t len,
                                    size_t *needed);
critreg_status critreg_learner_resume(struct critreg_learner *learner,
                                      const double *instances,
                                      size_t count,
                                      const uint8_t *bytes,
                                      size_t len);
critreg_status critreg_learner_journal(struct critreg_learner *learner,
                                       const double *instances,
                                       size_t count,
                                       size_t from,
                                       uint8_t *bytes,
                                       size_t len,
                                       size_t *needed);
critreg_status critreg_learner_resume_journal(struct critreg_learner *learner,
                                              const double *instances,
                                              size_t count,
                                              const uint8_t *bytes,
                                              size_t len,
                                              size_t *stands);
size_t critreg_region_size(void);
size_t critreg_region_align(void);
critreg_status critreg_region_parse(void *memory,
                                    size_t memory_len,
                                    const char *domain,
                                    const char *text,
                                    struct critreg_region **region);
critreg_status critreg_region_load(void *memory,
                                   size_t memory_len,
                                   const uint8_t *bytes,
                                   size_t len,
                                   struct critreg_region **region);
critreg_status critreg_check_domain(const char *domain,
                                    char *text,
                                    size_t len,
                                    size_t *needed);
critreg_status critreg_check_region(const char *domain,
                                    const char *region_text,
                                    char *text,
                                    size_t len,
                                    size_t *needed);
critreg_status critreg_region_save(const struct critreg_region *region,
                                   uint8_t *bytes,
                                   size_t len,
                                   size_t *needed);
critreg_status critreg_region_format(const struct critreg_region *region,
                                     char *text,
                                     size_t len,
                                     size_t *needed);
critreg_status critreg_region_instance_len(const struct critreg_region *region,
                                           size_t *len);
critreg_status critreg_region_parameter_count(const struct critreg_region *region,
                                              size_t *count);
critreg_status critreg_region_constraint_count(const struct critreg_region *region,
                                               size_t *count);
critreg_status critreg_constraint_init(struct critreg_constraint *constraint,
                                       size_t size);
critreg_status critreg_region_constraint(const struct critreg_region *region,
                                         size_t index,
                                         struct critreg_constraint *constraint);
critreg_status critreg_region_constraint_format(const struct critreg_region *region,
                                                size_t index,
                                                char *text,
                                                size_t len,
                                                size_t *needed);
critreg_status critreg_region_constraint_name(const struct critreg_region *region,
                                              size_t index,
                                              char *text,
                                              size_t len,
                                              size_t *needed);
critreg_status critreg_region_contains(const struct critreg_region *region,
                                       const double *instance,
                                       const double *theta,
                                       int32_t *inside);
critreg_status critreg_region_intervals(const struct critreg_region *region,
                                        const double *instance,
                                        double *ends,
                                        size_t capacity,
                                        size_t *count);
critreg_status critreg_region_is_empty(const struct critreg_region *region,
                                       const double *instance,
                                       int32_t *empty);
critreg_status critreg_sample_region(const struct critreg_region *region,
                                     const double *instance,
                                     struct critreg_rng *rng,
                                     double *theta);
critreg_status critreg_sample_regions(const struct critreg_region *const *regions,
                                      const double *const *instances,
                                      size_t count,
                                      struct critreg_rng *rng,
                                      double *theta);
critreg_status critreg_regions_are_empty(const struct critreg_region *const *regions,
                                         const double *const *instances,
                                         size_t count,
                                         int32_t *empty);
critreg_status critreg_region_contains_many(const struct critreg_region *region,
                                            const double *instance,
                                            const double *thetas,
                                            size_t count,
                                            uint8_t *inside);
critreg_status critreg_sample_region_many(const struct critreg_region *region,
                                          const double *instance,
                                          size_t count,
                                          struct critreg_rng *rng,
                                          double *thetas,
                                          size_t *drawn);
critreg_status critreg_region_margins(const struct critreg_region *region,
                                      const double *instance,
                                      const double *theta,
                                      double *values,
                                      double *gradients);
critreg_status critreg_proof_init(struct critreg_proof *proof, size_t size);
critreg_status critreg_region_implies(const struct critreg_region *region,
                                      const struct critreg_region *specification,
                                      const double *ranges,
                                      struct critreg_proof *proof,
                                      double *instance,
                                      double *theta);
critreg_status critreg_region_question_count(const struct critreg_region *specification,
                                             size_t *count);
critreg_status critreg_region_to_smt2(const struct critreg_region *region,
                                      const struct critreg_region *specification,
                                      const double *ranges,
                                      const struct critreg_proof *proof,
                                      size_t number,
                                      char *text,
                                      size_t len,
                                      size_t *needed);
critreg_status critreg_learner_challenge(struct critreg_learner *learner,
                                         const struct critreg_region *specification,
                                         const double *ranges,
                                         struct critreg_proof *proof,
                                         double *instance,
                                         double *theta);
critreg_status critreg_region_to_c(const struct critreg_region *region,
                                   const char *name,
                                   char *text,
                                   size_t len,
                                   size_t *needed);
critreg_status critreg_region_to_rust(const struct critreg_region *region,
                                      uint32_t precision,
                                      char *text,
                                      size_t len,
                                      size_t *needed);
critreg_status critreg_region_to_svg(const struct critreg_region *region,
                                     const double *instance,
                                     char *text,
                                     size_t len,
                                     size_t *needed);
struct critreg_rng critreg_rng_seed(uint64_t seed);
critreg_status critreg_rng_uniform(struct critreg_rng *rng, double *number);
critreg_status critreg_planner_config_init(struct critreg_planner_config *config,
                                           size_t size);
critreg_status critreg_check_pddl(const char *domain,
                                  const char *problem,
                                  char *text,
                                  size_t len,
                                  size_t *needed);
critreg_status critreg_planner_measure(const char *domain,
                                       const char *problem,
                                       struct critreg_planner_config *config);
size_t critreg_planner_size(const struct critreg_planner_config *config);
size_t critreg_planner_align(void);
critreg_status critreg_planner_init(void *memory,
                                    size_t memory_len,
                                    const char *domain,
                                    const char *problem,
                                    const struct critreg_planner_config *config,
                                    struct critreg_planner **planner);
critreg_status critreg_planner_set_ranges(struct critreg_planner *planner,
                                          const char *name,
                                          const double *ranges,
                                          size_t count);
critreg_status critreg_planner_message(const struct critreg_planner *planner,
                                       char *text,
                                       size_t len,
                                       size_t *needed);
critreg_status critreg_callbacks_init(struct critreg_callbacks *callbacks,
                                      size_t size);
critreg_status critreg_plan(struct critreg_planner *planner,
                            const struct critreg_callbacks *callbacks,
                            const double *initial,
                            uint64_t seed,
                            void *user_data,
                            size_t *length);
critreg_status critreg_planner_recover(struct critreg_planner *planner);
critreg_status critreg_step_init(struct critreg_step *step, size_t size);
critreg_status critreg_planner_step(struct critreg_planner *planner,
                                    size_t index,
                                    struct critreg_step *step);
critreg_status critreg_metrics_init(struct critreg_metrics *metrics,
                                    size_t size);
critreg_status critreg_planner_why(const struct critreg_planner *planner,
                                   uint32_t *why,
                                   char *text,
                                   size_t len,
                                   size_t *needed);
critreg_status critreg_planner_metrics(const struct critreg_planner *planner,
                                       struct critreg_metrics *metrics);
critreg_status critreg_planner_failures(struct critreg_planner *planner,
                                        const char *name,
                                        uint32_t *count);
critreg_status critreg_planner_reasons(struct critreg_planner *planner,
                                       uint32_t reason,
                                       uint32_t *count);
critreg_status critreg_planner_reason_text(const struct critreg_planner *planner,
                                           char *text,
                                           size_t len,
                                           size_t *needed);
critreg_status critreg_skills_config_init(struct critreg_skills_config *config,
                                          size_t size);
size_t critreg_skills_size(const struct critreg_skills_config *config);
size_t critreg_skills_align(void);
critreg_status critreg_skills_init(void *memory,
                                   size_t memory_len,
                                   const char *domain,
                                   const char *layout,
                                   const struct critreg_skills_config *config,
                                   struct critreg_skills **skills);
critreg_status critreg_skills_add_controller(struct critreg_skills *skills,
                                             const char *name,
                                             const char *actions,
                                             const char *objects,
                                             const double *ranges,
                                             size_t count);
critreg_status critreg_skills_add(struct critreg_skills *skills,
                                  const char *controller,
                                  const char *later,
                                  const char *members,
                                  const char *text);
critreg_status critreg_skills_add_task(struct critreg_skills *skills,
                                       const char *problem,
                                       const double *initial,
                                       size_t len);
critreg_status critreg_skills_message(const struct critreg_skills *skills,
                                      char *text,
                                      size_t len,
                                      size_t *needed);
critreg_status critreg_skills_learn(struct critreg_skills *skills,
                                    const struct critreg_callbacks *callbacks,
                                    void *user_data);
critreg_status critreg_skill_report_init(struct critreg_skill_report *report,
                                         size_t size);
critreg_status critreg_skills_report(struct critreg_skills *skills,
                                     size_t index,
                                     struct critreg_skill_report *report);
critreg_status critreg_skills_format(struct critreg_skills *skills,
                                     size_t index,
                                     char *text,
                                     size_t len,
                                     size_t *needed);
critreg_status critreg_skills_domain(struct critreg_skills *skills,
                                     size_t index,
                                     char *text,
                                     size_t len,
                                     size_t *needed);
critreg_status critreg_skills_save(struct critreg_skills *skills,
                                   uint8_t *bytes,
                                   size_t len,
                                   size_t *needed);
critreg_status critreg_skills_resume(struct critreg_skills *skills,
                                     const uint8_t *bytes,
                                     size_t len);
const char *critreg_stick_button_domain(void);
size_t critreg_stick_button_state_len(uint32_t buttons);
critreg_status critreg_stick_button_task(uint64_t seed,
                                         uint32_t options,
                                         uint32_t buttons,
                                         double *state,
                                         size_t len);
critreg_status critreg_stick_button_pick(void *user_data,
                                         const double *instance,
                                         const double *theta,
                                         critreg_outcome *outcome);
critreg_status critreg_stick_button_execute(void *user_data,
                                            const struct critreg_ground *ground,
                                            const double *parameters,
                                            const double *before,
                                            double *after,
                                            size_t len,
                                            uint32_t *actions);
critreg_status critreg_stick_button_holds(void *user_data,
                                          const struct critreg_ground *ground,
                                          const double *state,
                                          size_t len,
                                          int32_t *holds);
#ifdef __cplusplus
}
#endif
#endif
