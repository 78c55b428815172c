/**
 * @file critreg.h
 * Learns for which parameters an action works, and draws parameters that do.
 *
 * A planner names an action, some problem instances and a way to try the action.
 * The library answers with a region: a few readable constraints such as
 * "grasp.y <= 2.9 (zone.top - robot.radius)". From then on it draws parameters
 * from the region, in any instance.
 *
 *     critreg_learner_init     a domain text and memory make a learner
 *     critreg_learn_region     the learner tries samples and finds the region
 *     critreg_region_format    the region as text
 *     critreg_region_constraint  what supports each constraint
 *     critreg_sample_region    parameters for the action, in an instance
 *     critreg_sample_regions   the same, good for what comes after it, too
 *     critreg_region_margins   its constraints as functions, for optimisers
 *     critreg_region_to_c      the region as C that needs no library
 *     critreg_region_to_rust   the same as Rust
 *     critreg_region_to_svg    the region as a picture of an instance
 *     critreg_learner_to_svg   the same with what was tried there
 *     critreg_planner_init     PDDL texts and memory make a planner
 *     critreg_plan             operators and parameters that reach a goal
 *     critreg_skills_learn     what a planner is to know of all controllers, by trying them
 *
 * This file is the manual. It is generated from the library; do not edit it.
 *
 *
 * MEMORY
 *
 * The library never allocates memory, and it keeps no pointer that is passed to
 * it after the call returns, with two exceptions: the memory a learner, planner, region
 * or skills were made in, and the progress callback of a learner or of skills with its
 * data. Texts,
 * configurations and manual samples are copied; instances are passed to every
 * call that needs them.
 *
 * The memory of a learner, planner, region or skills belongs to it from its init, parse or load
 * call until the program stops using the handle. In that time it must stay where
 * it is and must not be written to or copied, because the handle in it refers to
 * its own address. There is nothing to free: when the program is done with the
 * handle, it may reuse the memory for anything.
 *
 * Buffers of one call must not overlap, except that inputs may overlap inputs.
 *
 * How much memory a learner takes, with the default instances and steps, on a
 * machine with pointers of 64 bits (critreg_learner_size() tells for any other):
 *
 *     forms       observations   CRITREG_VERSION_SPACE    CRITREG_ALGORITHM1
 *           1024           128            187240 bytes           35736 bytes
 *           4096           256            734088 bytes           47512 bytes
 *          10000           256           1445232 bytes           56352 bytes
 *          20000           256           2427728 bytes           71352 bytes
 *
 * Every further instance takes 1.5 * forms + 1400 bytes more at most, every further step
 * 16 * forms + 5888. On a small machine critreg_config.precision, critreg_config.tracked
 * and critreg_config.sums save most of it: 1024 forms, 128 observations and 4
 * instances take 48608 bytes with CRITREG_F32, nothing tracked, no sums and pointers of 32
 * bits, in a library without CRITREG_ALGORITHM1. The macros of
 * CRITREG_LEARNER_WORDS() are for static arrays; they are enough for either learner.
 *
 * A planner with the default capacities takes 301768 bytes, and 264 more for every
 * number of a state. Most of it are 4096 nodes of the search, 42 bytes each.
 *
 *
 * STACK
 *
 * Each function takes less than this, with the default features, on a machine with
 * pointers of 64 bits (a program of the tests measures it); callbacks of the program come on
 * top. On a Cortex-M4 with CRITREG_F32, learning and drawing take a little over 4 KiB.
 *
 *     critreg_learner_init(), critreg_learner_resume(), critreg_ask(), critreg_tell()    24 KiB
 *     critreg_learn_region()                                                             16 KiB
 *     critreg_region_parse()                                                             12 KiB
 *     critreg_region_load()                                                               8 KiB
 *     writing and saving regions and learners                                             4 KiB
 *     critreg_sample_region()                                                            12 KiB
 *     critreg_sample_regions(), critreg_region_contains(), critreg_region_intervals()    28 KiB
 *     critreg_region_implies(), critreg_learner_challenge(), critreg_region_to_smt2()     96 KiB
 *     critreg_check_domain()                                                             24 KiB
 *     critreg_check_region()                                                             32 KiB
 *     critreg_plan()                                                                     56 KiB
 *     critreg_planner_init()                                                            192 KiB
 *     critreg_check_pddl(), critreg_planner_measure()                                   320 KiB
 *
 * Threads of small stacks make planners elsewhere, then.
 *
 *
 * CALLS
 *
 * A function returns a status and writes its outputs only on success. Exceptions:
 * functions that cannot fail return their answer (critreg_strerror(),
 * critreg_rng_seed(), sizes); needed and count tell how much room is missing;
 * critreg_check_domain(), critreg_check_region(), critreg_check_pddl() and
 * critreg_check_config() write what is wrong; critreg_sample_region_many() tells how many
 * it drew; and a generator of random numbers moves on also if nothing was found.
 *
 * Arguments stand in this order: handle, inputs, user_data, outputs.
 *
 * Every pointer is checked for NULL and alignment, every length and every number
 * for NaN and infinity (NaN is the number of an absent member of a group). A handle is recognised by a seal in its memory. What C
 * cannot check is the caller's promise: that a pointer points to as much as the
 * function's description says, that texts end with NUL, that memory is not freed.
 *
 * A buffer for text or bytes comes with its length and with needed, which may be
 * NULL. With a length of 0 the buffer may be NULL too; the call then tells the
 * length needed and returns CRITREG_TOO_SMALL. An array without any numbers, such as
 * the sample of an action without parameters, may be NULL.
 *
 * Structs start with struct_size, which their init function sets. So a program
 * compiled with an older header runs with a newer library, which then knows the
 * rest of the struct only by its defaults. A library refuses a struct that is
 * larger than the one it knows, with CRITREG_INVALID_ARGUMENT.
 *
 * A callback gets the user_data that was passed beside it. If it returns anything
 * but CRITREG_OK, the call ends with that status, and the learner or planner stays
 * usable. While a callback runs, the learner or planner that called it answers
 * CRITREG_BUSY to all functions but those that take it as const.
 *
 *
 * THREADS
 *
 * There is no global state. A function that takes a handle as const may run in
 * several threads at once on the same handle, so a region can be shared; any
 * other needs the handle for itself. A generator of random numbers belongs to
 * one thread at a time.
 *
 *
 * NUMBERS
 *
 * All numbers are double, angles are in radians, and lengths in whatever unit the
 * domain text uses. An instance is one number per attribute of every object, in
 * order of declaration; several instances stand one behind the other. A member of a
 * group that an instance does not have has NAN for all of its attributes. A sample,
 * theta, is one number per parameter, at most CRITREG_MAX_PARAMETERS.
 * The same inputs and seed give the same results on every machine.
 *
 *
 * OUTCOMES
 *
 * What came of a trial is one of these numbers:
 *
 *     CRITREG_FEASIBLE          1    the action worked
 *     CRITREG_INFEASIBLE        0    it failed
 *     CRITREG_FAILED_STEP(k)   -k    step k of a sequence failed, those before it worked
 *     CRITREG_UNKNOWN           2    there is no answer: a crash, a time-out
 *
 * So a bool is an outcome, and "*outcome = works;" is right. A sequence of actions
 * (critreg_config.steps above 1) needs to know which step failed: there
 * CRITREG_INFEASIBLE is refused. An unknown outcome teaches nothing: the sample is put
 * aside and counted in the report.
 *
 * Every other number is refused with CRITREG_INVALID_ARGUMENT, and
 * critreg_learner_message() tells which one it was. So is CRITREG_NO_OUTCOME, which
 * the outcome holds before a callback is called: a callback that writes nothing is
 * found out. The sample that was refused is asked for again.
 *
 *
 * ASK AND TELL
 *
 * critreg_learn_region() calls a simulator that answers at once. One that takes minutes per
 * trial, runs elsewhere, or is a robot, is asked and told:
 *
 *     one trial at a time        critreg_ask(), critreg_tell()
 *     several at a time          critreg_ask_many(), critreg_tell_id()
 *     a worker was lost          critreg_forget()
 *     trials of somebody else    critreg_observe(), critreg_conclude()
 *     thousands of instances     critreg_choose_instances()
 *     save the run               critreg_learner_save(), critreg_learner_journal()
 *     go on with it              critreg_learner_resume(), then critreg_open_questions()
 *
 * None of them waits. A learner belongs to one thread at a time: with threads, lock it while
 * one of these runs, and not while a trial does (c_examples/thread_pool.c; on a cluster, with
 * MPI: c_examples/mpi.c). Questions that are
 * open at once know of each other; still an answer that comes late could not help to choose
 * those asked meanwhile. With 16 workers it takes 1.2 to 1.6 times as many trials, and a
 * fourteenth of the time. Answers are taken in the order of the questions, so the run does not
 * depend on which worker was faster between two calls that ask.
 *
 * For a trial that crashed or ran out of time tell CRITREG_UNKNOWN. Append
 * critreg_learner_journal() to a file after every answer: what was told then survives a
 * crash, even one that tears the last record. With several questions open an answer waits for
 * those before it until the learner asks next, so append after asking. critreg_learner_save() keeps the open questions
 * and answers that wait, too. Both resume with more calls, more memory, on another machine,
 * and with instances appended.
 *
 *
 * LEARNERS
 *
 * CRITREG_VERSION_SPACE, the default, is sound. It looks at forms: a feature
 * that the sample moves, such as a coordinate or distance of a point, minus one of
 * the instance, or nothing. A constraint bounds a form from one side. S is the
 * form's extreme value over the feasible samples, so a bound cannot be tighter; G
 * is the value at the first infeasible sample that the constraint has to exclude,
 * so it must be tighter than that. Infeasible samples delete nothing: some
 * constraint must exclude each. The region is the fewest and simplest constraints
 * that do; the queries are those about which such hypotheses disagree, and then
 * those that halve the gap between S and G. If exactly one simplest expression of
 * the domain's constants lies in the gap, it is the bound, and its name is printed
 * behind it. critreg_region_constraint() tells S, G and the number of infeasible
 * samples for each constraint.
 *
 * The last queries (critreg_config.certifying) are draws from the region. What
 * they prove about it is in the report: the certificate. It says that at least a share of
 * the region works, and would be wrong about that in one of twenty runs at most (with a
 * confidence of 0.95): ten draws of ten prove 0.74, 60 of 60 prove 0.95, 300 of 300 0.99. All
 * draws count that were decided while the region was as it is now; one that fails changes
 * it, and counting begins anew. It speaks of the training instances, each as often as
 * the others, and of uniform draws: instances of another kind, and parameters that a planner
 * chooses at the edge of the region, are not what was drawn. That nothing is missing in the
 * region is another matter: recall_low and recall_high.
 *
 * Sequences of actions: if the action is a chain, say in critreg_config.steps how
 * many steps it has, and answer with CRITREG_FAILED_STEP(k) if step k failed. Each step
 * is learned from the samples that reached it, and the region is what all of them
 * need. CRITREG_ALGORITHM1 makes no difference between steps.
 *
 * Wrong outcomes: if a share of them is wrong, say so in
 * critreg_config.noise. Every sample is then asked until one outcome leads by enough
 * (sequential test): about 3 calls per sample with 2% of wrong outcomes, 6 with 10%.
 * Allow for as many more calls.
 *
 * CRITREG_NO_REGION is an honest answer: no form excludes some infeasible sample,
 * the hypothesis is too complex for what it explains, or the parameters were not
 * shown to matter. Keep the original sampler.
 *
 * CRITREG_ALGORITHM1 is the thesis's learner as written, for comparison. It wants
 * the manual samples critreg_config.negative and .positive, which the other learner
 * does not need.
 *
 *
 * THE DOMAIN TEXT
 *
 * It says what there is to know about an action: objects whose attributes make up
 * an instance, constants, the parameters of the action, and points, of which those
 * that move with a parameter are the heart of the matter:
 *
 *     object stick  { x: length, y: length, theta: angle }
 *     object holder { x: length, y: length, theta: angle }
 *     constant stick.width  = 3.0: length
 *     constant holder.width = 0.3: length
 *     constant robot.radius = 0.1: length
 *     constant zone.top     = 3.0: length
 *     parameter mu in [0, 1]
 *     point grasp         = stick  + (mu * stick.width, 0)
 *     point holder.centre = holder + (0.5 * holder.width, 0)
 *
 * The grammar, in EBNF:
 *
 *     domain    = { statement } ;                 (* "#" starts a comment *)
 *     statement = type | object | constant | parameter | shape | point
 *               | feature | compare | relate ;
 *     type      = "type" name attributes ;
 *     object    = "object" named ( attributes | { "," named } ":" name ) ;
 *     named     = name [ "[" number "]" ] ;       (* a group of so many members *)
 *     attributes= "{" [ name ":" dimension { "," name ":" dimension } ] "}" ;
 *     dimension = "length" | "angle" | "area" | "flag" | "none" ;
 *     constant  = "constant" path "=" expr ":" dimension ;
 *     parameter = "parameter" name "in" "[" expr "," expr "]" [ ":" dimension ] ;
 *     shape     = "shape" path "=" ( solid [ "rounded" factor ] [ "centred" ] | "none" )
 *               | "shape" name "=" path { "+" path } ;    (* of earlier bodies *)
 *     solid     = "circle" "(" expr ")"           (* a ball in space *)
 *               | "rectangle" "(" expr "," expr ")"         (* a plate in space *)
 *               | "box" "(" expr "," expr "," expr ")"
 *               | "capsule" "(" expr "," expr ")" (* length along x, radius *)
 *               | "segment" "(" expr ")" ;        (* along x *)
 *     point     = "point" path "=" frame [ "turned" turn ] [ "+" offset ] ;
 *     frame     = "world" | path ;                (* object or earlier point *)
 *     turn      = factor                          (* yaw *)
 *               | "(" expr "," expr "," expr ")" ; (* yaw, pitch, roll *)
 *     offset    = "(" expr "," expr [ "," expr ] ")" ;
 *     feature   = "feature" path "=" expr [ ":" dimension ] ;
 *     compare   = "compare" expr { "," expr } ;
 *     relate    = "relate" path { "," path } ;
 *     expr      = term { ( "+" | "-" ) term } ;
 *     term      = factor { ( "*" | "/" ) factor } ;
 *     factor    = number | "pi" | path | "-" factor | "(" expr ")" | call | extreme ;
 *     extreme   = ( "min" | "max" ) "(" ( path | call ) ")" ;    (* over a group *)
 *     call      = ( "dist" | "dist_x" | "dist_y" | "dist_z" | "angle" | "off" )
 *                   "(" path "," path ")"
 *               | "angle" "(" path "," path "," path ")"    (* at the second point *)
 *               | "angle" "(" path "," path "," symmetry ")"     (* of headings *)
 *               | relation "(" path "," path ")"  (* between their bodies *)
 *               | "clear" "(" line "," path ")"
 *               | "area" "(" name ")" ;
 *     relation  = "clear" | "inside" | "inside_x" | "inside_y" | "inside_z" | "over"
 *               | "corner" | "x_in" | "y_in" | "z_in" | "abs_x_in" | "abs_y_in" | "abs_z_in" ;
 *     symmetry  = plain { "*" plain } | "symmetry" number ;   (* 2 pi / n, or n *)
 *     plain     = number | "pi" | path ;
 *     line      = ( "line" | "sweep" ) "(" path "," path ")" ;
 *     path      = name { "." name } ;
 *     name      = ( letter | "_" ) { letter | digit | "_" } ;
 *
 * No name is a word of the language: those of statements (type, object, constant,
 * parameter, shape, point, feature, compare, relate), in, turned, world, rounded, centred,
 * and, or, not, true, pi, symmetry, line, sweep, and all before "(" in extreme, call and
 * relation, as min, off or corner. Solids and dimensions are no such words: an object may be
 * a box, and an attribute may have any name.
 *
 * An object with the attributes x and y (and z, and the angles theta or yaw, pitch, roll) is
 * a point as well. An offset is along the axes of the frame, after the turn. The
 * corner of a rectangle is its object's position unless it is centred; a circle or a
 * rectangle of constant sizes on an object adds the points left, right, bottom, top and,
 * for rectangles, centre. Offsets, turns and sizes are made of numbers, constants,
 * attributes and parameters. "rounded r" grows a rectangle, a box or a segment by r on all
 * sides, as if a ball of that radius went around it: a plate of 0.2 rounded 0.01 is 0.22 wide.
 *
 * Only quantities of one dimension are added and compared. Lengths are in one unit for the
 * whole text, angles in radians. A flag is 0 or 1, and true above 0.5. Whatever else has no
 * word is "none", as a ratio, a mass, a speed, a force or a volume: numbers that are all
 * compared with each other. A product of two lengths is an area, of an angle and a length a
 * length (an arc), and plain numbers and flags scale. For other products, as a volume, there
 * is no word: they fit every number.
 *
 * The angle of two headings is in [0, pi]. Where one of them belongs to a thing that looks
 * the same after a turn by 2*pi/n, for a whole n from 2 to 12, angle(a, b, pi), as of a bar,
 * angle(a, b, 0.5*pi), as of a square, or in general angle(a, b, symmetry n) is how far the
 * angle is from the nearest such turn: in [0, pi/n].
 *
 * BODIES
 *
 * A shape makes a body of an object or a point, also of one that moves with parameters,
 * and one of each member of a group, with the member's own sizes. So an action is described
 * by what is there, and no point has to carry the answer:
 *
 *     shape tray  = rectangle(tray.width, tray.depth) centred
 *     shape place = rectangle(item.width, item.depth) centred
 *     shape can   = circle(can.radius)
 *
 * Its regions then read inside(place, tray) >= 0 and min(clear(place, can)) >= 0. All
 * relations are lengths, of the first body to the second one, in 2D and in 3D:
 *
 *     clear      how far they are apart; below zero, how deep they meet
 *     inside     how much room is left around the first one in the second one;
 *                inside_x, inside_y, inside_z: along one axis of the second one
 *     over       how far the first one's centre is inside of what the second one covers
 *     corner     how far the nearest corner of the first one is from the second one
 *     x_in, ...  where the first one's centre is in the frame of the second one;
 *                abs_x_in, ...: the magnitude of that
 *
 * The straight line from point to point is a body, too: clear(line(eye, sign), post) >= 0
 * says that the sign is seen past the post, and clear(sweep(robot, goal), post) >= 0 that
 * the way there is free, because a sweep is as wide as the circle of its first point.
 * off(sign, eye) <= 0.5 says that the sign is in a cone about the x axis of the eye: it is the
 * angle between that axis and the direction from the eye to the sign.
 *
 * Several bodies may have one name, as "shape gripper = left + right": clear(gripper, can),
 * inside(gripper, tray), over and corner are the least value over the parts, and clear also
 * takes such a name as its second body. A name whose shape is none is only there for others
 * to be placed in: learners say nothing of how it lies to things.
 *
 * A point without a shape is a body without extent. A size below zero is that of an absent
 * body, of which no constraint holds; an absent member of a group is passed over.
 *
 * A group, as in "object obstacle[6]: block", is any number of objects of one type,
 * up to the one in brackets (see Limits). An instance has the numbers of all six; each
 * number of a member that is absent is NAN. A shape or point of a group is one of each member. Nothing is
 * said of a single member, but min(...) and max(...) are the least and the greatest
 * value over the members that are there: "min(dist(hand, obstacle)) >= 0.2" holds
 * if the hand is clear of every obstacle, also if there is none. So one region
 * serves instances with different numbers of objects.
 *
 * A law that is known is written down once, and is compared before everything else:
 *
 *     feature slide = v*v / (2*9.81*ground.friction): length
 *
 * Regions call it by its name, as in slide - goal.far <= 0. What a product or a quotient
 * measures is what the text says; without, it follows from the factors, and where there is no
 * word for it, as for a mass divided by a length, it fits every number. A learner also looks
 * for laws of its own: products and quotients of a distance or a parameter and of up to two
 * numbers of the scene. "compare hand.x, slide" says that these expressions, and the features
 * with a name, are all that is compared, and "relate gripper, can" that relations between
 * points and bodies are of these only.
 *
 * Limits: CRITREG_DOMAIN_TEXT_MAX bytes; 16 types, 64 attributes of types, 32
 * objects, 8 groups, 255 numbers of an instance, 32 constants, 6 parameters, 64
 * points of which 8 depend on a parameter, 16 shapes with key points, 24 bodies, 4 names
 * for up to 6 bodies each, 8 features. Every member of a group counts as an object, with its own
 * numbers, points and bodies, so that a group has up to 32 members if it is all there is. A
 * point that moves with a parameter cannot be placed in a group, but in a single object. A region can refer to 32 points, with those they are placed
 * in. A text without an attribute of an object and without a parameter is refused: there is
 * nothing to learn then.
 *
 *
 * THE REGION TEXT
 *
 *     region     = conjunction { "or" conjunction } ;
 *     conjunction= literal { "and" literal } ;
 *     literal    = "not" literal | "true" | "(" region ")" | constraint ;
 *     constraint = expr ( "<" | "<=" | ">=" | ">" ) expr [ "(" expr ")" ] ;
 *
 * Here an expr may also name the coordinates of points, as in grasp.y, and
 * distances, angles and areas, and min(...) and max(...) of those of a group. The expression in brackets behind a constraint
 * names its right side in words of the domain; it is kept and printed, and
 * otherwise ignored. Limit: CRITREG_MAX_CONSTRAINTS constraints.
 *
 *
 * PLANNING
 *
 * Whoever has a planner uses the regions: critreg_sample_region() for an action,
 * critreg_sample_regions() for an action that has to be good for later ones,
 * critreg_region_contains() without a sample for an action without parameters, and
 * CRITREG_EMPTY_REGION as the reason to postpone a plan skeleton: proven is that no
 * parameters are in the region, and a learned region may be wrong.
 *
 * Whoever has none uses this one: search, then sample (Srivastava et al. 2014;
 * Chitnis et al. 2022). An operator is a PDDL action with objects and, beyond PDDL,
 * continuous parameters. Planning goes through sequences of operators that reach the
 * goal in the abstract (A* with LM-cut), and draws the parameters of each until the
 * program's simulator does what the operators promise. A complete program:
 *
 *     #include <stdio.h>
 *     #include "critreg.h"
 *
 *     // A cart drives along a rail and lights a lamp, which stands at 3.
 *     static const char DOMAIN[] =
 *         "(define (domain rail)"
 *         "  (:predicates (AtLamp) (Lit))"
 *         "  (:action Drive :parameters () :effect (AtLamp))"
 *         "  (:action Light :parameters () :precondition (AtLamp) :effect (Lit)))";
 *     static const char PROBLEM[] =
 *         "(define (problem light) (:domain rail) (:init) (:goal (Lit)))";
 *
 *     // The state: where the cart is, and whether the lamp is lit.
 *     static critreg_status execute(void *user_data, const critreg_ground *ground,
 *                                   const double *parameters, const double *before,
 *                                   double *after, size_t len, uint32_t *actions) {
 *         (void)user_data, (void)len;
 *         if (ground->index == 0)
 *             after[0] = before[0] + parameters[0];
 *         else
 *             after[1] = 1.0;
 *         *actions = 1;
 *         return CRITREG_OK;
 *     }
 *
 *     static critreg_status holds(void *user_data, const critreg_ground *ground,
 *                                 const double *state, size_t len, int32_t *holds) {
 *         (void)user_data, (void)len;
 *         if (ground->index == 0)
 *             *holds = state[0] > 2.9 && state[0] < 3.1;
 *         else
 *             *holds = state[1] > 0.5;
 *         return CRITREG_OK;
 *     }
 *
 *     static uint64_t memory[CRITREG_PLANNER_WORDS(2)];
 *
 *     int main(void) {
 *         static const double far[2] = {-4.0, 4.0}, start[2] = {0.0, 0.0};
 *         critreg_planner_config config;
 *         critreg_callbacks callbacks;
 *         critreg_planner *planner;
 *         critreg_step step;
 *         size_t length, i;
 *
 *         critreg_planner_config_init(&config, sizeof config);
 *         config.state_len = 2;
 *         critreg_callbacks_init(&callbacks, sizeof callbacks);
 *         callbacks.execute = execute;
 *         callbacks.holds = holds;
 *         if (critreg_planner_init(memory, sizeof memory, DOMAIN, PROBLEM, &config,
 *                                  &planner) != CRITREG_OK
 *             || critreg_planner_set_ranges(planner, "Drive", far, 1) != CRITREG_OK
 *             || critreg_plan(planner, &callbacks, start, 1, NULL, &length)
 *                 != CRITREG_OK)
 *             return 1;
 *         critreg_step_init(&step, sizeof step);
 *         for (i = 0; i < length; i++) {
 *             critreg_planner_step(planner, i, &step);
 *             printf("%s %.1f\n", step.ground.name, step.parameters[0]);
 *         }
 *         return 0;
 *     }
 *
 * It prints "Drive 3.0" and "Light 0.0".
 *
 * What is known of actions is brought in by skills, see the next chapter; or by two more
 * callbacks: sample draws from regions, and advise tells the search that a sequence of
 * operators is not expected to work before anything is drawn for it. All of it is advice: if
 * there is no plan before patience ends, planning begins anew without it. critreg_metrics
 * tells what planning cost, which operator failed most often, and which reason was given most
 * often.
 *
 * The PDDL that is understood is that of classical planning, STRIPS, ADL and the costs
 * of actions:
 *
 *     domain     = "(" "define" "(" "domain" name ")" { section | action } ")" ;
 *     section    = "(" ":requirements" { keyword } ")"
 *                | "(" ":types" { typed-name } ")" | "(" ":constants" { typed-name } ")"
 *                | "(" ":predicates" { "(" name { typed-var } ")" } ")"
 *                | "(" ":functions" { "(" name { typed-var } ")" [ "-" type ] } ")" ;
 *     action     = "(" ":action" name { ":parameters" "(" { typed-var } ")"
 *                | ":precondition" condition | ":effect" effect } ")" ;
 *     problem    = "(" "define" "(" "problem" name ")" { part } ")" ;
 *     part       = "(" ":domain" name ")" | "(" ":requirements" { keyword } ")"
 *                | "(" ":objects" { typed-name } ")" | "(" ":init" { fact } ")"
 *                | "(" ":goal" condition ")"
 *                | "(" ":metric" "minimize" "(" "total-cost" | "total-time" ")" ")" ;
 *     fact       = atom | "(" "not" atom ")" | "(" "=" atom number ")" ;
 *     condition  = "(" ")" | "(" "and" { condition } ")" | "(" "or" { condition } ")"
 *                | "(" "not" condition ")" | "(" "imply" condition condition ")"
 *                | "(" "forall" "(" { typed-var } ")" condition ")"
 *                | "(" "exists" "(" { typed-var } ")" condition ")"
 *                | "(" "=" term term ")" | atom ;
 *     effect     = "(" ")" | "(" "and" { effect } ")" | "(" "not" atom ")" | atom
 *                | "(" "forall" "(" { typed-var } ")" effect ")"
 *                | "(" "when" condition effect ")"
 *                | "(" "increase" "(" "total-cost" ")" ( number | atom ) ")" ;
 *     atom       = "(" name { term } ")" ;
 *     term       = name | variable ;             (* names only in problems *)
 *     typed-name = name [ "-" type ] ;           (* "a b - c": both are c *)
 *     typed-var  = variable [ "-" type ] ;
 *     type       = name | "(" "either" { name } ")" ;
 *
 * ";" starts a comment. Sections may stand in any order; case does not matter. Costs are
 * whole numbers, and count if the problem has a metric. Everything else of PDDL is refused
 * by name, at its line and column. Atoms of predicates that no action changes are decided
 * when the planner is made, and not asked for; nor are negations, nor atoms that no
 * action can reach. An action with alternatives in its precondition or with conditional
 * effects counts as several ground operators, at most 64.
 *
 * Limits: 64 types, constants, predicates and actions, with 10 arguments each and 192 of
 * all predicates and of all actions together; 768 words such as "and", preconditions and
 * effects in all; 255 objects, 128 words and atoms of the goal. The rest is in
 * critreg_planner_config.
 *
 *
 * SKILLS
 *
 * Skills are what is to be known of the program's controllers: with which parameters one
 * works, with which of them a later one works, too, and in which states one works at all.
 * critreg_skills_learn() finds out by trying operators in the program's simulator, and
 * critreg_plan() takes what was learned in one field:
 *
 *     critreg_skills_init(memory, memory_len, DOMAIN, LAYOUT, &config, &skills);
 *     critreg_skills_add_controller(skills, "Pick", NULL, NULL, ranges, 1);
 *     critreg_skills_add(skills, "Pick", NULL, NULL, PICK);         // Pick alone
 *     critreg_skills_add(skills, "Pick", "Place", NULL, NULL);      // and before Place
 *     critreg_skills_add_task(skills, problem, state, state_len);   // several dozens
 *     critreg_skills_learn(skills, &callbacks, user_data);
 *     callbacks.skills = skills;
 *     critreg_plan(planner, &callbacks, initial, seed, user_data, &length);
 *
 * Parameters are then drawn from where the step and those that come later are expected to
 * work, sequences of operators that cannot work are postponed (or pruned, see
 * critreg_callbacks.prune), and critreg_planner_why() and critreg_planner_reason_text() say
 * what stands in the way, as "Press(robby, button0) needs button0.y <= 2.9, and it is 4.1". Training tasks
 * and tasks to plan may have different objects. c_examples/plan_tasks.c and
 * c_examples/own_world.c are complete programs.
 *
 * The layout says which numbers of a state belong to which object. It is a domain text that
 * declares objects; their numbers follow one another in its order:
 *
 *     type robot { x: length, y: length }
 *     type box   { x: length, y: length, held: flag }
 *     object robby: robot
 *     object boxes[5]: box
 *
 * An object that the layout names is the object of that name in the problem, or one that the
 * problem does not have. A group stands for all other objects of its type in the problem, in
 * the order of their names (box2 before box10), as many as there are. Objects of neither kind
 * have no numbers, and numbers behind the last belong to nobody.
 *
 * A skill is described by a domain text, as of a learner, whose objects are roles. Their names
 * say who fills them; their attributes are those of the type, as many as matter:
 *
 *     box            the controller's object of the type box; if it has none, that of the
 *                    later one; else the only object of that type in the state
 *     box2           likewise the second object of the type
 *     later_box      the later controller's object, even if the controller has one, too
 *     other_box      the only object of the type that is none of the controllers'
 *     box[4]         a group: all objects of the type
 *     other_box[4]   a group: those that are none of the controllers'
 *
 * With parameters, a text asks with which of them the controller works; those that it does not
 * declare are drawn as the program draws them. Without, it asks in which states. Of a pair it
 * asks with which parameters of the first, or in which states, the later one works, with what
 * is needed in between; and it needs no text of its own: it follows from those of the two, in
 * which roles of the same name are the same object. Skills of single controllers come first,
 * in the order in which they are needed on the way.
 *
 * Learning is deterministic, can be stopped by any callback and goes on where it was, in the
 * same memory or, with critreg_skills_save() and critreg_skills_resume(), in another. A state
 * has at most CRITREG_MAX_STATE_NUMBERS numbers, a task CRITREG_MAX_STATE_OBJECTS objects, and
 * a training task 128 ground atoms and CRITREG_MAX_TRAINING_OPERATORS ground operators.
 *
 *
 * LINKING
 *
 * Link with -lcritreg, and for the static library with -lm too. From C++, critreg.hpp
 * wraps what follows.
 */


