/*
 * The stick-button environment in PDDL: its operators, and the problem to press all
 * buttons.
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
