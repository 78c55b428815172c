; Balls are carried between rooms. There are no types: static predicates tell
; rooms, balls and hands apart.
(define (domain gripper)
  (:requirements :strips)
  (:predicates
    (room ?x) (ball ?x) (hand ?x)
    (robot-in ?room) (in ?ball ?room) (free ?hand) (carries ?hand ?ball))

  (:action move
    :parameters (?from ?to)
    :precondition (and (room ?from) (room ?to) (robot-in ?from))
    :effect (and (robot-in ?to) (not (robot-in ?from))))

  (:action drop
    :parameters (?ball ?room ?hand)
    :precondition (and (ball ?ball) (room ?room) (hand ?hand)
                       (carries ?hand ?ball) (robot-in ?room))
    :effect (and (in ?ball ?room) (free ?hand) (not (carries ?hand ?ball))))

  (:action pick
    :parameters (?ball ?room ?hand)
    :precondition (and (ball ?ball) (room ?room) (hand ?hand)
                       (in ?ball ?room) (robot-in ?room) (free ?hand))
    :effect (and (carries ?hand ?ball) (not (in ?ball ?room)) (not (free ?hand)))))
