; The stick-button environment; each action is an operator of it.
(define (domain stick-button)
  (:requirements :strips :typing)
  (:types robot stick holder button)
  (:predicates
    (HandEmpty ?r - robot)
    (Grasped ?r - robot ?s - stick)
    (AboveNoButton)
    (RobotAboveButton ?r - robot ?b - button)
    (StickAboveButton ?s - stick ?b - button)
    (Pressed ?b - button))

  (:action RobotPressButtonFromNothing
    :parameters (?robot - robot ?button - button ?stick - stick)
    :precondition (and (HandEmpty ?robot) (AboveNoButton))
    :effect (and (Pressed ?button) (RobotAboveButton ?robot ?button) (not (AboveNoButton))))

  (:action RobotPressButtonFromButton
    :parameters (?robot - robot ?button ?from - button ?stick - stick)
    :precondition (and (HandEmpty ?robot) (RobotAboveButton ?robot ?from))
    :effect (and (Pressed ?button) (RobotAboveButton ?robot ?button)
                 (not (RobotAboveButton ?robot ?from))))

  (:action PickStickFromNothing
    :parameters (?robot - robot ?stick - stick)
    :precondition (and (HandEmpty ?robot) (AboveNoButton))
    :effect (and (Grasped ?robot ?stick) (not (HandEmpty ?robot))))

  (:action PickStickFromButton
    :parameters (?robot - robot ?stick - stick ?from - button)
    :precondition (and (HandEmpty ?robot) (RobotAboveButton ?robot ?from))
    :effect (and (Grasped ?robot ?stick) (AboveNoButton)
                 (not (HandEmpty ?robot)) (not (RobotAboveButton ?robot ?from))))

  (:action StickPressButtonFromNothing
    :parameters (?robot - robot ?stick - stick ?button - button)
    :precondition (and (Grasped ?robot ?stick) (AboveNoButton))
    :effect (and (StickAboveButton ?stick ?button) (Pressed ?button) (not (AboveNoButton))))

  (:action StickPressButtonFromButton
    :parameters (?robot - robot ?stick - stick ?button ?from - button)
    :precondition (and (Grasped ?robot ?stick) (StickAboveButton ?stick ?from))
    :effect (and (StickAboveButton ?stick ?button) (Pressed ?button)
                 (not (StickAboveButton ?stick ?from))))

  (:action PlaceStickFromNothing
    :parameters (?robot - robot ?stick - stick)
    :precondition (Grasped ?robot ?stick)
    :effect (and (HandEmpty ?robot) (not (Grasped ?robot ?stick))))

  (:action PlaceStickFromButton
    :parameters (?robot - robot ?stick - stick)
    :precondition (Grasped ?robot ?stick)
    :effect (and (HandEmpty ?robot) (AboveNoButton) (not (Grasped ?robot ?stick)))))