#ifndef CRITREG_H
#define CRITREG_H

#include <stddef.h>
#include <stdint.h>

/**
 * The outcome of a sequence of actions whose step k failed, from 1; the steps before it
 * worked.
 */
#define CRITREG_FAILED_STEP(k) (-(critreg_outcome)(k))

/** Left sides of forms that a learner derives; for CRITREG_LEARNER_WORDS_FOR. */
#define CRITREG_LEARNER_DERIVED(forms)                                         \
    ((forms) < 16 ? (size_t)0 : CRITREG_LEARNER_PLAIN(forms))

/** Its other left sides. */
#define CRITREG_LEARNER_PLAIN(forms)                                           \
    (16 + ((forms) / 128 < 48 ? (size_t)(forms) / 128 : (size_t)48))

/** Forms of a learner with a sum on the right, beside the others. */
#define CRITREG_LEARNER_SUMS(forms)                                            \
    ((forms) / 16 < 512 ? (size_t)(forms) / 16 : (size_t)512)

/**
 * How many uint64_t make the memory of a learner with room for so many forms,
 * observations, problem instances and steps of an action sequence, for static
 * arrays. It is enough for either learner; critreg_learner_size() tells the exact
 * number of bytes.
 */
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

/**
 * The same with room for CRITREG_DEFAULT_INSTANCES instances and one step, which
 * is what a configuration has unless it tells.
 *
 *     static uint64_t memory[CRITREG_LEARNER_WORDS(4096, 256)];
 */
#define CRITREG_LEARNER_WORDS(forms, observations)                        \
    CRITREG_LEARNER_WORDS_FOR(forms, observations,                        \
                              CRITREG_DEFAULT_INSTANCES, 1)

/**
 * How many uint64_t make the memory of a planner with room for so many bytes of
 * PDDL, ground operators, nodes of the search, ground atoms, atoms of :init, steps of a
 * plan and numbers of a state, for static arrays; see critreg_planner_config.
 * critreg_planner_size() tells the exact number of bytes.
 */
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

/** How many more words than two a set of so many atoms has. */
#define CRITREG_MORE_WORDS(atoms)                                              \
    ((size_t)((atoms) <= 128 ? 0 : (atoms) <= 512 ? 6 : 14))

/** The same with room for as many atoms as a configuration has unless it tells. */
#define CRITREG_PLANNER_WORDS_FOR(pddl_bytes, operators, nodes, length,        \
                                  state_len)                                   \
    CRITREG_PLANNER_WORDS_OF(pddl_bytes, operators, nodes,                     \
                             CRITREG_DEFAULT_ATOMS, CRITREG_DEFAULT_FACTS,     \
                             length, state_len)

/**
 * The same with the other capacities as a configuration has them unless it tells.
 *
 *     static uint64_t memory[CRITREG_PLANNER_WORDS(13)];
 */
#define CRITREG_PLANNER_WORDS(state_len)                                       \
    CRITREG_PLANNER_WORDS_FOR(CRITREG_DEFAULT_PDDL_BYTES,                      \
                              CRITREG_DEFAULT_OPERATORS,                       \
                              CRITREG_DEFAULT_NODES,                           \
                              CRITREG_DEFAULT_PLAN_LENGTH, state_len)

/**
 * How many uint64_t make the memory of a region that belongs to no learner.
 *
 *     static uint64_t memory[CRITREG_REGION_WORDS];
 */
#define CRITREG_REGION_WORDS                                                   \
    ((CRITREG_REGION_FIXED_BYTES + CRITREG_HANDLE_POINTERS * sizeof(void *)) / 8)

/**
 * The version of the binary interface, and the number in the name of the shared library,
 * libcritreg.so.0. It changes when a program has to be compiled again; compare it with
 * critreg_abi_version() when the library is loaded at run time.
 */
#define CRITREG_ABI_VERSION 0

/**
 * The version of this header. The library that runs may be another one: see
 * critreg_version(). What may change when stands in ffi/README.md.
 */
#define CRITREG_VERSION_MAJOR 0

/**
 * The second number of it.
 */
#define CRITREG_VERSION_MINOR 1

/**
 * The third number of it.
 */
#define CRITREG_VERSION_PATCH 0

/**
 * Of critreg_capabilities(): CRITREG_F64, learning and drawing with double.
 */
#define CRITREG_HAS_F64 (1 << 0)

/**
 * CRITREG_F32, learning and drawing with float.
 */
#define CRITREG_HAS_F32 (1 << 1)

/**
 * The roots and sines of CRITREG_F32 come from micromath: smaller, and good to three digits.
 */
#define CRITREG_HAS_MICROMATH (1 << 2)

/**
 * CRITREG_ALGORITHM1, the learner of the thesis.
 */
#define CRITREG_HAS_ALGORITHM1 (1 << 3)

/**
 * Learners with up to 2048 observations; without it, 256.
 */
#define CRITREG_HAS_MANY_OBSERVATIONS (1 << 4)

/**
 * Bodies with sizes, and the relations between them; without it, a shape has key points only.
 */
#define CRITREG_HAS_BODIES (1 << 5)

/**
 * Learners; without them there are regions only, from text or bytes.
 */
#define CRITREG_HAS_LEARNER (1 << 6)

/**
 * The planner, skills and the built-in environment.
 */
#define CRITREG_HAS_PLANNER (1 << 7)

/**
 * Longest domain text in bytes, with its NUL.
 */
#define CRITREG_DOMAIN_TEXT_MAX 2048

/**
 * Bytes of a learner that do not depend on its capacity, on a machine with
 * pointers of 32 bits; for CRITREG_LEARNER_WORDS.
 */
#define CRITREG_LEARNER_FIXED_BYTES 23600

/**
 * Bytes of a region, on a machine with pointers of 32 bits; for
 * CRITREG_REGION_WORDS.
 */
#define CRITREG_REGION_FIXED_BYTES 12544

/**
 * Pointers in a handle, which take more room on a machine with longer ones; for
 * CRITREG_LEARNER_WORDS and CRITREG_REGION_WORDS.
 */
#define CRITREG_HANDLE_POINTERS 656

/**
 * Bytes of a sample that was told, apart from its left sides; for
 * CRITREG_LEARNER_WORDS.
 */
#define CRITREG_OBSERVATION_BYTES 76

/**
 * Bytes of a question that can be open, of which CRITREG_LEARNER_WORDS has
 * CRITREG_DEFAULT_QUESTIONS.
 */
#define CRITREG_QUESTION_BYTES 88

/**
 * Bytes of a feature, apart from its values in the instances; for
 * CRITREG_LEARNER_WORDS.
 */
#define CRITREG_FEATURE_BYTES 26

/**
 * Bytes of a form and step; for CRITREG_LEARNER_WORDS.
 */
#define CRITREG_SPAN_BYTES 16

/**
 * Bytes of a form with a sum, apart from its values in the instances; for
 * CRITREG_LEARNER_WORDS.
 */
#define CRITREG_SUM_BYTES 24

/**
 * Bytes of an instance, apart from values; for CRITREG_LEARNER_WORDS.
 */
#define CRITREG_INSTANCE_BYTES 16

/**
 * Bytes of a step; for CRITREG_LEARNER_WORDS.
 */
#define CRITREG_STEP_BYTES 5888

/**
 * Bytes of a planner that do not depend on its capacity, apart from pointers; for
 * CRITREG_PLANNER_WORDS.
 */
#define CRITREG_PLANNER_FIXED_BYTES 31648

/**
 * Pointers of a planner that do not depend on its capacity; for
 * CRITREG_PLANNER_WORDS.
 */
#define CRITREG_PLANNER_POINTERS 3168

/**
 * Bytes of a planner for every word of sets beyond two; for CRITREG_PLANNER_WORDS_OF.
 */
#define CRITREG_PLANNER_WORD_BYTES 1320

/**
 * Bytes of a ground operator; for CRITREG_PLANNER_WORDS.
 */
#define CRITREG_OPERATOR_BYTES 96

/**
 * Bytes of a node of the search; for CRITREG_PLANNER_WORDS.
 */
#define CRITREG_NODE_BYTES 46

/**
 * Bytes of an atom or number of :init; for CRITREG_PLANNER_WORDS.
 */
#define CRITREG_FACT_BYTES 20

/**
 * Bytes of a step of the longest plan, apart from its state and pointers; for
 * CRITREG_PLANNER_WORDS.
 */
#define CRITREG_PLAN_STEP_BYTES 136

/**
 * Pointers of a step of the longest plan; for CRITREG_PLANNER_WORDS.
 */
#define CRITREG_PLAN_STEP_POINTERS 13

/**
 * Bytes that are enough for the words of critreg_planner_reason_text(), with their NUL.
 */
#define CRITREG_REASON_MAX 1024

/**
 * Most parameters of an action: an array for theta of this length fits every
 * domain.
 */
#define CRITREG_MAX_PARAMETERS 6

/**
 * Most constraints of a region.
 */
#define CRITREG_MAX_CONSTRAINTS 32

/**
 * Most intervals that critreg_region_intervals() can find.
 */
#define CRITREG_MAX_INTERVALS 33

/**
 * For critreg_config.precision: computing with double, the default. The same inputs
 * give the same bytes on every machine.
 */
#define CRITREG_F64 64

/**
 * For critreg_config.precision: computing with float, in half the memory, and much
 * faster on a microcontroller whose floating-point unit has single precision only.
 * Thresholds are good to about six digits.
 */
#define CRITREG_F32 32

/**
 * Of a region: nothing is known of its quality; it was parsed, loaded, or learned by
 * CRITREG_ALGORITHM1. Of a learner: there is no region.
 */
#define CRITREG_NO_QUALITY 0

/**
 * It agrees with the answers so far, but they are too few to tell it from chance.
 */
#define CRITREG_PROVISIONAL 1

/**
 * It is wrong about some answers: the truth is not quite what the domain text can say, or
 * answers are wrong. The report estimates how good it is.
 */
#define CRITREG_APPROXIMATE 2

/**
 * It agrees with all answers, but for the few that critreg_report.strays counts.
 */
#define CRITREG_EXACT 3

/**
 * There is an exact region.
 */
#define CRITREG_WHY_EXPLAINED 0

/**
 * Nothing was told yet.
 */
#define CRITREG_WHY_NOTHING_TOLD 1

/**
 * No sample worked. A smaller range of the parameters helps.
 */
#define CRITREG_WHY_NONE_WORKED 2

/**
 * All samples worked: the region is everything.
 */
#define CRITREG_WHY_ALL_WORKED 3

/**
 * In no instance did some samples work and others not.
 */
