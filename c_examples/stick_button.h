/*
 * The stick-button environment in texts: its operators and the problem to press all buttons
 * in PDDL, the layout of its state, and what can be said of its controllers.
 */
#ifndef STICK_BUTTON_H
#define STICK_BUTTON_H

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#define BUTTONS 4               /* most buttons of a problem */

static const char STICK_BUTTON[] =
    "(define (domain stick-button)\n"
    "  (:requirements :strips :typing)\n"
    "  (:types robot stick button)\n"
    "  (:predicates (AboveNoButton) (Grasped ?r - robot ?s - stick) (HandEmpty ?r - robot)\n"
    "    (Pressed ?b - button) (RobotAboveButton ?r - robot ?b - button)\n"
    "    (StickAboveButton ?s - stick ?b - button))\n"
    "  (:action RobotPressButtonFromNothing\n"
    "    :parameters (?r - robot ?b - button ?s - stick)\n"
    "    :precondition (and (HandEmpty ?r) (AboveNoButton))\n"
    "    :effect (and (Pressed ?b) (RobotAboveButton ?r ?b) (not (AboveNoButton))))\n"
    "  (:action RobotPressButtonFromButton\n"
    "    :parameters (?r - robot ?b ?from - button ?s - stick)\n"
    "    :precondition (and (HandEmpty ?r) (RobotAboveButton ?r ?from))\n"
    "    :effect (and (Pressed ?b) (RobotAboveButton ?r ?b) (not (RobotAboveButton ?r ?from))))\n"
    "  (:action PickStickFromNothing\n"
    "    :parameters (?r - robot ?s - stick)\n"
    "    :precondition (and (HandEmpty ?r) (AboveNoButton))\n"
    "    :effect (and (Grasped ?r ?s) (not (HandEmpty ?r))))\n"
    "  (:action PickStickFromButton\n"
    "    :parameters (?r - robot ?s - stick ?from - button)\n"
    "    :precondition (and (HandEmpty ?r) (RobotAboveButton ?r ?from))\n"
    "    :effect (and (Grasped ?r ?s) (AboveNoButton) (not (HandEmpty ?r))\n"
    "                 (not (RobotAboveButton ?r ?from))))\n"
    "  (:action StickPressButtonFromNothing\n"
    "    :parameters (?r - robot ?s - stick ?b - button)\n"
    "    :precondition (and (Grasped ?r ?s) (AboveNoButton))\n"
    "    :effect (and (StickAboveButton ?s ?b) (Pressed ?b) (not (AboveNoButton))))\n"
    "  (:action StickPressButtonFromButton\n"
    "    :parameters (?r - robot ?s - stick ?b ?from - button)\n"
    "    :precondition (and (Grasped ?r ?s) (StickAboveButton ?s ?from))\n"
    "    :effect (and (StickAboveButton ?s ?b) (Pressed ?b) (not (StickAboveButton ?s ?from))))\n"
    "  (:action PlaceStickFromNothing\n"
    "    :parameters (?r - robot ?s - stick)\n"
    "    :precondition (Grasped ?r ?s)\n"
    "    :effect (and (HandEmpty ?r) (not (Grasped ?r ?s))))\n"
    "  (:action PlaceStickFromButton\n"
    "    :parameters (?r - robot ?s - stick)\n"
    "    :precondition (Grasped ?r ?s)\n"
    "    :effect (and (HandEmpty ?r) (AboveNoButton) (not (Grasped ?r ?s)))))\n";

/* Which numbers of a state belong to which object. */
static const char LAYOUT[] =
    "type robot { x: length, y: length, theta: angle }\n"
    "type stick { x: length, y: length, theta: angle, held: flag }\n"
    "type holder { x: length, y: length, theta: angle }\n"
    "type button { x: length, y: length, pressed: flag }\n"
    "object robby: robot  object stick: stick  object holder: holder  object buttons[4]: button\n";

/* Sizes, and the robot. */
#define ROBOT_TEXT                                                              \
    "constant zone.top = 3.0: length  constant robot.radius = 0.1: length\n"    \
    "constant button.radius = 0.1: length  constant stick.width = 3.0: length\n" \
    "constant stick.height = 0.05: length  constant tip.width = 0.05: length\n" \
    "constant holder.width = 0.3: length  constant holder.height = 0.125: length\n" \
    "object robot { x: length, y: length, theta: angle }\n"
/* With the stick and its holder. */
#define STICK_TEXT ROBOT_TEXT                                                   \
    "object stick { x: length, y: length, theta: angle }\n"                     \
    "object holder { x: length, y: length, theta: angle }\n"                    \
    "point holder.centre = holder + (0.5 * holder.width, 0.5 * holder.height)\n"

/* What can be said of controllers: of picking the stick, where along it. */
static const char PICK[] = STICK_TEXT
    "parameter mu in [0, 1]\n"
    "point grasp = stick + (mu * stick.width, 0.5 * stick.height)\n"
    "point stick.tip = stick + (stick.width - tip.width, 0.5 * stick.height)\n";
/* Of placing it, where the robot lets go. */
static const char PLACE[] = STICK_TEXT
    "parameter o in [-1, 1]\n"
    "point release = world + (holder.x - 0.5*holder.height, holder.y + o * 0.5*stick.width)\n";
/* Of pressing a button by hand. */
static const char PRESS[] = ROBOT_TEXT "object button { x: length, y: length }\n";

/* The problem to press all of so many buttons. */
static void write_problem(uint32_t buttons, char *text, size_t len)
{
    char names[16 * BUTTONS] = "", goals[24 * BUTTONS] = "";
    uint32_t i;
    for (i = 0; i < buttons; i++) {
        sprintf(names + strlen(names), " button%" PRIu32, i);
        sprintf(goals + strlen(goals), " (Pressed button%" PRIu32 ")", i);
    }
    snprintf(text, len,
             "(define (problem press) (:domain stick-button)\n"
             "  (:objects%s - button robby - robot stick - stick)\n"
             "  (:init (HandEmpty robby) (AboveNoButton)) (:goal (and%s)))", names, goals);
}

#endif
