; Blocks on a table. A block is never put onto itself, nor taken off itself.
(define (domain blocks)
  (:requirements :strips :typing :equality :negative-preconditions)
  (:types block)
  (:predicates
    (on ?above ?below - block)
    (on-table ?b - block)
    (clear ?b - block)
    (holding ?b - block)
    (hand-empty))

  (:action unstack
    :parameters (?b ?from - block)
    :precondition (and (hand-empty) (clear ?b) (on ?b ?from) (not (= ?b ?from)))
    :effect (and (holding ?b) (clear ?from)
                 (not (hand-empty)) (not (clear ?b)) (not (on ?b ?from))))

  (:action stack
    :parameters (?b ?onto - block)
    :precondition (and (holding ?b) (clear ?onto) (not (= ?b ?onto)))
    :effect (and (hand-empty) (clear ?b) (on ?b ?onto)
                 (not (holding ?b)) (not (clear ?onto))))

  (:action pick-up
    :parameters (?b - block)
    :precondition (and (hand-empty) (clear ?b) (on-table ?b))
    :effect (and (holding ?b) (not (hand-empty)) (not (clear ?b)) (not (on-table ?b))))

  (:action put-down
    :parameters (?b - block)
    :precondition (holding ?b)
    :effect (and (hand-empty) (clear ?b) (on-table ?b) (not (holding ?b)))))