#define CRITREG_WHY_NO_INFLUENCE 4

/**
 * There are too few answers for the smallest explanation.
 */
#define CRITREG_WHY_TOO_FEW 5

/**
 * Answers at one and the same place contradict each other.
 */
#define CRITREG_WHY_CONTRADICTION 6

/**
 * Nothing that the domain text can say explains some of the samples.
 */
#define CRITREG_WHY_UNEXPLAINED 7

/**
 * Bytes that are enough for the words of critreg_learner_why(), with their NUL.
 */
#define CRITREG_WHY_MAX 384

/**
 * In a critreg_report: this did not happen (yet), or never does in this learner.
 */
#define CRITREG_NOT_RUN UINT64_MAX

/**
 * For critreg_config.learner: the learner of the thesis (Algorithm 1, 4.3). It
 * prunes hypotheses "left comparison right". It is the baseline and it is
 * fragile: often it learns nothing, and says so with CRITREG_NO_REGION.
 */
#define CRITREG_ALGORITHM1 1

/**
 * For critreg_config.learner: the sound learner, and the default. It keeps every
 * hypothesis that agrees with the outcomes, asks where they disagree, names the thresholds it
 * finds, says what supports each constraint, and certifies the region by draws
 * from it. Where none explains the outcomes it says CRITREG_NO_REGION.
 */
#define CRITREG_VERSION_SPACE 2

/**
 * Observations a learner has room for unless the configuration tells: this many,
 * or calls + 2 if that is more.
 */
#define CRITREG_DEFAULT_OBSERVATIONS 256

/**
 * Forms that critreg_learner_size() makes room for unless the configuration
 * tells.
 */
#define CRITREG_DEFAULT_FORMS 4096

/**
 * Most forms that a learner takes without being told how many.
 */
#define CRITREG_MAX_DEFAULT_FORMS (1 << 24)

/**
 * Problem instances a learner has room for unless the configuration tells.
 */
#define CRITREG_DEFAULT_INSTANCES 16

/**
 * Questions that can be open at once unless the configuration tells.
 */
#define CRITREG_DEFAULT_QUESTIONS 16

/**
 * Most questions that can be open at once.
 */
#define CRITREG_MAX_QUESTIONS 64

/**
 * Most steps of a sequence of actions.
 */
#define CRITREG_MAX_STEPS 4

/**
 * Most observations of CRITREG_VERSION_SPACE; 256 in a library that was built without
 * the feature many_observations.
 */
#define CRITREG_MAX_OBSERVATIONS 2048

/**
 * Most regions of critreg_sample_regions() and critreg_regions_are_empty().
 */
#define CRITREG_MAX_REGIONS 32

/**
 * In a critreg_proof: neither a proof nor a counterexample was found.
 */
#define CRITREG_UNDECIDED 0

/**
 * In a critreg_proof: the region satisfies the specification, in all instances in the
 * ranges and with all parameters.
 */
#define CRITREG_PROVEN 1

/**
 * In a critreg_proof: there is a counterexample.
 */
#define CRITREG_REFUTED 2

/**
 * For critreg_planner_config.heuristic: LM-cut (Helmert and Domshlak 2009), the
 * default. Never too high, so that shorter sequences come before longer ones.
 */
#define CRITREG_LM_CUT 1

/**
 * For critreg_planner_config.heuristic: h-max (Bonet and Geffner 2001), never
 * above LM-cut.
 */
#define CRITREG_H_MAX 2

/**
 * For critreg_planner_config.heuristic: h-add (Bonet and Geffner 2001). It may be
 * too high, so that longer sequences can come before shorter ones.
 */
#define CRITREG_H_ADD 3

/**
 * For critreg_planner_config.heuristic: none. The search is breadth first.
 */
#define CRITREG_BLIND 4

/**
 * Most objects of an atom, and most parameters of a PDDL action.
 */
#define CRITREG_MAX_ARGUMENTS 10

/**
 * Most operators in a plan, and in a sequence of them.
 */
#define CRITREG_MAX_PLAN_LENGTH 128

/**
 * Operators in the longest plan unless the configuration tells.
 */
#define CRITREG_DEFAULT_PLAN_LENGTH 32

/**
 * Bytes for PDDL texts that a planner has room for unless the configuration
 * tells.
 */
#define CRITREG_DEFAULT_PDDL_BYTES 8192

/**
 * Ground operators that a planner has room for unless the configuration tells.
 */
#define CRITREG_DEFAULT_OPERATORS 256

/**
 * Nodes of the search that a planner has room for unless the configuration tells.
 */
#define CRITREG_DEFAULT_NODES 4096

/**
 * Ground atoms that a planner has room for unless the configuration tells.
 */
#define CRITREG_DEFAULT_ATOMS 128

/**
 * Most ground atoms of a planner.
 */
#define CRITREG_MAX_ATOMS 1024

/**
 * Atoms and numbers of :init that a planner has room for unless the configuration tells.
 */
#define CRITREG_DEFAULT_FACTS 512

/**
 * Longest domain or problem text of a planner in bytes, with its NUL.
 */
#define CRITREG_PDDL_TEXT_MAX 65536

/**
 * How many reasons are counted one by one: numbers below this. A callback that
 * gives others, or none, is counted in critreg_metrics.uncounted.
 */
#define CRITREG_MAX_REASONS 64

/**
 * No reason was given.
 */
#define CRITREG_NO_REASON 65535

/**
 * For critreg_metrics.conclusion: nothing was planned yet, or the call was refused
 * before planning began.
 */
#define CRITREG_NOT_PLANNED 0

/**
 * There is a plan.
 */
#define CRITREG_SOLVED 1

/**
 * No further sequence of operators reaches the goal: there is no plan, or it was
 * pruned, or it needs other samples.
 */
#define CRITREG_EXHAUSTED 2

/**
 * Likewise, but some sequences were not extended beyond
 * critreg_planner_config.max_length.
 */
#define CRITREG_LENGTH_SPENT 3

/**
 * critreg_planner_config.max_skeletons were refined in vain.
 */
#define CRITREG_SKELETONS_SPENT 4

/**
 * critreg_planner_config.max_samples were drawn.
 */
#define CRITREG_SAMPLES_SPENT 5

/**
 * The memory is full; critreg_planner_message() says which.
 */
#define CRITREG_MEMORY_FULL 6

/**
 * A callback stopped planning. Then the counts are 0, except those of
 * critreg_planner_failures() and critreg_planner_reasons().
 */
#define CRITREG_STOPPED 7

/**
 * For critreg_planner_why(): there is a plan, or nothing was planned yet.
 */
#define CRITREG_WHY_NOTHING 0

/**
 * An atom of the goal cannot be reached, whatever is done: the sentence names it, and
 * what is missing.
 */
#define CRITREG_WHY_UNREACHABLE 1

/**
 * No sequence of actions reaches the goal, however long.
 */
#define CRITREG_WHY_NO_SKELETON 2

/**
 * The callback advise, or skills, pruned all sequences that reach the goal.
 */
#define CRITREG_WHY_PRUNED 3

/**
 * No sequence of up to critreg_planner_config.max_length actions reaches the goal.
 */
#define CRITREG_WHY_LENGTH 4

/**
 * Steps with parameters failed critreg_planner_config.max_tries times, while samples were
 * left.
 */
#define CRITREG_WHY_TRIES 5

/**
 * Steps without parameters failed: the simulator does not do what the text says.
 */
#define CRITREG_WHY_WORLD 6

/**
 * critreg_planner_config.max_skeletons were refined in vain.
 */
#define CRITREG_WHY_SKELETONS 7

/**
 * critreg_planner_config.max_samples were drawn in vain.
 */
#define CRITREG_WHY_SAMPLES 8

/**
 * The memory is full.
 */
#define CRITREG_WHY_MEMORY 9

/**
 * A callback stopped planning.
 */
#define CRITREG_WHY_STOPPED 10

/**
 * Most numbers of a state that skills are learned or used in.
 */
#define CRITREG_MAX_STATE_NUMBERS 64

/**
 * Most objects of a task that skills are learned or used in.
 */
#define CRITREG_MAX_STATE_OBJECTS 32

/**
 * Most ground operators of a task that skills are learned from, and most ground atoms.
 * A planner that uses the skills may have more.
 */
#define CRITREG_MAX_TRAINING_OPERATORS 512

/**
 * Bytes for texts that skills have room for unless the configuration tells.
 */
#define CRITREG_DEFAULT_SKILL_TEXTS 65536

/**
 * Option of the stick-button environment: robot and stick can turn, and lie at
 * any angle in new tasks. Without it all angles are pi/2, as in the thesis.
 */
#define CRITREG_STICK_BUTTON_ANGLES 1

/**
 * A learner. It lies at the start of the memory it was made in.
 */
typedef struct critreg_learner critreg_learner;

/**
 * A planner for one problem. It lies at the start of the memory it was made in.
 */
typedef struct critreg_planner critreg_planner;

/**
 * A region: the parameters with which an action is expected to work, as
 * constraints over a domain. It knows its domain. It either belongs to a learner
 * or lies at the start of the memory it was made in.
 */
typedef struct critreg_region critreg_region;

/**
 * Skills: what is learned of a program's controllers. They lie at the start of the memory
 * they were made in.
 */
typedef struct critreg_skills critreg_skills;

/**
 * What became of a call: CRITREG_OK, one of the codes below, or the status of
 * the program's own callback.
 */
typedef int32_t critreg_status;

/**
 * How learning went so far.
 *
 * CRITREG_VERSION_SPACE counts forms, from the first query on;
 * it deletes none. CRITREG_ALGORITHM1 counts every comparison of two features on
 * its own; it ignores no samples and has no certificate, so these are 0.
 */
typedef struct critreg_report {
    /**
     * Size of this struct in bytes, from critreg_report_init().
     */
    uint32_t struct_size;
    /**
     * What the region is worth: CRITREG_EXACT, CRITREG_APPROXIMATE, CRITREG_PROVISIONAL or,
     * if there is none, CRITREG_NO_QUALITY.
     */
    uint32_t quality;
    /**
     * Hypotheses that the grammar makes of the domain.
     */
    uint64_t enumerated;
    /**
     * Those the learner started with.
     */
    uint64_t kept;
    /**
     * Those that found no room in the memory: the most complex ones.
     */
    uint64_t left_out;
    /**
     * CRITREG_ALGORITHM1: hypotheses left after the negative sample, or
     * CRITREG_NOT_RUN.
     */
    uint64_t after_negative;
    /**
     * CRITREG_ALGORITHM1: hypotheses left after the positive sample, or
     * CRITREG_NOT_RUN.
     */
    uint64_t after_positive;
    /**
     * Hypotheses left now.
     */
    uint64_t remaining;
    /**
     * Outcomes told of what was asked: calls of the simulator.
     */
    uint64_t calls;
    /**
     * Samples that were feasible. With noise a sample takes several calls, so
     * that feasible and infeasible ones are fewer than the calls.
     */
    uint64_t feasible;
    /**
     * Samples that were infeasible.
     */
    uint64_t infeasible;
    /**
     * Samples that were put aside, because their outcome is CRITREG_UNKNOWN.
     */
    uint64_t unknown;
    /**
     * CRITREG_VERSION_SPACE: samples that the region is wrong about; see
     * critreg_config.slack.
     */
    uint64_t strays;
    /**
     * Constraints that found no room in the region.
     */
    uint64_t constraints_left_out;
    /**
     * The certificate of CRITREG_VERSION_SPACE: this many of the last samples are
     * independent, uniform draws from the region as it is now.
     */
    uint64_t certificate_draws;
    /**
     * Those that worked.
     */
    uint64_t certificate_feasible;
    /**
     * With the configured confidence, at least this share of the region works in
     * the training instances (Clopper and Pearson 1934); 0 without draws.
     */
    double certificate_lower_bound;
    /**
     * The share of the region that works lies between these two, each with the configured
     * confidence, by the same draws; NaN without draws.
     */
    double precision_low;
    /**
     * See precision_low.
     */
    double precision_high;
    /**
     * The share of what works that is in the region, likewise, by draws from everything
     * since the region is as it is; NaN without feasible ones.
     */
    double recall_low;
    /**
     * See recall_low.
     */
    double recall_high;
    /**
     * Outcomes told of what was not asked, see critreg_observe().
     */
    uint64_t observed;
} critreg_report;

/**
 * Called by critreg_learn_region() after every sample.
 *
 * @param progress_data That of the configuration.
 * @param report How learning went so far; valid until the callback returns.
 * @return CRITREG_OK to go on. Anything else stops learning and becomes the
 * status of critreg_learn_region(): CRITREG_CANCELLED, or CRITREG_USER_STATUS
 * and above. What was learned so far stays, and learning can go on later.
 */
typedef critreg_status (*critreg_progress)(void *progress_data,
                                           const struct critreg_report *report);

/**
 * What a learner does. Fill it with critreg_config_init() and change what you
 * like. Nothing in it is kept after critreg_learner_init() returns, except the
 * progress callback and its data.
 *
 * A field of one learner is ignored by the other.
 */
typedef struct critreg_config {
    /**
     * Size of this struct in bytes, from critreg_config_init().
     */
    uint32_t struct_size;
    /**
     * Which learner: CRITREG_VERSION_SPACE, the default, or CRITREG_ALGORITHM1.
     */
    uint32_t learner;
    /**
     * Seed of all random choices. Default 0. The same seed, domain, instances,
     * capacities and outcomes give the same region on every machine.
     */
    uint64_t seed;
    /**
     * Forms to have room for, at least 4: the differences of two features that
     * CRITREG_VERSION_SPACE bounds, or the comparisons of two features that are the
     * hypotheses of CRITREG_ALGORITHM1. More reach more complex constraints and take
     * more time per sample. Default 0: what the memory has room for.
     */
    uint32_t forms;
    /**
     * Samples to have room for. When they are used up, telling returns
     * CRITREG_CAPACITY_EXCEEDED. CRITREG_VERSION_SPACE takes at most
     * CRITREG_MAX_OBSERVATIONS. Default 0: CRITREG_DEFAULT_OBSERVATIONS, or
     * calls + 2 if that is more; with critreg_observe() say how many it takes in all.
     */
    uint32_t observations;
    /**
     * Outcomes that CRITREG_VERSION_SPACE asks for in all; samples that
     * CRITREG_ALGORITHM1 draws itself (K of the thesis), beside its manual ones.
     * Default 100.
     */
    uint32_t calls;
    /**
     * CRITREG_VERSION_SPACE: how many draws from the region certify it, with the last
     * calls. With noise a draw takes several calls, of which they get a quarter of all at
     * most. Default 10.
     */
    uint32_t certifying;
    /**
     * CRITREG_VERSION_SPACE: problem instances to have room for, at least 1.
     * Learning from more returns CRITREG_CAPACITY_EXCEEDED. Default
     * CRITREG_DEFAULT_INSTANCES.
     */
    uint32_t instances;
    /**
     * CRITREG_VERSION_SPACE: steps of the sequence of actions that is learned
     * about, from 1 to CRITREG_MAX_STEPS; see critreg_outcome. Default 1.
     */
    uint32_t steps;
    /**
     * CRITREG_VERSION_SPACE: share of the outcomes that is wrong, from 0 to 0.2. If
     * it is not 0, samples are asked again until the outcome is beyond doubt:
     * noise costs calls. Default 0.
     */
    double noise;
    /**
     * CRITREG_VERSION_SPACE: share of the queries that look for what nothing
     * hints at, from 0 to 1. Default 0.1.
     */
    double exploring;
    /**
     * CRITREG_VERSION_SPACE: how far the boundary of a constraint may lie elsewhere
     * in single instances, as a share of what its left side ranges over, from 0 to
     * 0.2: for actions that work a little beyond a boundary or fail a little before
     * it. With 0 the region agrees with every answer. Default 0.05.
     */
    double slack;
    /**
     * CRITREG_VERSION_SPACE: confidence of the certificate, from 0 to 0.9999.
     * Default 0.95.
     */
    double confidence;
    /**
     * CRITREG_ALGORITHM1: parameters that are expected to fail (z- of the thesis),
     * tried first in the first instance: one number per parameter of the domain,
     * within its range. Copied. Default NULL: not tried.
     */
    const double *negative;
    /**
     * CRITREG_ALGORITHM1: parameters that are expected to work (z+ of the thesis),
     * tried next in the first instance. Copied. Default NULL: not tried.
     */
    const double *positive;
    /**
     * Called after every sample that critreg_learn_region() tries. Default NULL.
     */
    critreg_progress progress;
    /**
     * Passed to the progress callback. Default NULL.
     */
    void *progress_data;
    /**
     * CRITREG_VERSION_SPACE: of how many forms, the simplest ones, it is tracked what
     * the outcomes say about them. That of the others is computed whenever it is
     * needed: the region is the same, for less memory and more time. Default
     * UINT32_MAX: of all.
     */
    uint32_t tracked;
    /**
     * What is computed with: CRITREG_F64, the default, or CRITREG_F32. A library that
     * was built without one of them refuses it with CRITREG_INVALID_ARGUMENT.
     */
    uint32_t precision;
    /**
     * CRITREG_VERSION_SPACE: forms more to have room for whose right side is a sum of sizes
     * ("board.half - item.half", "0.4 * stack.width"), whose left side is derived ("hand.x +
     * hand.y", coordinates in the frame of an object, a parameter times a size), or that are
     * conditions on the scene alone ("part.width <= gripper.open"). They are looked for
     * where the others explain the outcomes at length or not at all. Default UINT32_MAX: a
     * sixteenth of forms, at most 512. 0: none.
     */
    uint32_t sums;
    /**
     * CRITREG_VERSION_SPACE: which share of the region must work at least where no region
     * agrees with all outcomes, from 0.5 to 0.999. The learner then looks for the largest
     * such region, and spends a quarter of the calls to estimate how good it is. Default 0.95.
     */
    double precision_wanted;
    /**
     * CRITREG_VERSION_SPACE: questions that can be open at once, from 1 to
     * CRITREG_MAX_QUESTIONS; see critreg_ask_many(). Default CRITREG_DEFAULT_QUESTIONS; for
     * each one more critreg_learner_size() tells CRITREG_QUESTION_BYTES more.
     */
    uint32_t questions;
} critreg_config;

/**
 * Makes an instance of a source: a task of a generator, a scene of a data set.
 *
 * It must return, as a critreg_simulate must, and may not use the learner.
 *
 * @param user_data What the program passed to critreg_choose_instances().
 * @param number Which instance, from 0. The same number makes the same instance.
 * @param instance Receives it: one number per attribute. Points to a number also where the
 * domain has no objects.
 * @return CRITREG_OK, or anything else to stop; that becomes the status of
 * critreg_choose_instances().
 */
typedef critreg_status (*critreg_make_instance)(void *user_data,
                                                size_t number,
                                                double *instance);

/**
 * What came of a trial: CRITREG_INFEASIBLE, CRITREG_FEASIBLE, CRITREG_UNKNOWN or
 * CRITREG_FAILED_STEP(k); see OUTCOMES above.
 */
typedef int32_t critreg_outcome;

/**
 * Whatever can tell whether an action works: a simulator, a motion planner, a
 * robot.
 *
 * It must return: no longjmp(), no C++ exception may leave it. A handle that was left by a
 * longjmp() all the same answers CRITREG_BUSY until critreg_learner_recover(); a C++
 * exception ends the program, or does worse. It may not touch
 * the memory of the learner, nor call functions on it other than those that take
 * it as const; the others return CRITREG_BUSY.
 *
 * @param user_data What the program passed to critreg_learn_region().
 * @param instance The instance: one number per attribute. Points to a number also
 * where the domain has no objects.
 * @param theta The parameters to try: one number each. Points to a number also if
 * there are none.
 * @param outcome Receives what came of it; holds CRITREG_NO_OUTCOME, which is refused.
 * @return CRITREG_OK if there is an outcome. Anything else stops learning and
 * becomes the status of critreg_learn_region(): CRITREG_CANCELLED, or
 * CRITREG_USER_STATUS and above. The sample then stays to be tried.
 */
typedef critreg_status (*critreg_simulate)(void *user_data,
                                           const double *instance,
                                           const double *theta,
                                           critreg_outcome *outcome);

/**
 * What supports a constraint of a region: what any other bound would have to
 * agree with.
 *
 * A bound of the constraint's left side fits the observations if it is not inside
 * of feasible, S, and stays inside of infeasible, G: an upper bound from S to
 * below G, a lower bound from above G to S. The gap between them is what is not
 * known.
 */
typedef struct critreg_constraint {
    /**
     * Size of this struct in bytes, from critreg_constraint_init().
     */
    uint32_t struct_size;
    /**
     * 1 if CRITREG_VERSION_SPACE learned it and the region still belongs to the
     * learner; 0 for other regions, of which no more is known. Then the numbers
     * below are 0, and NAN for S and G.
     */
    int32_t has_evidence;
    /**
     * The step of the sequence of actions that needs it, from 1.
     */
    uint32_t step;
    /**
     * How many infeasible samples it excludes.
     */
    uint32_t support;
    /**
     * S: the extreme value at the feasible samples, apart from those it ignores.
     */
    double feasible;
    /**
     * G: the value at the first infeasible sample that it alone excludes, or, if
     * there is none, at the first one that it excludes.
     */
    double infeasible;
} critreg_constraint;

