; Parcels are brought from a depot: subtypes of subtypes, a constant, static roads.
(define (domain delivery)
  (:requirements :strips :typing :equality)
  (:types
    truck drone - vehicle
    vehicle parcel - movable
    place movable - object)
  (:constants depot - place)
  (:predicates
    (at ?x - movable ?p - place)
    (loaded ?x - parcel ?v - vehicle)
    (road ?from ?to - place)
    (docked ?d - drone ?t - truck)
    (carried-out ?x - parcel))

  (:action load
    :parameters (?x - parcel ?v - vehicle)
    :precondition (and (at ?x depot) (at ?v depot))
    :effect (and (loaded ?x ?v) (not (at ?x depot))))

  (:action unload
    :parameters (?x - parcel ?v - vehicle ?p - place)
    :precondition (and (loaded ?x ?v) (at ?v ?p) (not (= ?p depot)))
    :effect (and (at ?x ?p) (carried-out ?x) (not (loaded ?x ?v))))

  (:action Drive
    :parameters (?t - truck ?from ?to - place)
    :precondition (and (road ?from ?to) (at ?t ?from))
    :effect (and (at ?t ?to) (not (at ?t ?from))))

  (:action fly-out
    :parameters (?d - drone ?t - truck ?from ?to - place)
    :precondition (and (docked ?d ?t) (and (at ?t ?from) (at ?d ?from)) (= ?from depot))
    :effect (and (not (at ?d ?from)) (at ?d ?to)))

  (:action give-up :parameters ()))