/**
 * A generator of random numbers (PCG XSH-RR 64/32): the same stream on every
 * machine. Copy it freely: a copy goes on with the same numbers. Do not store it
 * across versions of the library; store the seed. One that is all zero is that
 * of seed 0.
 */
typedef struct critreg_rng {
    /**
     * Opaque.
     */
    uint64_t state[2];
} critreg_rng;

/**
 * What critreg_region_implies() may cost, and what it found.
 */
typedef struct critreg_proof {
    /**
     * Size of this struct in bytes, from critreg_proof_init().
     */
    uint32_t struct_size;
    /**
     * How many boxes of instances and parameters are examined at most for each statement of
     * the specification, and for each member of a group that it is about. A box takes ten
     * to a hundred microseconds. Default: 20000.
     */
    uint32_t max_boxes;
    /**
     * By how much a constraint of the specification may be missed, in its own unit: above
     * zero. Default: 1e-6.
     */
    double tolerance;
    /**
     * CRITREG_PROVEN, CRITREG_REFUTED or CRITREG_UNDECIDED.
     */
    uint32_t verdict;
    /**
     * If it is undecided: 1 if a box was halved as often as there is room for, so that more
     * boxes do not help; else 0, and they may.
     */
    uint32_t too_fine;
    /**
     * If it is not proven: which of the statements that the specification joins by "and" is
     * refuted, or has most that is open; from 0.
     */
    uint32_t statement;
    /**
     * How many boxes were examined.
     */
    uint32_t boxes;
    /**
     * If it is undecided: the share of the cases of that statement that is open.
     */
    double open;
} critreg_proof;

/**
 * How to plan, how long, and with how much memory. Fill it with
 * critreg_planner_config_init(), set state_len, and change what you like. Nothing
 * in it is kept after critreg_planner_init() returns.
 *
 * Budgets are counts, not times: the same inputs end in the same way on every
 * machine.
 */
typedef struct critreg_planner_config {
    /**
     * Size of this struct in bytes, from critreg_planner_config_init().
     */
    uint32_t struct_size;
    /**
     * What guides the search: CRITREG_LM_CUT, the default, CRITREG_H_MAX,
     * CRITREG_H_ADD or CRITREG_BLIND.
     */
    uint32_t heuristic;
    /**
     * Numbers of a state, at least 1. Default 0, which is refused: say how many.
     */
    uint32_t state_len;
    /**
     * Most plan skeletons to refine. Default 1000.
     */
    uint32_t max_skeletons;
    /**
     * Tries of a step with parameters before an earlier one is tried again; a
     * step without any has one. Default 10.
     */
    uint32_t max_tries;
    /**
     * Most operators in a plan, from 1 to CRITREG_MAX_PLAN_LENGTH; each takes
     * memory for a state. Default CRITREG_DEFAULT_PLAN_LENGTH.
     */
    uint32_t max_length;
    /**
     * Most low-level actions in a plan, as execute counts them. Default 100.
     */
    uint32_t max_actions;
    /**
     * Most calls of execute, with tries for which sample found nothing. Default 10000.
     */
    uint32_t max_samples;
    /**
     * How many nodes are expanded and samples drawn with advice: what advise
     * postpones, what sample draws from a region or finds to be empty. If there is
     * no plan by then, planning begins anew without any, and so do the limits
     * above. So wrong advice costs at most so much, but never a plan. Default 256.
     */
    uint32_t patience;
    /**
     * Bytes to have room for in the domain and problem text together, their NULs
     * included. Default CRITREG_DEFAULT_PDDL_BYTES.
     */
    uint32_t pddl_bytes;
    /**
     * Ground operators to have room for: every choice of objects for every PDDL
     * action that the static preconditions admit. One with more than eight
     * preconditions and add effects counts for several. Default
     * CRITREG_DEFAULT_OPERATORS.
     */
    uint32_t operators;
    /**
     * Nodes of the search to have room for: sequences of operators that are
     * created. Default CRITREG_DEFAULT_NODES.
     */
    uint32_t nodes;
    /**
     * Ground atoms to have room for that can change, and negations that preconditions
     * ask for. Sets of them have room for 128, 512 or 1024, so that is what each operator
     * and node takes memory for. Default CRITREG_DEFAULT_ATOMS, at most
     * CRITREG_MAX_ATOMS.
     */
    uint32_t atoms;
    /**
     * Atoms and numbers of :init to have room for. Default CRITREG_DEFAULT_FACTS.
     */
    uint32_t facts;
    /**
     * How many sequences that lead to one abstract state are extended before all others
     * are; more only if a skeleton cannot be refined, or nothing else is left. Where no
     * action has parameters it is 1. Default 4. 0 is no bound: then a beginning of a
     * skeleton that cannot work is tried again in others, too.
     */
    uint32_t skeletons_per_state;
    /**
     * With skills: how many draws of the parameters of a step are followed, in the states
     * that are expected of the steps after it, before the step is taken for impossible; and
     * likewise the steps of a sequence before it is postponed. In the first try of a step, of
     * up to 8 draws with which all steps can work the one is taken that keeps later states
     * farthest from the bounds of their regions. Default 0: none are followed, and only what
     * holds with all parameters counts.
     */
    uint32_t lookahead;
} critreg_planner_config;

/**
 * A ground atom or a ground operator: a predicate, or a PDDL action, with its
 * objects.
 *
 * Names are spelled as where they are declared, ended by NUL, and stay where they
 * are as long as the planner does.
 */
typedef struct critreg_ground {
    /**
     * Name of the predicate or action.
     */
    const char *name;
    /**
     * Names of its objects, in order; NULL beyond the last.
     */
    const char *object_names[CRITREG_MAX_ARGUMENTS];
    /**
     * Which predicate or action it is: 0 for the first in the domain text.
     */
    uint32_t index;
    /**
     * How many objects it has.
     */
    uint32_t object_count;
    /**
     * Which objects: places among all objects and constants of the problem in the
     * order of their names (by ASCII code, without regard to case); 0 beyond the
     * last.
     */
    uint32_t objects[CRITREG_MAX_ARGUMENTS];
} critreg_ground;

/**
 * Runs the controller of an operator in the program's simulator.
 *
 * This and the other callbacks of a planner must return: no longjmp(), no C++
 * exception may leave them; see critreg_planner_recover(). They may not touch the memory of the planner, nor call
 * functions on it other than those that take it as const; the others return
 * CRITREG_BUSY. If one returns anything but CRITREG_OK, planning stops and
 * critreg_plan() returns that.
 *
 * @param user_data What the program passed to critreg_plan().
 * @param ground The operator and its objects.
 * @param parameters Its parameters: CRITREG_MAX_PARAMETERS numbers, 0 beyond the
 * last.
 * @param before The state before.
 * @param after Holds a copy of it; receives the state afterwards, which may be
 * any if the operator fails.
 * @param len How many numbers a state has.
 * @param actions Receives how many low-level actions it took, at least 1; or 0,
 * which it is set to already, if the operator failed.
 * @return CRITREG_OK, also if the operator failed; CRITREG_CANCELLED, or
 * CRITREG_USER_STATUS and above.
 */
typedef critreg_status (*critreg_execute)(void *user_data,
                                          const struct critreg_ground *ground,
                                          const double *parameters,
                                          const double *before,
                                          double *after,
                                          size_t len,
                                          uint32_t *actions);

/**
 * Tells whether an atom holds in a state.
 *
 * @param user_data What the program passed to critreg_plan().
 * @param ground The atom: a predicate and its objects.
 * @param state The state.
 * @param len How many numbers it has.
 * @param holds Receives 1 or 0.
 * @return CRITREG_OK, or what shall stop planning.
 */
typedef critreg_status (*critreg_holds)(void *user_data,
                                        const struct critreg_ground *ground,
                                        const double *state,
                                        size_t len,
                                        int32_t *holds);

/**
 * A step of a plan skeleton whose parameters are to be drawn.
 */
typedef struct critreg_draw {
    /**
     * The operators of the whole skeleton: what comes later may narrow what is
     * good now.
     */
    const struct critreg_ground *skeleton;
    /**
     * How many there are.
     */
    size_t length;
    /**
     * The step to draw for, from 0; its operator is at this place of the skeleton.
     */
    size_t step;
    /**
     * The state before it.
     */
    const double *state;
    /**
     * How many numbers it has.
     */
    size_t state_len;
    /**
     * How many parameters are to be drawn: the ranges of
     * critreg_planner_set_ranges(). May be 0.
     */
    size_t parameter_count;
    /**
     * Which try of the step in this state it is, from 1.
     */
    uint32_t attempt;
    /**
     * 1; or 0 once critreg_planner_config.patience is at its end: then draw as if
     * nothing were known.
     */
    int32_t advised;
} critreg_draw;

/**
 * What was drawn.
 */
typedef struct critreg_drawn {
    /**
     * The parameters, within their ranges; hold NAN. execute gets just these.
     */
    double parameters[CRITREG_MAX_PARAMETERS];
    /**
     * 1 if the parameters are from where they are expected to work, such as a
     * learned region; holds 0.
     */
    int32_t informed;
    /**
     * Why there are no parameters, if there are none; holds CRITREG_NO_REASON.
     */
    uint32_t reason;
} critreg_drawn;

/**
 * Draws the parameters of a step, for instance with critreg_sample_regions().
 * Asked for operators without parameters, too: it may expect that they do not work.
 *
 * @param user_data What the program passed to critreg_plan().
 * @param draw The step to draw for.
 * @param rng Random numbers. They follow from the seed of critreg_plan().
 * @param drawn Receives the parameters, or why there are none.
 * @return CRITREG_OK; CRITREG_EMPTY_REGION if no parameters are expected to work in
 * this state, upon which an earlier step is tried again; CRITREG_NO_SAMPLE if none were
 * found, which is a failed try like any other; or what shall stop planning. So what
 * critreg_sample_region() returned may be passed on.
 */
typedef critreg_status (*critreg_sample)(void *user_data,
                                         const struct critreg_draw *draw,
                                         struct critreg_rng *rng,
                                         struct critreg_drawn *drawn);

/**
 * What to do with a sequence of operators: CRITREG_KEEP, CRITREG_POSTPONE or
 * CRITREG_PRUNE.
 */
typedef int32_t critreg_advice;

/**
 * Advises the search before anything is sampled for a sequence of operators. It is
 * asked when the search comes to the sequence; all shorter prefixes were kept.
 *
 * @param user_data What the program passed to critreg_plan().
 * @param prefix The operators so far.
 * @param length How many there are, at least 1.
 * @param initial The state that planning begins in.
 * @param len How many numbers it has.
 * @param advice Receives what to do; holds CRITREG_KEEP.
 * @param reason Receives why, unless it is kept; holds CRITREG_NO_REASON.
 * @return CRITREG_OK, or what shall stop planning.
 */
typedef critreg_status (*critreg_advise)(void *user_data,
                                         const struct critreg_ground *prefix,
                                         size_t length,
                                         const double *initial,
                                         size_t len,
                                         critreg_advice *advice,
                                         uint32_t *reason);

/**
 * What a planner asks the program. Fill it with critreg_callbacks_init() and set
 * at least execute and holds.
 */
typedef struct critreg_callbacks {
    /**
     * Size of this struct in bytes, from critreg_callbacks_init().
     */
    uint32_t struct_size;
    /**
     * 1: sequences of operators that skills expect not to work are dropped, and a plan may be
     * lost. 0, the default: they are postponed, until critreg_planner_config.patience is at
     * its end.
     */
    uint32_t prune;
    /**
     * Runs operators. Must be set.
     */
    critreg_execute execute;
    /**
     * Tells what holds. Must be set.
     */
    critreg_holds holds;
    /**
     * Draws parameters. NULL, the default: uniform over their ranges.
     */
    critreg_sample sample;
    /**
     * Advises the search. NULL, the default: everything is kept.
     */
    critreg_advise advise;
    /**
     * What was learned, or NULL, the default. Where something is known of a step, its
     * parameters are drawn from that, and sample is asked where nothing is, or without
     * advice; what cannot work is postponed before advise is asked. Actions have the
     * parameters of their controllers. The skills are in use while critreg_plan() runs.
     */
    struct critreg_skills *skills;
} critreg_callbacks;

/**
 * A step of a plan.
 */
typedef struct critreg_step {
    /**
     * Size of this struct in bytes, from critreg_step_init().
     */
    uint32_t struct_size;
    /**
     * How many low-level actions it takes.
     */
    uint32_t actions;
    /**
     * The operator and its objects.
     */
    struct critreg_ground ground;
    /**
     * How many parameters it has.
     */
    size_t parameter_count;
    /**
     * Its parameters, as execute got them; 0 beyond the last.
     */
    double parameters[CRITREG_MAX_PARAMETERS];
    /**
     * The state afterwards. It belongs to the planner and stays until the next
     * critreg_plan().
     */
    const double *state;
} critreg_step;

/**
 * What the last critreg_plan() cost, and what stood in its way.
 */
typedef struct critreg_metrics {
    /**
     * Size of this struct in bytes, from critreg_metrics_init().
     */
    uint32_t struct_size;
    /**
     * How planning ended: CRITREG_SOLVED or another code.
     */
    uint32_t conclusion;
    /**
     * Operators in the plan.
     */
    uint32_t plan_length;
    /**
     * Tries of a step: parameters were drawn and execute was called, or
     * CRITREG_NO_SAMPLE was returned. Steps without parameters count too, so the length
     * of the plan is the least.
     */
    uint32_t samples;
    /**
     * Plan skeletons that were refined.
     */
    uint32_t skeletons;
    /**
     * Sequences of operators that were extended by one.
     */
    uint32_t nodes_expanded;
    /**
     * Sequences of operators that were created, the empty one included.
     */
    uint32_t nodes_created;
    /**
     * Sequences that advise pruned.
     */
    uint32_t pruned;
    /**
     * Sequences that advise postponed: they were left out until patience ended.
     */
    uint32_t postponed;
    /**
     * Sequences that were not extended because of their length.
     */
    uint32_t cut_off;
    /**
     * Draws that ended with CRITREG_EMPTY_REGION.
     */
    uint32_t empty_draws;
    /**
     * Draws that were informed; see critreg_drawn.
     */
    uint32_t informed_draws;
    /**
     * 1 if critreg_planner_config.patience ended, so that planning began anew
     * without advice; else 0.
     */
    uint32_t patience_ended;
    /**
     * Reasons that were not given, or not below CRITREG_MAX_REASONS.
     */
    uint32_t uncounted;
    /**
     * Low-level actions that execute told of.
     */
    uint64_t actions;
    /**
     * The PDDL action whose steps failed most often; NULL if none did. The name
     * stays where it is as long as the planner does.
     */
    const char *most_failed;
    /**
     * The reason that was given most often: why no plan was found.
     * CRITREG_NO_REASON if none was.
     */
    uint32_t main_reason;
    /**
     * Sequences that were not extended at first, as enough others lead to the same
     * abstract state; see critreg_planner_config.skeletons_per_state.
     */
    uint32_t repeated;
} critreg_metrics;

/**
 * How learning goes.
 */
typedef struct critreg_training {
    /**
     * Size of this struct in bytes.
     */
    uint32_t struct_size;
    /**
     * Which skill is being learned, from 0.
     */
    uint32_t skill;
    /**
     * How many skills there are.
     */
    uint32_t skills;
    /**
     * Runs of controllers for this skill so far, those that were kept included.
     */
    uint32_t runs;
} critreg_training;

/**
 * Called by critreg_skills_learn() after each run of a controller.
 *
 * @param progress_data That of the configuration.
 * @param training How learning goes; valid until the callback returns.
 * @return CRITREG_OK to go on. Anything else stops learning and becomes the status of
 * critreg_skills_learn(): CRITREG_CANCELLED, or CRITREG_USER_STATUS and above.
 */
typedef critreg_status (*critreg_training_progress)(void *progress_data,
                                                    const struct critreg_training *training);

/**
 * How much is tried to learn skills, and what there is room for. Fill it with
 * critreg_skills_config_init(), set state_len, and change what you like. Nothing in it is
 * kept after critreg_skills_init() returns, except the progress callback and its data.
 */
typedef struct critreg_skills_config {
    /**
     * Size of this struct in bytes, from critreg_skills_config_init().
     */
    uint32_t struct_size;
    /**
     * Most numbers of a state, from 1 to CRITREG_MAX_STATE_NUMBERS. Default 0, which is
     * refused: say how many.
     */
    uint32_t state_len;
    /**
     * What the learner of a skill is told: seed, calls, slack and so on, and how many forms
     * it has room for. Its learner, precision, instances, steps and progress do not count.
     * Default NULL: the defaults of critreg_config, with CRITREG_DEFAULT_FORMS.
     */
    const struct critreg_config *learner;
    /**
     * Questions about two controllers. Default 200.
     */
    uint32_t chained;
    /**
     * How many controllers may be run to learn one about which there is a single skill: its
     * questions are what the ways to situations leave of them, if that is more than the
     * calls of the learner. Default 0.
     */
    uint32_t budget;
    /**
     * Situations that a skill with parameters is tried in, chosen to differ. Default 20.
     */
    uint32_t situations;
    /**
     * Situations that a skill without parameters is tried in, each once. Default 150.
     */
    uint32_t states;
    /**
     * Training tasks that situations of one skill are taken from. Default 150.
     */
    uint32_t situation_tasks;
    /**
     * Training tasks to have room for. Default 150.
     */
    uint32_t tasks;
    /**
     * Controllers to have room for; an action that belongs to none is one. Default 16.
     */
    uint32_t controllers;
    /**
     * Skills to have room for. Default 16.
     */
    uint32_t skills;
    /**
     * Bytes to have room for in all texts together, their NULs included: the PDDL domain,
     * the layout, the skills, the problems of the training tasks. Default
     * CRITREG_DEFAULT_SKILL_TEXTS.
     */
    uint32_t texts;
    /**
     * Nodes of the search for a way to a situation. Default 1024.
     */
    uint32_t nodes;
    /**
     * Atoms and numbers of :init of a problem to have room for. Default 512.
     */
    uint32_t facts;
    /**
     * Runs of controllers to keep of the skill that is being learned: after a stop they are
     * not repeated. Default 512.
     */
    uint32_t runs;
    /**
     * Controllers that may be run on the way to one situation, at each attempt. Default
     * 10000; say less where a run is expensive.
     */
    uint32_t way;
    /**
     * Called after each run of a controller. Default NULL.
     */
    critreg_training_progress progress;
    /**
     * Passed to the progress callback. Default NULL.
     */
    void *progress_data;
} critreg_skills_config;

/**
 * What was learned of a skill, and what it took.
 */
typedef struct critreg_skill_report {
    /**
     * Size of this struct in bytes, from critreg_skill_report_init().
     */
    uint32_t struct_size;
    /**
     * 1 if it was learned; 0 if its turn has not come.
     */
    uint32_t finished;
    /**
     * 1 if there is a region, which planning uses; else 0.
     */
    uint32_t has_region;
    /**
     * CRITREG_EXACT, CRITREG_APPROXIMATE, CRITREG_PROVISIONAL or CRITREG_NO_QUALITY.
     */
    uint32_t quality;
    /**
     * Why there is no region, or none that is exact: CRITREG_WHY_EXPLAINED and so on, as for
     * critreg_learner_why().
     */
    uint32_t why;
    /**
     * Training tasks that situations were taken from.
     */
    uint32_t tasks;
    /**
     * Situations that it was tried in.
     */
    uint32_t situations;
    /**
     * Runs of controllers, those on the way to a situation included.
     */
    uint32_t runs;
    /**
     * Questions that were answered.
     */
    uint32_t calls;
    /**
     * How often it worked.
     */
    uint32_t feasible;
    /**
     * How often it did not.
     */
    uint32_t infeasible;
    /**
     * Draws from the region that were tried to certify it.
     */
    uint32_t certificate_draws;
    /**
     * Those of them that worked.
     */
    uint32_t certificate_feasible;
    /**
     * Always 0.
     */
    uint32_t reserved;
    /**
     * At least this share of the region works, with the confidence of the learner.
     */
    double certificate_lower_bound;
} critreg_skill_report;

/**
 * The call did what it promises.
 */
#define CRITREG_OK 0

/**
 * A pointer is NULL that must not be.
 */
#define CRITREG_NULL_POINTER 1

/**
 * A pointer is not aligned for what it points to.
 */
#define CRITREG_MISALIGNED 2

/**
 * Memory, a buffer or an array is too small.
 */
#define CRITREG_TOO_SMALL 3

/**
 * An argument is outside of what the function accepts.
 */
#define CRITREG_INVALID_ARGUMENT 4

/**
 * A number is NaN or infinite.
 */
#define CRITREG_NOT_FINITE 5

/**
 * A text could not be read; critreg_check_domain() and critreg_check_region()
 * tell the line, the column and what was expected.
 */
#define CRITREG_SYNTAX_ERROR 6

/**
 * A table of the library is full: too many objects, constraints, observations.
 */
#define CRITREG_CAPACITY_EXCEEDED 7

/**
 * Proven: no parameters are in the region in this instance. Where the region is right
 * nothing works here, so postpone the plan skeleton, or drop it; a learned region may
 * be wrong.
 */
#define CRITREG_EMPTY_REGION 8

/**
 * No parameters were found within the budget; the region may be empty.
 */
#define CRITREG_NO_SAMPLE 9

/**
 * The observations explain no region: nothing was learned.
 */
#define CRITREG_NO_REGION 10

/**
 * The call does not fit the state of the learner: telling before asking, asking
 * after the end.
 */
#define CRITREG_OUT_OF_SEQUENCE 11

/**
 * Instances or saved bytes do not belong to this domain or configuration.
 */
#define CRITREG_MISMATCH 12

/**
 * Saved bytes are damaged, incomplete or of another version.
 */
#define CRITREG_CORRUPT 13

/**
 * A callback called back into the learner or planner that is calling it.
 */
#define CRITREG_BUSY 14

/**
 * For callbacks: the program wants to stop. The library itself never returns it.
 */
#define CRITREG_CANCELLED 15

/**
 * The pointer is no handle, or no longer: the memory was overwritten, moved or
 * copied, or the learner of a region went on.
 */
#define CRITREG_NOT_A_HANDLE 16

/**
 * No plan was found: critreg_planner_metrics() tells how planning ended and what
 * stood in the way.
 */
#define CRITREG_NO_PLAN 17

/**
 * From here on the codes belong to the program: a callback may return any of
 * them and finds it again as the status of the call.
 */
#define CRITREG_USER_STATUS 1000

/**
 * The action failed. It is what false says. Of a sequence of actions it does not say
 * enough: use CRITREG_FAILED_STEP(k).
 */
#define CRITREG_INFEASIBLE 0

/**
 * The action worked. It is what true says.
 */
#define CRITREG_FEASIBLE 1

/**
 * There is no answer: the trial crashed, say, or took too long. It teaches nothing, and
 * the sample is put aside.
 */
#define CRITREG_UNKNOWN 2

/**
 * What an outcome holds before a callback is to write it, so that one that was not
 * written is noticed. It is refused.
 */
#define CRITREG_NO_OUTCOME INT32_MIN

/**
 * Go on with it.
 */
#define CRITREG_KEEP 0

/**
 * Leave it out, with everything that begins with it, until
 * critreg_planner_config.patience is at its end. The right advice from knowledge
 * that may be wrong, such as a learned region.
 */
#define CRITREG_POSTPONE 1

/**
 * Drop it, with everything that begins with it. For what is certain: a plan may
 * be lost.
 */
#define CRITREG_PRUNE 2

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * The CRITREG_ABI_VERSION of the library that runs.
 */
uint32_t critreg_abi_version(void);

/**
 * The version of the library that runs, such as "0.1.0".
 *
 * @return A static text, never NULL.
 */
const char *critreg_version(void);

/**
 * What the library that runs was built with; everything unless someone left it out. What
 * is not there is refused where it is asked for; functions that are not there are not linked. Bits that are not named here are 0.
 *
 * @return CRITREG_HAS_F64 and its like, combined with or.
 */
uint32_t critreg_capabilities(void);

/**
 * What a status means, in a few words of English.
 *
 * @return A static text, never NULL, also for codes the library does not know.
 */
const char *critreg_strerror(critreg_status status);

/**
 * The name of a status as it stands in the header, such as "CRITREG_BUSY".
 *
 * @return A static text, never NULL: "CRITREG_USER_STATUS" for all codes of the
 * program, "unknown" for what is no code.
 */
const char *critreg_status_name(critreg_status status);

/**
 * How good a learned region is, in one word.
 *
 * @param region The region.
 * @param quality Receives CRITREG_EXACT, CRITREG_APPROXIMATE, CRITREG_PROVISIONAL or
 * CRITREG_NO_QUALITY; a larger number is better.
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_quality(const struct critreg_region *region,
                                      uint32_t *quality);

/**
 * Prepares a report for critreg_learner_report().
 *
 * @param report The report.
 * @param size sizeof *report; see critreg_config_init().
 * @return As critreg_config_init().
 */
critreg_status critreg_report_init(struct critreg_report *report, size_t size);

/**
 * Fills a configuration with the defaults.
 *
 * @param config The configuration.
 * @param size sizeof *config. It lets a program that was compiled with an older
 * header run with a newer library: the library writes and reads no more.
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED; CRITREG_INVALID_ARGUMENT if
 * size is smaller than the struct ever was, or larger than this library knows.
 */
critreg_status critreg_config_init(struct critreg_config *config, size_t size);

/**
 * Looks at the configuration of a learner and says what is wrong with it, such as
 * "config.noise is from 0 to 0.2, not 0.5".
 *
 * What depends on the domain text is not looked at: the manual samples of
 * CRITREG_ALGORITHM1.
 *
 * @param config The configuration, from critreg_config_init() and changed since; NULL for
 * the defaults, with which nothing is wrong.
 * @param text Receives the words, as for critreg_check_domain().
 * @param len Length of text in bytes; 0 if the words are not wanted.
 * @param needed NULL, or receives the length of the words with their NUL.
 * @return CRITREG_OK if critreg_learner_init() would accept it, given memory enough;
 * CRITREG_INVALID_ARGUMENT; CRITREG_NOT_FINITE for a share that is NaN or infinite;
 * CRITREG_TOO_SMALL if no memory can be that large; CRITREG_NULL_POINTER,
 * CRITREG_MISALIGNED.
 */
critreg_status critreg_check_config(const struct critreg_config *config,
                                    char *text,
                                    size_t len,
                                    size_t *needed);

/**
 * How many bytes of memory a learner takes.
 *
 * Where the capacities are constants, CRITREG_LEARNER_WORDS() sizes a static
 * array instead.
 *
 * @param config What the learner is to do, with its capacities; NULL for the
 * defaults. Where it leaves the number of forms open it is
 * CRITREG_DEFAULT_FORMS.
 * @return The number of bytes; 0 if the configuration is wrong or memory cannot
 * be that large.
 */
size_t critreg_learner_size(const struct critreg_config *config);

/**
 * The alignment in bytes that the memory of a learner needs. An array of
 * uint64_t and what malloc() returns have it.
 */
size_t critreg_learner_align(void);

/**
 * Makes a learner in memory of the program.
 *
 * The capacities come from the configuration. Where it leaves the number of
 * forms open, the learner takes as many as the memory has room for beside
 * the observations, so that CRITREG_LEARNER_WORDS(4096, 256) words and a config
 * of NULL make room for at least 4096 forms and 256 samples. What is
 * learned depends on the number of forms; where the same result is wanted
 * from memory of another size, set config.forms.
 *
 * A learner needs no end: reuse its memory when you are done with it. What the
 * memory held before does not matter.
 *
 * @param memory Memory for the learner, aligned to critreg_learner_align(). From
 * now on it belongs to the learner: do not write to it, move it or copy it.
 * @param memory_len Its length in bytes.
 * @param domain What there is to know about the action, in the language of the
 * domain text above, ended by NUL. Copied.
 * @param config What the learner does; NULL for the defaults. Copied.
 * @param learner Receives the handle, which lies at the start of the memory.
 * @return CRITREG_TOO_SMALL if the memory is too short for the capacities;
 * CRITREG_SYNTAX_ERROR (ask critreg_check_domain() where);
 * CRITREG_CAPACITY_EXCEEDED if the text is longer than CRITREG_DOMAIN_TEXT_MAX
 * or declares too many things; CRITREG_INVALID_ARGUMENT for a domain without
 * parameters (CRITREG_ALGORITHM1 only), a text that is not UTF-8, a wrong configuration or a manual sample
 * outside of the ranges of the parameters; CRITREG_NOT_FINITE for a manual sample
 * or a share of the configuration; CRITREG_NULL_POINTER, CRITREG_MISALIGNED.
 */
critreg_status critreg_learner_init(void *memory,
                                    size_t memory_len,
                                    const char *domain,
                                    const struct critreg_config *config,
                                    struct critreg_learner **learner);

/**
 * How many numbers an instance has: one per attribute of every object of the
 * domain, in order of declaration.
 *
 * @param learner The learner.
 * @param len Receives the number.
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_learner_instance_len(const struct critreg_learner *learner,
                                            size_t *len);

/**
 * How many parameters the action has: the length of a sample.
 *
 * @param learner The learner.
 * @param count Receives the number.
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_learner_parameter_count(const struct critreg_learner *learner,
                                               size_t *count);

/**
 * Chooses instances of a source that can make thousands, and writes them into an array for
 * critreg_learn_region(), critreg_ask() and all others that take instances: as many as there
 * is room for, those that differ most. Where instances are alike, a condition that holds in all
 * of them by chance looks as good as the one that matters. Only what is chosen takes memory.
 *
 * The source is divided into as many parts as there is room for instances, and of each the one
 * is taken that differs most from those before, in what the learner measures: distances,
 * coordinates, angles. Every instance is made two or three times. The same source makes the same
 * choice.
 *
 * ```c
 * static double instances[64 * NUMBERS];
 * size_t count;
 * CHECK(critreg_choose_instances(learner, 1000, make_task, NULL, instances, 64, &count));
 * CHECK(critreg_learn_region(learner, instances, count, try_grasp, NULL, &region));
 * ```
 *
 * @param learner The learner, of which nothing was asked and nothing told;
 * CRITREG_VERSION_SPACE.
 * @param offered How many instances the source has.
 * @param make Makes one.
 * @param user_data Passed to make.
 * @param instances Receives the chosen ones, one behind the other. If the call fails, it holds
 * anything.
 * @param room For how many there is room; no more than critreg_config.instances are written.
 * @param count Receives how many there are.
 * @return CRITREG_OUT_OF_SEQUENCE after something was asked or told;
 * CRITREG_INVALID_ARGUMENT if there is no instance, no room for one, or CRITREG_ALGORITHM1;
 * CRITREG_NOT_FINITE for a number of an instance; what make returned if that is not CRITREG_OK;
 * CRITREG_BUSY from a callback; CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
 * CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_choose_instances(struct critreg_learner *learner,
                                        size_t offered,
                                        critreg_make_instance make,
                                        void *user_data,
                                        double *instances,
                                        size_t room,
                                        size_t *count);

/**
 * Learns a region by trying samples with a simulator until the learner has
 * nothing more to ask. It is the loop critreg_ask(), simulate(), critreg_tell().
 *
 * ```c
 * static uint64_t memory[CRITREG_LEARNER_WORDS(4096, 256)];
 * critreg_learner *learner;
 * const critreg_region *region;
 * char text[512];
 *
 * if (critreg_learner_init(memory, sizeof memory, DOMAIN, NULL, &learner) == CRITREG_OK
 *     && critreg_learn_region(learner, instances, 4, try_grasp, NULL, &region) == CRITREG_OK
 *     && critreg_region_format(region, text, sizeof text, NULL) == CRITREG_OK)
 *     puts(text);
 * ```
 *
 * If it was stopped, call it again to go on; it begins with the sample that was
 * not told. If learning is finished, it only returns the region.
 *
 * @param learner The learner.
 * @param instances The problem instances, one behind the other: count times one
 * number per attribute, as the program has them or as critreg_choose_instances() chose them of
 * very many. They must be the same in all calls; others may be appended,
 * as far as there is room for them: what was told is then taken in again.
 * @param count How many instances there are, at least one.
 * @param simulate Tries a sample.
 * @param user_data Passed to simulate.
 * @param region NULL, or receives the region; it is valid as the one of
 * critreg_learner_region() is.
 * @return CRITREG_NO_REGION if nothing was learned that is exact or approximate, see
 * critreg_region_quality() and critreg_learner_why(); CRITREG_CAPACITY_EXCEEDED if
 * there is no room for another observation (critreg_learner_region() still has
 * what was learned) or for so many instances (critreg_config.instances); the status
 * of a callback that was not CRITREG_OK; CRITREG_INVALID_ARGUMENT for no instance, or
 * an outcome that was not written or is none (the sample then stays to be tried);
 * CRITREG_NOT_FINITE for a number of an instance; CRITREG_MISMATCH if the instances
 * changed; CRITREG_BUSY from a callback; CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
 * CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_learn_region(struct critreg_learner *learner,
                                    const double *instances,
                                    size_t count,
                                    critreg_simulate simulate,
                                    void *user_data,
                                    const struct critreg_region **region);

/**
 * Makes a learner usable again that answers CRITREG_BUSY because a callback was left by
 * longjmp(), which it must not be. The sample that was being tried stays to be tried; all
 * that was told before is kept. A learner that is not busy stays as it is.
 *
 * @param learner The learner. No call on it may be running, so this is not for callbacks.
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_learner_recover(struct critreg_learner *learner);

/**
 * Tells which sample to try next. Asking again before telling gives the same one.
 *
 * ```c
 * int32_t finished = 0;
 * while (critreg_is_finished(learner, &finished) == CRITREG_OK && !finished) {
 *     size_t instance;
 *     double theta[2];
 *     critreg_outcome outcome;
 *     CHECK(critreg_ask(learner, instances, count, &instance, theta));
 *     outcome = try_on_the_robot(instance, theta);
 *     CHECK(critreg_tell(learner, instances, count, outcome));
 * }
 * ```
 *
 * @param learner The learner.
 * @param instances The problem instances, as for critreg_learn_region(). They are
 * checked in every call.
 * @param count How many there are.
 * @param instance Receives the index of the instance to try it in.
 * @param theta Receives the parameters: one number each. NULL if there are none.
 * @return CRITREG_OUT_OF_SEQUENCE if learning is finished; CRITREG_MISMATCH if
 * the instances changed; CRITREG_CAPACITY_EXCEEDED if there is no room for so
 * many (critreg_config.instances); CRITREG_INVALID_ARGUMENT, CRITREG_NOT_FINITE,
 * CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_ask(struct critreg_learner *learner,
                           const double *instances,
                           size_t count,
                           size_t *instance,
                           double *theta);

/**
 * Tells the learner what came of a sample that it did not ask for: of a log, a
 * demonstration, somebody else's trials. It costs no call, works before anything is asked
 * and between critreg_ask() and critreg_tell() (the sample that was asked for stays to be
 * told), and is saved with the run. Where few parameters work, one sample that works says
 * where to look: also for a slot of a ten thousandth of the range.
 *
 * ```c
 * for (size_t i = 0; i < logged; ++i)
 *     CHECK(critreg_observe(learner, instances, count, log[i].instance, log[i].theta,
 *                           log[i].worked));
 * CHECK(critreg_conclude(learner, instances, count));
 * ```
 *
 * With noise, what was asked for is asked again until its outcome is beyond doubt; what was
 * not is taken at its word, and wrong outcomes make the region an approximate one, which is
 * judged by a quarter of what was not asked for.
 *
 * A log may be longer than critreg_config.observations: when these are used up, of what was
 * not asked everything near the bounds of the region is kept and elsewhere every second
 * sample. What is learned agrees with what is kept.
 *
 * @param learner The learner; CRITREG_VERSION_SPACE.
 * @param instances The problem instances, as for critreg_ask().
 * @param count How many there are.
 * @param instance The index of the instance that it was tried in.
 * @param theta The parameters: one number each. NULL if there are none.
 * @param outcome What came of it.
 * @return CRITREG_CAPACITY_EXCEEDED if there is no room for another observation, because
 * nearly all were asked for;
 * CRITREG_INVALID_ARGUMENT for an instance or outcome that is none, a step that the
 * configuration does not have, or CRITREG_ALGORITHM1; CRITREG_NOT_FINITE for a parameter;
 * and as critreg_ask() where that is not finished. Then nothing was told.
 */
critreg_status critreg_observe(struct critreg_learner *learner,
                               const double *instances,
                               size_t count,
                               size_t instance,
                               const double *theta,
                               critreg_outcome outcome);

/**
 * Brings the region up to date with everything that was told. The region agrees with that
 * anyway as far as it can; but a better one is only looked for when the learner asks, at
 * the end, and now and then while critreg_observe() is called. A program that only
 * observes calls it before it asks for the region. What is asked next may be something
 * else than without it.
 *
 * @param learner The learner.
 * @param instances The problem instances, as for critreg_ask().
 * @param count How many there are.
 * @return As critreg_ask(), where that is not finished.
 */
critreg_status critreg_conclude(struct critreg_learner *learner,
                                const double *instances,
                                size_t count);

/**
 * Tells the learner what came of the sample it asked for. If this fails, the
 * sample is still to be told.
 *
 * @param learner The learner.
 * @param instances The problem instances, as for critreg_ask().
 * @param count How many there are.
 * @param outcome What came of the sample.
 * @return CRITREG_OUT_OF_SEQUENCE if nothing was asked; CRITREG_CAPACITY_EXCEEDED
 * if there is no room for another observation; CRITREG_INVALID_ARGUMENT for a number
 * that is no outcome, or a step that the configuration does not have; and as
 * critreg_ask().
 */
critreg_status critreg_tell(struct critreg_learner *learner,
                            const double *instances,
                            size_t count,
                            critreg_outcome outcome);

/**
 * Asks for several samples at once, for as many workers: threads, processes, robots. Each
 * has an id, by which critreg_tell_id() knows it. They are chosen to be good together: each
 * for what is left whichever answers the open ones get. No two open questions are about the
 * same sample.
 *
 * It never waits. It gives fewer questions than wanted, or none, if no more are worth asking
 * before an answer comes: the calls that are left are all asked for, or
 * critreg_config.questions are open. With CRITREG_ALGORITHM1 there is one at a time.
 *
 * ```c
 * while (critreg_is_finished(learner, &finished) == CRITREG_OK && !finished) {
 *     CHECK(critreg_ask_many(learner, instances, count, idle_workers(), ids, numbers, thetas,
 *                            &given));
 *     for (size_t i = 0; i < given; ++i)
 *         start_worker(ids[i], numbers[i], &thetas[i * PARAMETERS]);
 *     wait_for_a_worker(&id, &outcome);
 *     CHECK(critreg_tell_id(learner, instances, count, id, outcome));
 * }
 * ```
 *
 * @param learner The learner.
 * @param instances The problem instances, as for critreg_ask().
 * @param count How many there are.
 * @param wanted How many questions there is room for.
 * @param ids Receives the id of each.
 * @param instance_numbers Receives the index of the instance to try each in.
 * @param thetas Receives the parameters of each, one sample behind the other. NULL if there
 * are none.
 * @param given Receives how many questions there are; 0 also if learning is finished.
 * @return As critreg_ask(), where that is not finished. If it fails, questions that were
 * asked on the way are open: critreg_open_questions().
 */
critreg_status critreg_ask_many(struct critreg_learner *learner,
                                const double *instances,
                                size_t count,
                                size_t wanted,
                                uint64_t *ids,
                                size_t *instance_numbers,
                                double *thetas,
                                size_t *given);

/**
 * Tells the learner what came of a question, in any order. What it learns does not depend on
 * the order in which answers come between two calls of critreg_ask() or critreg_ask_many():
 * the answer to a question before which others are open waits for these, at most until the
 * learner asks next or critreg_conclude() is called. What critreg_learner_report() and
 * critreg_learner_region() tell is without it until then. Among questions that
 * critreg_observe() comes in between, the order of that does matter.
 *
 * CRITREG_UNKNOWN teaches nothing, and the learner asks something else next.
 *
 * @param learner The learner.
 * @param instances The problem instances, as for critreg_ask().
 * @param count How many there are.
 * @param id The id of the question.
 * @param outcome What came of it.
 * @return CRITREG_OUT_OF_SEQUENCE if no question with this id waits for an answer, since it
 * was told, or forgotten so long ago that its place was needed: critreg_observe() takes it
 * then; and as critreg_tell(). If it fails, the question still waits.
 */
critreg_status critreg_tell_id(struct critreg_learner *learner,
                               const double *instances,
                               size_t count,
                               uint64_t id,
                               critreg_outcome outcome);

/**
 * Waits no longer for the answer to a question: its worker was lost, or is too slow. Its
 * sample may be asked about again, with another id. An answer that comes all the same is
 * taken: it is a fact about the world.
 *
 * @param learner The learner.
 * @param id The id of the question.
 * @return CRITREG_OUT_OF_SEQUENCE if no question with this id waits for an answer;
 * CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_forget(struct critreg_learner *learner,
                              uint64_t id);

/**
 * Tells which questions are open, in the order in which they were asked; for a run that was
 * resumed with critreg_learner_resume(), to hand them to its workers again.
 *
 * @param learner The learner.
 * @param wanted How many questions there is room for.
 * @param ids Receives the id of each.
 * @param instance_numbers Receives the index of the instance to try each in.
 * @param thetas Receives the parameters of each, one sample behind the other. NULL if there
 * are none.
 * @param given Receives how many were written.
 * @return CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_open_questions(struct critreg_learner *learner,
                                      size_t wanted,
                                      uint64_t *ids,
                                      size_t *instance_numbers,
                                      double *thetas,
                                      size_t *given);

/**
 * Whether there is nothing more to ask.
 *
 * @param learner The learner; may be called from its callbacks.
 * @param finished Receives 1 or 0.
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_is_finished(const struct critreg_learner *learner,
                                   int32_t *finished);

/**
 * What is learned so far: the best region there is, of whatever quality; see
 * critreg_region_quality().
 *
 * @param learner The learner.
 * @param region Receives the region. It belongs to the learner and is valid until
 * the next call of critreg_learn_region(), critreg_tell(), critreg_observe(),
 * critreg_conclude(), critreg_learner_resume() or critreg_learner_resume_journal() on it; after that using it gives
 * CRITREG_NOT_A_HANDLE. To keep it, save it and load it into memory of its own;
 * what supports its constraints is not saved.
 * @return CRITREG_NO_REGION if there is none, see critreg_learner_why();
 * CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_learner_region(struct critreg_learner *learner,
                                      const struct critreg_region **region);

/**
 * Why there is no region, or none that is exact: as a code and in words.
 *
 * ```c
 * uint32_t why;
 * char words[CRITREG_WHY_MAX];
 * CHECK(critreg_learner_why(learner, &why, words, sizeof words, NULL));
 * printf("%s\n", words);
 * ```
 *
 * @param learner The learner.
 * @param why NULL, or receives the code: CRITREG_WHY_EXPLAINED, or another one. What the
 * code counts is in the words; also what could be compared but found no room, if that may be
 * why: lend memory for more forms then.
 * @param text NULL, or receives the words, ended by NUL; CRITREG_WHY_MAX bytes are enough.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the words with their NUL.
 * @return CRITREG_TOO_SMALL; CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
 * CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_learner_why(struct critreg_learner *learner,
                                   uint32_t *why,
                                   char *text,
                                   size_t len,
                                   size_t *needed);

/**
 * How learning went so far.
 *
 * @param learner The learner; may be called from its callbacks.
 * @param report A report from critreg_report_init(), to be filled.
 * @return CRITREG_INVALID_ARGUMENT if the report was not initialised;
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_learner_report(const struct critreg_learner *learner,
                                      struct critreg_report *report);

/**
 * Why the last call on this learner failed that did fail, in words; an empty text
 * if none did. Calls that take the learner as const, and refusals with
 * CRITREG_BUSY or CRITREG_NOT_A_HANDLE, leave no words.
 *
 * @param learner The learner; may be called from its callbacks.
 * @param text Receives the words, ended by NUL; 128 bytes are always enough.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the words with their NUL, also
 * if the buffer is too small.
 * @return CRITREG_TOO_SMALL (nothing but needed is written);
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_learner_message(const struct critreg_learner *learner,
                                       char *text,
                                       size_t len,
                                       size_t *needed);

/**
 * Draws what is learned so far in an instance, as critreg_region_to_svg(), with what was
 * told about that instance: what worked in blue, what failed as red crosses. While there
 * is no region, only that and what the parameters can choose.
 *
 * @param learner The learner.
 * @param instances The instances of the problem, one behind the other.
 * @param count How many there are.
 * @param index Which of them is drawn, from 0.
 * @param text Receives the SVG, ended by NUL.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the text with its NUL, also if the
 * buffer is too small.
 * @return CRITREG_TOO_SMALL (nothing but needed is written); CRITREG_INVALID_ARGUMENT for
 * an index that is not below count; and as critreg_region_to_svg() and critreg_ask().
 */
critreg_status critreg_learner_to_svg(struct critreg_learner *learner,
                                      const double *instances,
                                      size_t count,
                                      size_t index,
                                      char *text,
                                      size_t len,
                                      size_t *needed);

/**
 * Saves what a learner was told, so that a run can be resumed: versioned,
 * checksummed, the same on every machine. A sample that was asked for but not
 * told is saved with it, and asked for again after resuming.
 *
 * @param learner The learner.
 * @param instances The problem instances, as for critreg_ask().
 * @param count How many there are.
 * @param bytes Receives the bytes.
 * @param len Length of bytes; 0 to ask for the length only.
 * @param needed NULL, or receives how many bytes it takes, also if the buffer is
 * too small.
 * @return CRITREG_TOO_SMALL (nothing but needed is written);
 * CRITREG_INVALID_ARGUMENT, CRITREG_NOT_FINITE, CRITREG_BUSY,
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_learner_save(struct critreg_learner *learner,
                                    const double *instances,
                                    size_t count,
                                    uint8_t *bytes,
                                    size_t len,
                                    size_t *needed);

/**
 * Brings a fresh learner to the state that critreg_learner_save() wrote, by
 * replaying what was told.
 *
 * @param learner A learner that was just made, with the domain, configuration and
 * number of forms of the saved one. It may have other calls, and room for more.
 * @param instances The instances of the saved run, and perhaps others behind.
 * @param count How many there are.
 * @param bytes The saved bytes.
 * @param len How many there are.
 * @return CRITREG_CORRUPT for damaged bytes; CRITREG_MISMATCH if they belong to
 * another domain, instances, configuration or number of forms;
 * CRITREG_OUT_OF_SEQUENCE if the learner is not fresh; CRITREG_CAPACITY_EXCEEDED
 * if there is no room for all observations: in all these cases nothing is told;
 * CRITREG_INVALID_ARGUMENT, CRITREG_NOT_FINITE, CRITREG_BUSY,
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_learner_resume(struct critreg_learner *learner,
                                      const double *instances,
                                      size_t count,
                                      const uint8_t *bytes,
                                      size_t len);

/**
 * Writes what is to be appended to a journal: a file to which a program adds each answer as
 * it is told, instead of saving the whole run again. Each record has a checksum of its own,
 * so one that was torn when the machine stopped is noticed and everything before it stands.
 *
 * ```c
 * CHECK(critreg_tell(learner, instances, count, outcome));
 * CHECK(critreg_learner_journal(learner, instances, count, written, bytes, sizeof bytes, &len));
 * fwrite(bytes, 1, len, file);
 * fflush(file);
 * written++;
 * ```
 *
 * @param learner The learner.
 * @param instances The problem instances, as for critreg_ask().
 * @param count How many there are.
 * @param from How many observations the journal has, asked for or not: those from there on
 * are written.
 * @param bytes Receives the bytes; a record takes 34 and 8 for each parameter.
 * @param len Length of bytes; 0 to ask for the length only.
 * @param needed NULL, or receives how many bytes it takes, also if the buffer is
 * too small.
 * @return As critreg_learner_save().
 */
critreg_status critreg_learner_journal(struct critreg_learner *learner,
                                       const double *instances,
                                       size_t count,
                                       size_t from,
                                       uint8_t *bytes,
                                       size_t len,
                                       size_t *needed);

/**
 * Brings a fresh learner to the state that a journal tells of.
 *
 * @param learner A learner as for critreg_learner_resume().
 * @param instances The instances of the run, and perhaps others behind.
 * @param count How many there are.
 * @param bytes The journal.
 * @param len How many bytes it has.
 * @param stands NULL, or receives how many of them stand. What is behind was torn or
 * damaged and left out; cut it off before anything is appended.
 * @return CRITREG_MISMATCH for a record of another domain, instances, configuration or
 * number of forms, CRITREG_CORRUPT if one is missing before it,
 * CRITREG_CAPACITY_EXCEEDED if there is no room for it, CRITREG_OUT_OF_SEQUENCE if the
 * learner is not fresh: in all these cases nothing is told; CRITREG_INVALID_ARGUMENT,
 * CRITREG_NOT_FINITE, CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
 * CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_learner_resume_journal(struct critreg_learner *learner,
                                              const double *instances,
                                              size_t count,
                                              const uint8_t *bytes,
                                              size_t len,
                                              size_t *stands);

/**
 * How many bytes of memory a region takes that does not belong to a learner.
 * CRITREG_REGION_WORDS sizes a static array.
 */
size_t critreg_region_size(void);

/**
 * The alignment in bytes that the memory of a region needs. An array of uint64_t
 * and what malloc() returns have it.
 */
size_t critreg_region_align(void);

/**
 * Makes a region from its text, in memory of the program.
 *
 * ```c
 * static uint64_t memory[CRITREG_REGION_WORDS];
 * critreg_region *region;
 * status = critreg_region_parse(memory, sizeof memory, DOMAIN,
 *                               "grasp.y <= zone.top - robot.radius", &region);
 * ```
 *
 * @param memory Memory for the region, aligned to critreg_region_align(). From
 * now on it belongs to the region: do not write to it, move it or copy it.
 * @param memory_len Its length in bytes, at least critreg_region_size().
 * @param domain The domain text, ended by NUL. Copied.
 * @param text The region text, ended by NUL. Copied.
 * @param region Receives the handle, which lies at the start of the memory.
 * @return CRITREG_TOO_SMALL; CRITREG_SYNTAX_ERROR (ask critreg_check_region()
 * where); CRITREG_CAPACITY_EXCEEDED if a text is too long or has too many parts;
 * CRITREG_INVALID_ARGUMENT if one is not UTF-8; CRITREG_NULL_POINTER,
 * CRITREG_MISALIGNED.
 */
critreg_status critreg_region_parse(void *memory,
                                    size_t memory_len,
                                    const char *domain,
                                    const char *text,
                                    struct critreg_region **region);

/**
 * Makes a region from bytes that critreg_region_save() wrote, in memory of the
 * program.
 *
 * @param memory Memory for the region, as for critreg_region_parse().
 * @param memory_len Its length in bytes, at least critreg_region_size().
 * @param bytes The saved bytes.
 * @param len How many there are.
 * @param region Receives the handle, which lies at the start of the memory.
 * @return CRITREG_CORRUPT if the bytes are damaged, incomplete or of an unknown
 * version; CRITREG_INVALID_ARGUMENT if the region computes with a precision that the
 * library was built without, CRITREG_NOT_FINITE if that cannot hold its numbers; and as
 * critreg_region_parse().
 */
critreg_status critreg_region_load(void *memory,
                                   size_t memory_len,
                                   const uint8_t *bytes,
                                   size_t len,
                                   struct critreg_region **region);

/**
 * Reads a domain text and says what is wrong with it, such as
 * "line 3, column 7: unknown object".
 *
 * @param domain The domain text, ended by NUL.
 * @param text Receives the words, ended by NUL: an empty text if all is well.
 * They are written also if the check fails, which is what they are for, and cut
 * off where the buffer ends. 256 bytes are always enough.
 * @param len Length of text in bytes; 0 if the words are not wanted.
 * @param needed NULL, or receives the length of the words with their NUL.
 * @return CRITREG_OK if the text is a domain; CRITREG_SYNTAX_ERROR; CRITREG_CAPACITY_EXCEEDED if it is
 * longer than CRITREG_DOMAIN_TEXT_MAX or declares too many things;
 * CRITREG_INVALID_ARGUMENT if it is not UTF-8; CRITREG_NULL_POINTER,
 * CRITREG_MISALIGNED.
 */
critreg_status critreg_check_domain(const char *domain,
                                    char *text,
                                    size_t len,
                                    size_t *needed);

/**
 * Reads a region text and says what is wrong with it.
 *
 * @param domain The domain text that the region speaks about, ended by NUL.
 * @param region_text The region text, ended by NUL.
 * @param text Receives the words, as for critreg_check_domain(). If the domain
 * text is wrong, they are about that.
 * @param len Length of text in bytes; 0 if the words are not wanted.
 * @param needed NULL, or receives the length of the words with their NUL.
 * @return CRITREG_OK if critreg_region_parse() would accept both texts, else as
 * critreg_check_domain().
 */
critreg_status critreg_check_region(const char *domain,
                                    const char *region_text,
                                    char *text,
                                    size_t len,
                                    size_t *needed);

/**
 * Writes a region with its domain and precision as bytes: versioned, checksummed, the same
 * on every machine.
 *
 * @param region The region.
 * @param bytes Receives the bytes.
 * @param len Length of bytes; 0 to ask for the length only.
 * @param needed NULL, or receives how many bytes the region takes, also if the
 * buffer is too small.
 * @return CRITREG_TOO_SMALL (nothing but needed is written);
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_save(const struct critreg_region *region,
                                   uint8_t *bytes,
                                   size_t len,
                                   size_t *needed);

/**
 * Writes a region as text. Reading that text with the same domain gives the same
 * region.
 *
 * @param region The region.
 * @param text Receives the text, ended by NUL.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the text with its NUL, also if
 * the buffer is too small.
 * @return CRITREG_TOO_SMALL (nothing but needed is written);
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_format(const struct critreg_region *region,
                                     char *text,
                                     size_t len,
                                     size_t *needed);

/**
 * How many numbers an instance has: one per attribute of every object of the
 * domain, in order of declaration.
 *
 * @param region The region.
 * @param len Receives the number.
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_instance_len(const struct critreg_region *region,
                                           size_t *len);

/**
 * How many parameters the action has.
 *
 * @param region The region.
 * @param count Receives the number.
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_parameter_count(const struct critreg_region *region,
                                              size_t *count);

/**
 * How many constraints a region has: those of its text from left to right,
 * whatever connects them.
 *
 * ```c
 * size_t count, i;
 * CHECK(critreg_region_constraint_count(region, &count));
 * for (i = 0; i < count; i++) {
 *     critreg_constraint constraint;
 *     char text[256];
 *     CHECK(critreg_constraint_init(&constraint, sizeof constraint));
 *     CHECK(critreg_region_constraint(region, i, &constraint));
 *     CHECK(critreg_region_constraint_format(region, i, text, sizeof text, NULL));
 *     printf("%s excludes %u failures\n", text, (unsigned)constraint.support);
 * }
 * ```
 *
 * @param region The region.
 * @param count Receives the number, at most CRITREG_MAX_CONSTRAINTS.
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_constraint_count(const struct critreg_region *region,
                                               size_t *count);

/**
 * Prepares a struct for critreg_region_constraint().
 *
 * @param constraint The struct.
 * @param size sizeof *constraint; see critreg_config_init().
 * @return As critreg_config_init().
 */
critreg_status critreg_constraint_init(struct critreg_constraint *constraint,
                                       size_t size);

/**
 * What supports a constraint of a region.
 *
 * @param region The region.
 * @param index Index of the constraint, from 0.
 * @param constraint A struct from critreg_constraint_init(), to be filled.
 * @return CRITREG_INVALID_ARGUMENT if there is no constraint with this index or
 * the struct was not initialised; CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
 * CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_constraint(const struct critreg_region *region,
                                         size_t index,
                                         struct critreg_constraint *constraint);

/**
 * Writes a constraint of a region as text, with the name of its bound in brackets
 * if it has one, as in critreg_region_format(). It is itself the text of a region.
 *
 * @param region The region.
 * @param index Index of the constraint, from 0.
 * @param text Receives the text, ended by NUL.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the text with its NUL, also if
 * the buffer is too small.
 * @return CRITREG_TOO_SMALL (nothing but needed is written);
 * CRITREG_INVALID_ARGUMENT if there is no constraint with this index;
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_constraint_format(const struct critreg_region *region,
                                                size_t index,
                                                char *text,
                                                size_t len,
                                                size_t *needed);

/**
 * Writes the name of a constraint's bound as text: what it is in terms of the
 * domain's constants, such as "zone.top - robot.radius".
 *
 * @param region The region.
 * @param index Index of the constraint, from 0.
 * @param text Receives the text, ended by NUL; an empty text if the bound has no
 * name.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the text with its NUL, also if
 * the buffer is too small.
 * @return As critreg_region_constraint_format().
 */
critreg_status critreg_region_constraint_name(const struct critreg_region *region,
                                              size_t index,
                                              char *text,
                                              size_t len,
                                              size_t *needed);

/**
 * Whether an action with these parameters is expected to work.
 *
 * @param region The region.
 * @param instance The instance: one number per attribute.
 * @param theta The parameters: one number each; NULL if there are none. Outside of
 * their ranges they are not inside of any region.
 * @param inside Receives 1 or 0.
 * @return CRITREG_NOT_FINITE for a number of the instance or of theta;
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_contains(const struct critreg_region *region,
                                       const double *instance,
                                       const double *theta,
                                       int32_t *inside);

/**
 * The exact set of values that the region admits for the only parameter of an
 * action, as sorted intervals that do not touch.
 *
 * Whether the ends belong to the set, which depends on < and <= in the
 * constraints, is not told: no sampler can notice. Where a constraint has no
 * closed form (a turn by the parameter, a sum of two distances), or there are more
 * than CRITREG_MAX_INTERVALS of them, the set is too large rather than too small;
 * critreg_sample_region() is right all the same.
 *
 * @param region The region of an action with one parameter.
 * @param instance The instance: one number per attribute.
 * @param ends Receives lower and upper end of each interval: 2 * capacity
 * numbers. NULL if capacity is 0.
 * @param capacity How many intervals there is room for.
 * @param count Receives how many intervals there are, also if they are more than
 * capacity; 0 for an empty set.
 * @return CRITREG_TOO_SMALL if there are more than capacity (nothing but count is
 * written); CRITREG_INVALID_ARGUMENT unless the action has one parameter;
 * CRITREG_NOT_FINITE, CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
 * CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_intervals(const struct critreg_region *region,
                                        const double *instance,
                                        double *ends,
                                        size_t capacity,
                                        size_t *count);

/**
 * Whether it is proven that the region admits no parameters in an instance. With
 * one parameter the answer is exact; with several, 0 may mean that no proof was
 * found.
 *
 * @param region The region.
 * @param instance The instance: one number per attribute.
 * @param empty Receives 1 or 0.
 * @return CRITREG_NOT_FINITE, CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
 * CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_is_empty(const struct critreg_region *region,
                                       const double *instance,
                                       int32_t *empty);

/**
 * Draws parameters from the region in an instance. This is what a planner calls.
 *
 * One parameter: uniform over the exact intervals. Several: uniform by rejection;
 * if the region is small, by hit-and-run, which tends to uniform. What comes back
 * always satisfies critreg_region_contains().
 *
 * ```c
 * critreg_rng rng = critreg_rng_seed(7);
 * double theta[1];
 * switch (critreg_sample_region(region, instance, &rng, theta)) {
 * case CRITREG_OK:           return try_action(theta);
 * case CRITREG_EMPTY_REGION: return postpone_this_skeleton();
 * default:                   return try_action_with_any_parameters();
 * }
 * ```
 *
 * @param region The region.
 * @param instance The instance: one number per attribute.
 * @param rng The generator, which moves on, also if no parameters are found.
 * @param theta Receives the parameters: one number each. NULL if there are none.
 * @return CRITREG_EMPTY_REGION if it is proven that the region has none here,
 * CRITREG_NO_SAMPLE if none were found within the budget; CRITREG_NOT_FINITE,
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_sample_region(const struct critreg_region *region,
                                     const double *instance,
                                     struct critreg_rng *rng,
                                     double *theta);

/**
 * Draws parameters that several regions admit, each in an instance of its own: the
 * region of an action, and those of what comes after it.
 *
 * This is what a planner with a search of its own uses for chains. A region that
 * was learned about a sequence of actions, such as "pick, then press", says with
 * which parameters of the first action the last one works. It is put into as many
 * instances as the plan skeleton has last actions, one for each button that is
 * going to be pressed, and the intersection is known before anything is tried: if
 * it is empty, the skeleton contradicts what was learned.
 *
 * ```c
 * const critreg_region *regions[] = {pick, pick_and_press, pick_and_press};
 * const double *instances[] = {now, with_first_button, with_second_button};
 * switch (critreg_sample_regions(regions, instances, 3, &rng, theta)) {
 * case CRITREG_OK:           return try_action(theta);
 * case CRITREG_EMPTY_REGION: return postpone_this_skeleton();
 * default:                   return try_action_with_any_parameters();
 * }
 * ```
 *
 * Draws are made in the way of critreg_sample_region().
 *
 * @param regions The regions. Their domains may differ, but not in number and
 * ranges of the parameters.
 * @param instances An instance for each: one number per attribute.
 * @param count How many regions there are, from 1 to CRITREG_MAX_REGIONS.
 * @param rng The generator, which moves on, also if no parameters are found.
 * @param theta Receives the parameters: one number each. NULL if there are none.
 * @return CRITREG_EMPTY_REGION if it is proven that the regions have none in common
 * here, CRITREG_NO_SAMPLE if none were found within the budget; CRITREG_MISMATCH if the
 * regions have other parameters; CRITREG_CAPACITY_EXCEEDED for too many regions;
 * CRITREG_INVALID_ARGUMENT for no region; CRITREG_NOT_FINITE,
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_sample_regions(const struct critreg_region *const *regions,
                                      const double *const *instances,
                                      size_t count,
                                      struct critreg_rng *rng,
                                      double *theta);

/**
 * Whether it is proven that several regions, each in an instance of its own, admit
 * no parameters together; see critreg_sample_regions() and
 * critreg_region_is_empty().
 *
 * @param regions The regions.
 * @param instances An instance for each: one number per attribute.
 * @param count How many regions there are, from 1 to CRITREG_MAX_REGIONS.
 * @param empty Receives 1 or 0.
 * @return CRITREG_MISMATCH, CRITREG_CAPACITY_EXCEEDED, CRITREG_INVALID_ARGUMENT as
 * critreg_sample_regions(); CRITREG_NOT_FINITE, CRITREG_NULL_POINTER,
 * CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_regions_are_empty(const struct critreg_region *const *regions,
                                         const double *const *instances,
                                         size_t count,
                                         int32_t *empty);

/**
 * Whether an action with each of many parameters is expected to work in an instance: as
 * critreg_region_contains(), but the instance is looked at once.
 *
 * @param region The region.
 * @param instance The instance: one number per attribute.
 * @param thetas The parameters of one sample behind those of another; NULL if there are
 * none.
 * @param count How many samples there are.
 * @param inside Receives 1 or 0 for each sample; NULL if count is 0. What it holds is
 * undefined unless the call succeeds.
 * @return CRITREG_NOT_FINITE for a number of the instance or of thetas;
 * CRITREG_INVALID_ARGUMENT for a count that no memory holds; CRITREG_NULL_POINTER,
 * CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_contains_many(const struct critreg_region *region,
                                            const double *instance,
                                            const double *thetas,
                                            size_t count,
                                            uint8_t *inside);

/**
 * Draws many parameters from the region in an instance: the same as so many calls of
 * critreg_sample_region(), but the instance is looked at once.
 *
 * @param region The region.
 * @param instance The instance: one number per attribute.
 * @param count How many samples are wanted.
 * @param rng The generator, which moves on, also if no parameters are found.
 * @param thetas Receives the parameters of one sample behind those of another. NULL if
 * there are none.
 * @param drawn Receives how many samples were drawn: count, or fewer if the call fails
 * with CRITREG_NO_SAMPLE. Those stand in thetas.
 * @return CRITREG_EMPTY_REGION, CRITREG_NO_SAMPLE as critreg_sample_region();
 * CRITREG_NOT_FINITE, CRITREG_INVALID_ARGUMENT, CRITREG_NULL_POINTER,
 * CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_sample_region_many(const struct critreg_region *region,
                                          const double *instance,
                                          size_t count,
                                          struct critreg_rng *rng,
                                          double *thetas,
                                          size_t *drawn);

/**
 * How far each constraint of a region is from its bound, with gradients: what an optimiser
 * calls g(x) <= 0.
 *
 * A value is at most 0 where the constraint holds, and below 0 where it says < or >. The
 * constraints are in the order of the text, critreg_region_constraint_count() of them. Of
 * a region that joins them by "and" they are all there is to know; of another one they
 * are its constraints without "or" and "not".
 *
 * Parameters may be outside of their ranges in the domain text, which are bounds of the
 * optimiser's variables. A constraint over no member of a group has
 * the value minus infinity, one about a body that is absent plus infinity; their gradients
 * are 0. At a kink, such as that of a distance along an axis where it is 0, the derivative
 * is the one for a growing parameter.
 *
 * ```c
 * double g[CRITREG_MAX_CONSTRAINTS];
 * double by_theta[CRITREG_MAX_CONSTRAINTS * CRITREG_MAX_PARAMETERS];
 * critreg_region_margins(region, instance, theta, g, by_theta);
 * ```
 *
 * @param region The region.
 * @param instance The instance: one number per attribute.
 * @param theta The parameters: one number each; NULL if there are none.
 * @param values Receives one number per constraint; NULL if there are none.
 * @param gradients NULL, or receives for each constraint its derivative by each parameter:
 * those of the first constraint, those of the second one, and so on.
 * @return CRITREG_NOT_FINITE for a number of the instance or of theta;
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_margins(const struct critreg_region *region,
                                      const double *instance,
                                      const double *theta,
                                      double *values,
                                      double *gradients);

/**
 * Prepares a proof for critreg_region_implies(), with defaults.
 *
 * @param proof The proof.
 * @param size sizeof *proof; see critreg_config_init().
 * @return As critreg_config_init().
 */
critreg_status critreg_proof_init(struct critreg_proof *proof, size_t size);

/**
 * Whether all that a region admits satisfies a specification, in every instance whose
 * numbers are in ranges.
 *
 * A specification is a region of the same domain text that says what must hold, as "the
 * hand stays in its zone and clear of every obstacle":
 *
 * ```c
 * critreg_region_parse(memory, sizeof memory, domain_text,
 *     "hand.y + radius <= zone.top and min(clear(hand, obstacle)) >= 0", &specification);
 * critreg_proof_init(&proof, sizeof proof);
 * critreg_region_implies(region, specification, ranges, &proof, instance, theta);
 * if (proof.verdict == CRITREG_REFUTED)
 *     try_it(instance, theta);
 * ```
 *
 * A proof is one in real arithmetic (rounding is outward), up to proof.tolerance. A
 * counterexample is in the region and not in the specification, as
 * critreg_region_contains() tells of double precision. Statements are proven one by one,
 * those about all members of a group for one member at a time, so their number costs
 * little. Members of groups may be there or not; one whose ranges are NaN never is. What
 * touches what is specified without a gap, or hangs together by many numbers, may stay
 * undecided.
 *
 * Some things cannot be proven: angles with a symmetry, lines of sight, and how clear two
 * bodies are of each other that both have sides. A specification about them is refused;
 * in a region they count as if they were not said.
 *
 * @param region The region.
 * @param specification What it has to satisfy.
 * @param ranges A lower and an upper end for each number of an instance.
 * @param proof From critreg_proof_init(); what it may cost is read, what was found is
 * written.
 * @param instance Receives the instance of a counterexample, one number per attribute: NaN
 * for those of members that it is not about. What it holds is undefined unless there is one.
 * @param theta Receives its parameters, if there is one; NULL if the action has none.
 * @return CRITREG_MISMATCH for regions of two domain texts; CRITREG_INVALID_ARGUMENT for a
 * specification that cannot be proven, and for a range or a tolerance that is none;
 * CRITREG_NOT_FINITE for a range; CRITREG_CAPACITY_EXCEEDED for more terms than there is
 * room for; CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_implies(const struct critreg_region *region,
                                      const struct critreg_region *specification,
                                      const double *ranges,
                                      struct critreg_proof *proof,
                                      double *instance,
                                      double *theta);

/**
 * How many questions for another prover a specification is, see critreg_region_to_smt2():
 * one for each statement that it joins by "and", and for each member of a group that this
 * is about.
 *
 * @param specification The specification.
 * @param count Receives how many there are; 0 for "true".
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_question_count(const struct critreg_region *specification,
                                             size_t *count);

/**
 * Writes one of the questions of critreg_region_implies() as SMT-LIB 2, for another prover:
 * z3 and its like answer "unsat" if the region satisfies this part of the specification in
 * all instances in the ranges, up to the tolerance. "sat" is a counterexample, if the
 * angles that the model stands for are in their ranges.
 *
 * Numbers are reals, written as the shortest decimals; an angle is a point of the unit
 * circle, a distance a number with a square. Angles between what moves are not said. A
 * prover may take for ever where something turns; critreg_region_implies() mostly does not.
 *
 * @param region The region.
 * @param specification What it has to satisfy.
 * @param ranges A lower and an upper end for each number of an instance.
 * @param proof NULL for defaults, or a struct from critreg_proof_init() with the tolerance.
 * @param number Which question, from 0; see critreg_region_question_count().
 * @param text Receives the script, ended by NUL.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the text with its NUL, also if the buffer
 * is too small.
 * @return CRITREG_TOO_SMALL (nothing but needed is written); CRITREG_INVALID_ARGUMENT for a
 * number that no question has; all others as critreg_region_implies().
 */
critreg_status critreg_region_to_smt2(const struct critreg_region *region,
                                      const struct critreg_region *specification,
                                      const double *ranges,
                                      const struct critreg_proof *proof,
                                      size_t number,
                                      char *text,
                                      size_t len,
                                      size_t *needed);

/**
 * Whether the region that a learner has satisfies a specification, as
 * critreg_region_implies(): if not, the counterexample is what to try next.
 *
 * So learning goes on until the region is proven, or the proof says what is open: append
 * the instance to those of the learner, try the parameters there, and tell what came of it.
 *
 * ```c
 * critreg_learn_region(learner, instances, count, try, user_data, &region);
 * while (critreg_learner_challenge(learner, specification, ranges, &proof, next, theta)
 *        == CRITREG_OK && proof.verdict == CRITREG_REFUTED && count < room) {
 *     memcpy(&instances[count * len], next, len * sizeof *next);
 *     outcome = try_it(next, theta);
 *     critreg_observe(learner, instances, count + 1, count, theta, outcome);
 *     critreg_conclude(learner, instances, ++count);
 * }
 * ```
 *
 * If the action works there after all, the specification asks for too much. The learner
 * needs room for the instances and observations that come to it.
 *
 * @param learner The learner.
 * @param specification What the region has to satisfy: a region of the same domain text.
 * @param ranges A lower and an upper end for each number of an instance.
 * @param proof From critreg_proof_init(); what it may cost is read, what was found is
 * written.
 * @param instance Receives the instance of a counterexample.
 * @param theta Receives its parameters; NULL if the action has none.
 * @return CRITREG_NO_REGION if nothing is learned; CRITREG_BUSY; all others as
 * critreg_region_implies().
 */
critreg_status critreg_learner_challenge(struct critreg_learner *learner,
                                         const struct critreg_region *specification,
                                         const double *ranges,
                                         struct critreg_proof *proof,
                                         double *instance,
                                         double *theta);

/**
 * Writes a region as C99 that needs no library: a header with static inline functions,
 * for a robot on which there is no room for more.
 *
 * ```text
 * int  pick_contains(instance, theta)    1 if the parameters are inside
 * void pick_margins(instance, theta, values, gradients)
 *                                        as critreg_region_margins()
 * int  pick_intervals(instance, ends)    lower and upper ends, up to
 *                                        2 * pick_MAX_INTERVALS numbers; how many
 * int  pick_sample(instance, share, theta)
 *                                        a draw for a uniform share in [0, 1); 0 if
 *                                        nothing is inside
 * ```
 *
 * The last two are there for an action with one parameter whose constraints have a closed
 * form that can be written: those of coordinates and distances, not of angles of what
 * moves, nor extremes of that; a comment at the head of the text says so. The numbers are
 * double, or float where pick_FLOAT is defined.
 *
 * What is computed is what the library computes, in the same order: with
 * -ffp-contract=off the answers are equal to the last bit, apart from what sin, cos and
 * atan2 of the C library round otherwise. Within rounding of the end of an interval,
 * pick_contains() looks at the constraints and critreg_region_contains() at the interval.
 * Numbers are not checked: where one is NaN, nothing is inside.
 *
 * @param region The region.
 * @param name What all names begin with, as "pick": up to 64 letters, digits and _.
 * @param text Receives the C, ended by NUL.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the text with its NUL, also if the
 * buffer is too small.
 * @return CRITREG_TOO_SMALL (nothing but needed is written); CRITREG_INVALID_ARGUMENT for
 * a name that is none in C, and for a region about relations between bodies or angles
 * with a symmetry, which cannot be written; CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
 * CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_to_c(const struct critreg_region *region,
                                   const char *name,
                                   char *text,
                                   size_t len,
                                   size_t *needed);

/**
 * Writes a region as a module of Rust that needs the crate libm only, and neither std nor a
 * heap: contains(), margins(), intervals() and sample(), which say what those of
 * critreg_region_to_c() do, and are there where those are.
 *
 * What is computed is what the library computes, equal to the last bit.
 *
 * @param region The region.
 * @param precision What the module computes with: CRITREG_F64 or CRITREG_F32.
 * @param text Receives the module, ended by NUL.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the text with its NUL, also if the
 * buffer is too small.
 * @return CRITREG_INVALID_ARGUMENT for another precision; otherwise as
 * critreg_region_to_c().
 */
critreg_status critreg_region_to_rust(const struct critreg_region *region,
                                      uint32_t precision,
                                      char *text,
                                      size_t len,
                                      size_t *needed);

/**
 * Draws a region in an instance, as SVG: its text; the scene with its bodies, and where
 * the action moves points and bodies, green where it is expected to work and grey where
 * not; beside it the parameters that are inside, of one as intervals, of two as an area,
 * of more as draws. In space the scene is seen from above and from the side.
 *
 * The same region and instance give the same text everywhere. It has some 10 to 100 KB.
 *
 * ```c
 * size_t needed;
 * critreg_region_to_svg(region, instance, NULL, 0, &needed);
 * ```
 *
 * @param region The region.
 * @param instance The instance: one number per attribute.
 * @param text Receives the SVG, ended by NUL.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the text with its NUL, also if the
 * buffer is too small.
 * @return CRITREG_TOO_SMALL (nothing but needed is written); CRITREG_NOT_FINITE for a
 * number of the instance; CRITREG_CAPACITY_EXCEEDED if more points of the domain move
 * than fit; CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_region_to_svg(const struct critreg_region *region,
                                     const double *instance,
                                     char *text,
                                     size_t len,
                                     size_t *needed);

/**
 * A generator with this seed.
 */
struct critreg_rng critreg_rng_seed(uint64_t seed);

/**
 * Draws a number uniform in [0, 1).
 *
 * @param rng The generator, which moves on.
 * @param number Receives the number.
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED.
 */
critreg_status critreg_rng_uniform(struct critreg_rng *rng, double *number);

/**
 * Fills a configuration with the defaults.
 *
 * @param config The configuration.
 * @param size sizeof *config, as for critreg_config_init().
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED; CRITREG_INVALID_ARGUMENT if
 * size is smaller than the struct ever was, or larger than this library knows.
 */
critreg_status critreg_planner_config_init(struct critreg_planner_config *config,
                                           size_t size);

/**
 * Reads a PDDL domain and a problem of it and says what is wrong with them, such as
 * "problem, line 3, column 7: unknown object".
 *
 * @param domain The PDDL domain, ended by NUL.
 * @param problem A PDDL problem of that domain, ended by NUL.
 * @param text Receives the words, as for critreg_check_domain().
 * @param len Length of text in bytes; 0 if the words are not wanted.
 * @param needed NULL, or receives the length of the words with their NUL.
 * @return CRITREG_OK if critreg_planner_init() would accept both texts, given
 * memory enough, else as critreg_check_domain(); CRITREG_CAPACITY_EXCEEDED for a
 * text longer than CRITREG_PDDL_TEXT_MAX or too many ground atoms.
 */
critreg_status critreg_check_pddl(const char *domain,
                                  const char *problem,
                                  char *text,
                                  size_t len,
                                  size_t *needed);

/**
 * Sets pddl_bytes, operators, atoms and facts of a configuration to what a PDDL domain and
 * a problem of it need; the rest stays. Ask critreg_planner_size() then how much memory
 * that is.
 *
 * It takes much stack, see above.
 *
 * @param domain The PDDL domain, ended by NUL.
 * @param problem A PDDL problem of that domain, ended by NUL.
 * @param config A configuration from critreg_planner_config_init(), to be changed.
 * @return CRITREG_OK; else as critreg_check_pddl(), which has words for it, and nothing
 * is changed.
 */
critreg_status critreg_planner_measure(const char *domain,
                                       const char *problem,
                                       struct critreg_planner_config *config);

/**
 * How many bytes of memory a planner takes.
 *
 * Where the capacities are constants, CRITREG_PLANNER_WORDS() sizes a static array
 * instead.
 *
 * @param config What the planner is to do, with its capacities.
 * @return The number of bytes; 0 if the configuration is wrong or memory cannot be
 * that large.
 */
size_t critreg_planner_size(const struct critreg_planner_config *config);

/**
 * The alignment in bytes that the memory of a planner needs. An array of uint64_t
 * and what malloc() returns have it.
 */
size_t critreg_planner_align(void);

/**
 * Makes a planner for a problem, in memory of the program.
 *
 * Operators and problem come as PDDL, see PLANNING above. Operators have no
 * parameters until critreg_planner_set_ranges() says so.
 *
 * A planner needs no end: to plan another problem, make another planner in the
 * same memory.
 *
 * @param memory Memory for the planner, aligned to critreg_planner_align(). From
 * now on it belongs to the planner: do not write to it, move it or copy it.
 * @param memory_len Its length in bytes, at least critreg_planner_size().
 * @param domain The PDDL domain, ended by NUL. Copied.
 * @param problem A PDDL problem of that domain, ended by NUL. Copied.
 * @param config How to plan, with the length of a state. Copied.
 * @param planner Receives the handle, which lies at the start of the memory.
 * @return CRITREG_TOO_SMALL if the memory is too short for the capacities;
 * CRITREG_SYNTAX_ERROR (ask critreg_check_pddl() where);
 * CRITREG_CAPACITY_EXCEEDED if the texts, the ground operators or the ground atoms
 * find no room; CRITREG_INVALID_ARGUMENT for a wrong configuration or a text that
 * is not UTF-8; CRITREG_NULL_POINTER, CRITREG_MISALIGNED.
 */
critreg_status critreg_planner_init(void *memory,
                                    size_t memory_len,
                                    const char *domain,
                                    const char *problem,
                                    const struct critreg_planner_config *config,
                                    struct critreg_planner **planner);

/**
 * Says which continuous parameters the operators of a PDDL action have. Before,
 * and with a count of 0, they have none.
 *
 * ```c
 * static const double ranges[][2] = {{0.0, 1.0}};
 * status = critreg_planner_set_ranges(planner, "PickStick", &ranges[0][0], 1);
 * ```
 *
 * @param planner The planner.
 * @param name The name of the action, ended by NUL; case does not matter.
 * @param ranges The least and the greatest value of each parameter: 2 * count
 * numbers. NULL if count is 0. Copied.
 * @param count How many parameters there are, at most CRITREG_MAX_PARAMETERS.
 * @return CRITREG_INVALID_ARGUMENT if there is no such action, or a range is upside
 * down; CRITREG_CAPACITY_EXCEEDED for too many parameters; CRITREG_NOT_FINITE,
 * CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_planner_set_ranges(struct critreg_planner *planner,
                                          const char *name,
                                          const double *ranges,
                                          size_t count);

/**
 * Why the last call on this planner failed that did fail, in words, as
 * critreg_learner_message().
 *
 * @param planner The planner; may be called from its callbacks.
 * @param text Receives the words, ended by NUL.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the words with their NUL, also
 * if the buffer is too small.
 * @return CRITREG_TOO_SMALL (nothing but needed is written);
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_planner_message(const struct critreg_planner *planner,
                                       char *text,
                                       size_t len,
                                       size_t *needed);

/**
 * Fills callbacks with the defaults.
 *
 * @param callbacks The callbacks.
 * @param size sizeof *callbacks, as for critreg_config_init().
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED; CRITREG_INVALID_ARGUMENT if
 * size is smaller than the struct ever was, or larger than this library knows.
 */
critreg_status critreg_callbacks_init(struct critreg_callbacks *callbacks,
                                      size_t size);

/**
 * Plans from a state: first which operators, then with which parameters.
 *
 * The search goes through sequences of operators that reach the goal in the
 * abstract, from shorter to longer ones. Such a plan skeleton is refined step by
 * step: parameters are drawn and execute() is called. A step works if it took an
 * action and whatever the rest of the skeleton and the goal need of it holds; if
 * its tries are spent, an earlier step is tried again. A skeleton that cannot be
 * refined is followed by another one.
 *
 * The state is the program's own: the planner copies it and passes it on, and
 * never looks into it.
 *
 * @param planner The planner.
 * @param callbacks What the planner may ask, from critreg_callbacks_init().
 * @param initial The state to begin in: critreg_planner_config.state_len numbers.
 * In it those atoms must hold that the problem's :init names, and no others.
 * @param seed Seed of all random choices. The same seed, texts, configuration and
 * answers of the callbacks give the same plan on every machine.
 * @param user_data Passed to the callbacks.
 * @param length NULL, or receives how many steps the plan has; read them with
 * critreg_planner_step().
 * @return CRITREG_NO_PLAN if none was found: critreg_planner_metrics() tells how
 * planning ended and what stood in the way; CRITREG_CAPACITY_EXCEEDED if the memory
 * is full; CRITREG_MISMATCH if the initial state does not agree with :init
 * (critreg_planner_message() names the atom); the status of a callback that was
 * not CRITREG_OK; CRITREG_INVALID_ARGUMENT or CRITREG_NOT_FINITE for an answer of a
 * callback that is none; CRITREG_BUSY from a callback; CRITREG_NULL_POINTER, also
 * if execute or holds are not set, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE. In all
 * cases the planner can be used again.
 */
critreg_status critreg_plan(struct critreg_planner *planner,
                            const struct critreg_callbacks *callbacks,
                            const double *initial,
                            uint64_t seed,
                            void *user_data,
                            size_t *length);

/**
 * Makes a planner usable again that answers CRITREG_BUSY because a callback was left by
 * longjmp(), which it must not be. It has no plan then; plan again. A planner that is not
 * busy stays as it is.
 *
 * @param planner The planner. No call on it may be running, so this is not for callbacks.
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_planner_recover(struct critreg_planner *planner);

/**
 * Fills a step, so that critreg_planner_step() knows its size.
 *
 * @param step The step.
 * @param size sizeof *step, as for critreg_config_init().
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED; CRITREG_INVALID_ARGUMENT if
 * size is smaller than the struct ever was, or larger than this library knows.
 */
critreg_status critreg_step_init(struct critreg_step *step, size_t size);

/**
 * A step of the plan that the last critreg_plan() found.
 *
 * @param planner The planner.
 * @param index The step, from 0.
 * @param step A step from critreg_step_init(), to be filled.
 * @return CRITREG_INVALID_ARGUMENT if the plan has no such step or the struct was
 * not initialised; CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
 * CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_planner_step(struct critreg_planner *planner,
                                    size_t index,
                                    struct critreg_step *step);

/**
 * Fills metrics, so that critreg_planner_metrics() knows their size.
 *
 * @param metrics The metrics.
 * @param size sizeof *metrics, as for critreg_config_init().
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED; CRITREG_INVALID_ARGUMENT if
 * size is smaller than the struct ever was, or larger than this library knows.
 */
critreg_status critreg_metrics_init(struct critreg_metrics *metrics,
                                    size_t size);

/**
 * Why the last critreg_plan() found no plan: what stood in the way, and what to change
 * first. critreg_planner_metrics() has the numbers.
 *
 * ```c
 * if (critreg_plan(planner, &callbacks, state, 1, NULL, NULL) == CRITREG_NO_PLAN
 *     && critreg_planner_why(planner, &why, text, sizeof text, NULL) == CRITREG_OK)
 *     puts(text);   // the goal cannot be reached: nothing reaches (At roof), as Climb ...
 * ```
 *
 * @param planner The planner; may be called from its callbacks.
 * @param why Receives CRITREG_WHY_UNREACHABLE or another code.
 * @param text Receives the sentence, ended by NUL; empty for CRITREG_WHY_NOTHING.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the sentence with its NUL, also
 * if the buffer is too small.
 * @return CRITREG_TOO_SMALL (of text nothing is written); CRITREG_NULL_POINTER,
 * CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_planner_why(const struct critreg_planner *planner,
                                   uint32_t *why,
                                   char *text,
                                   size_t len,
                                   size_t *needed);

/**
 * What the last critreg_plan() cost, however it ended.
 *
 * @param planner The planner; may be called from its callbacks.
 * @param metrics Metrics from critreg_metrics_init(), to be filled.
 * @return CRITREG_INVALID_ARGUMENT if the metrics were not initialised;
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_planner_metrics(const struct critreg_planner *planner,
                                       struct critreg_metrics *metrics);

/**
 * How often steps of a PDDL action failed in the last critreg_plan().
 *
 * @param planner The planner.
 * @param name The name of the action, ended by NUL; case does not matter.
 * @param count Receives how often.
 * @return CRITREG_INVALID_ARGUMENT if there is no such action; CRITREG_BUSY,
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_planner_failures(struct critreg_planner *planner,
                                        const char *name,
                                        uint32_t *count);

/**
 * How often a reason was given in the last critreg_plan().
 *
 * @param planner The planner.
 * @param reason The number of the reason, below CRITREG_MAX_REASONS.
 * @param count Receives how often.
 * @return CRITREG_INVALID_ARGUMENT for a larger number; CRITREG_BUSY,
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_planner_reasons(struct critreg_planner *planner,
                                       uint32_t reason,
                                       uint32_t *count);

/**
 * What stood in the way most often in the last critreg_plan(), in the words of the skills,
 * such as "RobotPressButton(robby, button0, stick) needs button0.y <= 2.9, and it is 4.1"; also if a plan
 * was found. Empty if it is a reason of the program, or if there is none.
 *
 * @param planner The planner; may be called from its callbacks.
 * @param text Receives the words, ended by NUL; CRITREG_REASON_MAX bytes are always enough.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the words with their NUL, also if the buffer
 * is too small.
 * @return CRITREG_TOO_SMALL (nothing but needed is written); CRITREG_NULL_POINTER,
 * CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_planner_reason_text(const struct critreg_planner *planner,
                                           char *text,
                                           size_t len,
                                           size_t *needed);

/**
 * Fills a configuration with the defaults.
 *
 * @param config The configuration.
 * @param size sizeof *config, as for critreg_config_init().
 * @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED; CRITREG_INVALID_ARGUMENT if
 * size is smaller than the struct ever was, or larger than this library knows.
 */
critreg_status critreg_skills_config_init(struct critreg_skills_config *config,
                                          size_t size);

/**
 * How many bytes of memory skills take.
 *
 * @param config How much is tried, with the capacities.
 * @return The number of bytes; 0 if the configuration is wrong or memory cannot be that
 * large.
 */
size_t critreg_skills_size(const struct critreg_skills_config *config);

/**
 * The alignment in bytes that the memory of skills needs. An array of uint64_t and what
 * malloc() returns have it.
 */
size_t critreg_skills_align(void);

/**
 * Makes skills in memory of the program; nothing is known of them yet. Add controllers,
 * skills and training tasks, see SKILLS above.
 *
 * @param memory Memory for the skills, aligned to critreg_skills_align(). From now on it
 * belongs to them: do not write to it, move it or copy it.
 * @param memory_len Its length in bytes, at least critreg_skills_size().
 * @param domain The PDDL domain, ended by NUL. Copied.
 * @param layout Which numbers of a state belong to which object, ended by NUL: a domain
 * text that declares objects, and groups of those whose names differ from problem to
 * problem. Copied.
 * @param config How much is tried, with the length of a state.
 * @param skills Receives the handle, which lies at the start of the memory.
 * @return CRITREG_TOO_SMALL if the memory is too short for the capacities;
 * CRITREG_SYNTAX_ERROR (ask critreg_check_pddl() or critreg_check_domain() where);
 * CRITREG_CAPACITY_EXCEEDED if the texts find no room; CRITREG_INVALID_ARGUMENT for a wrong
 * configuration or a text that is not UTF-8; CRITREG_NULL_POINTER, CRITREG_MISALIGNED.
 */
critreg_status critreg_skills_init(void *memory,
                                   size_t memory_len,
                                   const char *domain,
                                   const char *layout,
                                   const struct critreg_skills_config *config,
                                   struct critreg_skills **skills);

/**
 * Why the last call on these skills failed that did fail, in words, as
 * critreg_learner_message().
 *
 * @param skills The skills; may be called from their callbacks.
 * @param text Receives the words, ended by NUL.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the words with their NUL, also if the buffer
 * is too small.
 * @return CRITREG_TOO_SMALL (nothing but needed is written); CRITREG_NULL_POINTER,
 * CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_skills_message(const struct critreg_skills *skills,
                                      char *text,
                                      size_t len,
                                      size_t *needed);

/**
 * Adds a controller: what several PDDL actions may run, with its continuous parameters.
 * Actions that no controller names are controllers of their own, without parameters.
 *
 * ```c
 * static const double along[2] = {0.0, 1.0};
 * status = critreg_skills_add_controller(skills, "PickStick",
 *     "PickStickFromNothing PickStickFromButton", "?robot ?stick", along, 1);
 * ```
 *
 * @param skills The skills.
 * @param name A name for it, ended by NUL. Copied.
 * @param actions The names of its actions, separated by blanks, ended by NUL. NULL: the
 * action that is called as it is.
 * @param objects Which parameters of each of these actions are its objects: their variables,
 * separated by blanks, ended by NUL. NULL: all of the first action. Objects that it is about
 * belong to it also where its command does not need them.
 * @param ranges The least and the greatest value of each continuous parameter: 2 * count
 * numbers. NULL if count is 0. Copied. They are those of its actions when a planner uses the
 * skills.
 * @param count How many parameters there are, at most CRITREG_MAX_PARAMETERS.
 * @return CRITREG_INVALID_ARGUMENT if there is no such action or variable, an action has a
 * controller already, the name is taken, or a range is upside down;
 * CRITREG_CAPACITY_EXCEEDED if it finds no room; CRITREG_OUT_OF_SEQUENCE after
 * critreg_skills_learn() or critreg_skills_resume(); CRITREG_NOT_FINITE, CRITREG_BUSY,
 * CRITREG_NULL_POINTER, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_skills_add_controller(struct critreg_skills *skills,
                                             const char *name,
                                             const char *actions,
                                             const char *objects,
                                             const double *ranges,
                                             size_t count);

/**
 * Adds a skill: a controller, or two that run one after the other, and what can be said of
 * them.
 *
 * @param skills The skills.
 * @param controller The name of the controller, ended by NUL.
 * @param later NULL; or the name of a controller that runs later, ended by NUL: learned is
 * then with which parameters of the first the later one works, too.
 * @param members NULL; or names of predicates of one object, separated by blanks, ended by
 * NUL. An object is a member of a group of the text only if all of them that are about its
 * type hold of it.
 * @param text The domain text, ended by NUL; its objects are roles, see SKILLS above. Its
 * parameters are the controller's first ones. Copied. NULL for a pair: it follows from the
 * texts of the two, in which roles of the same name are the same object; a later one that
 * has no text is described by its objects. NULL for a single controller: it is described by
 * its objects.
 * @return CRITREG_INVALID_ARGUMENT if there is no such controller or predicate;
 * CRITREG_SYNTAX_ERROR (ask critreg_check_domain() where); CRITREG_MISMATCH if an object of
 * the text is no role, the text has more parameters than the controller, or a pair without
 * text has a first one without; CRITREG_CAPACITY_EXCEEDED if it finds no room;
 * CRITREG_OUT_OF_SEQUENCE after critreg_skills_learn() or critreg_skills_resume();
 * CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_skills_add(struct critreg_skills *skills,
                                  const char *controller,
                                  const char *later,
                                  const char *members,
                                  const char *text);

/**
 * Adds a training task. Several dozens of them, with different numbers of objects, are a
 * good beginning: what is never tried is never learned.
 *
 * @param skills The skills.
 * @param problem A problem of the PDDL domain, ended by NUL; its goal does not matter.
 * Copied.
 * @param initial The state that it begins in. Copied.
 * @param len How many numbers it has.
 * @return CRITREG_SYNTAX_ERROR (ask critreg_check_pddl() where); CRITREG_MISMATCH if the
 * state is shorter than the layout says; CRITREG_CAPACITY_EXCEEDED if there is no room for
 * another task, its objects or its numbers; CRITREG_OUT_OF_SEQUENCE after
 * critreg_skills_learn() or critreg_skills_resume(); CRITREG_NOT_FINITE, CRITREG_BUSY,
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_skills_add_task(struct critreg_skills *skills,
                                       const char *problem,
                                       const double *initial,
                                       size_t len);

/**
 * Learns all skills, one after the other, by trying operators in the program's simulator:
 * situations are collected from the training tasks, those that differ most are chosen, and
 * a learner asks with which parameters, or in which states, a controller works. That a
 * skill has no region is no error; critreg_skills_report() tells why.
 *
 * If a callback stops it, call it again to go on: skills that were learned stay, and of the
 * one that was being learned the runs that were kept (critreg_skills_config.runs) are not
 * repeated. What is learned is the same as if nothing had happened. Once all is learned it
 * returns at once.
 *
 * @param skills The skills.
 * @param callbacks What may be asked, from critreg_callbacks_init(): execute and holds; and
 * sample, if it is set, which proposes where to look for parameters that work, as if nothing
 * came later (one operator, advised 0). Its skills and advise do not count.
 * @param user_data Passed to the callbacks.
 * @return The status of a callback that was not CRITREG_OK; CRITREG_CAPACITY_EXCEEDED if
 * the operators or atoms of a task, or the features of a text, find no room;
 * CRITREG_INVALID_ARGUMENT or CRITREG_NOT_FINITE for an answer of a callback that is none;
 * CRITREG_OUT_OF_SEQUENCE if there is no training task; CRITREG_BUSY from a callback;
 * CRITREG_NULL_POINTER, also if execute or holds are not set, CRITREG_MISALIGNED,
 * CRITREG_NOT_A_HANDLE. In all cases the skills can be used as far as they were learned.
 */
critreg_status critreg_skills_learn(struct critreg_skills *skills,
                                    const struct critreg_callbacks *callbacks,
                                    void *user_data);

/**
 * Prepares a report for critreg_skills_report().
 *
 * @param report The report.
 * @param size sizeof *report; see critreg_config_init().
 * @return As critreg_config_init().
 */
critreg_status critreg_skill_report_init(struct critreg_skill_report *report,
                                         size_t size);

/**
 * What was learned of a skill, and what it took.
 *
 * @param skills The skills.
 * @param index Which skill, from 0, in the order in which they were added.
 * @param report A report from critreg_skill_report_init(), to be filled.
 * @return CRITREG_INVALID_ARGUMENT if there is no such skill or the report was not
 * initialised; CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
 * CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_skills_report(struct critreg_skills *skills,
                                     size_t index,
                                     struct critreg_skill_report *report);

/**
 * Writes the region of a skill as text, such as "grasp.y <= 2.9 (zone.top - robot.radius)";
 * or, if it has none, why.
 *
 * @param skills The skills.
 * @param index Which skill, from 0.
 * @param text Receives the text, ended by NUL.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the text with its NUL, also if the buffer
 * is too small.
 * @return CRITREG_NO_REGION if there is none: the text then tells why; CRITREG_TOO_SMALL;
 * CRITREG_INVALID_ARGUMENT if there is no such skill; CRITREG_BUSY, CRITREG_NULL_POINTER,
 * CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_skills_format(struct critreg_skills *skills,
                                     size_t index,
                                     char *text,
                                     size_t len,
                                     size_t *needed);

/**
 * Writes the domain text of a skill: as it was added, or as it was made of the texts of its
 * members. With it, critreg_region_parse() makes a region of what critreg_skills_format()
 * wrote.
 *
 * @param skills The skills.
 * @param index Which skill, from 0.
 * @param text Receives the text, ended by NUL.
 * @param len Length of text in bytes; 0 to ask for the length only.
 * @param needed NULL, or receives the length of the text with its NUL, also if the buffer
 * is too small.
 * @return CRITREG_TOO_SMALL; CRITREG_INVALID_ARGUMENT if there is no such skill;
 * CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_skills_domain(struct critreg_skills *skills,
                                     size_t index,
                                     char *text,
                                     size_t len,
                                     size_t *needed);

/**
 * Saves what was learned so far: the skills that are learned, and the runs that were kept
 * of the one that is being learned. Versioned, checksummed, the same on every machine.
 *
 * @param skills The skills.
 * @param bytes Receives the bytes.
 * @param len Length of bytes; 0 to ask for the length only.
 * @param needed NULL, or receives how many bytes it takes, also if the buffer is too small.
 * @return CRITREG_TOO_SMALL (nothing but needed is written); CRITREG_OUT_OF_SEQUENCE if
 * there is no training task yet; CRITREG_CAPACITY_EXCEEDED, CRITREG_BUSY,
 * CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_skills_save(struct critreg_skills *skills,
                                   uint8_t *bytes,
                                   size_t len,
                                   size_t *needed);

/**
 * Brings fresh skills to the state that critreg_skills_save() wrote; critreg_skills_learn()
 * then goes on from there.
 *
 * @param skills Skills that were just made, with the texts, configuration, controllers,
 * skills and training tasks of the saved ones. They may have room for more.
 * @param bytes The saved bytes.
 * @param len How many there are.
 * @return CRITREG_CORRUPT for damaged bytes; CRITREG_MISMATCH if they belong to other texts,
 * tasks or another configuration; CRITREG_CAPACITY_EXCEEDED if the runs that were kept find
 * no room (critreg_skills_config.runs); CRITREG_OUT_OF_SEQUENCE if the skills are not fresh:
 * in all these cases nothing is known of any skill; CRITREG_BUSY, CRITREG_NULL_POINTER,
 * CRITREG_NOT_A_HANDLE.
 */
critreg_status critreg_skills_resume(struct critreg_skills *skills,
                                     const uint8_t *bytes,
                                     size_t len);

/**
 * The domain text of picking the stick with one button on the table, the action
 * PickStickFromNothing of the thesis. Its one parameter is mu, the place of the
 * grasp along the stick, from 0 to 1.
 *
 * @return A static text, never NULL.
 */
const char *critreg_stick_button_domain(void);

/**
 * How many numbers a state has: robot x, y, theta; stick x, y, theta, held; holder
 * x, y, theta; and x, y, pressed of each button. Lengths are in units of the table
 * (10 by 6), angles in radians. An instance of critreg_stick_button_domain() is a
 * state with one button.
 */
size_t critreg_stick_button_state_len(uint32_t buttons);

/**
 * Draws a random task, to press all buttons, and writes its initial state. Nothing
 * is held in it, and the robot and the stick lie above no button.
 *
 * @param seed Every seed gives one task, the same on every machine.
 * @param options 0 or CRITREG_STICK_BUTTON_ANGLES.
 * @param buttons How many buttons there are, from 1 to 10.
 * @param state Receives the state.
 * @param len Length of state in numbers, at least
 * critreg_stick_button_state_len().
 * @return CRITREG_TOO_SMALL; CRITREG_INVALID_ARGUMENT for unknown options or
 * another number of buttons; CRITREG_NULL_POINTER, CRITREG_MISALIGNED.
 */
critreg_status critreg_stick_button_task(uint64_t seed,
                                         uint32_t options,
                                         uint32_t buttons,
                                         double *state,
                                         size_t len);

/**
 * Tries to pick the stick: a critreg_simulate to pass to critreg_learn_region().
 * It rolls the controller out, at most 50 steps of the environment.
 *
 * @param user_data NULL, or a pointer to a uint32_t with options: 0 or
 * CRITREG_STICK_BUTTON_ANGLES. It is only read.
 * @param instance The instance: a state with one button.
 * @param theta The parameter mu.
 * @param outcome Receives CRITREG_FEASIBLE or CRITREG_INFEASIBLE.
 * @return CRITREG_NOT_FINITE for a number of the instance or for mu;
 * CRITREG_INVALID_ARGUMENT for unknown options; CRITREG_NULL_POINTER,
 * CRITREG_MISALIGNED.
 */
critreg_status critreg_stick_button_pick(void *user_data,
                                         const double *instance,
                                         const double *theta,
                                         critreg_outcome *outcome);

/**
 * Runs an operator of the environment: a critreg_execute for critreg_callbacks.
 *
 * The operators are RobotPressButtonFromNothing (robot button stick),
 * RobotPressButtonFromButton (robot button from stick), PickStickFromNothing (robot
 * stick), PickStickFromButton (robot stick from), StickPressButtonFromNothing (robot
 * stick button), StickPressButtonFromButton (robot stick button from),
 * PlaceStickFromNothing (robot stick) and PlaceStickFromButton (robot stick).
 * Picking has the parameter mu from 0 to 1, placing one from -1 to 1. The objects
 * are robby, stick, holder, button0, button1 and so on, in the order of the state.
 *
 * @param user_data NULL, or a pointer to a uint32_t with options, as for
 * critreg_stick_button_pick().
 * @param ground The operator; its name and those of its objects count, its indices
 * do not.
 * @param parameters Its parameters.
 * @param before The state before.
 * @param after Receives the state afterwards; the same one if it failed.
 * @param len Numbers of a state: critreg_stick_button_state_len().
 * @param actions Receives how many steps of the environment it took; 0 if it
 * failed.
 * @return CRITREG_INVALID_ARGUMENT for an unknown operator, object or option, or a
 * wrong number of objects or of numbers; CRITREG_NOT_FINITE, CRITREG_NULL_POINTER,
 * CRITREG_MISALIGNED.
 */
critreg_status critreg_stick_button_execute(void *user_data,
                                            const struct critreg_ground *ground,
                                            const double *parameters,
                                            const double *before,
                                            double *after,
                                            size_t len,
                                            uint32_t *actions);

/**
 * Tells whether an atom of the environment holds: a critreg_holds for
 * critreg_callbacks.
 *
 * The predicates are AboveNoButton (), Grasped (robot stick), HandEmpty (robot),
 * Pressed (button), RobotAboveButton (robot button) and StickAboveButton (stick
 * button).
 *
 * @param user_data As for critreg_stick_button_execute().
 * @param ground The atom; its name and those of its objects count.
 * @param state The state.
 * @param len Numbers of a state: critreg_stick_button_state_len().
 * @param holds Receives 1 or 0.
 * @return CRITREG_INVALID_ARGUMENT for an unknown predicate, object or option, or a
 * wrong number of objects or of numbers; CRITREG_NOT_FINITE, CRITREG_NULL_POINTER,
 * CRITREG_MISALIGNED.
 */
critreg_status critreg_stick_button_holds(void *user_data,
                                          const struct critreg_ground *ground,
                                          const double *state,
                                          size_t len,
                                          int32_t *holds);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* CRITREG_H */
